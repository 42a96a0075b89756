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

// A face as the curvatures see it; the size is the mean of those at its corners.
struct Face_frame
{
  Vec centre = Vec(0, 0, 0), normal = Vec(0, 0, 0);
  double h = 0;

  Face_frame() = default;
  Face_frame(const Adaptation_state& s, Index f)
  {
    const Corners p = s.corners(f);
    centre = 0.25 * (p[0] + p[1] + (p[2] + p[3]));
    normal = normalized(area_vector(p));
    for(Index v : s.mesh.quad(f)) h += 0.25 * s.mesh.vertex(v).h;
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

// Principal curvatures of the surface at face f, without signs, from its neighbours in both
// directions, but for those beyond feature curves.  The shape operator maps ways to turns; across a
// strip between curves it is not known, and zero.  `frame(f)`: that of a face.
template <typename Frame>
std::array<double, 2> face_curvatures(const Quad_complex& m, Index f, const Frame& frame)
{
  constexpr double parallel = 1e-6;
  const auto beyond = [&](Index h) -> decltype(auto) {
    return frame(m.opposite(h) < 0 || m.curve(h) >= 0 ? f : m.face(m.opposite(h)));
  };
  const Way_and_turn ways[2] = { { beyond(4 * f), beyond(4 * f + 2) },
                                 { beyond(4 * f + 1), beyond(4 * f + 3) } };
  const int first = norm(ways[0].way) > 0 ? 0 : 1;
  const Way_and_turn &a = ways[first], &b = ways[1 - first];
  const Vec n = frame(f).normal;
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

inline std::array<double, 2> face_curvatures(const Adaptation_state& s, Index f)
{
  return face_curvatures(s.mesh, f, [&s](Index g) { return Face_frame(s, g); });
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_CURVATURES_H
