// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_EXAMPLES_QUARTER_PLATE_H
#define QUAD_MESH_ADAPTATION_EXAMPLES_QUARTER_PLATE_H

#include "Mesh_builder.h"

#include <cmath>
#include <vector>

namespace paper_cases {

/// A quarter of the square plate [-6,6]^2 with a hole of radius 1 around the origin.
struct Quarter_plate
{
  static constexpr double side = 6., hole_radius = 1.;
};

namespace internal {

inline Point on_hole(double share)
{
  // exact end points, so that the symmetry lines x = 0 and y = 0 are met exactly
  if(share <= 0) return Point(Quarter_plate::hole_radius, 0, 0);
  if(share >= 1) return Point(0, Quarter_plate::hole_radius, 0);
  const double angle = share * std::acos(-1.) / 2;
  return Point(Quarter_plate::hole_radius * std::cos(angle),
               Quarter_plate::hole_radius * std::sin(angle), 0);
}

inline Vertex add_between(Mesh_builder& b, const Point& p, const Point& q, double w)
{
  return b.vertex((1 - w) * p.x() + w * q.x(), (1 - w) * p.y() + w * q.y(), 0.);
}

} // namespace internal

/// The initial mesh: 103 k^2 quads of size about 0.6/k.  A regular grid whose corner square of
/// side 1.8 is replaced by layers around the hole; one interior node has valence 5.
inline Mesh quarter_plate_mesh(int k)
{
  const int n = 10 * k, m = 3 * k, layers = 2 * k; // cells of the side, of the square, of a layer
  const double h = Quarter_plate::side / n;
  Mesh_builder b;
  std::vector<std::vector<Vertex>> grid(n + 1, std::vector<Vertex>(n + 1));
  for(int i = 0; i <= n; ++i)
    for(int j = 0; j <= n; ++j)
      if(i >= m || j >= m) grid[i][j] = b.vertex(h * i, h * j, 0.);
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
      if(i >= m || j >= m)
        b.face({ grid[i][j], grid[i + 1][j], grid[i + 1][j + 1], grid[i][j + 1] });

  std::vector<Vertex> before;
  for(int q = 0; q <= 2 * m; ++q) { // along the square's two inner sides, from (1.8, 0) to (0, 1.8)
    const Vertex end = q <= m ? grid[m][q] : grid[2 * m - q][m];
    const Point hole = internal::on_hole(q / (2. * m)), far = b.mesh.point(end);
    std::vector<Vertex> line;
    for(int l = 0; l < layers; ++l)
      line.push_back(internal::add_between(b, hole, far, double(l) / layers));
    line.push_back(end);
    for(int l = 0; l < layers && q > 0; ++l)
      b.face({ before[l], before[l + 1], line[l + 1], line[l] });
    before.swap(line);
  }
  return b.mesh;
}

/// The same region in fine triangles, for its border: the hole is an arc of `sectors` segments,
/// off the circle by at most 3.1e-7 with the default.
inline Mesh quarter_plate_reference(int sectors = 1000, int layers = 8)
{
  Mesh_builder b;
  std::vector<Vertex> before;
  for(int i = 0; i <= sectors; ++i) {
    const double t = 2. * i / sectors; // runs up the right side, then left along the top
    const Point hole = internal::on_hole(double(i) / sectors);
    const Point far = t <= 1 ? Point(Quarter_plate::side, Quarter_plate::side * t, 0)
                             : Point(Quarter_plate::side * (2 - t), Quarter_plate::side, 0);
    std::vector<Vertex> line;
    for(int l = 0; l <= layers; ++l) {
      const double w = double(l) / layers;
      line.push_back(internal::add_between(b, hole, far, 0.1 * w + 0.9 * w * w));
    }
    for(int l = 0; l < layers && i > 0; ++l) {
      b.face({ before[l], before[l + 1], line[l + 1] });
      b.face({ before[l], line[l + 1], line[l] });
    }
    before.swap(line);
  }
  return b.mesh;
}

} // namespace paper_cases

#endif // QUAD_MESH_ADAPTATION_EXAMPLES_QUARTER_PLATE_H
