// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CREASE_LOOKUP_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CREASE_LOOKUP_H

#include <CGAL/Quad_mesh_adaptation/internal/Reference_creases.h>
#include <CGAL/Quad_mesh_adaptation/internal/aabb_trees.h>

#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Tells where the borders and creases of a reference surface are.
class Crease_lookup
{
  using Segment_3 = Core_kernel::Segment_3;

public:
  explicit Crease_lookup(const Reference_creases& creases)
  {
    for(const auto& e : creases.segments()) {
      const Core_kernel::Point_3 a = CGAL::ORIGIN + e[0], b = CGAL::ORIGIN + e[1];
      if(a != b) segments_.emplace_back(a, b);
    }
    tree_.rebuild(segments_.cbegin(), segments_.cend());
  }
  Crease_lookup(const Crease_lookup&) = delete; // the tree points into the vector
  Crease_lookup& operator=(const Crease_lookup&) = delete;

  // Does one run beside the edge from a to b, nowhere farther off than half its length?
  bool runs_along(const Vec& a, const Vec& b) const
  {
    const double reach = 0.5 * distance(a, b);
    for(const Vec& p : { 0.5 * (a + b), a, b })
      if(!is_within(p, reach)) return false;
    return true;
  }

private:
  bool is_within(const Vec& p, double reach) const
  {
    return !tree_.empty() && tree_.squared_distance(CGAL::ORIGIN + p) <= reach * reach;
  }

  std::vector<Segment_3> segments_;
  Segment_aabb_tree tree_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CREASE_LOOKUP_H
