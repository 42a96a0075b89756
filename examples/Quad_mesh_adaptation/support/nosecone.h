// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_EXAMPLES_NOSECONE_H
#define QUAD_MESH_ADAPTATION_EXAMPLES_NOSECONE_H

#include "Mesh_builder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace paper_cases {

/// The paraboloid of revolution z = 16 (r/8)^2, 0 <= z <= 16, tip at the origin.
struct Paraboloid
{
  static constexpr double base_radius = 8., height = 16.;

  /// Length of the meridian from the tip to the parameter t = r / 8.
  static double arc_length(double t)
  {
    const double slope = 2 * height / base_radius; // dz/dr at the base
    const double u = slope * t;
    return base_radius / 2 * (t * std::sqrt(1 + u * u) + std::asinh(u) / slope);
  }

  /// Parameter at a given length; Newton's method on an increasing convex function.
  static double parameter(double s)
  {
    if(s <= 0) return 0;
    if(s >= arc_length(1)) return 1;
    double t = 1;
    for(int i = 0; i < 60; ++i) {
      const double u = 2 * height / base_radius * t;
      const double step = (arc_length(t) - s) / (base_radius * std::sqrt(1 + u * u));
      t -= step;
      if(std::abs(step) < 1e-15) break;
    }
    return t;
  }

  /// Point at length `s` from the tip along the meridian of angle `phi`.
  static Point at(double s, double phi)
  {
    const double t = parameter(s);
    return Point(base_radius * t * std::cos(phi), base_radius * t * std::sin(phi), height * t * t);
  }
};

namespace internal {

/// A point of the nosecone unrolled to a disk: (length from the tip, angle) in Cartesian form.
struct Disk_point
{
  double x, y;
};

inline Vertex add_unrolled(Mesh_builder& b, const Disk_point& p)
{
  const Point q = Paraboloid::at(std::hypot(p.x, p.y), std::atan2(p.y, p.x));
  return b.vertex(q.x(), q.y(), q.z());
}

/// The tip: a pentagon of five patches of n x n quads that share the tip (a node of valence 5);
/// the patches' far corners get valence 3.  Returns the rim, counter-clockwise from angle 0.
class Pentagon_cap
{
public:
  Pentagon_cap(Mesh_builder& b, int n, double inradius) : b(b), n(n), inradius(inradius)
  {
    tip = add_unrolled(b, { 0, 0 });
    for(int j = 0; j < 5; ++j) spokes[j] = make_spoke(j);
    for(int j = 0; j < 5; ++j) make_patch(j);
  }
  std::vector<Vertex> rim;
  std::vector<Disk_point> rim_points;

private:
  Mesh_builder& b;
  int n;
  double inradius;
  Vertex tip;
  std::array<std::vector<Vertex>, 5> spokes; // from the tip to the middles of the sides

  static double angle(double j) { return 2 * std::acos(-1.) * j / 5; }

  Disk_point on_spoke(int j, double w) const
  {
    return { w * inradius * std::cos(angle(j)), w * inradius * std::sin(angle(j)) };
  }
  std::vector<Vertex> make_spoke(int j)
  {
    std::vector<Vertex> s = { tip };
    for(int i = 1; i <= n; ++i) s.push_back(add_unrolled(b, on_spoke(j, double(i) / n)));
    return s;
  }
  // The patch between the spokes j and j+1, its far corner a corner of the pentagon.
  void make_patch(int j)
  {
    const int next = (j + 1) % 5;
    const double far = inradius / std::cos(angle(0.5));
    const Disk_point a = on_spoke(j, 1), d = on_spoke(next, 1),
                     c = { far * std::cos(angle(j + 0.5)), far * std::sin(angle(j + 0.5)) };
    std::vector<std::vector<Vertex>> v(n + 1, std::vector<Vertex>(n + 1));
    std::vector<std::vector<Disk_point>> p(n + 1, std::vector<Disk_point>(n + 1));
    for(int i = 0; i <= n; ++i)
      for(int l = 0; l <= n; ++l) {
        const double u = double(i) / n, w = double(l) / n;
        p[i][l] = { u * (1 - w) * a.x + u * w * c.x + (1 - u) * w * d.x,
                    u * (1 - w) * a.y + u * w * c.y + (1 - u) * w * d.y };
        v[i][l] = l == 0 ? spokes[j][i] : i == 0 ? spokes[next][l] : add_unrolled(b, p[i][l]);
      }
    for(int i = 0; i < n; ++i)
      for(int l = 0; l < n; ++l) b.face({ v[i][l], v[i + 1][l], v[i + 1][l + 1], v[i][l + 1] });
    for(int l = 0; l < n; ++l) add_to_rim(v[n][l], p[n][l]);
    for(int i = n; i > 0; --i) add_to_rim(v[i][n], p[i][n]);
  }
  void add_to_rim(Vertex v, const Disk_point& p)
  {
    rim.push_back(v);
    rim_points.push_back(p);
  }
};

} // namespace internal

/// The initial mesh: 725 k^2 quads of size about 1/k, six irregular nodes near the tip.
inline Mesh nosecone_mesh(int k)
{
  const double pi = std::acos(-1.), length = Paraboloid::arc_length(1);
  const int rings = 12 * k;
  Mesh_builder b;
  const internal::Pentagon_cap cap(b, 5 * k, 0.28 * length);
  std::vector<Vertex> inner = cap.rim;
  const std::size_t m = inner.size();
  for(int ring = 1; ring <= rings; ++ring) {
    const double w = double(ring) / rings;
    std::vector<Vertex> outer(m);
    for(std::size_t i = 0; i < m; ++i) {
      const internal::Disk_point& p = cap.rim_points[i];
      const double target = 2 * pi * double(i) / double(m);
      double turn = std::atan2(p.y, p.x) - target;
      turn -= 2 * pi * std::round(turn / (2 * pi));
      const double phi = target + (1 - w) * turn;
      const double s = (1 - w) * std::hypot(p.x, p.y) + w * length;
      outer[i] = internal::add_unrolled(b, { s * std::cos(phi), s * std::sin(phi) });
    }
    for(std::size_t i = 0; i < m; ++i)
      b.face({ inner[i], outer[i], outer[(i + 1) % m], inner[(i + 1) % m] });
    inner.swap(outer);
  }
  return b.mesh;
}

/// The surface in fine triangles, finer towards the tip: 360 000 with the default arguments, off
/// the paraboloid by at most about 1e-4.
inline Mesh nosecone_reference(int rings = 300, int sectors = 600)
{
  const double pi = std::acos(-1.), length = Paraboloid::arc_length(1);
  Mesh_builder b;
  const Vertex tip = b.vertex(0, 0, 0);
  std::vector<Vertex> inner(sectors, tip), outer(sectors);
  for(int ring = 1; ring <= rings; ++ring) {
    const double s = length * std::pow(double(ring) / rings, 1.5);
    for(int i = 0; i < sectors; ++i) {
      const Point p = Paraboloid::at(s, 2 * pi * i / sectors);
      outer[i] = b.vertex(p.x(), p.y(), p.z());
    }
    for(int i = 0; i < sectors; ++i) {
      const int next = (i + 1) % sectors;
      b.face({ inner[i], outer[i], outer[next] });
      if(ring > 1) b.face({ inner[i], outer[next], inner[next] });
    }
    inner = outer;
  }
  return b.mesh;
}

} // namespace paper_cases

#endif // QUAD_MESH_ADAPTATION_EXAMPLES_NOSECONE_H
