// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISTANCE_LIMIT_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISTANCE_LIMIT_H

#include <CGAL/Quad_mesh_adaptation/internal/Distance_measure.h>
#include <CGAL/Quad_mesh_adaptation/internal/Smooth_surface.h>
#include <CGAL/Quad_mesh_adaptation/internal/limit_slope.h>

#include <algorithm>
#include <cmath>
#include <limits>
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
      : surface_(s.surface), allowed_(allowed),
        limit_(s.surface.points().size(), (std::numeric_limits<double>::infinity)())
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
    const Index t = surface_.nearest_triangle(p);
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
      if(!m.is_face(f) || far.of(f) <= 0.85 * allowed_) continue;
      any = any || far.of(f) > allowed_;
      const Corners p = s.corners(f);
      wanted[f] = mean_edge_length(p) * (std::max)(0.4, std::sqrt(0.75 * allowed_ / far.of(f)));
      const Index t = surface_.nearest_triangle(0.25 * (p[0] + p[1] + p[2] + p[3]));
      for(Index v : surface_.triangles()[t]) limit_[v] = (std::min)(limit_[v], wanted[f]);
    }
    if(!any) return false;
    for(std::size_t v = 0; v < limit_.size(); ++v) {
      const Index f = far.face_below(Index(v));
      if(f >= 0) limit_[v] = (std::min)(limit_[v], wanted[f]);
    }
    grade();
    return true;
  }

private:
  double size_for(double curvature) const { return 0.92 * std::sqrt(8 * allowed_ / curvature); }

  void grade() { limit_slope(surface_.points(), surface_.triangles(), 0.5, limit_); }

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
      for(Index v : surface_.triangles()[surface_.nearest_triangle(p[i])])
        limit_[v] = (std::min)(limit_[v], h);
    }
  }

  const Reference_surface& surface_;
  double allowed_;
  std::vector<double> limit_; // infinite: none
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISTANCE_LIMIT_H
