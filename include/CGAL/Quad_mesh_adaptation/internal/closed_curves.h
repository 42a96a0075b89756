// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CLOSED_CURVES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CLOSED_CURVES_H

#include <CGAL/Quad_mesh_adaptation/internal/curve_order.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Stretches of closed curves that an operation is about to shrink to one node each.
class Closed_curve_check
{
public:
  explicit Closed_curve_check(const Adaptation_state& s) : s_(s) {}

  // `path`: the nodes of a stretch of curve c, in order; curves with ends are left alone.
  void add(Index c, std::vector<Index> path)
  {
    if(c < 0 || !s_.curves[c].is_closed()) return;
    edges_gone_[c] += int(path.size()) - 1;
    nodes_.insert(nodes_.end(), path.begin(), path.end());
    stretches_.push_back({ c, std::move(path) });
  }

  // Every curve keeps four edges: a disc of quads has an even number of them around it, and two
  // would join the same nodes.  None comes near half of the curve, where the way round that an edge
  // stands for would be in doubt.
  bool operator()() const
  {
    for(const Stretch& t : stretches_)
      if(!keeps_four_edges(t) || !keeps_edges_short(t)) return false;
    return true;
  }

private:
  struct Stretch
  {
    Index curve;
    std::vector<Index> path;
  };

  bool keeps_four_edges(const Stretch& t) const
  {
    const int wanted = 4 + edges_gone_.at(t.curve);
    Index before = t.path[0], v = t.path[1];
    int edges = 1;
    for(; edges < wanted && v != t.path[0]; ++edges) {
      const std::array<Index, 2> n = curve_neighbours(s_.mesh, v, t.curve);
      const Index next = n[0] == before ? n[1] : n[0];
      if(next < 0) return false; // where a part of the mesh ends that has been taken out
      before = v;
      v = next;
    }
    return edges >= wanted;
  }

  bool keeps_edges_short(const Stretch& t) const
  {
    const Feature_curve& curve = s_.curves[t.curve];
    const auto arc = [&](Index u, Index v) {
      return std::abs(curve.difference(s_.mesh.vertex(u).param, s_.mesh.vertex(v).param));
    };
    double length = 0;
    for(std::size_t i = 1; i < t.path.size(); ++i) length += arc(t.path[i - 1], t.path[i]);
    for(Index end : { t.path.front(), t.path.back() })
      for(Index n : curve_neighbours(s_.mesh, end, t.curve)) {
        if(std::find(t.path.begin(), t.path.end(), n) != t.path.end()) continue;
        if(std::find(nodes_.begin(), nodes_.end(), n) != nodes_.end()) return false; // two at once
        if(!(length + arc(end, n) < 0.45 * curve.length())) return false;
      }
    return true;
  }

  const Adaptation_state& s_;
  std::vector<Stretch> stretches_;
  std::vector<Index> nodes_;
  std::map<Index, int> edges_gone_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CLOSED_CURVES_H
