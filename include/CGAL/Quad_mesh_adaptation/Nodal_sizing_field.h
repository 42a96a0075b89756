// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_NODAL_SIZING_FIELD_H
#define CGAL_QUAD_MESH_ADAPTATION_NODAL_SIZING_FIELD_H

#include <CGAL/Quad_mesh_adaptation/Nodal_field.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {

/// \brief A sizing field given by sizes at the vertices of a background mesh.
///
/// The logarithm of the size is interpolated linearly over a triangulated copy of the background
/// mesh, so that the size between two vertices never exceeds their geometric interpolation.  The
/// field keeps the copy: the background mesh may be adapted or destroyed afterwards, and adapting
/// it several times does not make the sizes drift.  It may be the
/// mesh that is adapted, or any other mesh of the same surface.  At a point off the background mesh
/// the size is that of its nearest point.
///
/// Copies share their data.  `operator()` may be called from several threads.
class Nodal_sizing_field
{
public:
  /// \param mesh the background mesh, a model of `FaceListGraph` and `HalfedgeListGraph` with at
  ///        least one face of non-zero area: triangles, quads (cut along the diagonal that keeps
  ///        the triangles well oriented) or polygons (cut around the mean of their vertices).
  /// \param sizes a readable property map from vertices to the target edge length there, in units
  ///        of the coordinates.
  /// \param np optional: `vertex_point_map`.
  /// \throws std::invalid_argument if a size or a coordinate is not finite, a size is not
  ///         positive, or no face has an area.
  template <class PolygonMesh, class VertexSizeMap, class NP = parameters::Default_named_parameters>
  Nodal_sizing_field(const PolygonMesh& mesh, const VertexSizeMap& sizes,
                     const NP& np = parameters::default_values())
      : log_sizes_(mesh, logarithms(mesh, sizes), np)
  {
  }

  /// The same from arrays, for a background that need not be manifold or oriented.
  /// \param points anything with `x()`, `y()` and `z()`.
  /// \param polygons the numbers of the points of each, at least three.
  /// \param sizes one for each point.
  /// \throws std::invalid_argument also if the numbers of points and sizes differ, or a number of a
  ///         point is out of range.
  template <class Point, class Number>
  Nodal_sizing_field(const std::vector<Point>& points,
                     const std::vector<std::vector<Number>>& polygons,
                     const std::vector<double>& sizes)
      : log_sizes_(points, polygons, logarithms(sizes))
  {
  }

  /// Target edge length at a point (anything with `x()`, `y()` and `z()`); always positive.
  template <class Point>
  double operator()(const Point& point) const
  {
    return std::exp(log_sizes_(point));
  }

private:
  static double logarithm(double size)
  {
    if(!(std::isfinite(size) && size > 0))
      throw std::invalid_argument("Nodal_sizing_field: a size is not a positive finite number");
    return std::log(size);
  }

  static std::vector<double> logarithms(std::vector<double> sizes)
  {
    for(double& size : sizes) size = logarithm(size);
    return sizes;
  }

  template <class PolygonMesh, class VertexSizeMap>
  static auto logarithms(const PolygonMesh&, const VertexSizeMap& sizes)
  {
    using Vertex = typename boost::graph_traits<PolygonMesh>::vertex_descriptor;
    return boost::make_function_property_map<Vertex>(
        [&sizes](Vertex v) { return logarithm(CGAL::to_double(get(sizes, v))); });
  }

  Nodal_field log_sizes_;
};

namespace internal {

// The same from a list of sizes, in the order of the vertices.
template <class PolygonMesh, class NP>
Nodal_sizing_field nodal_sizing_field(const PolygonMesh& mesh, const std::vector<double>& sizes,
                                      const NP& np)
{
  auto size_of = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
  std::size_t i = 0;
  for(auto v : vertices(mesh)) put(size_of, v, sizes[i++]);
  return Nodal_sizing_field(mesh, size_of, np);
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_NODAL_SIZING_FIELD_H
