// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The finite-element analysis of the plate example.

#include "../../examples/Quad_mesh_adaptation/support/polar_plate.h"
#include "../../examples/Quad_mesh_adaptation/support/quarter_plate_in_tension.h"
#include "../../examples/Quad_mesh_adaptation/support/zienkiewicz_zhu.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>
#include <stdexcept>
#include <vector>

using namespace plane_stress;
using Eigen::Vector2d;

namespace {

// n x m quads on the image of the unit square.
Plane_mesh mapped_grid(int n, int m, const std::function<Vector2d(double, double)>& map)
{
  Plane_mesh mesh;
  for(int j = 0; j <= m; ++j)
    for(int i = 0; i <= n; ++i) mesh.nodes.push_back(map(double(i) / n, double(j) / m));
  for(int j = 0; j < m; ++j)
    for(int i = 0; i < n; ++i) {
      const int v = j * (n + 1) + i;
      mesh.quads.push_back({ v, v + 1, v + n + 2, v + n + 1 });
    }
  return mesh;
}

// The unit square with inner nodes pushed about at random.
Plane_mesh distorted_square(int n)
{
  Plane_mesh mesh = mapped_grid(n, n, [](double u, double v) { return Vector2d(u, v); });
  std::mt19937 random(5);
  std::uniform_real_distribution<> push(-0.3 / n, 0.3 / n);
  for(Vector2d& p : mesh.nodes)
    if(p.minCoeff() > 1e-9 && p.maxCoeff() < 1 - 1e-9) p += Vector2d(push(random), push(random));
  return mesh;
}

const Material steel = { 210000., 0.3, 2. };

} // namespace

TEST(Plane_stress, stiffness_is_symmetric_and_knows_the_rigid_motions)
{
  const Plane_mesh mesh = distorted_square(4);
  const Sparse k = Problem(mesh, steel).stiffness();
  const double scale = Eigen::MatrixXd(k).cwiseAbs().maxCoeff();
  EXPECT_LT(Eigen::MatrixXd(k - Sparse(k.transpose())).cwiseAbs().maxCoeff(), 1e-12 * scale);
  Eigen::VectorXd shift_x(k.rows()), shift_y(k.rows()), turn(k.rows());
  for(std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    shift_x.segment<2>(2 * n) = Vector2d(1, 0);
    shift_y.segment<2>(2 * n) = Vector2d(0, 1);
    turn.segment<2>(2 * n) = Vector2d(-mesh.nodes[n].y(), mesh.nodes[n].x());
  }
  for(const Eigen::VectorXd& motion : { shift_x, shift_y, turn })
    EXPECT_LT((k * motion).cwiseAbs().maxCoeff(), 1e-11 * scale);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> spectrum{ Eigen::MatrixXd(k) };
  EXPECT_LT(std::abs(spectrum.eigenvalues()[2]), 1e-9 * scale);
  EXPECT_GT(spectrum.eigenvalues()[3], 1e-4 * scale); // and no other motion without strain
}

TEST(Plane_stress, patch_test_with_prescribed_boundary)
{
  const Plane_mesh mesh = distorted_square(5);
  Problem problem(mesh, steel);
  const auto exact = [](const Vector2d& p) {
    return Vector2d(1e-3 * (2 * p.x() + p.y() + 1), 1e-3 * (0.5 * p.x() - 3 * p.y()));
  };
  for(const auto& edge : boundary_edges(mesh))
    for(int direction = 0; direction < 2; ++direction)
      problem.prescribe(edge.first, direction, exact(mesh.nodes[edge.first])[direction]);
  const Eigen::VectorXd u = problem.solve();
  const Stress expected = steel.elasticity() * Stress(2e-3, -3e-3, 1.5e-3);
  for(std::size_t n = 0; n < mesh.nodes.size(); ++n)
    EXPECT_LT((u.segment<2>(2 * n) - exact(mesh.nodes[n])).norm(), 1e-13);
  for(std::size_t e = 0; e < mesh.quads.size(); ++e)
    for(const Local_point& p : gauss_points())
      EXPECT_LT((problem.stress(u, e, p) - expected).norm(), 1e-10 * expected.norm());
  const Error_estimate estimate = estimate_error(problem, u);
  EXPECT_LT(estimate.relative_error(), 1e-10);
  EXPECT_NEAR(estimate.max_effective_stress, effective(expected), 1e-9 * expected.norm());
}

