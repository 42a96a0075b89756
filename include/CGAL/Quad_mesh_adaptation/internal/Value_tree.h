// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_VALUE_TREE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_VALUE_TREE_H

#include <CGAL/Quad_mesh_adaptation/internal/Four_boxes.h>
#include <CGAL/Quad_mesh_adaptation/internal/boxes.h>
#include <CGAL/Quad_mesh_adaptation/internal/closest_point.h>
#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

struct Valued_triangle
{
  std::array<Vec, 3> corners;
  std::array<double, 3> values;

  bool has_area() const
  {
    return norm(cross(corners[1] - corners[0], corners[2] - corners[0])) > 0;
  }
};

// Triangles under a tree of boxes, for many searches of the nearest one.  Box_tree halves its
// triangles in the same way and finds the same one, in more time and a third of the memory: here
// it is 32 to 64 bytes a triangle besides the triangle itself.
//
// Here a node has the boxes of four parts, two halvings at once, and looks at all four together; in
// the lowest nodes they are those of up to four triangles, for a triangle takes as long as several
// nodes.
class Value_tree
{
public:
  // A search for the triangle nearest to p, within a distance.
  struct Search
  {
    Search(const Value_tree& tree, const Vec& p_, double within)
        : p(p_), q(tree.inverse_ * (p_ - tree.origin_)), point(q), least(within * within)
    {
      set_bound(tree);
    }
    void set_bound(const Value_tree& tree)
    {
      bound = float((std::min)(least * tree.to_bound_, 1e36)) + 1e-36f; // never below the true one
    }

    Vec p, q; // q: of coordinates in [0, 1] over the whole
    Point_of_floats point;
    double least; // squared
    float bound;  // the same for boxes
    Vec nearest;
    Index triangle = -1; // none
  };

  // A part of the triangles: the level and number of a node, or of a triangle of one; and its
  // squared distance in front, so that parts compare by that.
  using Part = std::uint64_t;
  static constexpr Part everything = 0;
  static Part part(float distance2, std::uint32_t level, std::uint32_t number)
  {
    std::uint32_t bits; // of positive floats are in their order
    std::memcpy(&bits, &distance2, sizeof bits);
    return Part(bits) << 32 | Part(level << level_shift) | number;
  }

  // Precondition: there is at least one triangle.
  explicit Value_tree(std::vector<Valued_triangle> triangles)
  {
    Box all;
    std::vector<Triangle_centre> sorted;
    sorted.reserve(triangles.size());
    for(const Valued_triangle& t : triangles) {
      for(const Vec& p : t.corners) all.add(p);
      sorted.push_back({ (t.corners[0] + t.corners[1] + t.corners[2]) / 3, Index(sorted.size()) });
    }
    origin_ = all.low;
    extent_ = all.extent();
    const double longest = all.longest_side();
    inverse_ = longest > 0 ? 1 / longest : 1;
    to_bound_ = Point_of_floats::allowance * inverse_ * inverse_;
    while((std::size_t(4) << halvings_) < triangles.size()) ++halvings_;
    last_level_ = (halvings_ + 1) / 2;
    std::uint32_t nodes = 0;
    for(std::uint32_t level = 0; level <= last_level_; ++level) {
      first_node_[level] = nodes;
      nodes += level == 0 ? 1u : 1u << (halvings_ - 2 * (last_level_ - level));
    }
    nodes_.resize(nodes);
    first_triangle_.resize(std::size_t(1) << halvings_);
    build(0, 0, 0, triangles.size(), sorted, triangles);
    triangles_.reserve(sorted.size());
    for(const Triangle_centre& c : sorted) triangles_.push_back(triangles[c.triangle]);
  }

  // In the order of the tree.
  const std::vector<Valued_triangle>& triangles() const { return triangles_; }
  const Vec& origin() const { return origin_; }
  const Vec& extent() const { return extent_; }
  double inverse() const { return inverse_; } // of the largest extent
  std::uint32_t last_level() const { return last_level_; }

  Four_floats squared_distances(std::uint32_t level, std::uint32_t node, const Search& s) const
  {
    return nodes_[first_node_[level] + node].squared_distances(s.point);
  }

  void search_in(Part part, Search& s) const
  {
    Part waiting[3 * most_levels + 4];
    std::size_t top = 0;
    while(true) {
      if(part <= Value_tree::part(s.bound, 15, number_bits)) {
        const std::uint32_t place = std::uint32_t(part), level = place >> level_shift,
                            number = place & number_bits;
        if(level > last_level_)
          look_at(first_triangle_[number >> 2] + Index(number & 3u), s);
        else
          top += open(level, number, s, waiting + top);
      }
      if(top == 0) return;
      part = waiting[--top];
    }
  }

  // For a point that is too far away for floats.
  void search_all(Search& s) const
  {
    for(Index t = 0; t < Index(triangles_.size()); ++t) look_at(t, s);
  }

private:
  static constexpr int most_levels = 15;
  static constexpr std::uint32_t level_shift = 28, number_bits = (1u << level_shift) - 1;

