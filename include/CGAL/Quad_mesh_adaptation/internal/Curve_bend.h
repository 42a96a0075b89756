// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CURVE_BEND_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CURVE_BEND_H

#include <CGAL/Quad_mesh_adaptation/internal/Feature_curve.h>
#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Where the polyline of a curve bends.
struct Curve_bend
{
  double arc;                  // where on the curve
  double shorter, mean_length; // of the two edges of the polyline
  double turn;                 // radians

  // The share of its length that the curve loses at worst if edges as long as h pass it by.
  double loss(double h) const { return turn * turn / 8 * (std::min)(1., h / mean_length); }
};

constexpr double curve_loss_allowed = 7e-4;

// The bends of a curve that cost more than they may if nodes pass them by.
inline std::vector<Curve_bend> bends_of(const Feature_curve& c)
{
  const std::vector<Vec>& p = c.points();
  const std::size_t n = p.size() - 1;
  std::vector<Curve_bend> bends;
  for(std::size_t i = c.is_closed() ? 0 : 1; i < n; ++i) {
    const Vec a = p[i] - p[i == 0 ? n - 1 : i - 1], b = p[i + 1] - p[i];
    const double turn = angle_between(a, b), la = norm(a), lb = norm(b);
    if(turn * turn / 8 > curve_loss_allowed)
      bends.push_back({ c.arcs()[i], (std::min)(la, lb), 0.5 * (la + lb), turn });
  }
  return bends;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CURVE_BEND_H