TEST(Plane_stress, patch_test_with_traction_on_an_unsymmetric_mesh)
{
  const Plane_mesh mesh = distorted_square(5);
  Quarter_plate_in_tension plate;
  plate.a = plate.b = plate.c = { 1, 1 };
  const auto r = plate.solve(mesh);
  for(const Stress& s : r.estimate.nodal_stress)
    EXPECT_LT((s - Stress(plate.traction, 0, 0)).norm(), 1e-10 * plate.traction);
  EXPECT_NEAR(r.x_at_a, plate.traction / plate.material.young, 1e-15);
}

TEST(Plane_stress, refuses_a_free_body_and_clockwise_elements)
{
  const Plane_mesh mesh = distorted_square(3);
  Problem floating(mesh, steel);
  floating.prescribe(0, 0, 0);
  EXPECT_THROW(floating.solve(), std::runtime_error);
  Plane_mesh clockwise = mesh;
  for(auto& q : clockwise.quads) std::swap(q[1], q[3]);
  EXPECT_THROW(Problem(clockwise, steel).stiffness(), std::invalid_argument);
}

TEST(Plane_stress, recovery_reproduces_a_linear_stress_on_a_regular_mesh)
{
  // pure bending of the unit square: sigma_xx = y - 1/2, which bilinear elements meet at centres
  const Plane_mesh mesh = mapped_grid(8, 8, [](double u, double v) { return Vector2d(u, v); });
  Material m = { 1., 0., 1. };
  Problem problem(mesh, m);
  const auto exact = [](const Vector2d& p) {
    return Vector2d(p.x() * (p.y() - 0.5), -0.5 * p.x() * p.x());
  };
  Eigen::VectorXd u(2 * mesh.nodes.size());
  for(std::size_t n = 0; n < mesh.nodes.size(); ++n) u.segment<2>(2 * n) = exact(mesh.nodes[n]);
  const std::vector<Stress> s = Patch_recovery(problem, u).nodal_stress();
  for(std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    EXPECT_NEAR(s[n][0], mesh.nodes[n].y() - 0.5, 1e-12);
    EXPECT_NEAR(s[n][1], 0., 1e-12);
    EXPECT_NEAR(s[n][2], 0., 1e-12);
  }
}

TEST(Plane_stress, energy_converges_with_the_square_of_the_size)
{
  std::vector<double> energy, estimated;
  for(int n : { 8, 16, 32, 64 }) {
    const auto r = Quarter_plate_in_tension().solve(polar_plate(6, 6, n, n));
    energy.push_back(r.estimate.energy_norm * r.estimate.energy_norm);
    estimated.push_back(r.estimate.error_norm);
  }
  const double d0 = energy[1] - energy[0], d1 = energy[2] - energy[1], d2 = energy[3] - energy[2];
  EXPECT_GT(d0, 0.); // compatible displacements under load: energy from below
  EXPECT_NEAR(d0 / d1, 4., 0.6);
  EXPECT_NEAR(d1 / d2, 4., 0.3);
  for(int i = 0; i < 3; ++i) EXPECT_NEAR(estimated[i] / estimated[i + 1], 2., 0.25);
  // effectivity: the estimate against the error from the extrapolated energy
  const double limit = energy[3] + d2 / 3;
  EXPECT_NEAR(estimated[2] / std::sqrt(limit - energy[2]), 1., 0.1);
}

TEST(Plane_stress, stress_concentration_meets_the_handbook)
{
  EXPECT_NEAR(howland_factor(0.1, 1), 3.0354, 1e-4);
  Quarter_plate_in_tension plate;
  // d/w = 0.1, four times as long as wide
  const auto strip = plate.solve(polar_plate(40, 10, 96, 96));
  EXPECT_NEAR(strip.stress_concentration, howland_factor(2, 20), 0.01 * 3.0354);
  // a square plate with the same hole: 3.086, a known result of quadratic elements
  const auto square = plate.solve(polar_plate(10, 10, 96, 96));
  EXPECT_NEAR(square.stress_concentration, 3.086, 0.01 * 3.086);
}
