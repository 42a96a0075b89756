// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Linear elasticity in plane stress on bilinear quads, as in any textbook on finite elements (for
// example Zienkiewicz, Taylor and Zhu, "The Finite Element Method", chapter on elasticity).

#ifndef QUAD_MESH_ADAPTATION_EXAMPLES_PLANE_STRESS_H
#define QUAD_MESH_ADAPTATION_EXAMPLES_PLANE_STRESS_H

#include "Plane_mesh.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace plane_stress {

using Stress = Eigen::Vector3d; // (xx, yy, xy)
using Matrix_8 = Eigen::Matrix<double, 8, 8>;
using Sparse = Eigen::SparseMatrix<double>;

struct Material
{
  double young = 1, poisson = 0, thickness = 1;

  /// Stress = elasticity * strain, with the engineering shear strain.
  Eigen::Matrix3d elasticity() const
  {
    Eigen::Matrix3d d;
    d << 1, poisson, 0, poisson, 1, 0, 0, 0, (1 - poisson) / 2;
    return young / (1 - poisson * poisson) * d;
  }
};

/// Effective stress of von Mises.
inline double effective(const Stress& s)
{
  return std::sqrt(s[0] * s[0] - s[0] * s[1] + s[1] * s[1] + 3 * s[2] * s[2]);
}

/// A point of an element in its own coordinates, both in [-1, 1].
struct Local_point
{
  double u, v;
};

inline const std::array<Local_point, 4>& gauss_points()
{
  static const double g = 1 / std::sqrt(3.);
  static const std::array<Local_point, 4> points = {
    { { -g, -g }, { g, -g }, { g, g }, { -g, g } }
  };
  return points;
}

inline Eigen::Vector4d shape_functions(const Local_point& p)
{
  return 0.25 * Eigen::Vector4d((1 - p.u) * (1 - p.v), (1 + p.u) * (1 - p.v), (1 + p.u) * (1 + p.v),
                                (1 - p.u) * (1 + p.v));
}

/// The strain operator at a point of an element: strain = strain_of * (u0, v0, u1, v1 ...), and
/// the area per unit of the element's own coordinates.
struct Strain_operator
{
  Eigen::Matrix<double, 3, 8> strain_of;
  double area;
};

/// Throws `std::invalid_argument` where the element is folded.
inline Strain_operator strain_operator(const std::array<Eigen::Vector2d, 4>& corners,
                                       const Local_point& p)
{
  Eigen::Matrix<double, 4, 2> local; // derivatives of the shape functions
  local << -(1 - p.v), -(1 - p.u), (1 - p.v), -(1 + p.u), (1 + p.v), (1 + p.u), -(1 + p.v),
      (1 - p.u);
  local *= 0.25;
  Eigen::Matrix2d jacobian = Eigen::Matrix2d::Zero(); // columns d/du, d/dv of the position
  for(int i = 0; i < 4; ++i) jacobian += corners[i] * local.row(i);
  Strain_operator b;
  b.area = jacobian.determinant();
  if(!(b.area > 0)) throw std::invalid_argument("plane_stress: an element is folded or clockwise");
  const Eigen::Matrix<double, 4, 2> gradient = local * jacobian.inverse();
  b.strain_of.setZero();
  for(int i = 0; i < 4; ++i) {
    b.strain_of(0, 2 * i) = b.strain_of(2, 2 * i + 1) = gradient(i, 0);
    b.strain_of(1, 2 * i + 1) = b.strain_of(2, 2 * i) = gradient(i, 1);
  }
  return b;
}

inline Matrix_8 element_stiffness(const std::array<Eigen::Vector2d, 4>& corners,
                                  const Material& material)
{
  const Eigen::Matrix3d elasticity = material.thickness * material.elasticity();
  Matrix_8 k = Matrix_8::Zero();
  for(const Local_point& p : gauss_points()) {
    const Strain_operator b = strain_operator(corners, p);
    k += b.area * b.strain_of.transpose() * elasticity * b.strain_of;
  }
  return k;
}

