// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_EDGE_SWAP_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_EDGE_SWAP_H

#include <CGAL/Quad_mesh_adaptation/internal/Cavity.h>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Edge swap: the edge of h, inside the hexagon of its two faces, is turned by one corner,
// counter-clockwise or clockwise.  Its ends lose an edge, the new ends gain one.
inline bool is_edge_swap_allowed(const Adaptation_state& s, Index h)
{
  return s.mesh.opposite(h) >= 0 && s.mesh.curve(h) < 0;
}

inline void describe_edge_swap(Adaptation_state& s, Index h, bool counter_clockwise, Cavity& cavity)
{
  const Quad_complex& m = s.mesh;
  const Index o = m.opposite(h);
  // hexagon, counter-clockwise from the target of h, with the half-edge leaving each corner
  const Index side[6] = { m.next(h), m.next(m.next(h)), m.prev(h),
                          m.next(o), m.next(m.next(o)), m.prev(o) };
  cavity.clear();
  cavity.add_old_face(m.face(h));
  cavity.add_old_face(m.face(o));
  int v[6];
  Index c[6];
  for(int i = 0; i < 6; ++i) {
    v[i] = cavity.node(m.origin(side[i]));
    c[i] = m.curve(side[i]);
  }
  // from corner k to corner k + 3; the old edge has k = 0
  const int k = counter_clockwise ? 1 : 2;
  const auto at = [&](int i) { return (k + i) % 6; };
  cavity.add_quad(v[at(0)], v[at(1)], v[at(2)], v[at(3)], { c[at(0)], c[at(1)], c[at(2)], -1 },
                  m.face(h));
  cavity.add_quad(v[at(3)], v[at(4)], v[at(5)], v[at(0)], { c[at(3)], c[at(4)], c[at(5)], -1 },
                  m.face(o));
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_EDGE_SWAP_H
