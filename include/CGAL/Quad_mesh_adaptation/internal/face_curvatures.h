// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_CURVATURES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_CURVATURES_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

inline Vec centre_of(const Corners& p) { return 0.25 * (p[0] + p[1] + (p[2] + p[3])); }

// The neighbour of f across half-edge h, or f itself where there is none or a feature curve is
// between them.
inline Index neighbour_within_patch(const Quad_complex& m, Index f, Index h)
{
  return m.opposite(h) < 0 || m.curve(h) >= 0 ? f : m.face(m.opposite(h));
}

// A face as the curvatures see it.
struct Face_frame
{
  Vec centre, normal;

  explicit Face_frame(const Corners& p) : centre(centre_of(p)), normal(normalized(area_vector(p)))
  {
  }
};

// From one face to another: the way between their centres, and the turn of their normals.
struct Way_and_turn
{
  Vec way, turn;

  Way_and_turn(const Face_frame& from, const Face_frame& to)
      : way(to.centre - from.centre), turn(to.normal - from.normal)
  {
  }
};

// A bound for the principal curvatures that face f can have, whatever its neighbours' normals, by
// the centres of faces alone; infinite where nothing can be said.
inline double largest_curvature(const Adaptation_state& s, Index f, const std::vector<Vec>& centres)
{
  const Quad_complex& m = s.mesh;
  const auto centre = [&](int i) { return centres[neighbour_within_patch(m, f, 4 * f + i)]; };
  const Vec a = centre(2) - centre(0), b = centre(3) - centre(1), n = area_vector(s.corners(f));
  const double nn = n * n, both = a * a + b * b, d = cross(a, b) * n;
  if(!(nn > 0 && d * d > 0)) return (std::numeric_limits<double>::infinity)();
  // the ways stretch by `least` at least, squared, and both turns by no more than 2
  const double area2 = d * d / nn,
               least = 2 * area2 / (both + std::sqrt((std::max)(both * both - 4 * area2, 0.)));
  return std::sqrt(8 / least);
}

// Principal curvatures of the surface at face f, without signs, from its neighbours in both
// directions, but for those beyond feature curves.  The shape operator maps ways to turns; across a
// strip between curves it is not known, and zero.
inline std::array<double, 2> face_curvatures(const Adaptation_state& s, Index f)
{
  constexpr double parallel = 1e-6;
  const auto beyond = [&](Index h) {
    return Face_frame(s.corners(neighbour_within_patch(s.mesh, f, h)));
  };
  const Way_and_turn ways[2] = { { beyond(4 * f), beyond(4 * f + 2) },
                                 { beyond(4 * f + 1), beyond(4 * f + 3) } };
  const int first = norm(ways[0].way) > 0 ? 0 : 1;
  const Way_and_turn &a = ways[first], &b = ways[1 - first];
  const Vec n = normalized(area_vector(s.corners(f)));
  const Vec u = normalized(a.way - (a.way * n) * n), v = cross(n, u);
  const double length = a.way * u, along = b.way * u, height = b.way * v;
  if(!(length > 0)) return { 0, 0 };
  const double uu = a.turn * u / length, vu = a.turn * v / length;
  double uv = vu, vv = 0;
  if(std::abs(height) > parallel * norm(b.way)) {
    uv = (b.turn * u - uu * along) / height;
    vv = (b.turn * v - vu * along) / height;
  }
  const double mean = 0.5 * (uu + vv), half = std::hypot(0.5 * (uu - vv), 0.5 * (uv + vu));
  return { std::abs(mean + half), std::abs(mean - half) };
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_CURVATURES_H
