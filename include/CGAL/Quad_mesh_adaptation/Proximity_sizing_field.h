// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_PROXIMITY_SIZING_FIELD_H
#define CGAL_QUAD_MESH_ADAPTATION_PROXIMITY_SIZING_FIELD_H

#include <CGAL/Quad_mesh_adaptation/Nodal_sizing_field.h>
#include <CGAL/Quad_mesh_adaptation/Size_range.h>
#include <CGAL/Quad_mesh_adaptation/internal/Opposite_sheets.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {

/// What is thin in the sense of `Proximity_sizing_field`.
enum class Proximity
{
  thickness, ///< the part behind the surface, against the normals: walls, ribs, wings
  gap,       ///< the space in front of it: slots, parts that nearly touch
  both
};

/// \brief A sizing field for thin parts: faces so small that `n` of them would fit between a sheet
/// of the surface and the sheet opposite.
///
/// The distance is that of a ray along the normal to the next sheet, unless that is turned by more
/// than 60 degrees; at a vertex the smallest one from the faces around it counts.  Between the
/// vertices the sizes are interpolated as by `Nodal_sizing_field`.  Where there is no sheet
/// opposite the largest size holds, so `Graded_sizing_field` is meant to be put on top.
/// A thin part that begins and ends within one face of the mesh may be missed.
class Proximity_sizing_field
{
public:
  /// \param mesh a polygon mesh, model of `FaceListGraph` and `HalfedgeListGraph`.
  /// \param n elements across, positive; 1 makes faces as long as the part is thick.
  /// \param range the sizes are brought within; by default not above the diagonal of the box
  ///        around the mesh.
  /// \param what thin parts, narrow gaps or both.
  /// \param np optional: `vertex_point_map`.
  /// \throws std::invalid_argument if `n` or `range` is not valid, a coordinate is not finite, or
  ///         the mesh has no face with an area, or if sheets touch (a size would be 0) and `range`
  ///         has no smallest size.
  ///
  /// O(n log n): a ray for each corner of a face.
  template <class PolygonMesh, class NP = parameters::Default_named_parameters>
  Proximity_sizing_field(const PolygonMesh& mesh, double n, const Size_range& range = Size_range(),
                         Proximity what = Proximity::thickness,
                         const NP& np = parameters::default_values())
      : field_(make(mesh, n, range, what, np))
  {
  }

  /// Target edge length at a point; always positive.
  template <class Point>
  double operator()(const Point& p) const
  {
    return field_(p);
  }

private:
  template <class PolygonMesh, class NP>
  static Nodal_sizing_field make(const PolygonMesh& mesh, double n, Size_range range,
                                 Proximity what, const NP& np)
  {
    range.check();
    if(!(n > 0 && std::isfinite(n)))
      throw std::invalid_argument("Proximity_sizing_field: the elements across are not positive");
    const internal::Face_arrays arrays = internal::face_arrays(mesh, np, "Proximity_sizing_field");
    if(!(arrays.area() > 0))
      throw std::invalid_argument("Proximity_sizing_field: the mesh has no face with an area");
    range.largest = (std::max)((std::min)(range.largest, arrays.diagonal()), range.smallest);
    const internal::Opposite_sheets sheets(arrays);
    std::vector<double> size(arrays.points.size(), range.largest);
    for(const double side : { -1., 1. }) {
      if(what == (side < 0 ? Proximity::gap : Proximity::thickness)) continue;
      const std::vector<double> distance = sheets.distances(side);
      for(std::size_t v = 0; v < size.size(); ++v)
        size[v] = (std::min)(size[v], range.clamp(distance[v] / n));
    }
    return internal::nodal_sizing_field(mesh, size, np);
  }

  Nodal_sizing_field field_;
};

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_PROXIMITY_SIZING_FIELD_H
