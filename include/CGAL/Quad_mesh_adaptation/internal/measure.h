// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_H

#include <CGAL/Quad_mesh_adaptation/internal/Kept_sizes.h>
#include <CGAL/Quad_mesh_adaptation/internal/ideal_count.h>
#include <CGAL/Quad_mesh_adaptation/internal/measure_complex.h>
#include <CGAL/Quad_mesh_adaptation/internal/measure_quality.h>
#include <CGAL/Quad_mesh_adaptation/internal/measure_sizes.h>
#include <CGAL/Quad_mesh_adaptation/internal/measure_topology.h>

#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// All figures of a quad mesh given as arrays, in time linear in its size.  Points that no quad
// uses are ignored.  Sizes are taken as they come: a caller who doubts them checks in `size`,
// whose exceptions pass through.  The ideal number of faces is integrated over
// `reference_triangles`, or over the mesh itself without them.  `max_distance_to_reference` is
// left at 0.  Strict size ratios that are known, one for each quad, need not be worked out again;
// nor need what is kept of the quads, nor how they are linked.
// Preconditions: indices are in range; the mesh may be non-manifold.
inline Mesh_measures measure(const std::vector<Vec>& points, const std::vector<Quad>& quads,
                             const Size_function& size,
                             const std::vector<Triangle>* reference_triangles = nullptr,
                             const std::vector<double>* strict_ratios = nullptr,
                             Kept_sizes* kept = nullptr, const Quad_complex* links = nullptr)
{
  Mesh_measures m;
  if(links)
    measure_topology(*links, m);
  else
    measure_topology(points.size(), quads, m);
  if(quads.empty()) return m;
  measure_quality(points, quads, m);
  measure_sizes(points, quads, size, strict_ratios, kept, m);
  m.ideal_number_of_faces = reference_triangles ? ideal_number_of_faces(*reference_triangles, size)
                            : kept ? ideal_number_of_faces(Kept_halves(points, quads, *kept), size)
                                   : ideal_number_of_faces(Quad_halves(points, quads), size);
  m.efficiency = m.ideal_number_of_faces / double(quads.size());
  return m;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_H