  static void larger_first(Part& a, Part& b)
  {
    const Part x = a, y = b;
    a = (std::max)(x, y);
    b = (std::min)(x, y);
  }

  // Puts the parts of a node that are near enough on the stack, the nearest on top; returns how
  // many.  Without branches, for nobody can predict them.
  std::size_t open(std::uint32_t level, std::uint32_t node, const Search& s, Part* k) const
  {
    const Four_floats distances2 = squared_distances(level, node, s);
    const unsigned near = not_above(distances2, Four_floats(s.bound));
    float d[4];
    distances2.store(d);
    for(std::uint32_t i = 0; i < 4; ++i)
      k[i] = part(d[i], level + 1, 4 * node + i) & (0 - Part((near >> i) & 1u));
    larger_first(k[0], k[1]);
    larger_first(k[2], k[3]);
    larger_first(k[0], k[2]);
    larger_first(k[1], k[3]);
    larger_first(k[1], k[2]);
    return (near & 1u) + ((near >> 1) & 1u) + ((near >> 2) & 1u) + (near >> 3);
  }

  void look_at(Index t, Search& s) const
  {
    const Vec there = closest_on_triangle(s.p, triangles_[t].corners).point;
    const double d2 = (s.p - there).squared_length();
    if(!(d2 < s.least ||
         (d2 == s.least && s.triangle >= 0 && t != s.triangle && is_before(t, s.triangle, s))))
      return;
    s.least = d2;
    s.nearest = there;
    s.triangle = t;
    s.set_bound(*this);
  }

  // Of two triangles as near as each other, would one meet t first who goes down into the nearer
  // half of the boxes always, and then into the other?  So the answer does not depend on where the
  // search began, and it is that of Box_tree.
  bool is_before(Index t, Index u, const Search& s) const
  {
    std::size_t first = 0, last = triangles_.size();
    std::uint32_t half = 0;
    for(std::uint32_t depth = 1; depth <= halvings_; ++depth) {
      const std::size_t middle = first + (last - first) / 2;
      const bool t_is_right = std::size_t(t) >= middle, u_is_right = std::size_t(u) >= middle;
      if(t_is_right != u_is_right) {
        const double scale = (1 - 1e-12) / (inverse_ * inverse_); // rounds as there
        const bool right_first = scale * box(depth, 2 * half + 1).squared_distance(s.q) <
                                 scale * box(depth, 2 * half).squared_distance(s.q);
        return t_is_right == right_first;
      }
      (t_is_right ? first : last) = middle;
      half = 2 * half + t_is_right;
    }
    return t < u;
  }

  // The one of that number after `depth` halvings.
  Box_of_floats box(std::uint32_t depth, std::uint32_t number) const
  {
    const std::uint32_t up = halvings_ - depth;
    if(up % 2 == 0)
      return nodes_[first_node_[last_level_ - up / 2 - 1] + (number >> 2)].box(number & 3u);
    Box_of_floats both = box(depth + 1, 2 * number);
    both.add(box(depth + 1, 2 * number + 1));
    return both;
  }

  // Fills a node and those below with the triangles from first to last; returns the box of all.
  Box_of_floats build(std::uint32_t level, std::uint32_t node, std::size_t first, std::size_t last,
                      std::vector<Triangle_centre>& sorted,
                      const std::vector<Valued_triangle>& triangles)
  {
    std::array<Box_of_floats, 4> boxes;
    if(level == last_level_) {
      first_triangle_[node] = Index(first);
      for(std::size_t i = first; i < last; ++i)
        boxes[i - first] = box_around(triangles[sorted[i].triangle]);
    } else {
      const std::size_t middle = halve(sorted, first, last);
      std::array<std::size_t, 5> ends = { first, middle, last, last, last };
      if(level > 0 || halvings_ % 2 == 0) // else there are two parts only
        ends = { first, halve(sorted, first, middle), middle, halve(sorted, middle, last), last };
      for(std::uint32_t i = 0; i < 4; ++i)
        if(ends[i] < ends[i + 1])
          boxes[i] = build(level + 1, 4 * node + i, ends[i], ends[i + 1], sorted, triangles);
    }
    Box_of_floats all;
    for(int i = 0; i < 4; ++i) {
      nodes_[first_node_[level] + node].set(i, boxes[i]);
      all.add(boxes[i]);
    }
    return all;
  }

  Box_of_floats box_around(const Valued_triangle& t) const
  {
    const Box box(t.corners);
    return { inverse_ * (box.low - origin_), inverse_ * (box.high - origin_) };
  }

  std::vector<Valued_triangle> triangles_;
  std::vector<Four_boxes> nodes_;                              // level by level
  std::vector<Index> first_triangle_;                          // of each node of the last level
  std::array<std::uint32_t, most_levels + 1> first_node_ = {}; // of each level
  std::uint32_t halvings_ = 0, last_level_ = 0;                // down to at most four triangles
  Vec origin_ = Vec(0, 0, 0), extent_ = Vec(0, 0, 0);
  double inverse_ = 1, to_bound_ = 1;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_VALUE_TREE_H
