// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SMOOTH_SURFACE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SMOOTH_SURFACE_H

#include <CGAL/Quad_mesh_adaptation/internal/Hermite_curve.h>
#include <CGAL/Quad_mesh_adaptation/internal/Local_fit.h>
#include <CGAL/Quad_mesh_adaptation/internal/Reference_surface.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// A smooth surface through the vertices of triangles.  Every vertex has a polynomial fitted to its
// neighbourhood, one on each side of a sharp edge; the point above a point of a triangle blends
// those of the three corners, with weights that leave an edge to its two ends (as Phong
// tessellation does with tangent planes: Boubekeur and Alexa, SIGGRAPH Asia 2008).  Along sharp and
// border edges the surface is made to meet their curves exactly.  Distance to the surface that the
// vertices were taken from: O(h^4) where the fits are cubic.
class Smooth_surface
{
public:
  Smooth_surface(const Reference_surface& flat, const Hermite_edges& curves)
      : points_(flat.points()), triangles_(flat.triangles())
  {
    collect_fans(flat);
    normals_.reserve(triangles_.size());
    for(std::size_t t = 0; t < triangles_.size(); ++t) normals_.push_back(facet_normal(t));
    fit_all();
    attach(curves);
    calm();
  }

  Surface_point operator()(const Vec& foot, Index t) const
  {
    return above(t, weights(foot, t), foot);
  }

  // Per vertex, the largest sum of absolute principal curvatures of its fits.
  std::vector<double> curvatures() const
  {
    std::vector<double> k(points_.size(), 0.);
    for(std::size_t t = 0; t < triangles_.size(); ++t)
      for(int i = 0; i < 3; ++i) {
        double& c = k[triangles_[t][i]];
        c = (std::max)(c, fits_[fan_[t][i]].curvature());
      }
    return k;
  }

private:
  using Weights = std::array<double, 3>;

  Vec facet_normal(std::size_t t) const
  {
    const auto& c = triangles_[t];
    return normalized(cross(points_[c[1]] - points_[c[0]], points_[c[2]] - points_[c[0]]));
  }

  // Triangles about a vertex that no sharp edge parts are a fan.
  void collect_fans(const Reference_surface& flat)
  {
    fan_.assign(triangles_.size(), { -1, -1, -1 });
    for(std::size_t t = 0; t < triangles_.size(); ++t)
      for(int i = 0; i < 3; ++i) {
        if(fan_[t][i] >= 0) continue;
        const Index number = Index(members_.size()), v = triangles_[t][i];
        members_.push_back({ Index(t) });
        is_open_.push_back(0);
        fan_[t][i] = number;
        for(std::size_t k = 0; k < members_[number].size(); ++k) {
          const Index u = members_[number][k];
          const int j = corner(u, v);
          for(int side : { j, (j + 2) % 3 }) {
            const Index n = flat.neighbour(u, side);
            if(n < 0) is_open_[number] = 1;
            if(n < 0 || fan_[n][corner(n, v)] >= 0) continue;
            fan_[n][corner(n, v)] = number;
            members_[number].push_back(n);
          }
        }
      }
  }

  int corner(Index t, Index v) const
  {
    return triangles_[t][0] == v ? 0 : triangles_[t][1] == v ? 1 : 2;
  }

  void fit_all()
  {
    fits_.resize(members_.size());
    // on one side of a curve two rows of points do not settle the third power of the distance
    for(std::size_t n = 0; n < members_.size(); ++n) fit(Index(n), is_open_[n] ? 2 : 3);
  }

  // Fan n by a polynomial of at most that degree: over its own points and those of the fans next
  // to it, as far as they do not turn away.
  void fit(Index n, int degree)
  {
    const Index t0 = members_[n][0];
    const int i0 = fan_[t0][0] == n ? 0 : fan_[t0][1] == n ? 1 : 2;
    const Index v = triangles_[t0][i0];
    Vec normal(0, 0, 0);
    for(Index t : members_[n]) normal = normal + corner_angle(t, corner(t, v)) * normals_[t];
    normal = normalized(normal);
    std::vector<Index> around;
    for(Index t : members_[n])
      for(Index next : fan_[t])
        for(Index u : members_[next])
          if(normals_[u] * normal > 0.3)
            around.insert(around.end(), triangles_[u].begin(), triangles_[u].end());
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    std::vector<Vec> p;
    for(Index u : around)
      if(u != v) p.push_back(points_[u]);
    fits_[n] = Local_fit(points_[v], normal, p, degree);
  }

  double corner_angle(Index t, int i) const
  {
    const auto& c = triangles_[t];
    const Vec a = points_[c[(i + 1) % 3]] - points_[c[i]],
              b = points_[c[(i + 2) % 3]] - points_[c[i]];
    return angle_between(a, b);
  }

