// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_CURVATURE_SIZING_FIELD_H
#define CGAL_QUAD_MESH_ADAPTATION_CURVATURE_SIZING_FIELD_H

#include <CGAL/Quad_mesh_adaptation/Nodal_sizing_field.h>
#include <CGAL/Quad_mesh_adaptation/Size_range.h>
#include <CGAL/Quad_mesh_adaptation/internal/check_feature_angle.h>
#include <CGAL/Quad_mesh_adaptation/internal/chord_sizes.h>
#include <CGAL/Quad_mesh_adaptation/internal/spread_sizes.h>
#include <CGAL/Quad_mesh_adaptation/internal/vertex_curvatures.h>
#include <CGAL/Quad_mesh_adaptation/parameters.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {

/// \brief A sizing field that follows the curvature of a surface, for a given number of elements in
/// a full circle or a given chord error.
///
/// The curvature is estimated at the vertices of a mesh of the surface, on each side of creases and
/// borders on its own; the largest counts, and that of creases and borders as curves.  Creases are
/// the edges that turn by more than `feature_angle()` and constrained ones; those detected ones
/// that adaptation takes back, since a coarse mesh of a round turns so, are none here either.
/// Between the vertices the sizes are interpolated as by `Nodal_sizing_field`, and like that the
/// field keeps what it needs.  Sizes may change fast from one vertex to the next:
/// `Graded_sizing_field` is meant to be put on top.
///
/// Estimates are exact on spheres and cylinders up to the difference between an arc and its chord.
/// A curvature that the mesh does not show is not seen; noise of the vertices counts as curvature.
///
/// This header needs Eigen.
class Curvature_sizing_field
{
public:
  /// `n` edges along a full circle of the larger principal curvature: h = 2 sin(pi / n) / k.
  ///
  /// \param mesh a polygon mesh, model of `FaceListGraph` and `HalfedgeListGraph`.
  /// \param n at least 3.
  /// \param range the sizes are brought within; by default not above the diagonal of the box
  ///        around the mesh.
  /// \param np optional: `vertex_point_map`, `edge_is_constrained_map`, `feature_angle()`.
  /// \throws std::invalid_argument if `n`, `range` or the feature angle are not valid, a coordinate
  ///         is not finite, or the mesh has no face with an area.
  ///
  /// Linear in the size of the mesh, but for the search tree.
  template <class PolygonMesh, class NP = parameters::Default_named_parameters>
  static Curvature_sizing_field elements_per_circle(const PolygonMesh& mesh, double n,
                                                    const Size_range& range = Size_range(),
                                                    const NP& np = parameters::default_values())
  {
    if(!(n >= 3 && std::isfinite(n)))
      throw std::invalid_argument("Curvature_sizing_field: fewer than 3 elements in a circle");
    const double factor = 2 * std::sin(internal::pi / n);
    return Curvature_sizing_field(
        mesh, [factor](const internal::Principal_curvatures& k) { return factor / k.largest; },
        range, np);
  }

  /// Faces that leave the surface by at most about `error`, in units of the coordinates.
  ///
  /// A line of length L along the larger principal curvature does so by k L^2 / 8.  Sizes bound the
  /// mean edge h of a face; its diagonals and single edges are longer, L = 1.48 h.  So
  /// h = 2 sqrt(e (2 / k - e)) / 1.48, about 2 sqrt(e / k), k being a little more where the surface
  /// bends to the same side in both directions.  The folds between the flat faces of the mesh count
  /// as they come to lie under such a line: where faces become smaller than those of the mesh, a
  /// fold by the angle t asks for L = 4 e / t.  This holds for faces that stay on the mesh as it
  /// is; for those on a smooth surface through its vertices, give `smooth_reference(true)` here as
  /// well, and only the curvature counts.  Sizes hold for faces that reach a vertex: within half a
  /// size about it, and they grow by at most 0.35 per unit of length from there on.  Checked on
  /// shapes of many kinds, errors in both directions stay below 1.1 `error`; but with
  /// `smooth_reference(true)` up to 2.5 `error` were seen where the mesh turns by much from face to
  /// face.  Where a bound must hold, `max_distance()` is for that.
  ///
  /// Parameters and errors as above, and optionally `smooth_reference()`; `error` is positive.
  template <class PolygonMesh, class NP = parameters::Default_named_parameters>
  static Curvature_sizing_field chord_error(const PolygonMesh& mesh, double error,
                                            const Size_range& range = Size_range(),
                                            const NP& np = parameters::default_values())
  {
    if(!(error > 0 && std::isfinite(error)))
      throw std::invalid_argument("Curvature_sizing_field: the chord error is not positive");
    return Curvature_sizing_field(
        mesh,
        [error](const internal::Principal_curvatures& k) {
          const double radius = 1 / internal::chord_curvature(k), e = (std::min)(error, radius);
          return 2 * std::sqrt(e) * std::sqrt(2 * radius - e) / internal::longest_chord;
        },
        range, np, error);
  }

  /// Target edge length at a point; always positive.
  template <class Point>
  double operator()(const Point& p) const
  {
    return field_(p);
  }

private:
  static constexpr double growth = 0.35;

  template <class PolygonMesh, class SizeOfCurvature, class NP>
  Curvature_sizing_field(const PolygonMesh& mesh, const SizeOfCurvature& size, Size_range range,
                         const NP& np, double error = 0)
      : field_(make(mesh, size, range, np, error))
  {
  }

  template <class PolygonMesh, class SizeOfCurvature, class NP>
  static Nodal_sizing_field make(const PolygonMesh& mesh, const SizeOfCurvature& size,
                                 Size_range range, const NP& np, double error)
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    range.check();
    const double angle =
        choose_parameter(get_parameter(np, feature_angle_tag), default_feature_angle);
    const std::string complaint = internal::check_feature_angle(angle);
    if(!complaint.empty()) throw std::invalid_argument("Curvature_sizing_field: " + complaint);
    const internal::Face_arrays arrays = internal::face_arrays(mesh, np, "Curvature_sizing_field");
    range.largest = (std::max)((std::min)(range.largest, arrays.diagonal()), range.smallest);
    const double cos_feature = angle >= 180 ? -2. : std::cos(angle * internal::pi / 180);
    internal::Curvature_estimator estimator(arrays, cos_feature);
    std::vector<internal::Principal_curvatures> curvatures = estimator();
    std::vector<double> on_folds;
    if(error > 0 && !choose_parameter(get_parameter(np, smooth_reference_tag), false))
      on_folds = internal::chord_sizes(arrays, estimator.features(), cos_feature, error);
    std::vector<double> lengths(curvatures.size());
    for(std::size_t i = 0; i < lengths.size(); ++i) {
      const internal::Principal_curvatures& k = curvatures[i];
      lengths[i] = k.largest > 0 ? size(k) : range.largest;
      if(!on_folds.empty()) lengths[i] = (std::min)(lengths[i], on_folds[i]);
      lengths[i] = range.clamp(lengths[i]);
    }
    if(error > 0) internal::spread_sizes(arrays, growth, lengths);
    return internal::nodal_sizing_field(mesh, lengths, np);
  }

  Nodal_sizing_field field_;
};

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_CURVATURE_SIZING_FIELD_H
