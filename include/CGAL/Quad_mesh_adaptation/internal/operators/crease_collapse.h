// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CREASE_COLLAPSE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CREASE_COLLAPSE_H

#include <CGAL/Quad_mesh_adaptation/internal/closed_curves.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/merge_nodes.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The faces at node v inside a crease. On either side they lie between the outgoing half-edges
// spokes[0], along the crease, ..., spokes[k], along the crease again, counter-clockwise.
struct Crease_star
{
  Index v;
  std::array<std::vector<Index>, 2> spokes;

  Index first(const Quad_complex& m) const { return m.target(spokes[0].front()); }
  Index last(const Quad_complex& m) const { return m.target(spokes[0].back()); }
};

inline bool find_crease_star(const Quad_complex& m, Index v, Crease_star& star)
{
  const Vertex_record& r = m.vertex(v);
  if(r.carrier != Carrier::curve || r.frozen || m.is_border_vertex(v)) return false;
  Index h = r.halfedge;
  while(m.curve(h) < 0) {
    h = m.turn_left(h);
    if(h == r.halfedge) return false;
  }
  star.v = v;
  for(std::vector<Index>& side : star.spokes) {
    side.assign(1, h);
    do {
      h = m.turn_left(h);
      side.push_back(h);
    } while(m.curve(h) < 0);
  }
  return h == star.spokes[0].front();
}

// Crease collapse about v: its two crease edges vanish, and v and its neighbours along the crease
// become one node; on either side the k faces at v become the k - 1 of a fan about that node.
// F - 2, V - 2, two crease edges fewer.  Without it creases inside a surface could lose edges by
// whole chords only.
inline bool is_crease_collapse_allowed(const Adaptation_state& s, const Crease_star& star)
{
  const Quad_complex& m = s.mesh;
  const Index a = star.first(m), c = star.last(m);
  const Index curve = m.curve(star.spokes[0].front());
  if(curve != m.curve(star.spokes[0].back()) || s.curves[curve].is_frozen() || a == c) return false;
  if(carrier_rank(m.vertex(a)) > 1 && carrier_rank(m.vertex(c)) > 1) return false; // would vanish
  Closed_curve_check closed_curves(s);
  closed_curves.add(curve, { a, star.v, c });
  return closed_curves();
}

// The one of the three nodes that stays.
inline Index kept_node(const Quad_complex& m, const Crease_star& star)
{
  const Index a = star.first(m), c = star.last(m);
  return carrier_rank(m.vertex(a)) > 1 ? a : carrier_rank(m.vertex(c)) > 1 ? c : star.v;
}

inline void describe_crease_collapse(Adaptation_state& s, const Crease_star& star, Cavity& cavity)
{
  const Quad_complex& m = s.mesh;
  const Index keep = kept_node(m, star), a = star.first(m), c = star.last(m);
  cavity.clear();
  cavity.add_old_star(star.v);
  const std::size_t at_v = cavity.old_faces.size();
  cavity.add_old_star(a);
  cavity.add_old_star(c);
  const int w = cavity.node(keep);
  for(std::size_t i = at_v; i < cavity.old_faces.size(); ++i) {
    Cavity_quad q = cavity.copy_of(cavity.old_faces[i]);
    for(int& n : q.v)
      if(n == cavity.node(a) || n == cavity.node(c)) n = w;
    cavity.quads.push_back(q);
  }
  for(const std::vector<Index>& side : star.spokes)
    for(std::size_t i = 1; i + 1 < side.size(); ++i) {
      // the face before the spoke and the one behind it share its end
      const Index before = m.next(m.next(side[i - 1])), behind = m.next(side[i]);
      const bool is_first = i == 1, is_last = i + 2 == side.size();
      cavity.add_quad(w, cavity.node(m.origin(before)), cavity.node(m.origin(behind)),
                      cavity.node(m.target(behind)),
                      { is_first ? m.curve(m.next(side[i - 1])) : -1, m.curve(before),
                        m.curve(behind), is_last ? m.curve(m.next(behind)) : -1 },
                      m.face(side[i]));
    }
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CREASE_COLLAPSE_H
