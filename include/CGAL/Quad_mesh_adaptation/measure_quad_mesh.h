// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_MEASURE_QUAD_MESH_H
#define CGAL_QUAD_MESH_ADAPTATION_MEASURE_QUAD_MESH_H

#include <CGAL/Quad_mesh_adaptation/internal/measure.h>
#include <CGAL/Quad_mesh_adaptation/internal/mesh_arrays.h>
#include <CGAL/Quad_mesh_adaptation/internal/size_at.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

template <class Point, class SizingField>
Size_function checked_size(const SizingField& sizing)
{
  return [&sizing](const Vec& p) {
    const double h = size_at(sizing, Point(p.x(), p.y(), p.z()));
    if(!(std::isfinite(h) && h > 0))
      throw std::domain_error("measure_quad_mesh: a size is not a positive finite number");
    return h;
  };
}

} // namespace internal

/// \brief Measures a quad mesh against a sizing field: counts, valences, the size-ratio table of
/// Anderson, Benzley and Owen (2009), efficiency and Verdict's quality figures.
///
/// The mesh comes first: it is what is measured.  Functions that change it take the sizes first.
///
/// \param mesh a model of `FaceListGraph` and `HalfedgeListGraph`; isolated vertices are ignored.
/// \param sizing the target edge length, in units of the coordinates: a number, or a callable
///        `double(const Point_3&)`.
/// \param np optional: `vertex_point_map` (default: the internal map of `mesh`).
/// \returns the measures.  The ideal number of faces, on which the efficiency rests, is integrated
///          over `mesh` itself to about 1e-3 of its value; `max_distance_to_reference` is 0.
/// \throws std::invalid_argument if a face is not a quad or a coordinate of one is not finite,
///         std::domain_error if a size is not a positive finite number;
///         exceptions of `sizing` pass through.
///
/// Linear in the number of faces; about five evaluations of `sizing` per face for the ratios and
/// eight for the efficiency, and never fewer than some 6e4 for the latter.
template <class QuadMesh, class SizingField, class NP = parameters::Default_named_parameters>
Mesh_measures measure_quad_mesh(const QuadMesh& mesh, const SizingField& sizing,
                                const NP& np = parameters::default_values())
{
  const auto point_map = internal::vertex_points(mesh, np);
  using Point = typename boost::property_traits<std::decay_t<decltype(point_map)>>::value_type;
  const internal::Quad_arrays a = internal::quad_arrays(mesh, point_map, "measure_quad_mesh");
  for(const internal::Quad& q : a.quads)
    for(const internal::Index v : q)
      if(!internal::is_finite(a.points[v]))
        throw std::invalid_argument("measure_quad_mesh: a coordinate is not finite");
  return internal::measure(a.points, a.quads, internal::checked_size<Point>(sizing));
}

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_MEASURE_QUAD_MESH_H
