// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_BARYCENTRIC_WEIGHTS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_BARYCENTRIC_WEIGHTS_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <array>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Weights of the corners at a point of the triangle, kept in [0,1] against rounding.
inline std::array<double, 3> barycentric_weights(const std::array<Vec, 3>& t, const Vec& q)
{
  const Vec normal = cross(t[1] - t[0], t[2] - t[0]);
  std::array<double, 3> w;
  double sum = 0;
  for(int i = 0; i < 3; ++i) {
    const Vec &a = t[(i + 1) % 3], &b = t[(i + 2) % 3];
    w[i] = (std::max)(cross(b - a, q - a) * normal, 0.);
    sum += w[i];
  }
  if(!(sum > 0)) return { 1. / 3, 1. / 3, 1. / 3 };
  for(double& x : w) x /= sum;
  return w;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_BARYCENTRIC_WEIGHTS_H
