// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_TOPOLOGY_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_TOPOLOGY_H

#include <CGAL/Quad_mesh_adaptation/Mesh_measures.h>
#include <CGAL/Quad_mesh_adaptation/internal/Disjoint_sets.h>
#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

struct Mesh_edge
{
  Index low, high; // end vertices, low <= high
  int faces;       // number of face sides on it: 1 on the boundary, 2 inside
};

// All edges, grouped by their lower vertex (bucket sort: linear in the number of faces).
inline std::vector<Mesh_edge> mesh_edges(std::size_t number_of_points,
                                         const std::vector<Quad>& quads)
{
  std::vector<std::size_t> first(number_of_points + 1, 0);
  for(const Quad& q : quads)
    for(int i = 0; i < 4; ++i) ++first[(std::min)(q[i], q[(i + 1) % 4]) + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());

  std::vector<Index> upper(first.back());
  std::vector<std::size_t> free_slot(first.begin(), first.end() - 1);
  for(const Quad& q : quads)
    for(int i = 0; i < 4; ++i) {
      const Index a = q[i], b = q[(i + 1) % 4];
      upper[free_slot[(std::min)(a, b)]++] = (std::max)(a, b);
    }

  std::vector<Mesh_edge> edges;
  edges.reserve(quads.size() * 2 + number_of_points / 8);
  for(std::size_t v = 0; v < number_of_points; ++v) {
    std::sort(upper.begin() + first[v], upper.begin() + first[v + 1]);
    for(std::size_t i = first[v]; i < first[v + 1];) {
      std::size_t j = i;
      while(j < first[v + 1] && upper[j] == upper[i]) ++j;
      edges.push_back({ Index(v), upper[i], int(j - i) });
      i = j;
    }
  }
  return edges;
}

// Number of connected components of the graph with the given edges.
template <class EdgeFilter>
std::size_t count_components(std::size_t number_of_points, const std::vector<Mesh_edge>& edges,
                             EdgeFilter belongs)
{
  Disjoint_sets sets(number_of_points);
  std::vector<char> used(number_of_points, 0);
  for(const Mesh_edge& e : edges)
    if(belongs(e)) {
      sets.unite(e.low, e.high);
      used[e.low] = used[e.high] = 1;
    }
  std::size_t n = 0;
  for(std::size_t v = 0; v < number_of_points; ++v)
    if(used[v] && sets.find(Index(v)) == Index(v)) ++n;
  return n;
}

// Counts, components, boundary loops (connected parts of the boundary graph) and valences.
inline void measure_topology(std::size_t number_of_points, const std::vector<Quad>& quads,
                             Mesh_measures& m)
{
  const std::vector<Mesh_edge> edges = mesh_edges(number_of_points, quads);
  std::vector<Index> valence(number_of_points, 0);
  std::vector<char> on_boundary(number_of_points, 0);
  for(const Mesh_edge& e : edges) {
    ++valence[e.low];
    ++valence[e.high];
    if(e.faces == 1) {
      ++m.boundary_edges;
      on_boundary[e.low] = on_boundary[e.high] = 1;
    }
  }
  std::vector<std::size_t> inside; // by valence
  for(std::size_t v = 0; v < number_of_points; ++v) {
    if(valence[v] == 0) continue;
    ++m.vertices;
    m.max_valence = (std::max)(m.max_valence, std::size_t(valence[v]));
    if(on_boundary[v]) continue;
    ++m.interior_vertices;
    if(std::size_t(valence[v]) >= inside.size()) inside.resize(std::size_t(valence[v]) + 1, 0);
    ++inside[valence[v]];
    if(valence[v] != 4) ++m.irregular_interior_vertices;
  }
  for(std::size_t k = 0; k < inside.size(); ++k)
    if(inside[k] > 0) m.interior_valence[k] = inside[k];
  m.edges = edges.size();
  m.faces = quads.size();
  m.euler_characteristic = long(m.vertices) - long(m.edges) + long(m.faces);
  m.components = count_components(number_of_points, edges, [](const Mesh_edge&) { return true; });
  m.boundary_loops =
      count_components(number_of_points, edges, [](const Mesh_edge& e) { return e.faces == 1; });
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_TOPOLOGY_H
