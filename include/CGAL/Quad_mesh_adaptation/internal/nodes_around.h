// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_NODES_AROUND_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_NODES_AROUND_H

#include <CGAL/Quad_mesh_adaptation/internal/Quad_complex.h>

#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Nodes of the given faces and `rings` rings of faces around them.
inline std::vector<char> nodes_around(const Quad_complex& m, const std::vector<Index>& faces,
                                      int rings)
{
  std::vector<char> in(m.vertex_end(), 0);
  std::vector<Index> front;
  const auto reach = [&](Index v) {
    if(in[v]) return;
    in[v] = 1;
    front.push_back(v);
  };
  for(Index f : faces)
    for(Index v : m.quad(f)) reach(v);
  std::vector<Index> out;
  for(int ring = 0; ring < rings && !front.empty(); ++ring) {
    std::vector<Index> now;
    now.swap(front);
    for(Index v : now) {
      m.outgoing(v, out);
      for(Index h : out)
        for(Index u : m.quad(m.face(h))) reach(u);
    }
  }
  return in;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_NODES_AROUND_H
