// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_H

#include <CGAL/Quad_mesh_adaptation/internal/measure_faces.h>
#include <CGAL/Quad_mesh_adaptation/internal/measure_sizes.h>
#include <CGAL/Quad_mesh_adaptation/internal/measure_topology.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// All figures of a quad mesh given as arrays, in time linear in its size.  Points that no quad
// uses are ignored.  Sizes are taken as they come: a caller who doubts them checks in `size`,
// whose exceptions pass through.  The ideal number of faces is integrated over
// `reference_triangles`, or over the mesh itself without them.  `max_distance_to_reference` is
// left at 0.
// Preconditions: indices are in range; the mesh may be non-manifold.
inline Mesh_measures measure(const std::vector<Vec>& points, const std::vector<Quad>& quads,
                             const Size_function& size,
                             const std::vector<Triangle>* reference_triangles = nullptr)
{
  Mesh_measures m;
  measure_topology(points.size(), quads, m);
  Figures_of_faces figures;
  figures.look_at(quads.size());
  const auto corners_of = [&](std::size_t k) -> std::array<Vec, 4> {
    const Quad& q = quads[k];
    return { points[q[0]], points[q[1]], points[q[2]], points[q[3]] };
  };
  const auto strict = [](std::size_t, double length, const Face_sizes& sizes) {
    return length / sizes.strict();
  };
  const auto known_strict = [](std::size_t) { return 0.; }; // there is none
  measure_faces(corners_of, size, strict, known_strict, reference_triangles, figures, m);
  return m;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_H
