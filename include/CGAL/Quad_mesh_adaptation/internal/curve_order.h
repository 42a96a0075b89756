// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CURVE_ORDER_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CURVE_ORDER_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The neighbours on curve c of its node v, which is no corner; -1 where there is none.
inline std::array<Index, 2> curve_neighbours(const Quad_complex& m, Index v, Index c)
{
  std::array<Index, 2> found = { -1, -1 };
  int n = 0;
  Index last = -1;
  for(Index h : m.outgoing(v)) {
    if(m.curve(h) == c && n < 2) found[n++] = m.target(h);
    last = m.prev(h);
  }
  if(m.is_border(last) && n < 2 && m.curve(last) == c) found[n] = m.origin(last);
  return found;
}

// A node that slides past its neighbour on a curve folds the curve over, which need not turn any
// face.  So two neighbours at arc lengths u and v must keep the order they had at u_before and
// v_before; on a closed curve that also keeps every edge shorter than half of it.
inline bool is_order_kept(const Feature_curve& c, double u_before, double v_before, double u,
                          double v)
{
  return c.difference(u_before, v_before) * c.difference(u, v) > 0;
}

// A node pushed against the corner at the end of its curve would stop right on it, and an edge
// without length is nothing that another move or a later call can mend.
inline bool is_clear_of_ends(const Feature_curve& c, double before, double now)
{
  if(c.is_closed()) return true;
  const double gap = (std::min)(now, c.length() - now);
  return gap > 0.1 * (std::min)(before, c.length() - before);
}

// The same for vertex v, which has moved from `before`, and its neighbours.
inline bool is_order_kept(const Adaptation_state& s, Index v, const Vertex_record& before)
{
  if(before.carrier != Carrier::curve) return true;
  const Feature_curve& c = s.curves[before.curve];
  const double here = s.mesh.vertex(v).param;
  if(!is_clear_of_ends(c, before.param, here)) return false;
  for(Index n : curve_neighbours(s.mesh, v, before.curve)) {
    if(n < 0 || s.mesh.vertex(n).carrier != Carrier::curve) continue; // none passes a corner
    const double there = s.mesh.vertex(n).param;
    if(!is_order_kept(c, before.param, there, here, there)) return false;
  }
  return true;
}

// Arc lengths of origin and target of h on its curve.
inline void ends_on_curve(const Adaptation_state& s, Index h, double& su, double& sv)
{
  const Index curve = s.mesh.curve(h);
  const Feature_curve& c = s.curves[curve];
  const Index u = s.mesh.origin(h), v = s.mesh.target(h);
  // corner w, next to x: on a loop it stands for both ends of the curve, and the way the curve
  // goes on beyond x tells for which
  const auto corner = [&](Index w, Index x) {
    if(c.first_corner != c.last_corner) return w == c.first_corner ? 0. : c.length();
    const Vertex_record& node = s.mesh.vertex(x);
    for(Index y : curve_neighbours(s.mesh, x, curve))
      if(y >= 0 && y != w) return s.mesh.vertex(y).param > node.param ? 0. : c.length();
    return 0.;
  };
  const auto arc = [&](Index w, Index x) {
    const Vertex_record& r = s.mesh.vertex(w);
    return r.carrier == Carrier::curve ? r.param : corner(w, x);
  };
  su = arc(u, v);
  sv = arc(v, u);
}

// Calls f(offset from s) for the points of the polyline between s and s + l.
template <typename F>
void for_each_arc(const Feature_curve& c, double s, double l, const F& f)
{
  const std::vector<double>& arcs = c.arcs();
  const double low = c.wrapped(l < 0 ? s + l : s), span = std::abs(l);
  std::size_t i = std::size_t(std::upper_bound(arcs.begin(), arcs.end(), low) - arcs.begin());
  for(std::size_t seen = 0; seen < arcs.size(); ++seen, ++i) {
    if(i == arcs.size()) {
      if(!c.is_closed()) return;
      i = 0;
    }
    double up = arcs[i] - low;
    if(up < 0) up += c.length();
    if(up >= span) return;
    f(l < 0 ? up + l : up);
  }
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CURVE_ORDER_H
