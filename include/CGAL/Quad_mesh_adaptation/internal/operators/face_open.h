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

inline void describe_face_open(Adaptation_state& s, Index ha, Index hb, Cavity& cavity)
{
  const Quad_complex& m = s.mesh;
  const Index v = m.origin(ha);
  cavity.clear();
  cavity.add_old_star(v);
  const int lv = cavity.node(v), la = cavity.node(m.target(ha)), lb = cavity.node(m.target(hb));
  std::vector<Index> sector; // faces from ha to hb, which take the new node
  Vec ahead(0, 0, 0), behind(0, 0, 0);
  for(Index h = ha; h != hb; h = m.turn_left(h)) {
    sector.push_back(m.face(h));
    ahead = ahead + m.point(m.target(m.next(h)));
  }
  int rest = 0;
  for(Index h = hb; h >= 0 && h != ha; h = m.turn_left(h), ++rest)
    behind = behind + m.point(m.target(m.next(h)));
  Vertex_record fresh = m.vertex(v);
  fresh.carrier = Carrier::surface;
  fresh.curve = -1;
  fresh.frozen = false;
  fresh.ideal_faces = 4;
  // both nodes step back from the new face, so that it is open from the start
  const bool both = m.vertex(v).carrier == Carrier::surface && !m.vertex(v).frozen && rest > 0;
  const double step = both ? 0.3 : 0.4;
  fresh.p = (1 - step) * fresh.p + (step / double(sector.size())) * ahead;
  fresh.hint = s.triangle_near(sector[0], fresh.p);
  s.place(fresh);
  if(both) {
    Vertex_record& old = cavity.nodes[lv];
    old.p = (1 - step) * old.p + (step / rest) * behind;
    s.place(old);
  }
  const int lw = cavity.add_new_node(fresh);
  const std::vector<Index> faces = cavity.old_faces;
  for(Index f : faces) {
    Cavity_quad q = cavity.copy_of(f);
    if(std::find(sector.begin(), sector.end(), f) != sector.end())
      for(int k = 0; k < 4; ++k)
        if(q.v[k] == lv) {
          q.v[k] = lw;
          q.curve[k] = q.curve[(k + 3) & 3] = -1; // curves stay with v
        }
    cavity.quads.push_back(q);
  }
  const Index ca = m.curve(ha), cb = m.curve(hb);
  cavity.add_quad(lv, la, lw, lb, { ca, -1, -1, cb }, sector[0]);
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_OPEN_H
