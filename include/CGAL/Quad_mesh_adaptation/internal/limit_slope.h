// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LIMIT_SLOPE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LIMIT_SLOPE_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>
#include <CGAL/Quad_mesh_adaptation/internal/lower_values.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The least of value(x) + slope |x p| over the points x of a segment whose ends have the given
// values, linear in between: what the segment lets a function of that slope be at p.
inline double bound_from_segment(const Vec& a, double at_a, const Vec& b, double at_b, const Vec& p,
                                 double slope)
{
  const double length = distance(a, b);
  if(!(length > 0)) return (std::min)(at_a, at_b) + slope * distance(a, p);
  if(std::isinf(at_b)) return at_a + slope * distance(a, p); // there is no value there yet
  const Vec along = (b - a) / length;
  const double foot = (p - a) * along, height = norm(p - a - foot * along);
  const double growth = (at_b - at_a) / length;
  double x = growth > 0 ? 0 : length;
  if(std::abs(growth) < slope)
    x = std::clamp(foot - growth * height / std::sqrt((slope - growth) * (slope + growth)), 0.,
                   length);
  return at_a + growth * x + slope * std::hypot(x - foot, height);
}

// Lowers values at points until they grow by at most `slope` per unit of distance over the
// triangles between them: Dijkstra's algorithm with fronts that cross the triangles (R. Kimmel and
// J. A. Sethian, "Computing geodesic paths on manifolds", 1998; the update is that of F. Bornemann
// and C. Rasch, "Finite-element discretization of static Hamilton-Jacobi equations based on a local
// variational principle", 2006).  A front that must turn at an obtuse angle may visit a point
// again, which keeps the result independent of the angles.
inline void limit_slope(const std::vector<Vec>& points,
                        const std::vector<std::array<Index, 3>>& triangles, double slope,
                        std::vector<double>& value)
{
  constexpr double least_gain = 1e-9; // relative; makes the revisits end
  std::vector<std::size_t> first(points.size() + 1, 0), of_point(3 * triangles.size());
  for(const auto& t : triangles)
    for(Index v : t) ++first[v + 1];
  for(std::size_t v = 0; v < points.size(); ++v) first[v + 1] += first[v];
  std::vector<std::size_t> end(first.begin(), first.end() - 1);
  for(std::size_t t = 0; t < triangles.size(); ++t)
    for(Index v : triangles[t]) of_point[end[v]++] = t;

  lower_values(value, [&](double h, Index v, const auto& lower) {
    for(std::size_t i = first[v]; i < end[v]; ++i) {
      const auto& t = triangles[of_point[i]];
      const int at = t[0] == v ? 0 : t[1] == v ? 1 : 2;
      const Index others[2] = { t[(at + 1) % 3], t[(at + 2) % 3] };
      for(int k = 0; k < 2; ++k) {
        const Index w = others[k], x = others[1 - k];
        const double bound =
            bound_from_segment(points[v], h, points[x], value[x], points[w], slope);
        if(bound < value[w] * (1 - least_gain)) lower(w, bound);
      }
    }
  });
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LIMIT_SLOPE_H
