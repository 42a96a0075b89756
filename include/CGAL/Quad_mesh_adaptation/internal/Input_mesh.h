// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_INPUT_MESH_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_INPUT_MESH_H

#include <CGAL/Quad_mesh_adaptation/Refusal.h>
#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The caller's mesh (or the region of it that may change) as arrays, with its constraints.
struct Input_mesh
{
  std::vector<Vec> points;
  std::vector<Quad> quads;
  std::vector<char> is_constrained; // per half-edge 4 f + i: a feature curve runs here
  std::vector<char> is_frozen;      // per half-edge: must not change at all
  std::vector<char> is_frozen_vertex;
  std::vector<Index> patch; // per quad, numbers of the caller's patches; empty: all the same

  bool has_frozen(Index h) const { return !is_frozen.empty() && is_frozen[h]; }
  bool has_constrained(Index h) const { return !is_constrained.empty() && is_constrained[h]; }
};

// Polygons of a reference surface cut into triangles.
struct Triangle_soup
{
  std::vector<Vec> points;
  std::vector<std::array<Index, 3>> triangles;
};

// Thrown where an input cannot be adapted, caught at the public header.
struct Refused
{
  Refusal reason;
  std::string message;
  long entity = -1;
  // where set, the entity is this vertex of the Input_mesh, and the message goes on after its
  // number
  Index input_vertex = -1;
};

// A quad is cut along the diagonal that leaves the two triangles least folded.
inline void append_quad(Triangle_soup& soup, const Quad& q)
{
  const auto fold = [&](int i) {
    const Vec &a = soup.points[q[i]], &b = soup.points[q[(i + 1) & 3]],
              &c = soup.points[q[(i + 2) & 3]], &d = soup.points[q[(i + 3) & 3]];
    const Vec n = cross(b - a, c - a), m = cross(c - a, d - a);
    const double lengths = norm(n) * norm(m);
    return lengths > 0 ? n * m / lengths : 0.;
  };
  const double f0 = fold(0), f1 = fold(1);
  const double d0 = (soup.points[q[0]] - soup.points[q[2]]).squared_length();
  const double d1 = (soup.points[q[1]] - soup.points[q[3]]).squared_length();
  const bool first = std::abs(f0 - f1) > 1e-9 ? f0 > f1 : d0 <= d1;
  const int i = first ? 0 : 1;
  soup.triangles.push_back({ q[i], q[i + 1], q[i + 2] });
  soup.triangles.push_back({ q[i], q[i + 2], q[(i + 3) & 3] });
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_INPUT_MESH_H
