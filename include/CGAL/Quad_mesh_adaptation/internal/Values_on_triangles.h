// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_VALUES_ON_TRIANGLES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_VALUES_ON_TRIANGLES_H

#include <CGAL/Quad_mesh_adaptation/internal/Nearest_triangle.h>
#include <CGAL/Quad_mesh_adaptation/internal/barycentric_weights.h>

#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// A function that is linear on each of some triangles, and elsewhere that of the nearest point on
// them.  Adaptation asks for millions of values.
class Values_on_triangles
{
public:
  // Precondition: there is at least one triangle, each with an area.
  explicit Values_on_triangles(std::vector<Valued_triangle> triangles)
      : nearest_(std::move(triangles))
  {
  }

  // Not a number where a coordinate is none.
  double operator()(const Vec& p) const
  {
    const Value_tree::Search found = nearest_(p);
    if(found.triangle < 0) return std::numeric_limits<double>::quiet_NaN();
    const Valued_triangle& t = nearest_[found.triangle];
    const std::array<double, 3> w = barycentric_weights(t.corners, found.nearest);
    return w[0] * t.values[0] + w[1] * t.values[1] + w[2] * t.values[2];
  }

private:
  Nearest_triangle nearest_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_VALUES_ON_TRIANGLES_H
