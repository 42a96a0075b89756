// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_VERTEX_ROTATION_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_VERTEX_ROTATION_H

#include <CGAL/Quad_mesh_adaptation/internal/Cavity.h>
#include <CGAL/Quad_mesh_adaptation/internal/huge_nodes.h>

#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Vertex rotation: the edges of inner node v to its neighbours are replaced by edges to the
// corners opposite it.  Neighbours lose an edge, the opposite corners gain one.  At a huge node it
// would do no good and cost much.
inline bool is_vertex_rotation_allowed(const Adaptation_state& s, Index v)
{
  const Quad_complex& m = s.mesh;
  if(m.is_border_vertex(v) || m.vertex(v).carrier != Carrier::surface) return false;
  if(is_huge(m, v)) return false;
  for(Index h : m.outgoing(v))
    if(m.curve(h) >= 0) return false;
  return true;
}

inline void describe_vertex_rotation(Adaptation_state& s, Index v, Cavity& cavity)
{
  const Quad_complex& m = s.mesh;
  cavity.clear();
  cavity.add_old_star(v);
  std::vector<Index> out;
  m.outgoing(v, out);
  const int lv = cavity.node(v);
  for(std::size_t i = 0; i < out.size(); ++i) {
    const Index h = out[i], g = out[(i + 1) % out.size()]; // faces left of h and of g share g
    const Index b = m.next(h), d = m.next(m.next(h)), e = m.next(g);
    cavity.add_quad(lv, cavity.node(m.target(b)), cavity.node(m.target(g)),
                    cavity.node(m.target(e)), { -1, m.curve(d), m.curve(e), -1 }, m.face(h));
  }
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_VERTEX_ROTATION_H
