// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FEATURE_CURVE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FEATURE_CURVE_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// A curve nodes live on: a polyline with its arc length, from corner to corner or closed.
// Nodes keep their arc length, so that moving along the curve never leaves its support.
class Feature_curve
{
public:
  Feature_curve() = default;
  // A closed curve repeats its first point at the end.
  Feature_curve(std::vector<Vec> points, bool is_closed, bool is_border, bool is_frozen)
      : points_(std::move(points)), closed_(is_closed), border_(is_border), frozen_(is_frozen)
  {
    arc_.resize(points_.size(), 0.);
    for(std::size_t i = 1; i < points_.size(); ++i)
      arc_[i] = arc_[i - 1] + distance(points_[i - 1], points_[i]);
  }

  bool is_closed() const { return closed_; }
  bool is_border() const { return border_; }
  bool is_frozen() const { return frozen_; } // its nodes and edges stay as they are
  double length() const { return arc_.empty() ? 0. : arc_.back(); }
  const std::vector<Vec>& points() const { return points_; }
  const std::vector<double>& arcs() const { return arc_; }

  bool is_constrained() const { return constrained; } // by the caller's map of constrained edges

  bool constrained = false;
  bool is_cut = false; // no curve of the whole, but where a part of it ends
  int images = 1;      // 2: the mesh will be completed by its mirror image along this curve
  // The corners it runs between, -1 for a closed curve without corner.
  Index first_corner = -1, last_corner = -1;

  double wrapped(double s) const
  {
    const double L = length();
    if(closed_) {
      s = std::fmod(s, L);
      return s < 0 ? s + L : s;
    }
    return (std::min)((std::max)(s, 0.), L);
  }

  // Signed arc length from s to t, the short way round where the curve is closed.
  double difference(double s, double t) const
  {
    double d = t - s;
    if(closed_) {
      const double L = length();
      d -= L * std::round(d / L);
    }
    return d;
  }

  Vec point(double s) const
  {
    s = wrapped(s);
    const std::size_t i = segment(s);
    const double l = arc_[i + 1] - arc_[i];
    const double w = l > 0 ? (s - arc_[i]) / l : 0.;
    return points_[i] + w * (points_[i + 1] - points_[i]);
  }

  Vec tangent(double s) const
  {
    const std::size_t i = segment(wrapped(s));
    return normalized(points_[i + 1] - points_[i]);
  }

  // Arc length of the point of the curve nearest to p; for many questions there is Curve_lookup.
  double nearest(const Vec& p) const
  {
    double best = -1, where = 0;
    for(std::size_t i = 0; i + 1 < points_.size(); ++i) {
      double arc = 0;
      const double d2 = squared_distance_to_segment(i, p, arc);
      if(best < 0 || d2 < best) {
        best = d2;
        where = arc;
      }
    }
    return where;
  }

  // Of p from the segment between points i and i + 1; `arc`: that of the nearest point there.
  double squared_distance_to_segment(std::size_t i, const Vec& p, double& arc) const
  {
    const Vec e = points_[i + 1] - points_[i];
    const double l2 = e * e;
    const double w = l2 > 0 ? (std::min)((std::max)((p - points_[i]) * e / l2, 0.), 1.) : 0.;
    const Vec d = p - (points_[i] + w * e);
    arc = arc_[i] + w * (arc_[i + 1] - arc_[i]);
    return d * d;
  }

private:
  std::size_t segment(double s) const
  {
    const auto it = std::upper_bound(arc_.begin(), arc_.end(), s);
    const std::size_t i = it == arc_.begin() ? 0 : std::size_t(it - arc_.begin()) - 1;
    return (std::min)(i, points_.size() - 2);
  }

  std::vector<Vec> points_;
  std::vector<double> arc_;
  bool closed_ = false, border_ = true, frozen_ = false;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FEATURE_CURVE_H
