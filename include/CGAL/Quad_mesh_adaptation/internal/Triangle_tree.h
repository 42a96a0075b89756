// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TRIANGLE_TREE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TRIANGLE_TREE_H

#include <CGAL/Quad_mesh_adaptation/internal/closest_point.h>
#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Nearest point of a set of triangles.  The tree is complete when the constructor returns, so
// that queries from several threads do not meet in a lazy construction.
class Triangle_tree
{
  using Triangle_3 = Core_kernel::Triangle_3;
  using Iterator = std::vector<Triangle_3>::const_iterator;
#if CGAL_VERSION_NR >= 1060000000
  using Primitive = CGAL::AABB_triangle_primitive_3<Core_kernel, Iterator>;
  using Traits = CGAL::AABB_traits_3<Core_kernel, Primitive>;
#else
  using Primitive = CGAL::AABB_triangle_primitive<Core_kernel, Iterator>;
  using Traits = CGAL::AABB_traits<Core_kernel, Primitive>;
#endif

public:
  struct Nearest
  {
    Vec point;
    std::size_t triangle;
  };

  // Precondition: there is at least one triangle.  With hints the nearest is found faster; they
  // take as long to prepare as the tree, and as much memory.
  explicit Triangle_tree(std::vector<Triangle_3> triangles, bool with_hints = true)
      : triangles_(std::move(triangles)), tree_(triangles_.cbegin(), triangles_.cend())
  {
    tree_.build();
    if(with_hints)
      tree_.accelerate_distance_queries();
    else
      tree_.do_not_accelerate_distance_queries();
  }
  Triangle_tree(const Triangle_tree&) = delete; // the tree points into the vector
  Triangle_tree& operator=(const Triangle_tree&) = delete;

  Nearest nearest(const Vec& p) const
  {
    const auto found = tree_.closest_point_and_primitive(Core_kernel::Point_3(p.x(), p.y(), p.z()));
    return { Vec(found.first.x(), found.first.y(), found.first.z()),
             std::size_t(found.second - triangles_.cbegin()) };
  }

  // The first triangle on a ray but for those that `skip(number)` is true for; -1 if there is none.
  template <class Skip>
  Index first_on_ray(const Vec& origin, const Vec& direction, const Skip& skip) const
  {
    const Core_kernel::Ray_3 ray(Core_kernel::Point_3(origin.x(), origin.y(), origin.z()),
                                 direction);
    const auto found = tree_.first_intersected_primitive(
        ray, [&](Iterator t) { return skip(Index(t - triangles_.cbegin())); });
    return found ? Index(*found - triangles_.cbegin()) : Index(-1);
  }

  // The triangle nearest to p, and nearer than `within`, among those that `accept(number)` likes;
  // -1 if there is none.
  template <typename Accept>
  long nearest_of(const Vec& p, const Accept& accept, double within) const
  {
    Search<Accept> search{ triangles_.cbegin(), p, accept, -1, within * within };
    tree_.traversal(p, search);
    return search.best;
  }

private:
  // What the tree's traversal asks: boxes and triangles nearer than the best so far.
  template <typename Accept>
  struct Search
  {
    Iterator first;
    Vec p;
    const Accept& accept;
    long best;
    double distance2; // of the best, at first the bound

    bool go_further() const { return true; }

    template <typename Node>
    bool do_intersect(const Vec&, const Node& node) const
    {
      const CGAL::Bbox_3& b = node.bbox();
      double d2 = 0;
      for(int i = 0; i < 3; ++i) {
        const double x = (std::max)({ (b.min)(i)-p[i], p[i] - (b.max)(i), 0. });
        d2 += x * x;
      }
      return d2 < distance2;
    }

    void intersection(const Vec&, const Primitive& primitive)
    {
      const std::size_t i = std::size_t(primitive.id() - first);
      if(!accept(i)) return;
      const auto corner = [&](int k) { return primitive.id()->vertex(k) - CGAL::ORIGIN; };
      const Vec q = closest_on_triangle(p, { corner(0), corner(1), corner(2) }).point;
      const double d2 = (p - q).squared_length();
      if(!(d2 < distance2)) return;
      distance2 = d2;
      best = long(i);
    }
  };

  std::vector<Triangle_3> triangles_;
  CGAL::AABB_tree<Traits> tree_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TRIANGLE_TREE_H
