// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_EXAMPLES_REFERENCE_STRESS_H
#define QUAD_MESH_ADAPTATION_EXAMPLES_REFERENCE_STRESS_H

#include "polar_plate.h"
#include "quarter_plate_in_tension.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace plane_stress {

/// The stress in a square quarter plate with a hole of radius 1, from a very fine polar mesh:
/// recovered at its nodes, interpolated between them.
class Reference_stress
{
public:
  explicit Reference_stress(const Quarter_plate_in_tension& plate, double side, int cells = 320)
      : side_(side), cells_(cells)
  {
    const Plane_mesh mesh = polar_plate(side, side, cells, cells);
    const Quarter_plate_in_tension::Result r = plate.solve(mesh);
    nodal_stress_ = r.estimate.nodal_stress;
    energy_norm_ = std::hypot(r.estimate.energy_norm, r.estimate.error_norm);
    relative_error_ = r.estimate.relative_error();
  }

  double energy_norm() const { return energy_norm_; }
  /// Estimated error of the fine solution before recovery, as a share of its energy norm.
  double relative_error() const { return relative_error_; }

  /// At a point of the plate; a point inside the hole gets the stress of its rim.
  Stress operator()(const Eigen::Vector2d& p) const
  {
    // the line through the hole's rim and the plate's that p lies on, by bisection
    double low = 0, high = 1;
    for(int i = 0; i < 50; ++i) {
      const double t = (low + high) / 2;
      (is_left_of_line(p, t) ? low : high) = t;
    }
    const double t = (low + high) / 2;
    const Eigen::Vector2d along = far(t) - rim(t);
    const double w = std::clamp((p - rim(t)).dot(along) / along.squaredNorm(), 0., 1.);
    const double across = std::log1p(w * std::expm1(3.)) / 3; // the layers of polar_plate()
    const int i = (std::min)(cells_ - 1, int(t * cells_)),
              l = (std::min)(cells_ - 1, int(across * cells_));
    const double u = t * cells_ - i, v = across * cells_ - l;
    return (1 - u) * ((1 - v) * at(i, l) + v * at(i, l + 1)) +
           u * ((1 - v) * at(i + 1, l) + v * at(i + 1, l + 1));
  }

private:
  Eigen::Vector2d rim(double t) const
  {
    const double angle = t * std::acos(-1.) / 2;
    return { std::cos(angle), std::sin(angle) };
  }
  Eigen::Vector2d far(double t) const
  {
    return t <= 0.5 ? Eigen::Vector2d(side_, 2 * t * side_)
                    : Eigen::Vector2d(2 * (1 - t) * side_, side_);
  }
  bool is_left_of_line(const Eigen::Vector2d& p, double t) const
  {
    const Eigen::Vector2d a = rim(t), d = far(t) - a, q = p - a;
    return d.x() * q.y() - d.y() * q.x() > 0;
  }
  const Stress& at(int i, int l) const { return nodal_stress_[i * (cells_ + 1) + l]; }

  double side_;
  int cells_;
  std::vector<Stress> nodal_stress_;
  double energy_norm_ = 0, relative_error_ = 0;
};

/// Energy norm of the difference between the stress of a solution and the reference, by 3 x 3
/// Gauss points in every element, as a share of the reference's energy norm.
inline double true_relative_error(const Plane_mesh& mesh, const Material& material,
                                  const Eigen::VectorXd& displacement,
                                  const Reference_stress& reference)
{
  const double g = std::sqrt(0.6);
  const std::array<double, 3> place = { { -g, 0, g } }, weight = { { 5. / 9, 8. / 9, 5. / 9 } };
  const Problem problem(mesh, material);
  const Eigen::Matrix3d compliance = material.thickness * material.elasticity().inverse();
  double squares = 0;
  for(std::size_t e = 0; e < mesh.quads.size(); ++e) {
    const auto c = mesh.corners(e);
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j) {
        const Local_point local = { place[i], place[j] };
        const Eigen::Vector4d shape = shape_functions(local);
        Eigen::Vector2d p(0, 0);
        for(int k = 0; k < 4; ++k) p += shape[k] * c[k];
        const Stress difference = reference(p) - problem.stress(displacement, e, local);
        squares += weight[i] * weight[j] * strain_operator(c, local).area *
                   difference.dot(compliance * difference);
      }
  }
  return std::sqrt(squares) / reference.energy_norm();
}

} // namespace plane_stress

#endif // QUAD_MESH_ADAPTATION_EXAMPLES_REFERENCE_STRESS_H