/// A boundary value problem on a mesh: forces and prescribed displacements at the nodes.
/// Unknown 2 n is the displacement of node n in x, 2 n + 1 in y.
class Problem
{
public:
  Problem(const Plane_mesh& mesh, const Material& material)
      : mesh(mesh), material(material), force(Eigen::VectorXd::Zero(2 * long(mesh.nodes.size()))),
        prescribed(2 * mesh.nodes.size(), false), value(force)
  {
  }

  void prescribe(int node, int direction, double displacement)
  {
    prescribed[2 * node + direction] = true;
    value[2 * node + direction] = displacement;
  }
  /// A constant traction (force per area) on the edge between two nodes.
  void add_traction(int a, int b, const Eigen::Vector2d& traction)
  {
    const double share = 0.5 * material.thickness * (mesh.nodes[b] - mesh.nodes[a]).norm();
    force.segment<2>(2 * a) += share * traction;
    force.segment<2>(2 * b) += share * traction;
  }

  /// The stiffness matrix of all unknowns, before supports.
  Sparse stiffness() const
  {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(64 * mesh.quads.size());
    for(std::size_t e = 0; e < mesh.quads.size(); ++e) {
      const Matrix_8 k = element_stiffness(mesh.corners(e), material);
      for(int i = 0; i < 8; ++i)
        for(int j = 0; j < 8; ++j) entries.emplace_back(unknown(e, i), unknown(e, j), k(i, j));
    }
    Sparse k(force.size(), force.size());
    k.setFromTriplets(entries.begin(), entries.end());
    return k;
  }

  /// Displacements of all nodes; throws `std::runtime_error` if the supports leave the body free.
  Eigen::VectorXd solve() const
  {
    const Sparse all = stiffness();
    std::vector<int> row(prescribed.size(), -1);
    int free = 0;
    for(std::size_t i = 0; i < prescribed.size(); ++i)
      if(!prescribed[i]) row[i] = free++;
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd right = Eigen::VectorXd::Zero(free);
    for(std::size_t i = 0; i < row.size(); ++i)
      if(row[i] >= 0) right[row[i]] = force[long(i)];
    for(int column = 0; column < all.outerSize(); ++column)
      for(Sparse::InnerIterator it(all, column); it; ++it) {
        if(row[it.row()] < 0) continue;
        if(row[column] >= 0)
          entries.emplace_back(row[it.row()], row[column], it.value());
        else
          right[row[it.row()]] -= it.value() * value[column];
      }
    Sparse reduced(free, free);
    reduced.setFromTriplets(entries.begin(), entries.end());
    const Eigen::VectorXd found = solve_positive(reduced, right);
    Eigen::VectorXd displacement = value;
    for(std::size_t i = 0; i < row.size(); ++i)
      if(row[i] >= 0) displacement[long(i)] = found[row[i]];
    return displacement;
  }

  Eigen::Matrix<double, 8, 1> of_element(const Eigen::VectorXd& nodal, std::size_t e) const
  {
    Eigen::Matrix<double, 8, 1> d;
    for(int i = 0; i < 8; ++i) d[i] = nodal[unknown(e, i)];
    return d;
  }
  Stress stress(const Eigen::VectorXd& displacement, std::size_t e, const Local_point& p) const
  {
    return material.elasticity() *
           (strain_operator(mesh.corners(e), p).strain_of * of_element(displacement, e));
  }

  const Plane_mesh& mesh;
  Material material;

private:
  int unknown(std::size_t e, int i) const { return 2 * mesh.quads[e][i / 2] + i % 2; }

  static Eigen::VectorXd solve_positive(const Sparse& k, const Eigen::VectorXd& right)
  {
    const Eigen::SimplicialLDLT<Sparse> factors(k);
    const char* const free_body = "plane_stress: the supports leave the body free to move";
    if(factors.info() != Eigen::Success) throw std::runtime_error(free_body);
    const auto pivots = factors.vectorD();
    if(pivots.size() && !(pivots.minCoeff() > 1e-12 * pivots.maxCoeff()))
      throw std::runtime_error(free_body);
    return factors.solve(right);
  }

  Eigen::VectorXd force;
  std::vector<bool> prescribed;
  Eigen::VectorXd value;
};

} // namespace plane_stress

#endif // QUAD_MESH_ADAPTATION_EXAMPLES_PLANE_STRESS_H
