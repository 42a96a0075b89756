// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISJOINT_SETS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISJOINT_SETS_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Disjoint sets over 0..n-1, with path halving; the representative of a set is its lowest member,
// so that it does not depend on the order of the unions.
class Disjoint_sets
{
public:
  explicit Disjoint_sets(std::size_t n = 0) : parent_(n)
  {
    std::iota(parent_.begin(), parent_.end(), Index(0));
  }

  std::size_t size() const { return parent_.size(); } // of all together

  // A set of its own; returns the number of its member.
  Index add()
  {
    parent_.push_back(Index(parent_.size()));
    return parent_.back();
  }

  Index find(Index i)
  {
    while(parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  // Joins the sets of `a` and `b`; false when they were one already.
  bool unite(Index a, Index b)
  {
    a = find(a);
    b = find(b);
    if(a == b) return false;
    parent_[(std::max)(a, b)] = (std::min)(a, b);
    return true;
  }

private:
  std::vector<Index> parent_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISJOINT_SETS_H
