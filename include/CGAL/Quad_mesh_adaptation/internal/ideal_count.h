// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_IDEAL_COUNT_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_IDEAL_COUNT_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

using Triangle = std::array<Vec, 3>;

inline double triangle_area(const Triangle& t)
{
  return 0.5 * norm(cross(t[1] - t[0], t[2] - t[0]));
}

// The two triangles of a quad cut along its shorter diagonal.
inline std::array<Triangle, 2> halves(const Vec& a, const Vec& b, const Vec& c, const Vec& d)
{
  if((c - a) * (c - a) <= (d - b) * (d - b)) return { { { a, b, c }, { a, c, d } } };
  return { { { a, b, d }, { b, c, d } } };
}

struct Integral_and_error
{
  double value, error;
};

// 1/h^2 over one triangle by the four-point rule of degree 3 (Strang and Fix).  The one-point rule
// it contains is off by a share r of the value; where h varies smoothly over the triangle the
// better rule is off by about r^2, which the estimate overstates tenfold.
template <typename Size>
Integral_and_error inverse_square_on(const Triangle& t, const Size& size)
{
  // h^2 may be zero although h is not; differences of infinite values say nothing
  const auto density = [&size](const Vec& p) {
    const double h = size(p);
    return (std::min)(1. / (h * h), 1e290);
  };
  const Vec sum = t[0] + t[1] + t[2];
  const double centre = density(sum / 3.);
  double corners = 0;
  for(const Vec& p : t) corners += density(0.2 * sum + 0.4 * p);
  const double area = triangle_area(t);
  const double value = area * (25. * corners - 27. * centre) / 48.;
  const double coarse_error = std::abs(value - area * centre);
  const double share = value > 0 ? coarse_error / value : 1.;
  return { value, coarse_error * (std::min)(1., 10. * share) };
}

// Triangles that are made when they are asked for, by number.
class Quad_halves
{
public:
  Quad_halves(const std::vector<Vec>& points, const std::vector<Quad>& quads)
      : points_(points), quads_(quads)
  {
  }

  std::size_t size() const { return 2 * quads_.size(); }
  Triangle operator[](std::size_t i) const
  {
    const Quad& q = quads_[i / 2];
    return halves(points_[q[0]], points_[q[1]], points_[q[2]], points_[q[3]])[i % 2];
  }

private:
  const std::vector<Vec>& points_;
  const std::vector<Quad>& quads_;
};

inline void append_quarters(const Triangle& t, std::vector<Triangle>& parts)
{
  const Vec ab = 0.5 * (t[0] + t[1]), bc = 0.5 * (t[1] + t[2]), ca = 0.5 * (t[2] + t[0]);
  parts.push_back({ t[0], ab, ca });
  parts.push_back({ ab, t[1], bc });
  parts.push_back({ ca, bc, t[2] });
  parts.push_back({ ab, bc, ca });
}

// Integrals over triangles, by their numbers; other lists of triangles may know them.
template <typename Triangles, typename Size>
std::vector<Integral_and_error> integrals_over(const Triangles& triangles, const Size& size)
{
  std::vector<Integral_and_error> found(triangles.size());
  for(std::size_t i = 0; i < found.size(); ++i) found[i] = inverse_square_on(triangles[i], size);
  return found;
}

// The integral over triangles, refined from round to round.
template <typename Size>
class Ideal_count
{
public:
  explicit Ideal_count(const Size& size) : size_(size) {}

  // One round: those of the triangles whose quarters are to be looked at; none in the end.
  template <typename Triangles>
  std::vector<Triangle> round(const Triangles& triangles)
  {
    const auto found = integrals_over(triangles, size_);
    double open = 0, open_error = 0;
    for(std::size_t i = 0; i < found.size(); ++i) {
      open += found[i].value;
      open_error += found[i].error;
    }
    value_ = done_ + open;
    std::vector<Triangle> parts;
    const double allowed = tolerance * value_;
    if(!(done_error_ + open_error > allowed)) return parts; // also ends on infinite values
    const double share = 0.25 * allowed / double(found.size());
    double settled = 0, settled_error = 0;
    for(std::size_t i = 0; i < found.size(); ++i) {
      if(found[i].error > share)
        append_quarters(triangles[i], parts);
      else {
        settled += found[i].value;
        settled_error += found[i].error;
      }
    }
    extra_ += parts.size();
    if(extra_ > most_extra_triangles) return {};
    done_ += settled;
    done_error_ += settled_error;
    return parts;
  }

  double value() const { return value_; }

private:
  static constexpr double tolerance = 3e-4;
  static constexpr std::size_t most_extra_triangles = 1000000;

  const Size& size_;
  double value_ = 0, done_ = 0, done_error_ = 0;
  std::size_t extra_ = 0;
};

// So many are looked at as they are; fewer are cut.
constexpr std::size_t least_triangles = 16384;

// Number of ideal faces: the integral of 1/h^2 over the triangles, refined where the error
// estimate is large until the sum of estimates is below 3e-4 of the value.  A few large triangles
// are first cut into at least 16384, lest a narrow dip of the size between the sample points be
// missed.  At most about 4 n + 4e6 evaluations of the size for n triangles.
template <typename Triangles, typename Size>
double ideal_number_of_faces(const Triangles& triangles, const Size& size)
{
  Ideal_count<Size> count(size);
  std::vector<Triangle> parts;
  if(triangles.size() >= least_triangles)
    parts = count.round(triangles);
  else
    for(std::size_t i = 0; i < triangles.size(); ++i) parts.push_back(triangles[i]);
  while(triangles.size() < least_triangles && !parts.empty() && parts.size() < least_triangles) {
    std::vector<Triangle> quarters;
    quarters.reserve(4 * parts.size());
    for(const Triangle& t : parts) append_quarters(t, quarters);
    parts.swap(quarters);
  }
  while(!parts.empty()) parts = count.round(parts);
  return count.value();
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_IDEAL_COUNT_H
