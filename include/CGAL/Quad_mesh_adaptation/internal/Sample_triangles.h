// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SAMPLE_TRIANGLES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SAMPLE_TRIANGLES_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// A conforming triangulation whose vertices are sample points, refined by the longest edges of its
// triangles (M. C. Rivara, "Algorithms for refining triangular grids suitable for adaptive and
// multigrid techniques", 1984), so that its angles stay bounded.  The surface does not change.
class Sample_triangles
{
public:
  struct Edge
  {
    Index source, target;
    double length;
  };

  // Every quad cut along its shorter diagonal.
  Sample_triangles(std::vector<Vec> points, const std::vector<Quad>& quads)
      : points_(std::move(points))
  {
    triangles_.reserve(2 * quads.size());
    for(const Quad& q : quads) {
      const int i =
          distance(points_[q[0]], points_[q[2]]) <= distance(points_[q[1]], points_[q[3]]) ? 0 : 1;
      triangles_.push_back({ q[i], q[i + 1], q[(i + 2) % 4] });
      triangles_.push_back({ q[i], q[(i + 2) % 4], q[(i + 3) % 4] });
    }
    number_edges();
  }

  const std::vector<Vec>& points() const { return points_; }
  const std::vector<std::array<Index, 3>>& triangles() const { return triangles_; }
  const std::vector<Edge>& edges() const { return edges_; }

  // Splits the marked edges, numbered as in edges(), and those that the rule of the longest edge
  // adds.  New points are the middles of edges and follow the old ones.
  void split(std::vector<char> is_marked)
  {
    mark_longest_edges(is_marked);
    std::vector<Index> middle(edges_.size(), -1);
    for(std::size_t e = 0; e < edges_.size(); ++e)
      if(is_marked[e]) {
        middle[e] = Index(points_.size());
        points_.push_back(0.5 * (points_[edges_[e].source] + points_[edges_[e].target]));
      }
    std::vector<std::array<Index, 3>> parts;
    parts.reserve(2 * triangles_.size());
    for(std::size_t t = 0; t < triangles_.size(); ++t) append_parts(t, middle, parts);
    triangles_.swap(parts);
    number_edges();
  }

private:
  // Edge i of a triangle runs from corner i to corner i + 1.
  void number_edges()
  {
    std::unordered_map<std::uint64_t, Index> number;
    number.reserve(2 * triangles_.size());
    edges_.clear();
    edges_of_.resize(triangles_.size());
    for(std::size_t t = 0; t < triangles_.size(); ++t)
      for(int i = 0; i < 3; ++i) {
        const auto [a, b] = std::minmax({ triangles_[t][i], triangles_[t][(i + 1) % 3] });
        const auto [it, is_new] =
            number.emplace((std::uint64_t(a) << 32) | std::uint64_t(b), Index(edges_.size()));
        if(is_new) edges_.push_back({ a, b, distance(points_[a], points_[b]) });
        edges_of_[t][i] = it->second;
      }
  }

  int longest(std::size_t t) const
  {
    const auto& e = edges_of_[t];
    const auto key = [&](int i) { return std::make_pair(edges_[e[i]].length, e[i]); };
    int best = 0;
    for(int i = 1; i < 3; ++i)
      if(key(best) < key(i)) best = i;
    return best;
  }

  void mark_longest_edges(std::vector<char>& is_marked) const
  {
    for(bool is_changed = true; is_changed;) {
      is_changed = false;
      for(std::size_t t = 0; t < triangles_.size(); ++t) {
        const auto& e = edges_of_[t];
        if(!is_marked[e[0]] && !is_marked[e[1]] && !is_marked[e[2]]) continue;
        char& mark = is_marked[e[longest(t)]];
        is_changed = is_changed || !mark;
        mark = true;
      }
    }
  }

  void append_parts(std::size_t t, const std::vector<Index>& middle,
                    std::vector<std::array<Index, 3>>& parts) const
  {
    const int i = longest(t);
    const auto corner = [&](int j) { return triangles_[t][(i + j) % 3]; };
    const auto half = [&](int j) { return middle[edges_of_[t][(i + j) % 3]]; };
    const Index a = corner(0), b = corner(1), c = corner(2);
    const Index ab = half(0), bc = half(1), ca = half(2); // ab is the longest side
    if(ab < 0) return parts.push_back(triangles_[t]);
    if(bc >= 0 && ca >= 0) {
      for(const auto& part :
          { std::array<Index, 3>{ a, ab, ca }, { ab, b, bc }, { ca, bc, c }, { ab, bc, ca } })
        parts.push_back(part);
      return;
    }
    if(ca < 0)
      parts.push_back({ a, ab, c });
    else {
      parts.push_back({ a, ab, ca });
      parts.push_back({ ca, ab, c });
    }
    if(bc < 0)
      parts.push_back({ ab, b, c });
    else {
      parts.push_back({ ab, b, bc });
      parts.push_back({ ab, bc, c });
    }
  }

  std::vector<Vec> points_;
  std::vector<std::array<Index, 3>> triangles_, edges_of_;
  std::vector<Edge> edges_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SAMPLE_TRIANGLES_H
