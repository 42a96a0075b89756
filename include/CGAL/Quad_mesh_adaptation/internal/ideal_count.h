// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_IDEAL_COUNT_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_IDEAL_COUNT_H

#include <CGAL/Quad_mesh_adaptation/internal/Face_sizes.h>
#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
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

// By a rule of degree 3 and by the one-point rule that it contains.  The latter is off by a share r
// of the value; where h varies smoothly the better rule is off by about r^2, which the estimate
// overstates tenfold.
inline Integral_and_error with_error(double value, double by_one_point)
{
  const double coarse_error = std::abs(value - by_one_point);
  const double share = value > 0 ? coarse_error / value : 1.;
  return { value, coarse_error * (std::min)(1., 10. * share) };
}

// h^2 may be zero although h is not; differences of infinite values say nothing.
inline double density_of(double h) { return (std::min)(1. / (h * h), 1e290); }

// 1/h^2 over one triangle by the four-point rule of degree 3 (Strang and Fix).
template <typename Size>
Integral_and_error inverse_square_on(const Triangle& t, const Size& size)
{
  const auto density = [&size](const Vec& p) { return density_of(size(p)); };
  const Vec sum = t[0] + t[1] + t[2];
  const double centre = density(sum / 3.);
  double corners = 0;
  for(const Vec& p : t) corners += density(0.2 * sum + 0.4 * p);
  const double area = triangle_area(t);
  return with_error(area * (25. * corners - 27. * centre) / 48., area * centre);
}

// The same over one face of which the sizes are known: the 2 x 2 rule of Gauss, of degree 3 as
// well. A face that is not convex is looked at by halves.
template <typename Size>
Integral_and_error inverse_square_on(const Corners& p, const Face_sizes& known, const Size& size)
{
  const std::array<Triangle, 2> t = halves(p[0], p[1], p[2], p[3]);
  const Vec normal = cross(p[2] - p[0], p[3] - p[1]);
  std::array<double, 4> at_corners; // areas of the patch, in proportion
  for(int i = 0; i < 4; ++i)
    at_corners[i] = normal * cross(p[(i + 1) & 3] - p[i], p[(i + 3) & 3] - p[i]);
  if(!(*std::min_element(at_corners.begin(), at_corners.end()) > 0)) {
    const Integral_and_error a = inverse_square_on(t[0], size), b = inverse_square_on(t[1], size);
    return { a.value + b.value, a.error + b.error };
  }
  const double g = 0.5 / std::sqrt(3.), near = (0.5 + g) * (0.5 + g), beside = 0.25 - g * g,
               far = (0.5 - g) * (0.5 - g);
  double sum = 0, areas = 0;
  for(std::size_t k = 0; k < gauss_corners.size(); ++k) {
    const std::size_t i = gauss_corners[k];
    const double a = near * at_corners[i] + far * at_corners[i ^ 2] +
                     beside * (at_corners[(i + 1) & 3] + at_corners[(i + 3) & 3]);
    areas += a;
    sum += a * density_of(known.at_gauss[k]);
  }
  const double area = triangle_area(t[0]) + triangle_area(t[1]);
  return with_error(area * (sum / areas), area * density_of(known.at_centre));
}

// The two triangles of each of many faces, made when they are asked for.
template <typename Corners_of>
class Halves_of_faces
{
public:
  Halves_of_faces(std::size_t faces, const Corners_of& corners_of)
      : faces_(faces), corners_of_(corners_of)
  {
  }

  std::size_t size() const { return 2 * faces_; }
  Triangle operator[](std::size_t i) const
  {
    const Corners p = corners_of_(i / 2);
    return halves(p[0], p[1], p[2], p[3])[i % 2];
  }

private:
  std::size_t faces_;
  const Corners_of& corners_of_;
};

inline void append_quarters(const Triangle& t, std::vector<Triangle>& parts)
{
  const Vec ab = 0.5 * (t[0] + t[1]), bc = 0.5 * (t[1] + t[2]), ca = 0.5 * (t[2] + t[0]);
  parts.push_back({ t[0], ab, ca });
  parts.push_back({ ab, t[1], bc });
  parts.push_back({ ca, bc, t[2] });
  parts.push_back({ ab, bc, ca });
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
    std::vector<Integral_and_error> found(triangles.size());
    for(std::size_t i = 0; i < found.size(); ++i) found[i] = inverse_square_on(triangles[i], size_);
    return round(
        found.size(), [&](std::size_t i) { return found[i]; },
        [&](std::size_t i, std::vector<Triangle>& parts) { append_quarters(triangles[i], parts); });
  }

  // The same for anything that consists of triangles; `found(i)`: the integral over the i-th,
  // `append(i, parts)`: its parts to be looked at.
  template <typename Found, typename Append>
  std::vector<Triangle> round(std::size_t n, const Found& found, const Append& append)
  {
    double open = 0, open_error = 0;
    for(std::size_t i = 0; i < n; ++i) {
      const Integral_and_error x = found(i);
      open += x.value;
      open_error += x.error;
    }
    value_ = done_ + open;
    std::vector<Triangle> parts;
    const double allowed = tolerance * value_;
    if(!(done_error_ + open_error > allowed)) return parts; // also ends on infinite values
    const double share = 0.25 * allowed / double(n);
    double settled = 0, settled_error = 0;
    for(std::size_t i = 0; i < n; ++i) {
      const Integral_and_error x = found(i);
      if(x.error > share)
        append(i, parts);
      else {
        settled += x.value;
        settled_error += x.error;
      }
    }
    extra_ += parts.size();
    if(extra_ > most_extra_triangles) return {};
    done_ += settled;
    done_error_ += settled_error;
    return parts;
  }

  // All that is left to do after a round; returns the integral.
  double finish(std::vector<Triangle> parts)
  {
    while(!parts.empty()) parts = round(parts);
    return value_;
  }

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
  if(triangles.size() >= least_triangles) return count.finish(count.round(triangles));
  std::vector<Triangle> parts;
  for(std::size_t i = 0; i < triangles.size(); ++i) parts.push_back(triangles[i]);
  while(!parts.empty() && parts.size() < least_triangles) {
    std::vector<Triangle> quarters;
    quarters.reserve(4 * parts.size());
    for(const Triangle& t : parts) append_quarters(t, quarters);
    parts.swap(quarters);
  }
  return count.finish(std::move(parts));
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_IDEAL_COUNT_H
