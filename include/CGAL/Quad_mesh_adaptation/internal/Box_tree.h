// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_BOX_TREE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_BOX_TREE_H

#include <CGAL/Quad_mesh_adaptation/internal/boxes.h>
#include <CGAL/Quad_mesh_adaptation/internal/closest_point.h>
#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// A compact AABB tree for the nearest triangles of a mesh that somebody else stores: each function
// is given `corners(t)`, which returns those of triangle t.  It takes 20 bytes a triangle, a tenth
// of what an AABB tree of CGAL takes with its copies of the triangles and hints, and half the time
// to build; the memory of trees was most of the peak.
class Box_tree
{
  using Triangle = std::array<Vec, 3>;

public:
  struct Nearest
  {
    Vec point;
    Index triangle = -1; // none
  };

  // Precondition: there is at least one triangle.
  template <typename Corners_of>
  Box_tree(Index triangles, const Corners_of& corners) : order_(std::size_t(triangles))
  {
    std::vector<Triangle_centre> centres;
    centres.reserve(order_.size());
    Box all;
    for(Index t = 0; t < triangles; ++t) {
      const Triangle c = corners(t);
      for(const Vec& p : c) all.add(p);
      centres.push_back({ (c[0] + c[1] + c[2]) / 3, t });
    }
    origin_ = all.low;
    const double longest = all.longest_side();
    inverse_ = longest > 0 ? 1 / longest : 1;
    int levels = 0;
    while((std::size_t(most_in_leaf) << levels) < order_.size()) ++levels;
    boxes_.resize((std::size_t(2) << levels) - 1);
    first_leaf_ = (std::size_t(1) << levels) - 1;
    build(0, 0, order_.size(), centres, corners);
  }

  // The triangle nearest to p, and nearer than `within`, among those that `accept(number)` likes.
  template <typename Corners_of, typename Accept>
  Nearest nearest(const Vec& p, const Corners_of& corners, const Accept& accept,
                  double within) const
  {
    Nearest best;
    double least = within * within;
    const Vec q = inverse_ * (p - origin_);
    // of the boxes, which are rounded outwards
    const double scale = (1 - 1e-12) / (inverse_ * inverse_);
    Part waiting[most_levels]; // the farther halves on the way down
    int top = 0;
    Part part = { 0, 0, order_.size(), scale * boxes_[0].squared_distance(q) };
    while(true) {
      // down, always into the nearer half
      while(part.distance2 < least && part.box < first_leaf_) {
        const std::size_t middle = part.first + (part.last - part.first) / 2;
        Part near = { 2 * part.box + 1, part.first, middle, 0 };
        Part far = { 2 * part.box + 2, middle, part.last, 0 };
        near.distance2 = scale * boxes_[near.box].squared_distance(q);
        far.distance2 = scale * boxes_[far.box].squared_distance(q);
        if(far.distance2 < near.distance2) std::swap(near, far);
        if(far.distance2 < least) waiting[top++] = far;
        part = near;
      }
      if(part.distance2 < least)
        for(std::size_t i = part.first; i < part.last; ++i)
          look_at(order_[i], p, corners, accept, best, least);
      if(top == 0) break;
      part = waiting[--top];
    }
    return best;
  }

private:
  static constexpr std::size_t most_in_leaf = 4;
  static constexpr int most_levels = 64;

  struct Part
  {
    std::size_t box, first, last;
    double distance2;
  };

  template <typename Corners_of, typename Accept>
  static void look_at(Index t, const Vec& p, const Corners_of& corners, const Accept& accept,
                      Nearest& best, double& least)
  {
    if(!accept(t)) return;
    const Vec there = closest_on_triangle(p, corners(t)).point;
    const double d2 = (p - there).squared_length();
    if(!(d2 < least)) return;
    least = d2;
    best = { there, t };
  }

  // Box k holds the triangles from first to last, its halves are boxes 2 k + 1 and 2 k + 2.
  template <typename Corners_of>
  void build(std::size_t k, std::size_t first, std::size_t last,
             std::vector<Triangle_centre>& centres, const Corners_of& corners)
  {
    if(k >= first_leaf_) {
      for(std::size_t i = first; i < last; ++i) order_[i] = centres[i].triangle;
      boxes_[k] = leaf_box(first, last, corners);
      return;
    }
    const std::size_t middle = halve(centres, first, last);
    build(2 * k + 1, first, middle, centres, corners);
    build(2 * k + 2, middle, last, centres, corners);
    boxes_[k] = boxes_[2 * k + 1];
    boxes_[k].add(boxes_[2 * k + 2]);
  }

  template <typename Corners_of>
  Box_of_floats leaf_box(std::size_t first, std::size_t last, const Corners_of& corners) const
  {
    Box box;
    for(std::size_t i = first; i < last; ++i)
      for(const Vec& p : corners(order_[i])) box.add(p);
    // rounding keeps the order, so once is enough
    return { inverse_ * (box.low - origin_), inverse_ * (box.high - origin_) };
  }

  std::vector<Index> order_; // of the triangles, as the boxes hold them
  // A full binary tree, in coordinates from 0 to 1 over the whole, for floats are precise near 0
  // only.
  std::vector<Box_of_floats> boxes_;
  std::size_t first_leaf_ = 0;
  Vec origin_ = Vec(0, 0, 0);
  double inverse_ = 1;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_BOX_TREE_H
