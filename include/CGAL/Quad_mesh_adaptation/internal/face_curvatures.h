// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_CURVATURES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_CURVATURES_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>

#include <array>
#include <cmath>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// From one face to another: the way between their centres, and the turn of their normals.
struct Way_and_turn
{
  Vec way = Vec(0, 0, 0), turn = Vec(0, 0, 0);

  Way_and_turn(const Corners& from, const Corners& to)
      : way(0.25 * (to[0] - from[0] + to[1] - from[1] + (to[2] - from[2]) + (to[3] - from[3]))),
        turn(normalized(area_vector(to)) - normalized(area_vector(from)))
  {
  }
};

// Principal curvatures of the surface at face f, without signs, from its neighbours in both
// directions, but for those beyond feature curves.  The shape operator maps ways to turns; across a
// strip between curves it is not known, and zero.
inline std::array<double, 2> face_curvatures(const Adaptation_state& s, Index f)
{
  constexpr double parallel = 1e-6;
  const Quad_complex& m = s.mesh;
  const auto beyond = [&](Index h) {
    return s.corners(m.opposite(h) < 0 || m.curve(h) >= 0 ? f : m.face(m.opposite(h)));
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
