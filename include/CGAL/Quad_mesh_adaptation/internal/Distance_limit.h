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
// vertices: at first from its curvature and that of the curves (the middle of a face of edge h is
// h^2 (|k1| + |k2|) / 8 below the surface), later lowered where that did not do.
class Distance_limit
{
public:
  Distance_limit(const Adaptation_state& s, double allowed)
      : surface_(s.surface), allowed_(allowed), cell_(2 * mean_edge(s.surface)),
        limit_(s.surface.points().size(), (std::numeric_limits<double>::infinity)()),
        least_(limit_.size(), 0.)
  {
    if(!surface_.is_planar()) {
      const std::vector<double> k = Smooth_surface(surface_, Hermite_edges()).curvatures();
      for(std::size_t v = 0; v < k.size(); ++v)
        if(k[v] > 0) limit_[v] = size_for(k[v]);
    }
    for(const Feature_curve& c : s.curves) bound_on_curve(c);
    grade();
  }

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

  // Lowers the sizes at the faces that are farther than allowed, and a little at those that are
  // nearly so; false if no face is too far.
  bool tighten(const Adaptation_state& s, const Distance_measure& far)
  {
    const Quad_complex& m = s.mesh;
    std::vector<double> wanted(m.face_end(), (std::numeric_limits<double>::infinity)());
    bool any = false;
    for(Index f = 0; f < m.face_end(); ++f) {
      if(!m.is_face(f) || far.of(f) <= 0.95 * allowed_) continue;
      any = any || far.of(f) > allowed_;
      const Corners p = s.corners(f);
      wanted[f] = mean_edge_length(p) * (std::max)(0.4, std::sqrt(0.8 * allowed_ / far.of(f)));
      const Vec centre = 0.25 * (p[0] + p[1] + p[2] + p[3]);
      for(int i = 0; i < 4; ++i) { // near the middle of each edge, where curves are missed
        const Vec q = 0.5 * (0.9 * (p[i] + p[(i + 1) & 3]) + 0.2 * centre);
        for(Index v : surface_.triangles()[triangle_at(q)]) lower(v, wanted[f]);
      }
    }
    if(!any) return false;
    for(std::size_t v = 0; v < limit_.size(); ++v) {
      const Index f = far.face_below(Index(v));
      if(f >= 0) lower(Index(v), wanted[f]);
    }
    grade();
    return true;
  }

private:
  double size_for(double curvature) const { return 0.92 * std::sqrt(8 * allowed_ / curvature); }

  // At most to half of what was first thought enough: where a curve of the input has no counterpart
  // in the reference, or the reference is rough, small faces do not help.
  void lower(Index v, double wanted)
  {
    if(!(wanted < limit_[v])) return;
    if(least_[v] == 0) least_[v] = 0.5 * (std::min)(limit_[v], 2 * wanted);
    limit_[v] = (std::max)(wanted, (std::min)(least_[v], limit_[v]));
  }

  void grade() { limit_slope(surface_.points(), surface_.triangles(), 0.5, limit_); }

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

  // Turn per length at every point of the polyline.
  void bound_on_curve(const Feature_curve& c)
  {
    const std::vector<Vec>& p = c.points();
    const std::size_t n = p.size() - 1;
    for(std::size_t i = c.is_closed() ? 0 : 1; i < n; ++i) {
      const Vec a = p[i] - p[i == 0 ? n - 1 : i - 1], b = p[i + 1] - p[i];
      const double turn = std::atan2(norm(cross(a, b)), a * b);
      if(turn < 1e-9) continue;
      const double h = size_for(2 * turn / (norm(a) + norm(b)));
      for(Index v : surface_.triangles()[triangle_at(p[i])]) limit_[v] = (std::min)(limit_[v], h);
    }
  }

  const Reference_surface& surface_;
  double allowed_, cell_;
  std::vector<double> limit_;       // infinite: none
  std::vector<double> least_;       // once lowered
  mutable std::shared_mutex mutex_; // of the triangles near the centres of cells
  mutable std::unordered_map<std::array<std::int64_t, 3>, Index, Hash> starts_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISTANCE_LIMIT_H
