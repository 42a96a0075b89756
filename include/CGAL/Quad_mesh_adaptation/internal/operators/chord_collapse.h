// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHORD_COLLAPSE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHORD_COLLAPSE_H

#include <CGAL/Quad_mesh_adaptation/internal/Chord.h>
#include <CGAL/Quad_mesh_adaptation/internal/closed_curves.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/merge_nodes.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// May the two ends of the edge of h become one?  Corners and frozen nodes never meet; nodes of
// curves only along the curve they share; see also Closed_curve_check.
inline bool is_rung_collapsible(const Adaptation_state& s, Index h)
{
  const Quad_complex& m = s.mesh;
  const Vertex_record &a = m.vertex(m.origin(h)), &b = m.vertex(m.target(h));
  const int ra = carrier_rank(a), rb = carrier_rank(b);
  if(ra >= 2 && rb >= 2) return false;
  if(ra >= 1 && rb >= 1) {
    const Index c = m.curve(h);
    return c >= 0 && !s.curves[c].is_frozen();
  }
  return true;
}

// Chord collapse: the ends of every rung become one, the quads of the chord disappear.  An open
// chord of n quads: F - n, V - n - 1, two border edges fewer; a closed one: F - n, V - n.
inline bool is_chord_collapse_allowed(const Adaptation_state& s, const Chord& c)
{
  const Quad_complex& m = s.mesh;
  std::vector<Index> ends, faces = c.faces;
  Closed_curve_check closed_curves(s);
  for(Index h : c.rungs) {
    if(!is_rung_collapsible(s, h)) return false;
    closed_curves.add(m.curve(h), { m.origin(h), m.target(h) });
    ends.push_back(m.origin(h));
    ends.push_back(m.target(h));
  }
  // neither crosses nor touches itself
  std::sort(faces.begin(), faces.end());
  std::sort(ends.begin(), ends.end());
  return std::adjacent_find(faces.begin(), faces.end()) == faces.end() &&
         std::adjacent_find(ends.begin(), ends.end()) == ends.end() &&
         Index(c.faces.size()) < m.number_of_faces() && closed_curves();
}

inline void describe_chord_collapse(Adaptation_state& s, const Chord& c, Cavity& cavity)
{
  const Quad_complex& m = s.mesh;
  std::vector<Node_merge> merges;
  for(Index h : c.rungs) {
    const Index a = m.origin(h), b = m.target(h);
    const bool a_wins = carrier_rank(m.vertex(a)) >= carrier_rank(m.vertex(b));
    merges.push_back({ a_wins ? b : a, a_wins ? a : b });
  }
  cavity.clear();
  describe_merge(s, merges, c.faces, cavity);
  for(const Node_merge& g : merges) {
    Vertex_record& w = cavity.nodes[cavity.node(g.winner)];
    const Vertex_record& l = m.vertex(g.loser);
    if(w.frozen || carrier_rank(w) != carrier_rank(l)) continue;
    if(w.carrier == Carrier::curve)
      w.param += 0.5 * s.curves[w.curve].difference(w.param, l.param);
    else
      w.p = 0.5 * (w.p + l.p);
    s.place(w);
  }
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHORD_COLLAPSE_H
