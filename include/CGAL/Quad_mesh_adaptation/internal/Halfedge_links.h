// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_HALFEDGE_LINKS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_HALFEDGE_LINKS_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Finds the opposites of the half-edges of quads, four after the other, by their end points.  Both
// half-edges of an edge are on the same curve then.
class Halfedge_links
{
public:
  Halfedge_links(const std::vector<Index>& origin, std::vector<Index>& opposite,
                 std::vector<Index>& curve, Index vertices)
      : origin_(origin), opposite_(opposite), curve_(curve), vertices_(std::size_t(vertices))
  {
  }

  // False, with the offending half-edge in `bad`, if an edge has more than two or two that run the
  // same way.
  bool operator()(Index* bad) { return link_all() || link_in_order(bad); }

private:
  Index origin(Index h) const { return origin_[h]; }
  Index target(Index h) const { return origin_[(h & ~3) | ((h + 1) & 3)]; }
  Index low_end(Index h) const { return (std::min)(origin(h), target(h)); }
  Index end() const { return Index(origin_.size()); }

  void link(Index g, Index h)
  {
    opposite_[g] = h;
    opposite_[h] = g;
    curve_[g] = curve_[h] = (std::max)(curve_[g], curve_[h]);
  }

  // In one pass, each with the first one of its edge, which is listed at its lower end.  False
  // where that is not so simple: at faults, and where lists are long.
  bool link_all()
  {
    constexpr int longest = 200;
    std::vector<Index> first(vertices_, -1), next(origin_.size());
    for(Index h = 0; h < end(); ++h) {
      if(origin(h) < 0) continue;
      const Index u = origin(h), v = target(h), low = (std::min)(u, v);
      Index g = first[low];
      int looked_at = 0;
      while(g >= 0 && origin(g) + target(g) != u + v) {
        g = next[g];
        if(++looked_at > longest) return false;
      }
      opposite_[h] = -1;
      if(g < 0) {
        next[h] = first[low];
        first[low] = h;
        continue;
      }
      if(opposite_[g] >= 0 || origin(g) == u) return false;
      link(g, h);
    }
    return true;
  }

  // The same by the numbers of vertices, to tell which is the first that cannot be linked.
  bool link_in_order(Index* bad)
  {
    std::vector<Index> start(vertices_ + 1, 0);
    for(Index h = 0; h < end(); ++h)
      if(origin(h) >= 0) ++start[low_end(h) + 1];
    for(std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
    std::vector<Index> sorted(start.back()); // bucketed by the lower vertex, in half-edge order
    for(Index h = 0; h < end(); ++h)
      if(origin(h) >= 0) sorted[start[low_end(h)]++] = h;
    std::vector<std::pair<Index, Index>> bucket; // upper end, half-edge
    for(std::size_t i = 0; i < sorted.size();) {
      const Index low = low_end(sorted[i]);
      bucket.clear();
      for(; i < sorted.size() && low_end(sorted[i]) == low; ++i)
        bucket.emplace_back((std::max)(origin(sorted[i]), target(sorted[i])), sorted[i]);
      if(!link_bucket(bucket, bad)) return false;
    }
    return true;
  }

  bool link_bucket(std::vector<std::pair<Index, Index>>& bucket, Index* bad)
  {
    std::sort(bucket.begin(), bucket.end());
    for(std::size_t i = 0; i < bucket.size();) {
      std::size_t j = i;
      while(j < bucket.size() && bucket[j].first == bucket[i].first) ++j;
      const Index g = bucket[i].second, h = j == i + 2 ? bucket[i + 1].second : Index(-1);
      if(j > i + 2 || (h >= 0 && origin(g) == origin(h))) {
        if(bad) *bad = g;
        return false;
      }
      if(h >= 0)
        link(g, h);
      else
        opposite_[g] = -1;
      i = j;
    }
    return true;
  }

  const std::vector<Index>& origin_;
  std::vector<Index>&opposite_, &curve_;
  std::size_t vertices_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_HALFEDGE_LINKS_H
