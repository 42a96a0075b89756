// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_QUALITY_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_QUALITY_H

#include <CGAL/Quad_mesh_adaptation/Mesh_measures.h>
#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Of one face.
struct Face_shape
{
  double jacobian, mean_length; // scaled; of its edges, eq. 1
};

// The side from which a corner turns left is given by the cross product of the face's principal
// axes, as in the Verdict library.
class Quality_meter
{
public:
  // Returns Verdict's scaled Jacobian: 0 for a face with a zero edge or without a normal.
  Face_shape add(const std::array<Vec, 4>& p)
  {
    records_ = {};
    std::array<Vec, 4> edge;
    std::array<double, 4> length;
    for(int i = 0; i < 4; ++i) {
      edge[i] = p[(i + 1) % 4] - p[i];
      length[i] = norm(edge[i]);
    }
    const Vec across = cross(edge[0] - edge[2], edge[1] - edge[3]), normal = normalized(across);
    const double edges = length[0] + length[1] + length[2] + length[3];
    add_warp(p, across, edges);
    double least = std::numeric_limits<double>::infinity();
    for(int i = 0; i < 4; ++i) {
      const int j = (i + 3) % 4;
      const Vec turn = cross(edge[j], edge[i]);
      const double signed_area = dot(turn, normal), lengths = length[j] * length[i];
      least = (std::min)(least, lengths > 1e-300 ? signed_area / lengths : 0.);
      add_angle(turn, -dot(edge[j], edge[i]), signed_area, lengths);
    }
    return { least, 0.25 * edges };
  }

  // Extremes that a face may have.
  enum Extreme
  {
    smallest_angle,
    largest_angle,
    largest_warp,
    extremes
  };
  // Those of the face that was added last, up to now.
  const std::array<bool, extremes>& records() const { return records_; }

  // A reflex corner counts as more than 180 degrees.
  void put_into(Mesh_measures& m) const
  {
    constexpr double degrees = 180. / pi;
    m.min_angle = min_angle_ * degrees;
    m.max_angle = max_angle_ * degrees;
    m.max_warp = max_warp_;
  }

private:
  template <typename Beats>
  void set_record(Extreme e, double value, double& record, const Beats& beats)
  {
    if(!beats(value, record)) return;
    record = value;
    records_[e] = true;
  }

  // The direction of a face's normal tells of most that they are not the most warped.
  void add_warp(const std::array<Vec, 4>& p, const Vec& across, double edges)
  {
    constexpr double margin = 1 - 1e-9;
    const double height = (p[0] - p[1] + p[2] - p[3]) * across, bound = max_warp_ * edges / 4;
    if(height * height <= margin * bound * bound * (across * across)) return;
    set_record(largest_warp, warp(p), max_warp_, std::greater<double>());
  }

  // Its cosine tells of most corners that their angle is neither the smallest nor the largest.
  void add_angle(const Vec& turn, double product, double signed_area, double lengths)
  {
    constexpr double margin = 1e-12;
    if(signed_area > 0 && product < (max_cosine_ - margin) * lengths &&
       product > (min_cosine_ + margin) * lengths)
      return;
    double angle = std::atan2(norm(turn), product);
    if(signed_area < 0) angle = 2 * pi - angle;
    set_record(smallest_angle, angle, min_angle_, std::less<double>());
    set_record(largest_angle, angle, max_angle_, std::greater<double>());
    if(!(signed_area > 0) || !(lengths > 0)) return;
    max_cosine_ = (std::max)(max_cosine_, product / lengths);
    min_cosine_ = (std::min)(min_cosine_, product / lengths);
  }

  double min_angle_ = std::numeric_limits<double>::infinity(), max_angle_ = 0, max_warp_ = 0;
  std::array<bool, extremes> records_ = {};
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

// Collects the scaled Jacobians of all faces.
class Jacobian_counter
{
public:
  void reserve(std::size_t faces) { all_.reserve(faces); }
  void add(double jacobian)
  {
    all_.push_back(jacobian);
    sum_ += jacobian;
    if(!(jacobian > 0)) ++inverted_;
  }
  // Precondition: there are faces.  Uses what has been collected up.
  void put_into(Mesh_measures& m)
  {
    m.inverted_faces = inverted_;
    m.min_scaled_jacobian = *std::min_element(all_.begin(), all_.end());
    m.mean_scaled_jacobian = sum_ / double(all_.size());
    m.p5_scaled_jacobian = percentile(all_, 5.);
  }

private:
  std::vector<double> all_;
  double sum_ = 0;
  std::size_t inverted_ = 0;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_QUALITY_H
