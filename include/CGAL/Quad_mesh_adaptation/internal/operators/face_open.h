// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_OPEN_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_OPEN_H

#include <CGAL/Quad_mesh_adaptation/internal/Cavity.h>

#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Face open (node split, reverse of face close): node v is split along two of its edges, from
// outgoing half-edge ha counter-clockwise to hb; the edges strictly between go to the new node.
// F + 1, V + 1; targets of ha and hb gain an edge.
inline bool is_face_open_allowed(const Adaptation_state& s, Index ha, Index hb)
{
  const Quad_complex& m = s.mesh;
  if(ha == hb || m.origin(ha) != m.origin(hb)) return false;
  int between = 0;
  for(Index h = m.turn_left(ha); h != hb; h = m.turn_left(h), ++between)
    if(h < 0 || h == ha || m.curve(h) >= 0) return false;
  return between >= 1;
}

// The faces at a node from outgoing half-edge `from` counter-clockwise to `to`, or to the border,
// and the sum of their corners opposite the node.
struct Face_sector
{
  std::vector<Index> faces;
  Vec corners = Vec(0, 0, 0);

  Face_sector(const Quad_complex& m, Index from, Index to)
  {
    for(Index h = from; h >= 0 && h != to; h = m.turn_left(h)) {
      faces.push_back(m.face(h));
      corners = corners + m.point(m.target(m.next(h)));
    }
  }

  // From p towards the middle of the corners.
  Vec step_into(const Vec& p, double step) const
  {
    return (1 - step) * p + (step / double(faces.size())) * corners;
  }
};

// A node is split into `old`, as which it comes, and the one that is returned.  Both step back from
// the new face, so that it is open from the start.
inline Vertex_record split_node(const Adaptation_state& s, const Face_sector& ahead,
                                const Face_sector& behind, Vertex_record& old)
{
  Vertex_record fresh = old;
  fresh.carrier = Carrier::surface;
  fresh.curve = -1;
  fresh.frozen = false;
  fresh.ideal_faces = 4;
  const bool both = old.carrier == Carrier::surface && !old.frozen && !behind.faces.empty();
  const double step = both ? 0.3 : 0.4;
  fresh.p = ahead.step_into(fresh.p, step);
  fresh.hint = s.triangle_near(ahead.faces[0], fresh.p);
  s.place(fresh);
  if(both) {
    old.p = behind.step_into(old.p, step);
    s.place(old);
  }
  return fresh;
}

inline void describe_face_open(Adaptation_state& s, Index ha, Index hb, Cavity& cavity)
{
  const Quad_complex& m = s.mesh;
  const Index v = m.origin(ha);
  cavity.clear();
  cavity.add_old_star(v);
  const int lv = cavity.node(v), la = cavity.node(m.target(ha)), lb = cavity.node(m.target(hb));
  const Face_sector ahead(m, ha, hb), behind(m, hb, ha); // the former takes the new node
  const int lw = cavity.add_new_node(split_node(s, ahead, behind, cavity.nodes[lv]));
  const std::vector<Index> faces = cavity.old_faces;
  for(Index f : faces) {
    Cavity_quad q = cavity.copy_of(f);
    if(std::find(ahead.faces.begin(), ahead.faces.end(), f) != ahead.faces.end())
      for(int k = 0; k < 4; ++k)
        if(q.v[k] == lv) {
          q.v[k] = lw;
          q.curve[k] = q.curve[(k + 3) & 3] = -1; // curves stay with v
        }
    cavity.quads.push_back(q);
  }
  const Index ca = m.curve(ha), cb = m.curve(hb);
  cavity.add_quad(lv, la, lw, lb, { ca, -1, -1, cb }, ahead.faces[0]);
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_OPEN_H
