// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_NODES_AROUND_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_NODES_AROUND_H

#include <CGAL/Quad_mesh_adaptation/internal/Quad_complex.h>

#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// So many rings of faces about those that there is work on are worked on.
constexpr int rings_to_work_on = 8;

// Marks the nodes of the given faces and of `rings` rings of faces around them; those that are
// marked already stop it.
inline void mark_nodes_around(const Quad_complex& m, const std::vector<Index>& faces, int rings,
                              std::vector<char>& marked)
{
  std::vector<Index> front;
  const auto reach = [&](Index v) {
    if(marked[v]) return;
    marked[v] = 1;
    front.push_back(v);
  };
  for(Index f : faces)
    for(Index v : m.quad(f)) reach(v);
  for(int ring = 0; ring < rings && !front.empty(); ++ring) {
    std::vector<Index> now;
    now.swap(front);
    for(Index v : now)
      for(Index h : m.outgoing(v))
        for(Index u : m.quad(m.face(h))) reach(u);
  }
}

// The same as a list of marks by node.
inline std::vector<char> nodes_around(const Quad_complex& m, const std::vector<Index>& faces,
                                      int rings)
{
  std::vector<char> marked(m.vertex_end(), 0);
  mark_nodes_around(m, faces, rings, marked);
  return marked;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_NODES_AROUND_H
