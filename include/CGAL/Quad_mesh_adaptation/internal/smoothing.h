// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SMOOTHING_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SMOOTHING_H

#include <CGAL/Quad_mesh_adaptation/internal/Node_relaxation.h>
#include <CGAL/Quad_mesh_adaptation/internal/curve_order.h>

#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Gathers the star of v for a relaxation.
inline void gather_star(const Adaptation_state& s, Index v, std::vector<Star_face>& star)
{
  star.clear();
  const Quad_complex& m = s.mesh;
  const Index start = m.vertex(v).halfedge;
  Index h = start;
  do {
    const Index a = m.target(h), b = m.target(m.next(h)), c = m.origin(m.prev(h));
    const Vertex_record &x = m.vertex(v), &ra = m.vertex(a), &rb = m.vertex(b), &rc = m.vertex(c);
    Star_face f;
    f.q1 = ra.p;
    f.q2 = rb.p;
    f.q3 = rc.p;
    f.reference = ra.normal + rb.normal + rc.normal;
    f.floor = 0.25 * (x.floor + ra.floor + rb.floor + rc.floor);
    f.grad_h = s.size.is_constant()
                   ? Vec(0, 0, 0)
                   : size_gradient({ x.p, ra.p, rb.p, rc.p }, { x.h, ra.h, rb.h, rc.h });
    star.push_back(f);
    h = m.turn_left(h);
  } while(h >= 0 && h != start);
}

// Moves node v to a better place on its carrier; tells whether it did.
inline bool move_node(Adaptation_state& s, Index v, Node_relaxation& relax)
{
  Vertex_record& r = s.mesh.vertex(v);
  if(r.frozen || r.carrier == Carrier::corner) return false;
  gather_star(s, v, relax.star());
  const Vertex_record old = r;
  if(!relax(r)) return false;
  if(!is_order_kept(s, v, old)) {
    r = old;
    return false;
  }
  Index h = r.halfedge;
  do {
    s.forget_energy(s.mesh.face(h));
    h = s.mesh.turn_left(h);
  } while(h >= 0 && h != r.halfedge);
  return true;
}

// Marks the nodes of all faces about v.
inline void mark_around(const Quad_complex& m, Index v, std::vector<char>& marks)
{
  const Index start = m.vertex(v).halfedge;
  Index h = start;
  do {
    for(Index u : m.quad(m.face(h))) marks[u] = 1;
    h = m.turn_left(h);
  } while(h >= 0 && h != start);
}

// Size-aware smoothing: at most `sweeps` rounds over the nodes in a fixed order, each moved to a
// better place on its carrier.  The first round visits all nodes, or those marked in `start`; later
// rounds those near which something moved.  Returns the number of moves.
inline std::size_t smooth(Adaptation_state& s, int sweeps, const std::vector<char>* start = nullptr)
{
  Node_relaxation relax(s);
  std::vector<char> now = start ? *start : std::vector<char>(s.mesh.vertex_end(), 1), next;
  std::size_t moves = 0;
  for(int sweep = 0; sweep < sweeps; ++sweep) {
    s.check_cancelled();
    next.assign(now.size(), 0);
    std::size_t moved = 0;
    for(Index v = 0; v < s.mesh.vertex_end(); ++v) {
      if(!now[v] || !s.mesh.is_vertex(v) || !move_node(s, v, relax)) continue;
      mark_around(s.mesh, v, next);
      ++moved;
    }
    moves += moved;
    now.swap(next);
    if(moved == 0) break;
  }
  return moves;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SMOOTHING_H
