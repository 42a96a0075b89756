// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_VALUES_ON_TRIANGLES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_VALUES_ON_TRIANGLES_H

#include <CGAL/Quad_mesh_adaptation/internal/Box_tree.h>
#include <CGAL/Quad_mesh_adaptation/internal/barycentric_weights.h>
#include <CGAL/Quad_mesh_adaptation/internal/closest_point.h>

#include <array>
#include <cstddef>
#include <cstdint>
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

// A function that is linear on each of some triangles, and elsewhere that of the nearest point on
// them.  Adaptation asks for millions of values, most of them near the one before; so each thread
// starts where its last search ended.  The result does not depend on that: the hint only bounds
// how far to look, and the order in which triangles are compared is always the same.
class Values_on_triangles
{
  struct Corners_of
  {
    const std::vector<Valued_triangle>& triangles;
    const std::array<Vec, 3>& operator()(Index t) const { return triangles[t].corners; }
  };

public:
  // Precondition: there is at least one triangle, each with an area.
  explicit Values_on_triangles(std::vector<Valued_triangle> triangles)
      : triangles_(std::move(triangles)), tree_(Index(triangles_.size()), Corners_of{ triangles_ })
  {
  }
  Values_on_triangles(const Values_on_triangles&) = delete; // hints are known by the address

  // Not a number where a coordinate is none.
  double operator()(const Vec& p) const
  {
    Hint& hint = my_hint();
    if(hint.owner != this || hint.triangle >= Index(triangles_.size())) hint = { this, 0 };
    const Valued_triangle& near = triangles_[hint.triangle];
    const double within = distance(p, closest_on_triangle(p, near.corners).point) +
                          1e-9 * distance(near.corners[0], near.corners[1]);
    const Box_tree::Nearest found = tree_.nearest(
        p, Corners_of{ triangles_ }, [](Index) { return true; }, (1 + 1e-9) * within);
    if(found.triangle < 0) return std::numeric_limits<double>::quiet_NaN();
    hint.triangle = found.triangle;
    const Valued_triangle& t = triangles_[found.triangle];
    const std::array<double, 3> w = barycentric_weights(t.corners, found.point);
    return w[0] * t.values[0] + w[1] * t.values[1] + w[2] * t.values[2];
  }

private:
  struct Hint
  {
    const Values_on_triangles* owner;
    Index triangle;
  };

  // One of a few for each thread, so that functions which are asked in turn keep theirs.
  Hint& my_hint() const
  {
    constexpr std::size_t few = 16;
    static thread_local std::array<Hint, few> hints = {};
    return hints[(reinterpret_cast<std::uintptr_t>(this) >> 4) % few];
  }

  std::vector<Valued_triangle> triangles_;
  Box_tree tree_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_VALUES_ON_TRIANGLES_H
