// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_OPTIMAL_SIZES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_OPTIMAL_SIZES_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The mesh with the fewest faces for its error has the same error on all faces.  With the error of
// a face going like h^(p + 1), p being the order of convergence of the error norm in the plane, a
// face of error e gets the size h r, r = (E / e)^(1 / (p + 1)), and turns into r^-2 faces of error
// E (E. Onate and G. Bugeda, "A study of mesh optimality criteria in adaptive finite element
// analysis", 1993).  r is kept within [1 / largest_change, largest_change].
class Optimal_sizes
{
public:
  Optimal_sizes(std::vector<double> errors, double order, double largest_change)
      : errors_(std::move(errors)), order_(order), change_(largest_change)
  {
  }

  double ratio(std::size_t f) const
  {
    const double e = errors_[f];
    if(!(e > 0)) return change_;
    return (std::min)((std::max)(std::exp((log_error_ - std::log(e)) / (order_ + 1)), 1 / change_),
                      change_);
  }

  double number_of_faces() const
  {
    double sum = 0;
    for(std::size_t f = 0; f < errors_.size(); ++f) sum += 1 / (ratio(f) * ratio(f));
    return sum;
  }

  // Of all faces together, as they are.
  double present_error() const
  {
    double sum = 0;
    for(double e : errors_) sum += e * e;
    return std::sqrt(sum);
  }

  // As they will be: square root of the sum of their r^-2 parts with error e r^(p + 1) each.
  double error() const
  {
    double sum = 0;
    for(std::size_t f = 0; f < errors_.size(); ++f)
      sum += std::pow(errors_[f] * std::pow(ratio(f), order_), 2);
    return std::sqrt(sum);
  }

  // Both move one way with E: bisection, since limits on r leave no formula.  Stays at the end of
  // the range where the limits forbid more.
  void set_error(double wanted)
  {
    bisect([&] { return error() > wanted; });
  }
  void set_number_of_faces(double wanted)
  {
    bisect([&] { return number_of_faces() < wanted; });
  }

private:
  template <class Is_too_coarse>
  void bisect(const Is_too_coarse& is_too_coarse)
  {
    double smallest = 0, largest = 0;
    for(double e : errors_) {
      if(e > 0) smallest = smallest > 0 ? (std::min)(smallest, e) : e;
      largest = (std::max)(largest, e);
    }
    if(!(largest > 0)) return;
    // beyond these all faces are at a limit
    const double margin = (order_ + 1) * std::log(change_) + 1;
    double low = std::log(smallest) - margin, high = std::log(largest) + margin;
    for(int i = 0; i < 100; ++i) {
      log_error_ = 0.5 * (low + high);
      (is_too_coarse() ? high : low) = log_error_;
    }
  }

  std::vector<double> errors_;
  double order_, change_, log_error_ = 0;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_OPTIMAL_SIZES_H
