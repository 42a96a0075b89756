// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_ENERGY_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_ENERGY_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

using Corners = std::array<Vec, 4>;

// Mean of the four edge lengths, eq. 1 of the paper.
inline double mean_edge_length(const Corners& p)
{
  return 0.25 * (distance(p[0], p[1]) + distance(p[1], p[2]) + distance(p[2], p[3]) +
                 distance(p[3], p[0]));
}

// Twice the vector area, along the face's own normal (cross product of the diagonals).
inline Vec area_vector(const Corners& p) { return cross(p[2] - p[0], p[3] - p[1]); }

// Verdict's scaled Jacobian: the smallest sine-like corner value in [-1, 1].
inline double scaled_jacobian(const Corners& p)
{
  const Vec n = normalized(area_vector(p));
  double worst = 1;
  for(int i = 0; i < 4; ++i) {
    const Vec a = p[(i + 1) & 3] - p[i], b = p[(i + 3) & 3] - p[i];
    const double l = std::sqrt((a * a) * (b * b));
    worst = (std::min)(worst, l > 0 ? n * cross(a, b) / l : 0.);
  }
  return n * n > 0 ? worst : 0.;
}

// Shape of one corner with edge vectors a, b and signed area D: s = (|a|^2 + |b|^2) / (2 D) - 1,
// zero for the corner of a square (Knupp's shape metric).  The cost s + s^2 weighs the worst
// corners more; where D is small it goes on as a steep line, so that an inverted corner has a
// finite cost that falls as the corner opens.
struct Corner_cost
{
  static constexpr double flat = 0.06; // D / N below which the line takes over

  static double value(double N, double D)
  {
    if(!(N > 0)) return limit();
    const double t = 2 * D / N; // in [-1, 1]
    if(t >= 2 * flat) {
      const double s = 1 / t - 1;
      return s + s * s;
    }
    return at_flat() + slope() * (2 * flat - t);
  }
  static double at_flat()
  {
    const double s = 0.5 / flat - 1;
    return s + s * s;
  }
  static double slope() // -d cost / dt at t = 2 flat
  {
    const double t = 2 * flat, s = 1 / t - 1;
    return (1 + 2 * s) / (t * t);
  }
  static double limit() { return at_flat() + slope() * (1 + 2 * flat); }
};

// Mean corner cost of a face, measured along the unit normal n.
inline double shape_cost(const Corners& p, const Vec& n)
{
  double sum = 0;
  for(int i = 0; i < 4; ++i) {
    const Vec a = p[(i + 1) & 3] - p[i], b = p[(i + 3) & 3] - p[i];
    sum += Corner_cost::value(a * a + b * b, n * cross(a, b));
  }
  return 0.25 * sum;
}

// The weights of the one energy that coarsening, clean-up and polishing lower:
//   E = sum over faces (1 + shape * cost + oversize(r)) + valence * sum over nodes (n - ideal)^2
struct Energy_weights
{
  double face = 1;        // what a face costs
  double shape = 0.5;     // times the mean corner cost
  double oversize = 4;    // faces larger than wanted
  double valence = 1.25;  // irregular nodes
  double tolerated = 1;   // size ratio above which a face is too large
  double min_gain = 1e-3; // every accepted operation lowers E by at least this

  // Grows faster than r^2, else splitting one face into four would not pay.
  double oversize_cost(double r) const
  {
    const double x = r / tolerated;
    return x > 1 ? oversize * (x * x * x - 1) : 0.;
  }
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_ENERGY_H
