// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Recovered stresses and the error estimate of O. C. Zienkiewicz and J. Z. Zhu, "The
// superconvergent patch recovery and a posteriori error estimates", parts 1 and 2 (1992).

#ifndef QUAD_MESH_ADAPTATION_EXAMPLES_ZIENKIEWICZ_ZHU_H
#define QUAD_MESH_ADAPTATION_EXAMPLES_ZIENKIEWICZ_ZHU_H

#include "plane_stress.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace plane_stress {

/// Superconvergent patch recovery: around every inner node a linear field is fitted by least
/// squares to the stresses at the centres of the elements of its patch, where bilinear elements are
/// superconvergent.  An inner node takes its own patch's value; a boundary node the mean of the
/// fields of the inner nodes it shares an element with.
class Patch_recovery
{
public:
  Patch_recovery(const Problem& problem, const Eigen::VectorXd& displacement)
      : mesh(problem.mesh), elements(mesh.nodes.size()), inner(mesh.nodes.size(), true)
  {
    for(std::size_t e = 0; e < mesh.quads.size(); ++e) {
      centre_stress.push_back(problem.stress(displacement, e, { 0, 0 }));
      for(int n : mesh.quads[e]) elements[n].push_back(int(e));
    }
    for(const auto& edge : boundary_edges(mesh)) inner[edge.first] = inner[edge.second] = false;
  }

  /// Recovered stress of every node.
  std::vector<Stress> nodal_stress() const
  {
    std::vector<Stress> result(mesh.nodes.size(), Stress::Zero());
    for(std::size_t n = 0; n < mesh.nodes.size(); ++n) {
      if(elements[n].empty()) continue;
      if(inner[n]) {
        result[n] = fit(elements[n], mesh.nodes[n]);
        continue;
      }
      const std::set<int> helpers = inner_neighbours(int(n));
      for(int helper : helpers)
        result[n] += fit(elements[helper], mesh.nodes[n]) / double(helpers.size());
      if(helpers.empty()) result[n] = fit(widened_patch(int(n)), mesh.nodes[n]);
    }
    return result;
  }

private:
  // Inner nodes of the elements at a boundary node.
  std::set<int> inner_neighbours(int node) const
  {
    std::set<int> found;
    for(int e : elements[node])
      for(int n : mesh.quads[e])
        if(inner[n]) found.insert(n);
    return found;
  }
  // The elements at a node and theirs neighbours, for bodies one element thick.
  std::vector<int> widened_patch(int node) const
  {
    std::set<int> found;
    for(int e : elements[node])
      for(int n : mesh.quads[e]) found.insert(elements[n].begin(), elements[n].end());
    return std::vector<int>(found.begin(), found.end());
  }
  // Value at p of the linear field nearest to the stresses at the centres; the least change from
  // their mean where the centres do not determine it.
  Stress fit(const std::vector<int>& patch, const Eigen::Vector2d& p) const
  {
    Eigen::Vector2d middle(0, 0);
    Stress mean = Stress::Zero();
    for(int e : patch) {
      middle += mesh.centre(e) / double(patch.size());
      mean += centre_stress[e] / double(patch.size());
    }
    Eigen::MatrixXd offset(patch.size(), 2), deviation(patch.size(), 3);
    for(std::size_t i = 0; i < patch.size(); ++i) {
      offset.row(i) = (mesh.centre(patch[i]) - middle).transpose();
      deviation.row(i) = (centre_stress[patch[i]] - mean).transpose();
    }
    auto solver = offset.completeOrthogonalDecomposition();
    solver.setThreshold(1e-6);
    const Eigen::MatrixXd slope = solver.solve(deviation);
    return mean + slope.transpose() * (p - middle);
  }

  const Plane_mesh& mesh;
  std::vector<std::vector<int>> elements;
  std::vector<bool> inner;
  std::vector<Stress> centre_stress;
};

/// What a solution is worth, element by element.
struct Error_estimate
{
  std::vector<Stress> nodal_stress;    ///< recovered
  std::vector<double> element_error;   ///< energy norm of recovered minus computed stress
  std::vector<double> effective_error; ///< per element, the largest effective stress of
                                       ///< recovered minus computed stress at Gauss points
  double energy_norm = 0;              ///< of the computed stress
  double error_norm = 0;               ///< root of the sum of the squared element errors
  double max_effective_stress = 0;     ///< of the recovered stress, over the nodes
  double max_effective_error = 0;

  double relative_error() const { return error_norm / std::hypot(energy_norm, error_norm); }
};

inline Error_estimate estimate_error(const Problem& problem, const Eigen::VectorXd& displacement)
{
  Error_estimate result;
  result.nodal_stress = Patch_recovery(problem, displacement).nodal_stress();
  const Plane_mesh& mesh = problem.mesh;
  const Eigen::Matrix3d compliance =
      problem.material.thickness * problem.material.elasticity().inverse();
  double energy = 0, error = 0;
  for(std::size_t e = 0; e < mesh.quads.size(); ++e) {
    double of_element = 0, effective_error = 0;
    for(const Local_point& p : gauss_points()) {
      const Eigen::Vector4d shape = shape_functions(p);
      const Stress computed = problem.stress(displacement, e, p);
      Stress difference = -computed;
      for(int i = 0; i < 4; ++i) difference += shape[i] * result.nodal_stress[mesh.quads[e][i]];
      const double area = strain_operator(mesh.corners(e), p).area;
      energy += area * computed.dot(compliance * computed);
      of_element += area * difference.dot(compliance * difference);
      effective_error = (std::max)(effective_error, effective(difference));
    }
    error += of_element;
    result.element_error.push_back(std::sqrt(of_element));
    result.effective_error.push_back(effective_error);
    result.max_effective_error = (std::max)(result.max_effective_error, effective_error);
  }
  for(const Stress& s : result.nodal_stress)
    result.max_effective_stress = (std::max)(result.max_effective_stress, effective(s));
  result.energy_norm = std::sqrt(energy);
  result.error_norm = std::sqrt(error);
  return result;
}

} // namespace plane_stress

#endif // QUAD_MESH_ADAPTATION_EXAMPLES_ZIENKIEWICZ_ZHU_H
