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

// The side from which a corner turns left is given by the cross product of the face's principal
// axes, as in the Verdict library.
class Quality_meter
{
public:
  // Returns the scaled Jacobian: Verdict's; 0 for a face with a zero edge or without a normal.
  double add(const std::array<Vec, 4>& p)
  {
    std::array<Vec, 4> edge;
    std::array<double, 4> length;
    for(int i = 0; i < 4; ++i) {
      edge[i] = p[(i + 1) % 4] - p[i];
      length[i] = norm(edge[i]);
    }
    const Vec across = cross(edge[0] - edge[2], edge[1] - edge[3]), normal = normalized(across);
    add_warp(p, across, length[0] + length[1] + length[2] + length[3]);
    double least = std::numeric_limits<double>::infinity();
    for(int i = 0; i < 4; ++i) {
      const int j = (i + 3) % 4;
      const Vec turn = cross(edge[j], edge[i]);
      const double signed_area = dot(turn, normal), lengths = length[j] * length[i];
      least = (std::min)(least, lengths > 1e-300 ? signed_area / lengths : 0.);
      add_angle(turn, -dot(edge[j], edge[i]), signed_area, lengths);
    }
    return least;
  }

  // Radians; a reflex corner counts as more than pi.
  double min_angle() const { return min_angle_; }
  double max_angle() const { return max_angle_; }
  double max_warp() const { return max_warp_; }

private:
  // The direction of a face's normal tells of most that they are not the most warped.
  void add_warp(const std::array<Vec, 4>& p, const Vec& across, double edges)
  {
    constexpr double margin = 1 - 1e-9;
    const double height = (p[0] - p[1] + p[2] - p[3]) * across, bound = max_warp_ * edges / 4;
    if(height * height <= margin * bound * bound * (across * across)) return;
    max_warp_ = (std::max)(max_warp_, warp(p));
  }

  // Its cosine tells of most corners that their angle is neither the smallest nor the largest.
  void add_angle(const Vec& turn, double product, double signed_area, double lengths)
  {
    constexpr double margin = 1e-12, pi = 3.14159265358979323846;
    if(signed_area > 0 && product < (max_cosine_ - margin) * lengths &&
       product > (min_cosine_ + margin) * lengths)
      return;
    double angle = std::atan2(norm(turn), product);
    if(signed_area < 0) angle = 2 * pi - angle;
    min_angle_ = (std::min)(min_angle_, angle);
    max_angle_ = (std::max)(max_angle_, angle);
    if(!(signed_area > 0) || !(lengths > 0)) return;
    max_cosine_ = (std::max)(max_cosine_, product / lengths);
    min_cosine_ = (std::min)(min_cosine_, product / lengths);
  }

  double min_angle_ = std::numeric_limits<double>::infinity(), max_angle_ = 0, max_warp_ = 0;
  double max_cosine_ = -1, min_cosine_ = 1; // of the corners that turn left
};

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
  double sum = 0;
  Quality_meter meter;
  for(const Quad& f : quads) {
    const double jacobian = meter.add({ points[f[0]], points[f[1]], points[f[2]], points[f[3]] });
    jacobians.push_back(jacobian);
    sum += jacobian;
    if(!(jacobian > 0)) ++m.inverted_faces;
  }
  m.min_scaled_jacobian = *std::min_element(jacobians.begin(), jacobians.end());
  m.mean_scaled_jacobian = sum / double(quads.size());
  m.p5_scaled_jacobian = percentile(jacobians, 5.);
  m.min_angle = meter.min_angle() * degrees;
  m.max_angle = meter.max_angle() * degrees;
  m.max_warp = meter.max_warp();
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_QUALITY_H
