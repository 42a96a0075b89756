// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CURVE_BENDS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CURVE_BENDS_H

// A curve that gets more nodes than the polyline it came as keeps its length only if nodes sit
// where the polyline bends: an edge h that cuts off a bend by t loses up to h t^2 / 8.  Nodes of
// the input that sit there are held there; where the edges are short against those of the polyline,
// the nearest nodes are moved there before the end.

#include <CGAL/Quad_mesh_adaptation/internal/Curve_bend.h>
#include <CGAL/Quad_mesh_adaptation/internal/large_mesh.h>
#include <CGAL/Quad_mesh_adaptation/internal/smoothing.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

inline void release_bends(Adaptation_state& s)
{
  for(Index v : s.mesh.vertices())
    if(is_held_at_bend(s.mesh.vertex(v))) s.mesh.vertex(v).frozen = false;
}

class Curve_bends
{
public:
  explicit Curve_bends(Adaptation_state& s) : s_(s), bends_(s.curves.size()), nodes_(bends_.size())
  {
    if(s.curve_lift) return; // the polyline is not what the nodes are on
    for(std::size_t c = 0; c < bends_.size(); ++c)
      if(!s.curves[c].is_frozen() && !s.curves[c].is_cut) bends_[c] = bends_of(s.curves[c]);
    for(Index v : s.mesh.vertices()) {
      const Vertex_record& r = s.mesh.vertex(v);
      if(r.carrier == Carrier::curve && !bends_[r.curve].empty()) nodes_[r.curve].push_back(v);
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

  // Holds all nodes that sit at bends.
  void hold_all()
  {
    for_each_bend([&](const Curve_bend& b, Index v, double way) {
      Vertex_record& r = s_.mesh.vertex(v);
      if(std::abs(way) <= 1e-9 * b.shorter && b.loss(r.h) >= curve_loss_allowed) r.frozen = true;
    });
  }

  // Moves nodes to the bends, and holds them, where edges are much shorter than those of the
  // polyline, or at all shorter and there is a node for every bend, or the curve has no fewer edges
  // than the polyline.  Returns how many there are.
  std::size_t fit()
  {
    constexpr double certainly = 1.6, where_all_do = 0.8;
    std::vector<Move> moves;
    for_each_bend([&](const Curve_bend& b, Index v, double way) {
      Vertex_record& r = s_.mesh.vertex(v);
      const double least =
          is_coarsened(r.curve) ? (has_node_for_each(r.curve) ? where_all_do : certainly) : 0;
      if(r.frozen || b.shorter < least * r.h || std::abs(way) > b.mean_length ||
         b.loss(r.h) < curve_loss_allowed)
        return;
      r.frozen = true;
      moves.push_back({ v, b.arc });
    });
    const std::size_t all = moves.size();
    const Short_smoothing coarse(s_);
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

  std::size_t number_of_edges(Index curve) const
  {
    return nodes_[curve].size() + (s_.curves[curve].is_closed() ? 0 : 1);
  }

  bool is_coarsened(Index curve) const
  {
    return number_of_edges(curve) + 1 < s_.curves[curve].points().size();
  }

  // Tells of every bend its node and the way from there to the bend.
  template <typename Visit>
  void for_each_bend(const Visit& visit)
  {
    for(Index c = 0; c < Index(bends_.size()); ++c) {
      if(nodes_[c].empty()) continue;
      const std::vector<std::size_t> share =
          has_node_for_each(c) ? one_node_each(c) : nearest_nodes(c);
      for(std::size_t i = 0; i < share.size(); ++i) {
        const Index v = nodes_[c][share[i]];
        visit(bends_[c][i], v, s_.curves[c].difference(param(v), bends_[c][i].arc));
      }
    }
  }

  // Where a bend lies between the nodes, as a fractional number of node; up to 1 before the first
  // and behind the last.
  double place_among_nodes(Index c, double arc) const
  {
    const std::vector<Index>& nodes = nodes_[c];
    const std::size_t n = nodes.size();
    const std::size_t after =
        std::size_t(std::lower_bound(nodes.begin(), nodes.end(), arc,
                                     [&](Index v, double a) { return param(v) < a; }) -
                    nodes.begin());
    const Feature_curve& curve = s_.curves[c];
    const bool beyond = after == 0 || after == n;
    if(beyond && !curve.is_closed()) return after == 0 ? 0. : double(n - 1);
    const double to = std::abs(curve.difference(arc, param(nodes[after % n]))),
                 from = std::abs(curve.difference(arc, param(nodes[(after + n - 1) % n])));
    return double(after) - (to > 0 ? to / (to + from) : 0.);
  }

  std::vector<std::size_t> nearest_nodes(Index c) const
  {
    const std::size_t n = nodes_[c].size();
    std::vector<std::size_t> share;
    for(const Curve_bend& b : bends_[c])
      share.push_back(std::size_t(std::lround(place_among_nodes(c, b.arc)) + long(n)) % n);
    return share;
  }

  // A node of its own for every bend, in order, as near as they come in the sense of least squares
  // of their numbers: isotonic regression of the places less the numbers of the bends, by pooling
  // of adjacent violators.  A closed curve is cut in its longest part without bends.
  std::vector<std::size_t> one_node_each(Index c) const
  {
    const std::size_t n = nodes_[c].size(), m = bends_[c].size();
    const bool closed = s_.curves[c].is_closed();
    std::vector<double> place;
    for(const Curve_bend& b : bends_[c]) place.push_back(place_among_nodes(c, b.arc));
    const std::size_t first = closed ? after_longest_gap(place, double(n)) : 0;
    std::vector<Pool> pools;
    for(std::size_t i = 0; i < m; ++i) {
      const std::size_t j = (first + i) % m;
      pools.push_back({ place[j] + (first + i < m ? 0. : double(n)) - double(i), 1 });
      while(pools.size() > 1 && pools[pools.size() - 2].mean() > pools.back().mean()) {
        pools[pools.size() - 2].add(pools.back());
        pools.pop_back();
      }
    }
    std::vector<std::size_t> share(m);
    std::size_t i = 0;
    const long slack = long(n) - long(m);
    // of a closed curve the last may not meet the first
    const long least = closed ? std::lround(pools.front().mean()) : 0;
    for(const Pool& p : pools)
      for(std::size_t k = 0; k < p.number; ++k, ++i) {
        const long offset = (std::min)((std::max)(std::lround(p.mean()), least), least + slack);
        share[(first + i) % m] = std::size_t(offset + long(i) + long(n)) % n;
      }
    return share;
  }

  struct Pool
  {
    double sum;
    std::size_t number;

    double mean() const { return sum / double(number); }
    void add(const Pool& p)
    {
      sum += p.sum;
      number += p.number;
    }
  };

  static std::size_t after_longest_gap(const std::vector<double>& place, double around)
  {
    std::size_t best = 0;
    double longest = -1;
    for(std::size_t i = 0; i < place.size(); ++i) {
      const double gap = i == 0 ? place[0] + around - place.back() : place[i] - place[i - 1];
      if(gap > longest) {
        longest = gap;
        best = i;
      }
    }
    return best;
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
    for(Index h : s_.mesh.outgoing(v)) {
      const Index f = s_.mesh.face(h);
      worst = (std::min)(worst, s_.face_quality(s_.corners(f), s_.reference_normal(f)));
    }
    return worst;
  }

  void tell_neighbours(Index v)
  {
    s_.node_moved(v);
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
