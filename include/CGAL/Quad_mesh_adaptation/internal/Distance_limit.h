// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISTANCE_LIMIT_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISTANCE_LIMIT_H

#include <CGAL/Quad_mesh_adaptation/internal/Distance_measure.h>
#include <CGAL/Quad_mesh_adaptation/internal/Smooth_surface.h>
#include <CGAL/Quad_mesh_adaptation/internal/limit_slope.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <mutex>
#include <shared_mutex>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The largest size that keeps faces within a distance of the reference surface, as values at its
// vertices: from its curvature and that of the curves (the middle of a face of edge h is
// h^2 (|k1| + |k2|) / 8 below the surface).
class Distance_limit
{
public:
  Distance_limit(const Adaptation_state& s, double allowed)
      : surface_(s.surface), allowed_(allowed), cell_(0.5 * mean_edge(s.surface)),
        limit_(s.surface.points().size(), (std::numeric_limits<double>::infinity)())
  {
    if(!surface_.is_planar()) {
      const std::vector<double> k = Smooth_surface(surface_, Hermite_edges()).curvatures(),
                                side = facet_sides();
      for(std::size_t v = 0; v < k.size(); ++v)
        if(k[v] > 0) limit_[v] = size_for(k[v], side[v]);
    }
    for(const Feature_curve& c : s.curves) bound_on_curve(c);
    grade();
  }

  // No value is below this.
  double least() const { return least_of_all_; }

  double operator()(const Vec& p) const
  {
    const Index t = triangle_at(p);
    const std::array<Vec, 3> c = surface_.triangle(t);
    const Vec q = closest_on_triangle(p, c).point, n = cross(c[1] - c[0], c[2] - c[0]);
    const double nn = n * n;
    if(!(nn > 0)) return limit_[surface_.triangles()[t][0]];
    const double w1 = std::clamp(cross(q - c[0], c[2] - c[0]) * n / nn, 0., 1.),
                 w2 = std::clamp(cross(c[1] - c[0], q - c[0]) * n / nn, 0., 1. - w1);
    const auto& v = surface_.triangles()[t];
    if(!(std::isfinite(limit_[v[0]]) && std::isfinite(limit_[v[1]]) && std::isfinite(limit_[v[2]])))
      return (std::min)({ limit_[v[0]], limit_[v[1]], limit_[v[2]] });
    return (1 - w1 - w2) * limit_[v[0]] + w1 * limit_[v[1]] + w2 * limit_[v[2]];
  }

private:
  // Faces smaller than the flat facets of the surface, of this side, meet its whole turn at once
  // where they lie across two of them: their middle is h t / 4 off, with t = curvature * side.
  double size_for(double curvature, double side) const
  {
    const double h = std::sqrt(8 * allowed_ / curvature);
    return 0.92 * (std::min)(h, 1.5 * h * h / (2 * side));
  }

  // Mean side of the squares that two triangles make, by vertex; zero where faces are lifted to a
  // smooth surface.
  std::vector<double> facet_sides() const
  {
    std::vector<double> area(limit_.size(), 0.), sides(limit_.size(), 0.);
    if(surface_.has_lift()) return sides;
    for(Index t = 0; t < Index(surface_.number_of_triangles()); ++t) {
      const std::array<Vec, 3> c = surface_.triangle(t);
      for(Index v : surface_.triangles()[t]) {
        area[v] += norm(cross(c[1] - c[0], c[2] - c[0])); // of two
        sides[v] += 1;
      }
    }
    for(std::size_t v = 0; v < sides.size(); ++v)
      if(sides[v] > 0) sides[v] = std::sqrt(area[v] / sides[v]);
    return sides;
  }

  void grade()
  {
    limit_slope(surface_.points(), surface_.triangles(), 0.3, limit_);
    least_of_all_ = *std::min_element(limit_.begin(), limit_.end());
  }

  // The triangle near p, walking from the one nearest to the centre of p's cell: quick, and the
  // same whatever was asked before.
  Index triangle_at(const Vec& p) const
  {
    std::array<std::int64_t, 3> cell;
    for(int i = 0; i < 3; ++i) cell[i] = std::int64_t(std::floor(p[i] / cell_));
    Index t = known_start(cell);
    if(t < 0) {
      const Vec half(0.5, 0.5, 0.5), corner{ double(cell[0]), double(cell[1]), double(cell[2]) };
      t = surface_.nearest_triangle(cell_ * (corner + half));
      const std::unique_lock<std::shared_mutex> lock(mutex_);
      starts_.emplace(cell, t);
    }
    surface_.nearest_on(p, t);
    return t;
  }

  Index known_start(const std::array<std::int64_t, 3>& cell) const
  {
    const std::shared_lock<std::shared_mutex> lock(mutex_);
    const auto known = starts_.find(cell);
    return known != starts_.end() ? known->second : Index(-1);
  }

  static double mean_edge(const Reference_surface& s)
  {
    double sum = 0;
    for(Index t = 0; t < Index(s.number_of_triangles()); ++t) {
      const std::array<Vec, 3> c = s.triangle(t);
      sum += std::sqrt(norm(cross(c[1] - c[0], c[2] - c[0])));
    }
    return sum / double(s.number_of_triangles());
  }

  struct Hash
  {
    std::size_t operator()(const std::array<std::int64_t, 3>& c) const
    {
      std::uint64_t h = 0;
      for(std::int64_t x : c) h = (h ^ std::uint64_t(x)) * 0x9E3779B97F4A7C15ull;
      return std::size_t(h ^ (h >> 32));
    }
  };

  // By the turn per length at every point of the polyline; but edges clearly shorter than its own
  // get a node there, see Curve_bends.
  void bound_on_curve(const Feature_curve& c)
  {
    constexpr double clearly_shorter = 0.6;
    const std::vector<Vec>& p = c.points();
    const std::size_t n = p.size() - 1;
    for(std::size_t i = c.is_closed() ? 0 : 1; i < n; ++i) {
      const Vec a = p[i] - p[i == 0 ? n - 1 : i - 1], b = p[i + 1] - p[i];
      const double turn = angle_between(a, b);
      if(turn < 1e-9) continue;
      const double side = (norm(a) + norm(b)) / 2,
                   with_node = clearly_shorter * (std::min)(norm(a), norm(b)),
                   h = (std::max)(size_for(turn / side, side), with_node);
      for(Index v : surface_.triangles()[triangle_at(p[i])]) limit_[v] = (std::min)(limit_[v], h);
    }
  }

  const Reference_surface& surface_;
  double allowed_, cell_, least_of_all_ = 0;
  std::vector<double> limit_;       // infinite: none
  mutable std::shared_mutex mutex_; // of the triangles near the centres of cells
  mutable std::unordered_map<std::array<std::int64_t, 3>, Index, Hash> starts_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISTANCE_LIMIT_H
