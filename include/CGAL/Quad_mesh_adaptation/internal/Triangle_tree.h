// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TRIANGLE_TREE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TRIANGLE_TREE_H

#include <CGAL/Quad_mesh_adaptation/internal/aabb_trees.h>
#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The first of a set of triangles on a ray.  The tree is complete when the constructor returns, so
// that queries from several threads do not meet in a lazy construction.
class Triangle_tree
{
  using Triangle_3 = Core_kernel::Triangle_3;

public:
  // Precondition: there is at least one triangle.
  explicit Triangle_tree(std::vector<Triangle_3> triangles)
      : triangles_(std::move(triangles)), tree_(triangles_.cbegin(), triangles_.cend())
  {
    tree_.do_not_accelerate_distance_queries();
    tree_.build();
  }
  Triangle_tree(const Triangle_tree&) = delete; // the tree points into the vector
  Triangle_tree& operator=(const Triangle_tree&) = delete;

  // The first triangle on a ray but for those that `skip(number)` is true for; -1 if there is none.
  template <class Skip>
  Index first_on_ray(const Vec& origin, const Vec& direction, const Skip& skip) const
  {
    const Core_kernel::Ray_3 ray(Core_kernel::Point_3(origin.x(), origin.y(), origin.z()),
                                 direction);
    const auto found = tree_.first_intersected_primitive(
        ray, [&](Triangle_iterator t) { return skip(Index(t - triangles_.cbegin())); });
    return found ? Index(*found - triangles_.cbegin()) : Index(-1);
  }

private:
  std::vector<Triangle_3> triangles_;
  Triangle_aabb_tree tree_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TRIANGLE_TREE_H
