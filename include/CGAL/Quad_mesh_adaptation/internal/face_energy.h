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

// Mean of the four edge lengths, eq. 1 of the paper.
inline double mean_edge_length(const Corners& p)
{
  return 0.25 * (distance(p[0], p[1]) + distance(p[1], p[2]) + distance(p[2], p[3]) +
                 distance(p[3], p[0]));
}

// Twice the vector area, along the face's own normal (cross product of the diagonals).
BOOST_FORCEINLINE Vec area_vector(const Corners& p) { return cross(p[2] - p[0], p[3] - p[1]); }

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

// Is the scaled Jacobian below `floor`?  Most faces are far enough above it for squares to tell.
inline bool is_jacobian_below(const Corners& p, double floor)
{
  constexpr double margin = 1 + 1e-9;
  const Vec n = area_vector(p), e[4] = { p[1] - p[0], p[2] - p[1], p[3] - p[2], p[0] - p[3] };
  const double l[4] = { e[0] * e[0], e[1] * e[1], e[2] * e[2], e[3] * e[3] };
  const double least = margin * floor * floor * (n * n);
  for(int i = 0; i < 4; ++i) {
    const int j = (i + 3) & 3;
    const double d = n * cross(e[j], e[i]);
    if(!(floor > 0 && d > 0 && d * d > least * l[j] * l[i])) return scaled_jacobian(p) < floor;
  }
  return false;
}

// Warp as a quality to compare with scaled Jacobians: 1 for faces folded by 40 degrees or less, and
// below the floor of shapes from some 65 degrees on.
inline double flatness(double warp) { return (std::min)(1., 1 - 1.4 * (warp - 0.5)); }

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
    if(D >= flat * N) {
      const double i = N / (2 * D); // s + 1
      return i * (i - 1);
    }
    return at_flat() + slope() * (2 * flat - 2 * D / N);
  }
  static constexpr double at_flat()
  {
    const double s = 0.5 / flat - 1;
    return s + s * s;
  }
  static constexpr double slope() // -d cost / dt at t = 2 flat
  {
    const double t = 2 * flat, s = 1 / t - 1;
    return (1 + 2 * s) / (t * t);
  }
  static constexpr double limit() { return at_flat() + slope() * (1 + 2 * flat); }
};

// The same for operations, of a corner with squared edge lengths la and lb; but slivers with right
// angles and an aspect ratio above 8, as on the rim of a thin plate, cost less than twice as much
// if they are twice as long, or a row of them could never be thinned.
inline double corner_energy(double la, double lb, double D)
{
  constexpr double sliver = 4, narrow = 0.02; // s + 1; t = 1 / (s + 1) where a line takes over
  const double N = la + lb, cost = Corner_cost::value(N, D);
  if(!(2 * sliver * D < N) || !(D > 0)) return cost;
  const double square = std::clamp(5 * D / std::sqrt(la * lb) - 4, 0., 1.); // from 53 to 90 degrees
  const double t = 2 * D / N, slope = sliver * (2 * sliver - 1);
  const double flatter = sliver * (sliver - 1) - slope * std::log(sliver * (std::max)(t, narrow)) +
                         slope * (std::max)(1 - t / narrow, 0.);
  return cost + square * (flatter - cost);
}

// Mean corner cost of a face, measured along the unit normal n.
inline double shape_cost(const Corners& p, const Vec& n)
{
  const Vec e[4] = { p[1] - p[0], p[2] - p[1], p[3] - p[2], p[0] - p[3] };
  const double l[4] = { e[0] * e[0], e[1] * e[1], e[2] * e[2], e[3] * e[3] };
  // opposite corners add up to the cross product of the diagonals
  const double d0 = n * cross(e[3], e[0]), d1 = n * cross(e[0], e[1]), both = n * area_vector(p);
  return 0.25 * (corner_energy(l[3], l[0], d0) + corner_energy(l[0], l[1], d1) +
                 corner_energy(l[1], l[2], both - d0) + corner_energy(l[2], l[3], both - d1));
}

// Where a face should look: the unit normals of the reference surface at its corners, added up.
// Corners on curves of a curved surface have none.
struct Facing
{
  Vec sum = Vec(0, 0, 0);
  int count = 0;

  void add(const Vec& normal)
  {
    sum = sum + normal;
    if(normal * normal > 0) ++count;
  }
  // Mean cosine between the unit normal n of a face and those of the surface at its corners: 1 on
  // a plane, 0.71 for a cylinder of four faces.
  double mean_cosine(const Vec& n) const { return count > 0 ? n * sum / count : 1.; }
};

// How well a face follows the surface, on the scale of the scaled Jacobian: 0.5 where its normal
// leaves that of the surface by 68 degrees on average.
inline double following(double mean_cosine) { return 3 * (mean_cosine - 0.2); }

// The weights of the one energy that coarsening, clean-up and polishing lower:
//   E = sum over faces (1 + shape * cost + oversize(r) + turn(c)) + valence * sum over nodes
//       (n - ideal)^2
struct Energy_weights
{
  double face = 1;        // what a face costs
  double shape = 0.5;     // times the mean corner cost
  double oversize = 4;    // faces larger than wanted
  double turn = 20;       // faces that do not follow the surface
  double valence = 1.4;   // irregular nodes
  double tolerated = 1;   // size ratio above which a face is too large
  double min_gain = 1e-3; // every accepted operation lowers E by at least this

  // Grows faster than r^2, else splitting one face into four would not pay.
  double oversize_cost(double r) const
  {
    const double x = r / tolerated;
    return x > 1 ? oversize * (x * x * x - 1) : 0.;
  }

  double turn_cost(double mean_cosine) const
  {
    const double x = (std::max)(0.6 - mean_cosine, 0.);
    return turn * x * x;
  }
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_ENERGY_H
