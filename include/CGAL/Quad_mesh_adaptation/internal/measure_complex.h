// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_COMPLEX_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_COMPLEX_H

#include <CGAL/Quad_mesh_adaptation/Mesh_measures.h>
#include <CGAL/Quad_mesh_adaptation/internal/Face_parts.h>
#include <CGAL/Quad_mesh_adaptation/internal/Quad_complex.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Closed ways along the border, of which all vertices are given.
inline std::size_t number_of_border_loops(const Quad_complex& m, const std::vector<Index>& border)
{
  std::size_t n = 0;
  std::vector<char> seen(m.vertex_end(), 0);
  for(Index v : border) {
    if(seen[v]) continue;
    ++n;
    for(Index u = v; !seen[u]; u = m.target(m.vertex(u).halfedge)) seen[u] = 1;
  }
  return n;
}

// Counts and valences, as measure_topology() finds them without links.
inline void measure_topology(const Quad_complex& c, Mesh_measures& m)
{
  std::vector<std::size_t> inside; // vertices by valence
  std::vector<Index> border;
  for(Index v : c.vertices()) {
    ++m.vertices;
    const std::size_t valence = std::size_t(c.valence(v));
    m.max_valence = (std::max)(m.max_valence, valence);
    if(c.is_border_vertex(v)) {
      ++m.boundary_edges; // the one that starts here
      border.push_back(v);
      continue;
    }
    ++m.interior_vertices;
    if(valence >= inside.size()) inside.resize(valence + 1, 0);
    ++inside[valence];
    if(valence != 4) ++m.irregular_interior_vertices;
  }
  for(std::size_t k = 0; k < inside.size(); ++k)
    if(inside[k] > 0) m.interior_valence[k] = inside[k];
  m.faces = std::size_t(c.number_of_faces());
  m.edges = (4 * m.faces + m.boundary_edges) / 2;
  m.euler_characteristic = long(m.vertices) - long(m.edges) + long(m.faces);
  m.components = Face_parts(c, [](Index) { return true; }).size();
  m.boundary_loops = number_of_border_loops(c, border);
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_COMPLEX_H
