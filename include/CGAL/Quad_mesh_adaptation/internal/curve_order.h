// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CURVE_ORDER_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CURVE_ORDER_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>

#include <array>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The neighbours on curve c of its node v, which is no corner; -1 where there is none.
inline std::array<Index, 2> curve_neighbours(const Quad_complex& m, Index v, Index c)
{
  std::array<Index, 2> found = { -1, -1 };
  int n = 0;
  const Index start = m.vertex(v).halfedge;
  Index h = start, last = h;
  do {
    if(m.curve(h) == c && n < 2) found[n++] = m.target(h);
    last = h;
    h = m.turn_left(h);
  } while(h >= 0 && h != start);
  if(h < 0 && n < 2 && m.curve(m.prev(last)) == c) found[n] = m.origin(m.prev(last));
  return found;
}

// Is node r of curve c between two others on that curve?  `u` and `w` are their vertices, -1 for
// one that is none yet.  A node that slides past its neighbour folds the curve over, which need
// not turn any face.
inline bool is_between(const Feature_curve& c, const Vertex_record& r, Index u,
                       const Vertex_record& a, Index w, const Vertex_record& b)
{
  if(!c.is_closed() && c.first_corner == c.last_corner) // an end may stand for either arc length
    if(a.carrier != Carrier::curve || b.carrier != Carrier::curve) return true;
  const auto place = [&](Index v, const Vertex_record& x) {
    return x.carrier == Carrier::curve ? x.param : v == c.first_corner ? 0. : c.length();
  };
  return c.difference(r.param, place(u, a)) * c.difference(r.param, place(w, b)) < 0;
}

inline bool is_between_neighbours(const Adaptation_state& s, Index v)
{
  const Vertex_record& r = s.mesh.vertex(v);
  if(r.carrier != Carrier::curve) return true;
  const std::array<Index, 2> n = curve_neighbours(s.mesh, v, r.curve);
  if(n[0] < 0 || n[1] < 0) return true;
  return is_between(s.curves[r.curve], r, n[0], s.mesh.vertex(n[0]), n[1], s.mesh.vertex(n[1]));
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CURVE_ORDER_H
