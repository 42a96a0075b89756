// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_BORDER_HALF_RING_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_BORDER_HALF_RING_H

#include <CGAL/Quad_mesh_adaptation/internal/closed_curves.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/merge_nodes.h>
#include <CGAL/Quad_mesh_adaptation/internal/split_templates.h>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The two faces at a border node v and their corners: left = (a, v, m, p), right = (v, c, q, m),
// with a and c the neighbours of v along the border.
struct Border_pair
{
  Index v, a, c, m, p, q;
  Index left, right; // half-edges a -> v and v -> c
};

inline bool find_border_pair(const Quad_complex& mesh, Index v, Border_pair& b)
{
  const Vertex_record& r = mesh.vertex(v);
  if(r.faces != 2 || r.carrier != Carrier::curve || r.frozen || !mesh.is_border_vertex(v))
    return false;
  b.v = v;
  b.right = r.halfedge;
  b.left = mesh.prev(mesh.turn_left(b.right));
  b.a = mesh.origin(b.left);
  b.c = mesh.target(b.right);
  b.m = mesh.origin(mesh.prev(b.right));
  b.q = mesh.target(mesh.next(b.right));
  b.p = mesh.origin(mesh.prev(b.left));
  return mesh.is_border(b.left);
}

// Half-ring collapse about border node v: the path through its two faces that starts and ends on
// the border closes; a, v, c and m become one node.  F - 2, two border edges fewer.
inline bool is_half_ring_collapse_allowed(const Adaptation_state& s, const Border_pair& b)
{
  const Quad_complex& mesh = s.mesh;
  const Feature_curve& curve = s.curves[mesh.vertex(b.v).curve];
  const Vertex_record &a = mesh.vertex(b.a), &c = mesh.vertex(b.c), &m = mesh.vertex(b.m);
  if(curve.is_frozen() || m.carrier != Carrier::surface || m.frozen) return false;
  if(mesh.curve(b.left) != mesh.curve(b.right) || b.a == b.c) return false;
  if(carrier_rank(a) > 1 && carrier_rank(c) > 1) return false; // the curve would vanish
  if(mesh.curve(mesh.prev(b.right)) >= 0) return false;
  Closed_curve_check closed_curves(s);
  closed_curves.add(mesh.curve(b.left), { b.a, b.v, b.c });
  return closed_curves();
}

inline void describe_half_ring_collapse(Adaptation_state& s, const Border_pair& b, Cavity& cavity)
{
  const Quad_complex& mesh = s.mesh;
  const int ra = carrier_rank(mesh.vertex(b.a)), rc = carrier_rank(mesh.vertex(b.c));
  const Index keep = ra > 1 ? b.a : rc > 1 ? b.c : b.v;
  std::vector<Node_merge> merges;
  for(Index u : { b.a, b.v, b.c, b.m })
    if(u != keep) merges.push_back({ u, keep });
  cavity.clear();
  describe_merge(s, merges, { mesh.face(b.left), mesh.face(b.right) }, cavity);
}

// The reverse need not fit, so the border is refined by a split along the same path: both border
// edges at v and the edge from v inwards are cut, both faces by the 3-quad template.  F + 4, two
// border edges more.
inline bool is_border_split_allowed(const Adaptation_state& s, const Border_pair& b)
{
  return !s.curves[s.mesh.vertex(b.v).curve].is_frozen() &&
         s.mesh.curve(b.left) == s.mesh.curve(b.right) && s.mesh.curve(s.mesh.prev(b.right)) < 0;
}

inline void describe_border_split(Adaptation_state& s, const Border_pair& b, Cavity& cavity)
{
  const Quad_complex& m = s.mesh;
  cavity.clear();
  cavity.add_old_face(m.face(b.left));
  cavity.add_old_face(m.face(b.right));
  const auto node = [&](Index v) { return cavity.node(v); };
  const Index hl = b.left, hr = b.right, curve = m.curve(hl);
  const int n1 = cavity.add_new_node(edge_middle(s, hl)),
            n2 = cavity.add_new_node(edge_middle(s, hr));
  const int w = cavity.add_new_node(edge_middle(s, m.next(hl)));
  const int c1 =
      cavity.add_new_node(inner_node(s, m.vertex(b.v), m.vertex(b.p), 0.45, m.face(b.left)));
  const int c2 =
      cavity.add_new_node(inner_node(s, m.vertex(b.v), m.vertex(b.q), 0.45, m.face(b.right)));
  const Index lmp = m.curve(m.next(m.next(hl))), lpa = m.curve(m.prev(hl));
  const Index rcq = m.curve(m.next(hr)), rqm = m.curve(m.next(m.next(hr)));
  const Index fl = m.face(hl), fr = m.face(hr);
  cavity.add_quad(node(b.v), w, c1, n1, { -1, -1, -1, curve }, fl);
  cavity.add_quad(w, node(b.m), node(b.p), c1, { -1, lmp, -1, -1 }, fl);
  cavity.add_quad(n1, c1, node(b.p), node(b.a), { -1, -1, lpa, curve }, fl);
  cavity.add_quad(node(b.v), n2, c2, w, { curve, -1, -1, -1 }, fr);
  cavity.add_quad(n2, node(b.c), node(b.q), c2, { curve, rcq, -1, -1 }, fr);
  cavity.add_quad(w, c2, node(b.q), node(b.m), { -1, -1, rqm, -1 }, fr);
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_BORDER_HALF_RING_H
