// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_STATE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_STATE_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/Distance_measure.h>
#include <CGAL/Quad_mesh_adaptation/internal/Input_mesh.h>
#include <CGAL/Quad_mesh_adaptation/internal/measure_complex.h>
#include <CGAL/Quad_mesh_adaptation/internal/measure_faces.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

inline std::vector<Triangle> corner_points(const Triangle_soup& soup)
{
  std::vector<Triangle> list;
  list.reserve(soup.triangles.size());
  for(const auto& t : soup.triangles)
    list.push_back({ soup.points[t[0]], soup.points[t[1]], soup.points[t[2]] });
  return list;
}

// How far nodes are from where they belong.
inline double largest_distance_of_nodes(const Adaptation_state& s)
{
  double far = 0;
  for(Index v : s.mesh.vertices()) {
    if(s.is_own_vertex(v)) continue;
    Vertex_record r = s.mesh.vertex(v);
    s.put_on_carrier(r);
    far = (std::max)(far, distance(s.mesh.point(v), r.p));
  }
  return far;
}

inline void measure_faces_of(const Adaptation_state& s, const std::vector<Triangle>* reference,
                             Figures_of_faces& figures, Mesh_measures& m)
{
  figures.look_at(s.mesh);
  const bool is_strict = s.size.sampling == Size_sampling::strict;
  const auto size = [&s](const Vec& p) { return s.size.unscaled(p); };
  const auto corners_of = [&](std::size_t k) { return s.corners(figures.face(k)); };
  // strict ratios are asked for before and after this, too
  const auto strict = [&](std::size_t k, double length, const Face_sizes& sizes) {
    return is_strict ? s.size_ratio(figures.face(k), length, sizes) * s.size.scale()
                     : length / sizes.strict();
  };
  const auto known_strict = [&](std::size_t k) {
    if(is_strict) return s.size_ratio(figures.face(k)) * s.size.scale();
    const Corners p = corners_of(k);
    return mean_edge_length(p) / sizes_of_face(p, size).strict();
  };
  measure_faces(corners_of, size, strict, known_strict, reference, figures, m);
}

// What is kept of faces of the input is used, and kept if it is not yet.
inline Mesh_measures measure_state(const Adaptation_state& s,
                                   const std::optional<Triangle_soup>& reference,
                                   Figures_of_faces* kept = nullptr)
{
  Mesh_measures m;
  measure_topology(s.mesh, m);
  {
    std::optional<std::vector<Triangle>> triangles;
    if(reference) triangles = corner_points(*reference);
    Figures_of_faces figures;
    measure_faces_of(s, triangles ? &*triangles : nullptr, kept ? *kept : figures, m);
  } // distances need the memory
  m.max_distance_to_reference = largest_distance_of_nodes(s);
  const Distance_measure distances(s, Distance_measure::only_largest,
                                   kept ? kept->farthest : std::nullopt);
  if(kept && !kept->farthest) kept->farthest = distances.farthest_own();
  m.mesh_to_reference = distances.to_reference();
  m.reference_to_mesh = distances.from_reference();
  return m;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_STATE_H
