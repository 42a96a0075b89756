// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SMOOTHING_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SMOOTHING_H

#include <CGAL/Quad_mesh_adaptation/internal/Node_relaxation.h>
#include <CGAL/Quad_mesh_adaptation/internal/Walk.h>
#include <CGAL/Quad_mesh_adaptation/internal/curve_order.h>
#include <CGAL/Quad_mesh_adaptation/internal/distance_guard.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Witnesses of the faces about v, for a relaxation.
inline void gather_pulls(const Adaptation_state& s, Index v, std::vector<Pull>& pulls)
{
  pulls.clear();
  if(s.coverage.is_empty()) return;
  const Quad_complex& m = s.mesh;
  int number = 0;
  for(Index h : m.outgoing(v)) {
    s.coverage.for_each(m.face(h), [&](Index, const Witness& w) {
      pulls.push_back({ &w, number, (h & 1) == 0 });
    });
    ++number;
  }
}

// After a move of v each witness of its faces goes to the one it is nearest to now.
inline void share_witnesses(Adaptation_state& s, Index v)
{
  std::vector<Index> list, faces;
  std::vector<std::size_t> kept_by; // which of the faces
  for(Index h : s.mesh.outgoing(v)) {
    faces.push_back(s.mesh.face(h));
    s.coverage.take(faces.back(), list);
    kept_by.resize(list.size(), faces.size() - 1);
  }
  if(list.empty()) return;
  Covering_faces covers;
  for(Index f : faces) covers.add(s.corners(f));
  for(std::size_t i = 0; i < list.size(); ++i) {
    const auto best = covers.best_cover(s.coverage[list[i]], kept_by[i]);
    s.coverage.give(list[i], faces[best.second], best.first);
  }
}

// Gathers the star of v for a relaxation.
inline void gather_star(Adaptation_state& s, Index v, std::vector<Star_face>& star)
{
  star.clear();
  const Quad_complex& m = s.mesh;
  for(Index h : m.outgoing(v)) {
    const Index a = m.target(h), b = m.target(m.next(h)), c = m.origin(m.prev(h));
    const Vertex_record &x = m.vertex(v), &ra = m.vertex(a), &rb = m.vertex(b), &rc = m.vertex(c);
    Star_face f;
    f.face = m.face(h);
    f.set_corners(ra.p, rb.p, rc.p);
    f.factor = s.renewed_size_factor(m.face(h));
    f.sizes = ra.h + rb.h + rc.h;
    for(const Vertex_record* r : { &ra, &rb, &rc }) f.reference.add(r->normal);
    f.floor = 0.25 * (x.floor + ra.floor + rb.floor + rc.floor);
    f.grad_h = s.size.is_constant()
                   ? Vec(0, 0, 0)
                   : size_gradient({ x.p, ra.p, rb.p, rc.p }, { x.h, ra.h, rb.h, rc.h });
    star.push_back(f);
  }
}

constexpr double turned_away = 0.27; // mean cosine between normals of face and surface, or less

// Has the move of node v from `old` uncovered the surface where a face is turned away from it, or
// turned a corner over?  The rim of a thin wall slides inward like that where no feature holds it.
inline bool loses_surface(const Adaptation_state& s, Index v, const Vertex_record& old)
{
  if(s.surface.is_planar()) return false;
  const Vertex_record& r = s.mesh.vertex(v);
  double before = 0, now = 0, least = 1;
  int turned = 0; // more corners than before
  for(Index h : s.mesh.outgoing(v)) {
    Corners p = s.corners(s.mesh.face(h));
    Facing reference = s.reference_normal(s.mesh.face(h));
    const Vec a = area_vector(p);
    const double cosine = reference.mean_cosine(normalized(a));
    least = (std::min)(least, cosine);
    now += norm(a) * (std::max)(cosine, 0.);
    turned += scaled_jacobian(p) > 0 ? 0 : 1;
    p[h & 3] = old.p;
    turned -= scaled_jacobian(p) > 0 ? 0 : 1;
    reference.sum = reference.sum - r.normal + old.normal;
    const Vec b = area_vector(p);
    before += norm(b) * (std::max)(reference.mean_cosine(normalized(b)), 0.);
  }
  return turned > 0 || (least < turned_away && now < (1 - 1e-6) * before);
}

// Of the faces about v, with v at p.
inline double largest_warp(const Adaptation_state& s, Index v, const Vec& p)
{
  double largest = 0;
  for(Index h : s.mesh.outgoing(v)) {
    Corners c = s.corners(s.mesh.face(h));
    c[h & 3] = p;
    largest = (std::max)(largest, warp(c));
  }
  return largest;
}

// Has the move of node v from `old` folded a face along its diagonal by more than some 60 degrees,
// and by more than any was?  Corners alone say little about that, but `worst`, the least of the
// corner measures, is below 0.87 then.
inline bool warps_a_face(const Adaptation_state& s, Index v, const Vertex_record& old, double worst)
{
  constexpr double allowed = 0.7;
  if(s.surface.is_planar() || worst > 0.87) return false;
  const double now = largest_warp(s, v, s.mesh.point(v));
  return now > allowed && now > largest_warp(s, v, old.p);
}

