// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PRINCIPAL_CURVATURES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PRINCIPAL_CURVATURES_H

#include <Eigen/Dense>

#include <cmath>
#include <utility>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The curvatures of a surface at a point.
struct Principal_curvatures
{
  double largest = 0; // without sign
  double other = 0;   // negative where the surface bends the other way

  Principal_curvatures() = default;
  Principal_curvatures(double k1, double k2)
  {
    if(std::abs(k1) < std::abs(k2)) std::swap(k1, k2);
    largest = std::abs(k1);
    other = k1 < 0 ? -k2 : k2;
  }
  // Of a shape operator in space, that is zero along the normal.
  explicit Principal_curvatures(const Eigen::Matrix3d& m)
  {
    const Eigen::Vector3d k =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(m, Eigen::EigenvaluesOnly).eigenvalues();
    *this = std::abs(k[0]) > std::abs(k[2])
                ? Principal_curvatures(k[0], std::abs(k[1]) > std::abs(k[2]) ? k[1] : k[2])
                : Principal_curvatures(k[2], std::abs(k[1]) > std::abs(k[0]) ? k[1] : k[0]);
  }
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PRINCIPAL_CURVATURES_H
