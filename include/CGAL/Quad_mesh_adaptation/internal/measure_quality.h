// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_QUALITY_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_QUALITY_H

#include <CGAL/Quad_mesh_adaptation/Mesh_measures.h>
#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

struct Face_quality
{
  double scaled_jacobian;      // Verdict; 0 for a face with a zero edge or without a normal
  double min_angle, max_angle; // radians, a reflex corner counts as more than pi
  double warp;                 // see Mesh_measures
};

// The side from which a corner turns left is given by the cross product of the face's principal
// axes, as in the Verdict library.
inline Face_quality face_quality(const std::array<Vec, 4>& p)
{
  constexpr double pi = 3.14159265358979323846;
  std::array<Vec, 4> edge;
  for(int i = 0; i < 4; ++i) edge[i] = p[(i + 1) % 4] - p[i];
  const Vec normal = normalized(cross(edge[0] - edge[2], edge[1] - edge[3]));

  Face_quality q = { std::numeric_limits<double>::infinity(),
                     std::numeric_limits<double>::infinity(), 0., warp(p) };
  for(int i = 0; i < 4; ++i) {
    const Vec& in = edge[(i + 3) % 4];
    const Vec& out = edge[i];
    const Vec turn = cross(in, out);
    const double signed_area = dot(turn, normal);
    const double lengths = norm(in) * norm(out);
    q.scaled_jacobian =
        (std::min)(q.scaled_jacobian, lengths > 1e-300 ? signed_area / lengths : 0.);
    double angle = std::atan2(norm(turn), -dot(in, out));
    if(signed_area < 0) angle = 2 * pi - angle;
    q.min_angle = (std::min)(q.min_angle, angle);
    q.max_angle = (std::max)(q.max_angle, angle);
  }
  return q;
}

// The given percentile of a non-empty sample, linear between neighbouring ranks; reorders it.
inline double percentile(std::vector<double>& sample, double percent)
{
  const double rank = percent / 100. * double(sample.size() - 1);
  const std::size_t below = std::size_t(rank);
  std::nth_element(sample.begin(), sample.begin() + below, sample.end());
  const double low = sample[below];
  if(below + 1 >= sample.size()) return low;
  const double high = *std::min_element(sample.begin() + below + 1, sample.end());
  return low + (rank - double(below)) * (high - low);
}

inline void measure_quality(const std::vector<Vec>& points, const std::vector<Quad>& quads,
                            Mesh_measures& m)
{
  if(quads.empty()) return;
  constexpr double degrees = 180. / 3.14159265358979323846;
  std::vector<double> jacobians;
  jacobians.reserve(quads.size());
  double sum = 0, min_angle = std::numeric_limits<double>::infinity(), max_angle = 0;
  for(const Quad& f : quads) {
    const Face_quality q = face_quality({ points[f[0]], points[f[1]], points[f[2]], points[f[3]] });
    jacobians.push_back(q.scaled_jacobian);
    sum += q.scaled_jacobian;
    if(!(q.scaled_jacobian > 0)) ++m.inverted_faces;
    min_angle = (std::min)(min_angle, q.min_angle);
    max_angle = (std::max)(max_angle, q.max_angle);
    m.max_warp = (std::max)(m.max_warp, q.warp);
  }
  m.min_scaled_jacobian = *std::min_element(jacobians.begin(), jacobians.end());
  m.mean_scaled_jacobian = sum / double(quads.size());
  m.p5_scaled_jacobian = percentile(jacobians, 5.);
  m.min_angle = min_angle * degrees;
  m.max_angle = max_angle * degrees;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_QUALITY_H
