// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LINKED_TRIANGLES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LINKED_TRIANGLES_H

#include <CGAL/Quad_mesh_adaptation/internal/closest_point.h>
#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

using Edge_keys = std::vector<std::pair<Index, Index>>; // edges by their ends, lower one first

enum class Normals // of triangles
{
  none, // a plane can do without
  kept,
  found_anew // at each question, for the sake of memory
};

// Triangles and their neighbours.  Nobody walks across a sharp edge: the triangles between such
// edges are a patch.  Nor does one step lead to a triangle that faces the other way.
class Linked_triangles
{
public:
  Linked_triangles() = default;

  // `sharp` is sorted.
  Linked_triangles(std::vector<Vec> points, std::vector<std::array<Index, 3>> triangles,
                   const Edge_keys& sharp)
      : points_(std::move(points)), triangles_(std::move(triangles))
  {
    link(sharp);
    number_patches();
  }

  // Of triangles whose neighbours across sides (i, i + 1) are known, and maybe their patches.
  Linked_triangles(std::vector<Vec> points, std::vector<std::array<Index, 3>> triangles,
                   std::vector<std::array<Index, 3>> neighbours, std::vector<Index> patches)
      : points_(std::move(points)), triangles_(std::move(triangles)),
        neighbours_(std::move(neighbours)), patches_(std::move(patches))
  {
    if(patches_.empty()) number_patches();
  }

  std::size_t number_of_triangles() const { return triangles_.size(); }

  BOOST_FORCEINLINE std::array<Vec, 3> triangle(Index t) const
  {
    const auto& c = triangles_[t];
    return { points_[c[0]], points_[c[1]], points_[c[2]] };
  }

  const std::vector<Vec>& points() const { return points_; }
  const std::vector<std::array<Index, 3>>& triangles() const { return triangles_; }
  // Across edge (i, i + 1) of triangle t; -1 at the border and at a sharp edge.
  Index neighbour(Index t, int i) const { return neighbours_[t][i]; }
  Index patch(Index t) const { return patches_[t]; }
  // Once they are provided.
  Vec normal(Index t) const
  {
    return kind_of_normals_ == Normals::kept ? normals_[t] : computed_normal(t);
  }

  // Before normals are asked for, and walks where triangles may face another way.
  void provide_normals(Normals kind)
  {
    kind_of_normals_ = kind;
    normals_.clear();
    if(kind != Normals::kept) return;
    normals_.reserve(triangles_.size());
    for(std::size_t t = 0; t < triangles_.size(); ++t)
      normals_.push_back(computed_normal(Index(t)));
  }

  // To the nearest point from triangle t, or to the first whose squared distance is near enough.
  // Updates t: the triangle of that point, -1 if the walk is lost.  Across a fine surface it may
  // take as many steps as that is wide: to build a tree for a few walks takes far longer.
  Vec walk(const Vec& p, Index& t, double near_enough = 0) const
  {
    const Index start = t;
    auto here = closest_on_triangle(p, triangle(t));
    double d = (p - here.point).squared_length();
    constexpr std::size_t many = 200;
    for(std::size_t step = 0; step < many || step * step < triangles_.size(); ++step) {
      if(here.feature == Triangle_feature::inside || d <= near_enough) return here.point;
      const Index next = better_neighbour(p, t, start, here, d);
      if(next < 0) return here.point;
      t = next;
    }
    t = -1;
    return here.point;
  }

private:
  // Twice as long as the triangle is large.
  Vec area_vector(Index t) const
  {
    const auto c = triangle(t);
    return cross(c[1] - c[0], c[2] - c[0]);
  }

  Vec computed_normal(Index t) const { return normalized(area_vector(t)); }

