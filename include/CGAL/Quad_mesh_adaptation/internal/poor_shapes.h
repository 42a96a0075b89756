// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_POOR_SHAPES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_POOR_SHAPES_H

#include <CGAL/Quad_mesh_adaptation/Poor_face.h>
#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

inline double corner_angle(const Quad_complex& m, Index h)
{
  const Vec& p = m.point(m.origin(h));
  const Vec a = m.point(m.target(h)) - p, b = m.point(m.origin(m.prev(h))) - p;
  return angle_between(a, b);
}

// The angle between the two feature edges that enclose the corner of half-edge h, over all faces
// between them; 2 pi if none do.
inline double sector_angle(const Quad_complex& m, Index h)
{
  constexpr double none = 2 * pi;
  const auto is_feature = [&](Index e) { return m.is_border(e) || m.curve(e) >= 0; };
  double angle = corner_angle(m, h);
  for(Index e = h; !is_feature(e);) {
    e = m.turn_right(e);
    if(e == h) return none;
    angle += corner_angle(m, e);
  }
  for(Index e = h; !is_feature(m.prev(e));) {
    e = m.turn_left(e);
    angle += corner_angle(m, e);
  }
  return (std::min)(angle, none);
}

// Corners, nodes the caller holds, and those of edges that must not change.
inline bool is_held(const Adaptation_state& s, Index v)
{
  const Vertex_record& r = s.mesh.vertex(v);
  return r.carrier == Carrier::corner ||
         (r.carrier == Carrier::curve && s.curves[r.curve].is_frozen());
}

// The smallest cosine between the surface's normals at corners of f, 1 where they are not known.
inline double surface_turn(const Adaptation_state& s, Index f)
{
  const Quad q = s.mesh.quad(f);
  double least = 1;
  for(int i = 0; i < 4; ++i)
    for(int j = i + 1; j < 4; ++j) {
      const Vec &a = s.mesh.vertex(q[i]).normal, &b = s.mesh.vertex(q[j]).normal;
      if(a * a > 0 && b * b > 0) least = (std::min)(least, a * b);
    }
  return least;
}

// What keeps face f from a scaled Jacobian of `floor`.
inline Poor_face shape_limit(const Adaptation_state& s, Index f, double floor)
{
  constexpr double curved = 0.5; // 60 degrees
  const Quad_complex& m = s.mesh;
  const double least_angle = std::asin(floor);
  Poor_face p;
  p.scaled_jacobian = scaled_jacobian(s.corners(f));
  for(Index h = 4 * f; h < 4 * f + 4; ++h) {
    const double angle = sector_angle(m, h);
    if(angle > least_angle) continue;
    p.limit = Shape_limit::feature_angle;
    p.angle = angle * 180 / pi;
    p.vertex = std::size_t(m.origin(h));
    return p;
  }
  const Quad q = m.quad(f);
  if(std::count_if(q.begin(), q.end(), [&](Index v) { return is_held(s, v); }) >= 3)
    p.limit = Shape_limit::held_nodes;
  else if(surface_turn(s, f) < curved)
    p.limit = Shape_limit::curved_surface;
  return p;
}

// Is face f poorer than promised, with nothing that keeps it so?
inline bool is_unexcused(const Adaptation_state& s, Index f)
{
  return is_jacobian_below(s.corners(f), Poor_face::floor) &&
         shape_limit(s, f, Poor_face::floor).limit == Shape_limit::none;
}

// The same, but an excuse holds only as far as it goes: an angle between features leaves its sine,
// and what else there is does not make a face useless.
inline bool is_poorer_than_need_be(const Adaptation_state& s, Index f)
{
  constexpr double share = 0.5, useless = 0.15;
  if(!is_jacobian_below(s.corners(f), Poor_face::floor)) return false;
  const Poor_face p = shape_limit(s, f, Poor_face::floor);
  if(p.limit == Shape_limit::none) return true;
  return p.scaled_jacobian <
         (p.limit == Shape_limit::feature_angle ? share * std::sin(p.angle * pi / 180) : useless);
}

// All faces below `floor`, with their numbers in the state.
inline std::vector<Poor_face> poor_shapes(const Adaptation_state& s, double floor)
{
  std::vector<Poor_face> list;
  for(Index f : s.mesh.faces())
    if(is_jacobian_below(s.corners(f), floor)) {
      list.push_back(shape_limit(s, f, floor));
      list.back().face = std::size_t(f);
    }
  return list;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_POOR_SHAPES_H
