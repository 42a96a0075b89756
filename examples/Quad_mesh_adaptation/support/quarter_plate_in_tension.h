// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_EXAMPLES_QUARTER_PLATE_IN_TENSION_H
#define QUAD_MESH_ADAPTATION_EXAMPLES_QUARTER_PLATE_IN_TENSION_H

#include "zienkiewicz_zhu.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace plane_stress {

/// A quarter, x >= 0 and y >= 0, of a rectangular plate with a hole around the origin, pulled in x
/// at its right side.  The paper gives neither load nor material nor coordinates of its points A,
/// B, C; these give stresses and displacements like those of its Table 4.
struct Quarter_plate_in_tension
{
  Material material = { 70000., 0.3, 1. }; // aluminium, MPa and mm
  double traction = 35.;
  Eigen::Vector2d a = { 1, 0 }; // the hole on the axis of the load
  Eigen::Vector2d b = { 6, 6 }; // the corner of the plate
  Eigen::Vector2d c = { 6, 0 }; // the middle of the loaded side
  Eigen::Vector2d top_of_hole = { 0, 1 };

  struct Result
  {
    std::size_t nodes, faces;
    Eigen::VectorXd displacement;
    Error_estimate estimate;
    double x_at_a, x_at_b, x_at_c; ///< displacements along the load
    double stress_concentration;   ///< stress along the load at the top of the hole / traction
  };

  Result solve(const Plane_mesh& mesh) const
  {
    double right = 0;
    for(const Eigen::Vector2d& p : mesh.nodes) right = (std::max)(right, p.x());
    const double close = 1e-7 * right;
    Problem problem(mesh, material);
    for(const auto& [from, to] : boundary_edges(mesh)) {
      const Eigen::Vector2d &p = mesh.nodes[from], &q = mesh.nodes[to];
      for(int direction = 0; direction < 2; ++direction) // planes of symmetry x = 0 and y = 0
        if(std::abs(p[direction]) < close && std::abs(q[direction]) < close) {
          problem.prescribe(from, direction, 0);
          problem.prescribe(to, direction, 0);
        }
      if(std::abs(p.x() - right) < close && std::abs(q.x() - right) < close)
        problem.add_traction(from, to, { traction, 0 });
    }
    Result r;
    r.nodes = mesh.nodes.size();
    r.faces = mesh.quads.size();
    r.displacement = problem.solve();
    r.estimate = estimate_error(problem, r.displacement);
    r.x_at_a = r.displacement[2 * nearest_node(mesh, a)];
    r.x_at_b = r.displacement[2 * nearest_node(mesh, b)];
    r.x_at_c = r.displacement[2 * nearest_node(mesh, c)];
    r.stress_concentration = r.estimate.nodal_stress[nearest_node(mesh, top_of_hole)][0] / traction;
    return r;
  }
};

/// Stress concentration of a hole of diameter d in a long strip of width w in tension, on the
/// gross section: the fit to R. C. J. Howland's series (1930) given in Peterson's Stress
/// Concentration Factors, chart 4.1.
inline double howland_factor(double d, double w)
{
  const double rest = 1 - d / w;
  return 0.284 + 2 / rest - 0.6 * rest + 1.32 * rest * rest;
}

} // namespace plane_stress

#endif // QUAD_MESH_ADAPTATION_EXAMPLES_QUARTER_PLATE_IN_TENSION_H