  // The neighbour of t, across the edge or round the corner that `here` lies on, that is nearer
  // to p; updates here and d.  -1 if there is none.
  Index better_neighbour(const Vec& p, Index t, Index start, Closest_on_triangle& here,
                         double& d) const
  {
    const double enough = d * (1 - 1e-12) - 1e-300;
    if(here.is_edge()) {
      const Index n = neighbours_[t][here.index];
      return n >= 0 && improves(p, n, start, enough, here, d) ? n : Index(-1);
    }
    const Index corner = triangles_[t][here.index];
    for(int side = 0; side < 2; ++side) { // both ways round, for corners on the border
      Index u = t;
      for(int guard = 0; guard < 64; ++guard) {
        const int i = corner_index(u, corner);
        const Index n = neighbours_[u][side == 0 ? (i + 2) % 3 : i];
        if(n < 0 || n == t) break;
        if(improves(p, n, start, enough, here, d)) return n;
        u = n;
      }
    }
    return -1;
  }

  bool improves(const Vec& p, Index n, Index start, double enough, Closest_on_triangle& here,
                double& d) const
  {
    const auto there = closest_on_triangle(p, triangle(n));
    const double dn = (p - there.point).squared_length();
    if(!(dn < enough)) return false;
    if(kind_of_normals_ != Normals::none && is_turned(n, start)) return false;
    here = there;
    d = dn;
    return true;
  }

  // Is one of two triangles round a thin edge, on the other side?  A right angle, as of a box, is
  // still allowed.
  bool is_turned(Index t, Index u) const
  {
    if(kind_of_normals_ == Normals::kept) return normals_[t] * normals_[u] < -0.2;
    const Vec a = area_vector(t), b = area_vector(u);
    return !(a * b > 0) && normalized(a) * normalized(b) < -0.2; // few need roots
  }

  int corner_index(Index t, Index v) const
  {
    return triangles_[t][0] == v ? 0 : triangles_[t][1] == v ? 1 : 2;
  }

  struct Side // of a triangle, in the bucket of its lower end
  {
    Index high, triangle, side;
    bool operator<(const Side& o) const
    {
      return std::tie(high, triangle, side) < std::tie(o.high, o.triangle, o.side);
    }
  };

  void link(const Edge_keys& sharp)
  {
    neighbours_.assign(triangles_.size(), { -1, -1, -1 });
    std::vector<std::size_t> first(points_.size() + 1, 0);
    for(std::size_t t = 0; t < triangles_.size(); ++t)
      for(int i = 0; i < 3; ++i) ++first[(std::min)(end(t, i), end(t, i + 1)) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<Side> sides(first.back());
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    for(std::size_t t = 0; t < triangles_.size(); ++t)
      for(int i = 0; i < 3; ++i) {
        const Index a = end(t, i), b = end(t, i + 1);
        sides[next[(std::min)(a, b)]++] = { (std::max)(a, b), Index(t), Index(i) };
      }
    for(std::size_t v = 0; v < points_.size(); ++v) {
      std::sort(sides.begin() + first[v], sides.begin() + first[v + 1]);
      for(std::size_t i = first[v]; i + 1 < first[v + 1]; ++i)
        link_sides(Index(v), sides[i], sides[i + 1], sharp);
    }
  }

  Index end(std::size_t t, int i) const { return triangles_[t][i % 3]; }

  void link_sides(Index low, const Side& e, const Side& f, const Edge_keys& sharp)
  {
    if(e.high != f.high) return;
    if(std::binary_search(sharp.begin(), sharp.end(), std::make_pair(low, e.high))) return;
    neighbours_[e.triangle][e.side] = f.triangle;
    neighbours_[f.triangle][f.side] = e.triangle;
  }

  void number_patches()
  {
    patches_.assign(triangles_.size(), -1);
    Index number = 0;
    std::vector<Index> todo;
    for(std::size_t first = 0; first < triangles_.size(); ++first) {
      if(patches_[first] >= 0) continue;
      patches_[first] = number;
      todo.push_back(Index(first));
      while(!todo.empty()) {
        const Index t = todo.back();
        todo.pop_back();
        for(Index n : neighbours_[t]) {
          if(n < 0 || patches_[n] >= 0) continue;
          patches_[n] = number;
          todo.push_back(n);
        }
      }
      ++number;
    }
  }

  std::vector<Vec> points_;
  std::vector<std::array<Index, 3>> triangles_, neighbours_; // neighbour i: across edge i, i+1
  Normals kind_of_normals_ = Normals::none;
  std::vector<Vec> normals_; // if they are kept
  std::vector<Index> patches_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LINKED_TRIANGLES_H
