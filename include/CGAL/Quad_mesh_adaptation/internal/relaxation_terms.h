// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_RELAXATION_TERMS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_RELAXATION_TERMS_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/Star_face.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// What a node's star is worth with the node in one place.
struct Evaluation
{
  double value = 0, worst = 1; // worst corner t = 2 D / N
  int inverted = 0;            // faces
  double largest = 0;          // size ratio
};

// A corner's measure t = 2 D / N and the derivatives of its cost in t.
struct Corner_terms
{
  double t, inverse_N, c1, c2;
};

inline Corner_terms add_corner(double N, double D, Evaluation& e)
{
  if(!(N > 0)) {
    e.value += 0.25 * Corner_cost::limit();
    e.worst = -1;
    return { -1, 0, 0, 0 };
  }
  if(D >= Corner_cost::flat * N) {
    const double r = 1 / (2 * D * N), t = 4 * D * D * r, i = N * N * r; // i = 1 / t
    e.worst = (std::min)(e.worst, t);
    e.value += 0.25 * i * (i - 1);
    return { t, 2 * D * r, -0.25 * (2 * i - 1) * i * i, 0.25 * (6 * i - 2) * i * i * i };
  }
  const double inverse_N = 1 / N, t = 2 * D * inverse_N;
  e.worst = (std::min)(e.worst, t);
  constexpr double at_flat = Corner_cost::at_flat(), slope = Corner_cost::slope();
  e.value += 0.25 * (at_flat + slope * (2 * Corner_cost::flat - t));
  return { t, inverse_N, -0.25 * slope, 0 };
}

// hN: second derivative of N in each direction.
inline void add_corner_slopes(const Corner_terms& c, double hN, const double* dN, const double* dD,
                              Local_model& m)
{
  const double x = (2 * dD[0] - c.t * dN[0]) * c.inverse_N,
               y = (2 * dD[1] - c.t * dN[1]) * c.inverse_N;
  m.g[0] += c.c1 * x;
  m.g[1] += c.c1 * y;
  // N t = 2 D, differentiated twice (D is linear in x)
  const double s = -c.c1 * c.inverse_N;
  m.H[0] += c.c2 * x * x + s * (c.t * hN + 2 * dN[0] * x);
  m.H[1] += c.c2 * x * y + s * (dN[0] * y + dN[1] * x);
  m.H[2] += c.c2 * y * y + s * (c.t * hN + 2 * dN[1] * y);
}

inline double integer_power(double x, int n)
{
  double result = 1;
  for(; n > 0; n >>= 1, x *= x)
    if(n & 1) result *= x;
  return result;
}

// r^power / 2 up to r = 1.5, then its parabola, so that far too large faces do not swamp all.
inline double size_cost(const Smoothing_weights& w, double r, double& d1, double& d2)
{
  const double c = (std::min)(r, 1.5), k = w.power;
  const double p2 = integer_power(c, w.power - 2), b1 = 0.5 * k * p2 * c,
               b2 = 0.5 * k * (k - 1) * p2;
  double v = 0.5 * p2 * c * c + b1 * (r - c) + 0.5 * b2 * (r - c) * (r - c);
  d1 = w.size * (b1 + b2 * (r - c));
  d2 = w.size * b2;
  v *= w.size;
  if(w.hinge > 0 && r > w.hinge_at) {
    const double x = r - w.hinge_at;
    v += w.hinge * x * x;
    d1 += 2 * w.hinge * x;
    d2 += 2 * w.hinge;
  }
  return v;
}

// Newton step, with the Hessian shifted to be positive definite.
inline bool newton_step(const Local_model& m, int dofs, double* step)
{
  if(dofs == 1) {
    const double h = std::abs(m.H[0]);
    if(!(h > 0)) return false;
    step[0] = -m.g[0] / h;
    return std::isfinite(step[0]);
  }
  double a = m.H[0], b = m.H[1], c = m.H[2];
  const double mean = 0.5 * (a + c), dev = std::sqrt(0.25 * (a - c) * (a - c) + b * b);
  const double low = mean - dev, want = 0.1 * (std::abs(mean) + dev);
  if(low < want) {
    a += want - low;
    c += want - low;
  }
  const double det = a * c - b * b;
  if(!(det > 0)) return false;
  step[0] = -(c * m.g[0] - b * m.g[1]) / det;
  step[1] = -(a * m.g[1] - b * m.g[0]) / det;
  return std::isfinite(step[0]) && std::isfinite(step[1]);
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_RELAXATION_TERMS_H
