// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CORNER_SPLIT_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CORNER_SPLIT_H

#include <CGAL/Quad_mesh_adaptation/internal/Cavity.h>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Corner split (3 to 6): a row of faces along a curve goes past a node that had one flat face
// there, as the corner of a square has that became a disk.  With h from that node c to a, its face
// (c, a, x, b) and the two beside it behind its other edges become
//
//     p  a  c  b  s        four faces along the curve, on the new nodes i, j, k,
//     q  i  j  k  r        and two behind them, (i, q, x, j) and (j, x, r, k).
//           x
//
// F + 3, V + 3.  c, q and r gain an edge, x loses one, i and k have three.
struct Corner_split
{
  Index h, left, right; // in the face, behind a - x, behind x - b
};

inline Corner_split corner_split_at(const Quad_complex& m, Index h)
{
  const Index ax = m.next(h), xb = m.next(ax);
  return { h, m.opposite(ax), m.opposite(xb) };
}

inline bool is_corner_split_allowed(const Adaptation_state& s, const Corner_split& c)
{
  const Quad_complex& m = s.mesh;
  if(c.left < 0 || c.right < 0 || m.curve(c.left) >= 0 || m.curve(c.right) >= 0) return false;
  return m.face(c.left) != m.face(c.right) && m.face(c.left) != m.face(c.h) &&
         m.face(c.right) != m.face(c.h);
}

inline void describe_corner_split(Adaptation_state& s, const Corner_split& c, Cavity& cavity)
{
  const Quad_complex& m = s.mesh;
  const Index ca = c.h, bc = m.prev(ca);             // of the face
  const Index ap = m.next(c.left), pq = m.next(ap);  // of the one behind a - x
  const Index xr = m.next(c.right), rs = m.next(xr); // of the one behind x - b
  const Index qx = m.next(pq), sb = m.next(rs);
  cavity.clear();
  for(Index h : { ca, c.left, c.right }) cavity.add_old_face(m.face(h));
  const auto node = [&](Index h) { return cavity.node(m.origin(h)); };
  const Vec x = m.point(m.origin(xr));
  const auto between = [&](Index h, Index in) {
    Vertex_record r = m.vertex(m.origin(h));
    r.carrier = Carrier::surface;
    r.curve = -1;
    r.frozen = false;
    r.ideal_faces = 4;
    r.p = 0.5 * (r.p + x);
    r.hint = s.triangle_near(m.face(in), r.p);
    s.place(r);
    return cavity.add_new_node(r);
  };
  const int nc = node(ca), na = node(ap), nb = node(bc), np = node(pq), nq = node(qx),
            nx = node(xr), nr = node(rs), ns = node(sb);
  const int i = between(ap, c.left), j = between(ca, ca), k = between(bc, c.right);
  cavity.add_quad(nc, na, i, j, { m.curve(ca), -1, -1, -1 }, m.face(ca));
  cavity.add_quad(nb, nc, j, k, { m.curve(bc), -1, -1, -1 }, m.face(ca));
  cavity.add_quad(na, np, nq, i, { m.curve(ap), m.curve(pq), -1, -1 }, m.face(c.left));
  cavity.add_quad(i, nq, nx, j, { -1, m.curve(qx), -1, -1 }, m.face(c.left));
  cavity.add_quad(nr, ns, nb, k, { m.curve(rs), m.curve(sb), -1, -1 }, m.face(c.right));
  cavity.add_quad(j, nx, nr, k, { -1, m.curve(xr), -1, -1 }, m.face(c.right));
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CORNER_SPLIT_H
