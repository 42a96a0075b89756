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

// Every quad cut along its shorter diagonal.
inline std::vector<Triangle> triangles_of(const std::vector<Vec>& points,
                                          const std::vector<Quad>& quads)
{
  std::vector<Triangle> triangles;
  triangles.reserve(2 * quads.size());
  for(const Quad& q : quads) {
    const Vec &a = points[q[0]], &b = points[q[1]], &c = points[q[2]], &d = points[q[3]];
    if((c - a) * (c - a) <= (d - b) * (d - b)) {
      triangles.push_back({ a, b, c });
      triangles.push_back({ a, c, d });
    } else {
      triangles.push_back({ a, b, d });
      triangles.push_back({ b, c, d });
    }
  }
  return triangles;
}

struct Integral_and_error
{
  double value, error;
};

// 1/h^2 over one triangle by the four-point rule of degree 3 (Strang and Fix).  The one-point rule
// it contains is off by a share r of the value; where h varies smoothly over the triangle the
// better rule is off by about r^2, which the estimate overstates tenfold.
inline Integral_and_error inverse_square_on(const Triangle& t, const Size_function& size)
{
  const auto density = [&size](const Vec& p) {
    const double h = size(p);
    return 1. / (h * h);
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

inline void append_quarters(const Triangle& t, std::vector<Triangle>& parts)
{
  const Vec ab = 0.5 * (t[0] + t[1]), bc = 0.5 * (t[1] + t[2]), ca = 0.5 * (t[2] + t[0]);
  parts.push_back({ t[0], ab, ca });
  parts.push_back({ ab, t[1], bc });
  parts.push_back({ ca, bc, t[2] });
  parts.push_back({ ab, bc, ca });
}

// Number of ideal faces: the integral of 1/h^2 over the triangles, refined where the error
// estimate is large until the sum of estimates is below 3e-4 of the value.  A few large triangles
// are first cut into at least 16384, lest a narrow dip of the size between the sample points be
// missed.  At most about 4 n + 4e6 evaluations of the size for n triangles.
inline double ideal_number_of_faces(std::vector<Triangle> triangles, const Size_function& size)
{
  constexpr double tolerance = 3e-4;
  constexpr std::size_t least_triangles = 16384, most_extra_triangles = 1000000;
  while(!triangles.empty() && triangles.size() < least_triangles) {
    std::vector<Triangle> parts;
    parts.reserve(4 * triangles.size());
    for(const Triangle& t : triangles) append_quarters(t, parts);
    triangles.swap(parts);
  }

  double done = 0, done_error = 0;
  std::size_t extra = 0;
  while(!triangles.empty()) {
    std::vector<Integral_and_error> found(triangles.size());
    double open = 0, open_error = 0;
    for(std::size_t i = 0; i < triangles.size(); ++i) {
      found[i] = inverse_square_on(triangles[i], size);
      open += found[i].value;
      open_error += found[i].error;
    }
    const double allowed = tolerance * (done + open);
    if(!(done_error + open_error > allowed)) return done + open; // also ends on infinite values
    const double share = 0.25 * allowed / double(triangles.size());
    std::vector<Triangle> parts;
    double settled = 0, settled_error = 0;
    for(std::size_t i = 0; i < triangles.size(); ++i) {
      if(found[i].error > share)
        append_quarters(triangles[i], parts);
      else {
        settled += found[i].value;
        settled_error += found[i].error;
      }
    }
    extra += parts.size();
    if(extra > most_extra_triangles) return done + open;
    done += settled;
    done_error += settled_error;
    triangles.swap(parts);
  }
  return done;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_IDEAL_COUNT_H
