// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CURVE_BENDS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CURVE_BENDS_H

// A curve that gets more nodes than the polyline it came as keeps its length only if nodes sit
// where the polyline bends: an edge h that cuts off a bend by t loses up to h t^2 / 8.  Nodes of
// the input that sit there are held there; where the edges are short against those of the polyline,
// the nearest nodes are moved there before the end.

#include <CGAL/Quad_mesh_adaptation/internal/smoothing.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

struct Curve_bend
{
  double arc;                  // where on the curve
  double shorter, mean_length; // of the two edges of the polyline
  double turn;                 // radians

  // The share of its length that the curve loses at worst if edges as long as h pass it by.
  double loss(double h) const { return turn * turn / 8 * (std::min)(1., h / mean_length); }
};

constexpr double curve_loss_allowed = 7e-4;

// The bends of a curve that cost more than they may if nodes pass them by.
inline std::vector<Curve_bend> bends_of(const Feature_curve& c)
{
  const std::vector<Vec>& p = c.points();
  const std::size_t n = p.size() - 1;
  std::vector<Curve_bend> bends;
  for(std::size_t i = c.is_closed() ? 0 : 1; i < n; ++i) {
    const Vec a = p[i] - p[i == 0 ? n - 1 : i - 1], b = p[i + 1] - p[i];
    const double turn = std::atan2(norm(cross(a, b)), a * b), la = norm(a), lb = norm(b);
    if(turn * turn / 8 > curve_loss_allowed)
      bends.push_back({ c.arcs()[i], (std::min)(la, lb), 0.5 * (la + lb), turn });
  }
  return bends;
}

inline void release_bends(Adaptation_state& s)
{
  for(Index v = 0; v < s.mesh.vertex_end(); ++v)
    if(s.mesh.is_vertex(v) && is_held_at_bend(s.mesh.vertex(v))) s.mesh.vertex(v).frozen = false;
}

class Curve_bends
{
public:
  explicit Curve_bends(Adaptation_state& s) : s_(s), bends_(s.curves.size()), nodes_(bends_.size())
  {
    if(s.curve_lift) return; // the polyline is not what the nodes are on
    for(std::size_t c = 0; c < bends_.size(); ++c)
      if(!s.curves[c].is_frozen() && !s.curves[c].is_cut) bends_[c] = bends_of(s.curves[c]);
    for(Index v = 0; v < s.mesh.vertex_end(); ++v) {
      const Vertex_record& r = s.mesh.vertex(v);
      if(s.mesh.is_vertex(v) && r.carrier == Carrier::curve && !bends_[r.curve].empty())
        nodes_[r.curve].push_back(v);
    }
    for(std::vector<Index>& nodes : nodes_)
      std::sort(nodes.begin(), nodes.end(), [&](Index u, Index v) { return param(u) < param(v); });
  }

  // Holds the nodes that sit at bends and are to get others between them.  Returns their number.
  std::size_t hold()
  {
    constexpr double edges_between = 1.4, least = 0.7;
    std::size_t held = 0;
    for_each_bend([&](const Curve_bend& b, Index v, double way) {
      Vertex_record& r = s_.mesh.vertex(v);
      if(std::abs(way) > 1e-9 * b.shorter || b.mean_length < edges_between * r.h ||
         b.shorter < least * r.h || b.loss(r.h) < curve_loss_allowed)
        return;
      held += r.frozen ? 0 : 1;
      r.frozen = true;
    });
    return held;
  }

  // Moves the nodes nearest to bends there, and holds them, where edges are much shorter than those
  // of the polyline, or at all shorter and there is a node for every bend.  Returns how many there
  // are.
  std::size_t fit()
  {
    constexpr double certainly = 1.6, where_all_do = 0.8;
    std::vector<Move> moves;
    for_each_bend([&](const Curve_bend& b, Index v, double way) {
      Vertex_record& r = s_.mesh.vertex(v);
      if(r.frozen || b.shorter < (has_node_for_each(r.curve) ? where_all_do : certainly) * r.h ||
         std::abs(way) > 0.5 * b.shorter || b.loss(r.h) < curve_loss_allowed)
        return;
      r.frozen = true;
      moves.push_back({ v, b.arc });
    });
    const std::size_t all = moves.size();
    for(int round = 0; round < 6 && !moves.empty(); ++round) {
      moves.erase(
          std::remove_if(moves.begin(), moves.end(), [&](const Move& m) { return has_arrived(m); }),
          moves.end());
      smooth(s_, 3);
    }
    for(const Move& m : moves) s_.mesh.vertex(m.node).frozen = false;
    return all;
  }

private:
  struct Move
  {
    Index node;
    double to;
  };

  bool has_node_for_each(Index curve) const { return nodes_[curve].size() >= bends_[curve].size(); }

  double param(Index v) const { return s_.mesh.vertex(v).param; }

  // Tells of every bend its nearest node and the way from there to the bend.
  template <typename Visit>
  void for_each_bend(const Visit& visit)
  {
    for(std::size_t c = 0; c < bends_.size(); ++c) {
      const std::vector<Index>& nodes = nodes_[c];
      if(nodes.empty()) continue;
      for(const Curve_bend& b : bends_[c]) {
        const std::size_t after =
            std::size_t(std::lower_bound(nodes.begin(), nodes.end(), b.arc,
                                         [&](Index v, double a) { return param(v) < a; }) -
                        nodes.begin());
        const Index u = nodes[(after + nodes.size() - 1) % nodes.size()];
        const Index v = nodes[after % nodes.size()];
        const double to_u = s_.curves[c].difference(param(u), b.arc),
                     to_v = s_.curves[c].difference(param(v), b.arc);
        const bool first = std::abs(to_u) < std::abs(to_v);
        visit(b, first ? u : v, first ? to_u : to_v);
      }
    }
  }

  // Moves a node towards its bend as far as the faces about it allow; is it there?
  bool has_arrived(const Move& m)
  {
    Vertex_record& r = s_.mesh.vertex(m.node);
    const Vertex_record old = r;
    const double way = s_.curves[r.curve].difference(r.param, m.to);
    const double enough = (std::min)(0.4, 0.8 * worst_about(m.node));
    for(double part = 1; part > 0.1; part /= 2) {
      r.param = part == 1 ? m.to : old.param + part * way;
      s_.place(r);
      if(worst_about(m.node) >= enough && is_order_kept(s_, m.node, old)) {
        tell_neighbours(m.node);
        return part == 1;
      }
      r = old;
    }
    return false;
  }

  double worst_about(Index v) const
  {
    double worst = 1;
    const Index start = s_.mesh.vertex(v).halfedge;
    Index h = start;
    do {
      const Index f = s_.mesh.face(h);
      worst = (std::min)(worst, s_.face_quality(s_.corners(f), s_.reference_normal(f)));
      h = s_.mesh.turn_left(h);
    } while(h >= 0 && h != start);
    return worst;
  }

  void tell_neighbours(Index v)
  {
    const Index start = s_.mesh.vertex(v).halfedge;
    Index h = start;
    do {
      s_.face_moved(s_.mesh.face(h));
      h = s_.mesh.turn_left(h);
    } while(h >= 0 && h != start);
    if(!s_.coverage.is_empty()) share_witnesses(s_, v);
    disturb_around(s_, v);
    s_.stir(v);
  }

  Adaptation_state& s_;
  std::vector<std::vector<Curve_bend>> bends_; // by curve
  std::vector<std::vector<Index>> nodes_;      // by curve, in order
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CURVE_BENDS_H
