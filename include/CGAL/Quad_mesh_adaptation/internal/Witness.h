// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_WITNESS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_WITNESS_H

#include <CGAL/Quad_mesh_adaptation/internal/closest_point.h>
#include <CGAL/Quad_mesh_adaptation/internal/face_energy.h>
#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// A point of the reference surface that faces are to stay near, and what it costs if they do not:
// the square of what the distance is above the allowed one, in wanted sizes; from one size on its
// tangent, so that a tip that is far off does not swamp all else.
struct Witness
{
  static constexpr double weight = 20;
  static constexpr double turned_away = -0.3; // cosine to a face that cannot cover it

  Vec p, normal;
  double allowed = 0, inverse_h = 0;
  Index patch = -1, triangle = -1; // of the surface
  Index next = -1;                 // of the same face
  double cost = 0;                 // on its face

  double cost_at(double distance) const
  {
    const double x = (distance - allowed) * inverse_h;
    return x <= 0 ? 0. : weight * (x < 1 ? x * x : 2 * x - 1);
  }

  // Squared distance to a face, cut in two from corner 0 to corner 2.
  double distance2(const Corners& c) const
  {
    const Vec a = closest_on_triangle(p, { c[0], c[1], c[2] }).point - p,
              b = closest_on_triangle(p, { c[0], c[2], c[3] }).point - p;
    return (std::min)(a * a, b * b);
  }

  // From a face, but farther from one that is turned away: it does not cover, however near.
  double distance_to(const Corners& c) const { return distance_to(c, area_vector(c)); }
  double distance_to(const Corners& c, const Vec& n) const
  {
    const double d = std::sqrt(distance2(c));
    return n * normal < turned_away * norm(n) ? d + 1 / inverse_h : d;
  }
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_WITNESS_H