  void attach(const Hermite_edges& curves)
  {
    curve_.assign(triangles_.size(), { -1, -1, -1 });
    for(std::size_t t = 0; t < triangles_.size(); ++t)
      for(int i = 0; i < 3; ++i) {
        const Index a = triangles_[t][i], b = triangles_[t][(i + 1) % 3];
        const auto it = curves.find({ (std::min)(a, b), (std::max)(a, b) });
        if(it == curves.end()) continue;
        curve_[t][i] = Index(segments_.size());
        segments_.push_back(a < b ? it->second : it->second.reversed());
      }
  }

  Weights weights(const Vec& p, Index t) const
  {
    const auto& c = triangles_[t];
    const Vec a = points_[c[1]] - points_[c[0]], b = points_[c[2]] - points_[c[0]],
              d = p - points_[c[0]], n = cross(a, b);
    const double nn = n * n;
    if(!(nn > 0)) return { 1, 0, 0 };
    const double w1 = (std::max)(0., cross(d, b) * n / nn),
                 w2 = (std::max)(0., cross(a, d) * n / nn);
    const double w0 = (std::max)(0., 1 - w1 - w2), sum = w0 + w1 + w2;
    return { w0 / sum, w1 / sum, w2 / sum };
  }

  // Without regard to curves.
  Surface_point blend(Index t, const Weights& b, const Vec& p) const
  {
    double sum = 0;
    Vec point(0, 0, 0), normal(0, 0, 0);
    for(int i = 0; i < 3; ++i) {
      const double w = b[i] * b[i];
      if(w == 0) continue;
      const Surface_point q = fits_[fan_[t][i]].lift(p);
      sum += w;
      point = point + w * q.point;
      normal = normal + w * q.normal;
    }
    return { point / sum, normalized(normal) };
  }

  Surface_point above(Index t, const Weights& b, const Vec& foot) const
  {
    Surface_point q = blend(t, b, foot);
    for(int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const double s = b[i] + b[j];
      if(curve_[t][i] < 0 || !(b[i] > 0 && b[j] > 0)) continue;
      Weights e = { 0, 0, 0 };
      e[i] = b[i] / s;
      e[j] = b[j] / s;
      const Vec on = e[i] * points_[triangles_[t][i]] + e[j] * points_[triangles_[t][j]];
      const Vec gap = segments_[curve_[t][i]].at(e[j]) - blend(t, e, on).point;
      q.point = q.point + (s * s) * gap;
    }
    return q;
  }

  // Where a fit bulges or turns more than the triangles justify, all three corners take a lower
  // degree, down to none; the surface stays continuous because corners share their fits.
  void calm()
  {
    std::vector<char> wild(fits_.size());
    for(bool again = true; again;) {
      again = false;
      std::fill(wild.begin(), wild.end(), 0);
      for(std::size_t t = 0; t < triangles_.size(); ++t) {
        if(is_calm(Index(t))) continue;
        for(Index n : fan_[t])
          if(fits_[n].degree() > 0) wild[n] = again = true;
      }
      for(std::size_t n = 0; n < fits_.size(); ++n)
        if(wild[n]) fit(Index(n), fits_[n].degree() - 1);
    }
  }

  bool is_calm(Index t) const
  {
    const auto& c = triangles_[t];
    double longest = 0;
    for(int i = 0; i < 3; ++i)
      longest = (std::max)(longest, distance(points_[c[i]], points_[c[(i + 1) % 3]]));
    constexpr int n = 4;
    for(int i = 0; i <= n; ++i)
      for(int j = 0; i + j <= n; ++j) {
        const Weights b = { double(i) / n, double(j) / n, double(n - i - j) / n };
        const Vec p = b[0] * points_[c[0]] + b[1] * points_[c[1]] + b[2] * points_[c[2]];
        const Surface_point q = blend(t, b, p);
        if(!(distance(p, q.point) < 0.25 * longest) || !(q.normal * normals_[t] > 0.5))
          return false;
      }
    return true;
  }

  std::vector<Vec> points_;
  std::vector<std::array<Index, 3>> triangles_;
  std::vector<Vec> normals_;                // of the triangles
  std::vector<std::array<Index, 3>> fan_;   // of each corner
  std::vector<std::vector<Index>> members_; // triangles of each fan
  std::vector<char> is_open_;               // is the vertex on a curve?
  std::vector<Local_fit> fits_;             // of each fan
  std::vector<std::array<Index, 3>> curve_; // segment of each edge, -1: none
  std::vector<Hermite_segment> segments_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SMOOTH_SURFACE_H
