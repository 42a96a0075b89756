// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_BOX_TREE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_BOX_TREE_H

#include <CGAL/Quad_mesh_adaptation/internal/closest_point.h>
#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
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
    std::vector<Centre> centres;
    centres.reserve(order_.size());
    Vec low = corners(0)[0], high = low;
    for(Index t = 0; t < triangles; ++t) {
      const Triangle c = corners(t);
      for(const Vec& p : c) {
        low =
            Vec((std::min)(low.x(), p.x()), (std::min)(low.y(), p.y()), (std::min)(low.z(), p.z()));
        high = Vec((std::max)(high.x(), p.x()), (std::max)(high.y(), p.y()),
                   (std::max)(high.z(), p.z()));
      }
      const Vec centre = (c[0] + c[1] + c[2]) / 3;
      centres.push_back({ { centre.x(), centre.y(), centre.z() }, t });
    }
    origin_ = low;
    const Vec size = high - low;
    const double longest = (std::max)({ size.x(), size.y(), size.z() });
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

  // Coordinates from 0 to 1 over the whole, for floats are precise near 0 only.
  struct Box
  {
    std::array<float, 3> low, high;

    double squared_distance(const Vec& q) const
    {
      double sum = 0;
      for(int i = 0; i < 3; ++i) {
        const double x = (std::max)({ double(low[i]) - q[i], q[i] - double(high[i]), 0. });
        sum += x * x;
      }
      return sum;
    }
  };

  struct Centre // of a triangle
  {
    std::array<double, 3> p;
    Index triangle;
  };

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

  static float below(double x)
  {
    const float f = float(x);
    return std::nextafter(f, -std::numeric_limits<float>::infinity());
  }
  static float above(double x)
  {
    const float f = float(x);
    return std::nextafter(f, std::numeric_limits<float>::infinity());
  }

  // Box k holds the triangles from first to last, its halves are boxes 2 k + 1 and 2 k + 2.
  template <typename Corners_of>
  void build(std::size_t k, std::size_t first, std::size_t last, std::vector<Centre>& centres,
             const Corners_of& corners)
  {
    if(k >= first_leaf_) {
      for(std::size_t i = first; i < last; ++i) order_[i] = centres[i].triangle;
      boxes_[k] = leaf_box(first, last, corners);
      return;
    }
    const auto begin = centres.begin() + std::ptrdiff_t(first),
               end = centres.begin() + std::ptrdiff_t(last);
    const std::size_t middle = first + (last - first) / 2;
    const int axis = longest_axis(begin, end);
    std::nth_element(begin, centres.begin() + std::ptrdiff_t(middle), end,
                     [axis](const Centre& s, const Centre& t) {
                       return s.p[axis] < t.p[axis] ||
                              (s.p[axis] == t.p[axis] && s.triangle < t.triangle);
                     });
    build(2 * k + 1, first, middle, centres, corners);
    build(2 * k + 2, middle, last, centres, corners);
    const Box &a = boxes_[2 * k + 1], &b = boxes_[2 * k + 2];
    for(int i = 0; i < 3; ++i) {
      boxes_[k].low[i] = (std::min)(a.low[i], b.low[i]);
      boxes_[k].high[i] = (std::max)(a.high[i], b.high[i]);
    }
  }

  template <typename Iterator>
  static int longest_axis(Iterator begin, Iterator end)
  {
    std::array<double, 3> low = begin->p, high = low;
    for(Iterator c = begin; c != end; ++c)
      for(int i = 0; i < 3; ++i) {
        low[i] = (std::min)(low[i], c->p[i]);
        high[i] = (std::max)(high[i], c->p[i]);
      }
    const std::array<double, 3> size = { high[0] - low[0], high[1] - low[1], high[2] - low[2] };
    return size[0] >= size[1] && size[0] >= size[2] ? 0 : size[1] >= size[2] ? 1 : 2;
  }

  template <typename Corners_of>
  Box leaf_box(std::size_t first, std::size_t last, const Corners_of& corners) const
  {
    constexpr double none = std::numeric_limits<double>::infinity();
    Vec low(none, none, none), high = -low;
    for(std::size_t i = first; i < last; ++i)
      for(const Vec& p : corners(order_[i])) {
        low =
            Vec((std::min)(low.x(), p.x()), (std::min)(low.y(), p.y()), (std::min)(low.z(), p.z()));
        high = Vec((std::max)(high.x(), p.x()), (std::max)(high.y(), p.y()),
                   (std::max)(high.z(), p.z()));
      }
    // rounding keeps the order, so once is enough
    const Vec l = inverse_ * (low - origin_), h = inverse_ * (high - origin_);
    return { { below(l.x()), below(l.y()), below(l.z()) },
             { above(h.x()), above(h.y()), above(h.z()) } };
  }

  std::vector<Index> order_; // of the triangles, as the boxes hold them
  std::vector<Box> boxes_;   // a full binary tree
  std::size_t first_leaf_ = 0;
  Vec origin_ = Vec(0, 0, 0);
  double inverse_ = 1;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_BOX_TREE_H
