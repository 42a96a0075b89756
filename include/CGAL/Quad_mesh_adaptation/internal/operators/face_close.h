// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_CLOSE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_CLOSE_H

#include <CGAL/Quad_mesh_adaptation/internal/operators/merge_nodes.h>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Face close (diagonal collapse): the face of h disappears, origin(h) and the corner opposite
// become one.  F - 1, V - 1; the two other corners lose an edge.
inline bool is_face_close_allowed(const Adaptation_state& s, Index h)
{
  const Quad_complex& m = s.mesh;
  const Vertex_record& a = m.vertex(m.origin(h));
  const Vertex_record& c = m.vertex(m.target(m.next(h)));
  if(carrier_rank(a) > 0 && carrier_rank(c) > 0) return false; // would pinch a curve
  // two sides of the face that are zipped together must not both be curves
  const Index n = Quad_complex::next(h), nn = Quad_complex::next(n), p = Quad_complex::prev(h);
  return !(m.curve(h) >= 0 && m.curve(n) >= 0) && !(m.curve(nn) >= 0 && m.curve(p) >= 0);
}

inline void describe_face_close(Adaptation_state& s, Index h, Cavity& cavity)
{
  const Quad_complex& m = s.mesh;
  Index a = m.origin(h), c = m.target(m.next(h));
  if(carrier_rank(m.vertex(a)) < carrier_rank(m.vertex(c))) std::swap(a, c);
  cavity.clear();
  describe_merge(s, { { c, a } }, { m.face(h) }, cavity);
  Vertex_record& w = cavity.nodes[cavity.node(a)];
  if(w.carrier == Carrier::surface && !w.frozen) {
    w.p = 0.5 * (w.p + m.point(c));
    w.floor = 0.5 * (w.floor + m.vertex(c).floor);
    s.place(w);
  }
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_CLOSE_H
