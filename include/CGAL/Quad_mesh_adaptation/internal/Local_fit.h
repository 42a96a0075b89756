// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LOCAL_FIT_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LOCAL_FIT_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// A surface near one of its points as the graph of a polynomial over the tangent plane there:
// least squares through the points around, exact at the point itself (Cazals and Pouget,
// "Estimating differential quantities using polynomial fitting of osculating jets", CAGD 2005).
class Local_fit
{
public:
  Local_fit() = default;

  // Fits a polynomial of at most `degree` (1 to 3) in the plane across `normal`, and once more
  // across the normal that this gives.  A lower degree is taken where the points do not suffice; 0
  // is none.
  Local_fit(const Vec& origin, const Vec& normal, const std::vector<Vec>& around, int degree)
      : origin_(origin)
  {
    set_normal(normal);
    scale_ = 0;
    for(const Vec& p : around) scale_ += distance(p, origin);
    if(!(scale_ > 0) || degree < 1) return;
    scale_ /= double(around.size());
    for(degree_ = degree; degree_ > 0; --degree_) {
      set_normal(normal);
      if(int(around.size()) >= unknowns() + (degree_ > 1 ? 2 : 0) && fit(around)) {
        set_normal(at(0, 0).normal);
        if(fit(around)) return;
      }
    }
    set_normal(normal);
  }

  int degree() const { return degree_; }
  const Vec& normal() const { return n_; }

  // The point above p, along the normal of the plane, and the normal of the graph there.
  Surface_point lift(const Vec& p) const
  {
    if(degree_ == 0) return { p, n_ };
    const Vec d = p - origin_;
    return at(d * u_ / scale_, d * v_ / scale_);
  }

  // The sum of the absolute principal curvatures at the origin.
  double curvature() const
  {
    if(degree_ < 2) return 0;
    const double a = 2 * c_[2] / scale_, b = c_[3] / scale_, c = 2 * c_[4] / scale_;
    const double mean = 0.5 * (a + c), dev = std::sqrt(0.25 * (a - c) * (a - c) + b * b);
    return std::abs(mean + dev) + std::abs(mean - dev);
  }

private:
  int unknowns() const { return degree_ == 1 ? 2 : degree_ == 2 ? 5 : 9; }

  void set_normal(const Vec& n)
  {
    n_ = normalized(n);
    const auto [u, v] = tangents(n_);
    u_ = u;
    v_ = v;
  }

  static std::array<double, 9> monomials(double a, double b)
  {
    return { a, b, a * a, a * b, b * b, a * a * a, a * a * b, a * b * b, b * b * b };
  }

  Surface_point at(double a, double b) const
  {
    const std::array<double, 9> m = monomials(a, b);
    const std::array<double, 9> ma = { 1, 0, 2 * a, b, 0, 3 * a * a, 2 * a * b, b * b, 0 };
    const std::array<double, 9> mb = { 0, 1, 0, a, 2 * b, 0, a * a, 2 * a * b, 3 * b * b };
    double h = 0, ha = 0, hb = 0;
    for(int i = 0; i < unknowns(); ++i) {
      h += c_[i] * m[i];
      ha += c_[i] * ma[i];
      hb += c_[i] * mb[i];
    }
    return { origin_ + scale_ * (a * u_ + b * v_ + h * n_), normalized(n_ - ha * u_ - hb * v_) };
  }

  // Weighted normal equations; near points count more.  The tiny ridge decides where the points do
  // not, as for points of one line or one circle.
  bool fit(const std::vector<Vec>& around)
  {
    const int n = unknowns();
    double A[9][9] = {}, r[9] = {};
    for(const Vec& p : around) {
      const Vec d = (p - origin_) / scale_;
      const std::array<double, 9> m = monomials(d * u_, d * v_);
      const double w = std::exp(-3.5 * (d * d));
      for(int i = 0; i < n; ++i) {
        for(int j = 0; j <= i; ++j) A[i][j] += w * m[i] * m[j];
        r[i] += w * m[i] * (d * n_);
      }
    }
    double trace = 0;
    for(int i = 0; i < n; ++i) trace += A[i][i];
    for(int i = 0; i < n; ++i) A[i][i] += 1e-7 * trace;
    return solve(A, r, n);
  }

  // Cholesky; the solution goes to c_.
  bool solve(double (&A)[9][9], double (&r)[9], int n)
  {
    for(int i = 0; i < n; ++i)
      for(int j = 0; j <= i; ++j) {
        double s = A[i][j];
        for(int k = 0; k < j; ++k) s -= A[i][k] * A[j][k];
        if(i == j && !(s > 0)) return false;
        A[i][j] = i == j ? std::sqrt(s) : s / A[j][j];
      }
    for(int i = 0; i < n; ++i) {
      for(int k = 0; k < i; ++k) r[i] -= A[i][k] * r[k];
      r[i] /= A[i][i];
    }
    for(int i = n - 1; i >= 0; --i) {
      for(int k = i + 1; k < n; ++k) r[i] -= A[k][i] * r[k];
      r[i] /= A[i][i];
      c_[i] = r[i];
    }
    return true;
  }

  Vec origin_ = Vec(0, 0, 0), n_ = Vec(0, 0, 1), u_ = Vec(1, 0, 0), v_ = Vec(0, 1, 0);
  double scale_ = 1;
  int degree_ = 0;
  std::array<double, 9> c_ = {};
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LOCAL_FIT_H