// Moves node v to a better place on its carrier; tells whether it moved far enough for its
// neighbours to notice.
inline bool move_node(Adaptation_state& s, Index v, Node_relaxation& relax)
{
  Vertex_record& r = s.mesh.vertex(v);
  if(r.frozen || r.carrier == Carrier::corner) return false;
  gather_star(s, v, relax.star());
  gather_pulls(s, v, relax.pulls());
  const Vertex_record old = r;
  if(!relax(r)) return false;
  const bool doubtful = relax.worst() < following(turned_away) + 0.05;
  if(!is_order_kept(s, v, old) || (doubtful && loses_surface(s, v, old)) ||
     warps_a_face(s, v, old, relax.worst()) || leaves_reference(s, v, old)) {
    r = old;
    return false;
  }
  s.node_moved(v);
  if(!relax.pulls().empty()) share_witnesses(s, v);
  const double edge = distance(r.p, s.mesh.point(s.mesh.target(r.halfedge)));
  const double way = distance(r.p, old.p);
  if(way > s.smoothing.stir * edge) s.stir(v);
  return way > relax.wake() * edge;
}

// The nodes of all faces about v are worth a visit.
inline void disturb_around(Adaptation_state& s, Index v)
{
  for(Index h : s.mesh.outgoing(v))
    for(Index u : s.mesh.quad(s.mesh.face(h))) s.disturb(u);
}

// One round of smoothing.  Threads move the runs of one step of a walk side by side, but for nodes
// that have a neighbour among those of earlier runs, or among those of their own that have to wait;
// these come after them.  Since nodes only see their neighbours, that is the same as one after the
// other.
class Smoothing_sweep
{
public:
  explicit Smoothing_sweep(Adaptation_state& s)
      : s_(s), relax_(s), relaxations_([&s] { return std::make_unique<Node_relaxation>(s); })
  {
  }

  // Over the nodes that are marked; returns the number of moves.
  std::size_t operator()(const std::vector<char>& wanted)
  {
    // enough for threads, few enough that what lies about all places stays in the cache
    constexpr std::size_t places = 64;
    s_.make_room();
    place_.assign(s_.workers.are_several() ? std::size_t(s_.mesh.vertex_end()) : 0, 0);
    Walk walk(s_.mesh, wanted, 500, places, s_.order, run_length);
    std::size_t moves = 0;
    for(std::size_t step = 0; step < walk.steps(); ++step) {
      const std::vector<Index>& nodes = walk.step(step);
      if(s_.workers.are_several() && nodes.size() > 1) {
        moves += move_together(nodes);
      } else {
        for(Index v : nodes) moves += move(v);
      }
    }
    return moves;
  }

private:
  enum class Outcome : char
  {
    stayed,
    moved,
    has_to_wait
  };

  std::size_t move(Index v)
  {
    if(!move_node(s_, v, relax_)) return 0;
    disturb_around(s_, v);
    return 1;
  }

  std::size_t move_together(const std::vector<Index>& nodes)
  {
    outcome_.assign(nodes.size(), Outcome::stayed);
    for(std::size_t i = 0; i < nodes.size(); ++i) place_[nodes[i]] = Index(i) + 1;
    const std::size_t runs = (nodes.size() + run_length - 1) / run_length;
    s_.workers.run(runs, [&](std::size_t run) {
      const std::size_t last = (std::min)((run + 1) * run_length, nodes.size());
      for(std::size_t i = run * run_length; i < last; ++i)
        if(has_to_wait(nodes[i]))
          outcome_[i] = Outcome::has_to_wait;
        else if(move_node(s_, nodes[i], relaxations_.mine()))
          outcome_[i] = Outcome::moved;
    });
    std::size_t moves = 0;
    for(std::size_t i = 0; i < nodes.size(); ++i) {
      if(outcome_[i] == Outcome::has_to_wait) moves += move(nodes[i]);
      if(outcome_[i] != Outcome::moved) continue;
      disturb_around(s_, nodes[i]);
      ++moves;
    }
    for(Index v : nodes) place_[v] = 0;
    return moves;
  }

  bool has_to_wait(Index v) const
  {
    const Quad_complex& m = s_.mesh;
    const std::size_t here = std::size_t(place_[v] - 1), run = here / run_length;
    for(Index h : m.outgoing(v)) {
      for(Index u : m.quad(m.face(h))) {
        if(place_[u] == 0 || place_[u] >= place_[v]) continue;
        const std::size_t there = std::size_t(place_[u] - 1);
        if(there / run_length != run || outcome_[there] == Outcome::has_to_wait) return true;
      }
    }
    return false;
  }

  static constexpr std::size_t run_length = 16; // neighbours mostly: what they share stays near

  Adaptation_state& s_;
  Node_relaxation relax_;
  Worker_own<Node_relaxation> relaxations_;
  std::vector<Index> place_;     // of a node in the step, from 1
  std::vector<Outcome> outcome_; // by place
};

// Size-aware smoothing: at most `sweeps` rounds over the nodes about which something changed, each
// moved to a better place on its carrier.  Those that still moved in the last round are left for
// the next call.  Returns the number of moves.
inline std::size_t smooth(Adaptation_state& s, int sweeps)
{
  s.prepare_coverage();
  Smoothing_sweep sweep(s);
  std::size_t moves = 0;
  for(int round = 0; round < sweeps; ++round) {
    s.check_cancelled();
    std::vector<char> now;
    now.swap(s.restless);
    now.resize(s.mesh.vertex_end(), 1);
    s.restless.assign(now.size(), 0);
    const std::size_t moved = sweep(now);
    moves += moved;
    if(moved == 0) break;
  }
  return moves;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SMOOTHING_H
