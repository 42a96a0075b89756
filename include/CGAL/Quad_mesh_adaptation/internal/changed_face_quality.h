// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHANGED_FACE_QUALITY_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHANGED_FACE_QUALITY_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>

#include <algorithm>
#include <utility>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Is the face q longer than `limit` sizes with its nodes as node(v) has them?
template <typename Node_of>
bool is_changed_face_longer(const Quad& q, const Node_of& node, double limit)
{
  double sizes = 0, around = 0;
  for(int i = 0; i < 4; ++i) {
    const Vertex_record& r = node(q[i]);
    sizes += r.h;
    around += distance(r.p, node(q[(i + 1) & 3]).p);
  }
  return around > limit * sizes;
}

// Does it have nodes that are on curves or must not move?  Smoothing hardly mends it then.
template <typename Node_of>
bool is_changed_face_held(const Quad& q, const Node_of& node)
{
  return std::any_of(q.begin(), q.end(),
                     [&](Index v) { return node(v).carrier != Carrier::surface; });
}

// The face q with its nodes as node(v) has them, and where it should look.
template <typename Node_of>
std::pair<Corners, Facing> changed_face(const Quad& q, const Node_of& node)
{
  std::pair<Corners, Facing> face;
  for(int i = 0; i < 4; ++i) {
    const Vertex_record& r = node(q[i]);
    face.first[i] = r.p;
    face.second.add(r.normal);
  }
  return face;
}

// Its quality.
template <typename Node_of>
double changed_face_quality(const Quad& q, const Node_of& node)
{
  const std::pair<Corners, Facing> face = changed_face(q, node);
  return Adaptation_state::face_quality(face.first, face.second);
}

// Is the warp certainly no more than `most`?  Squares tell that of most faces.
inline bool is_surely_flat(const Corners& p, const Vec& area, double most)
{
  constexpr double margin = 1 - 1e-9;
  double squares = 0; // their sum is less than the square of the sum of the edges
  for(int i = 0; i < 4; ++i) squares += (p[(i + 1) & 3] - p[i]).squared_length();
  const double off = 4 * ((p[0] - p[1] + p[2] - p[3]) * area);
  return most > 0 && off * off < margin * most * most * (area * area) * squares;
}

// The same as to ask whether the quality of face p is `least` or more, with hardly a root.
inline bool has_quality(const Corners& p, const Facing& reference, double least)
{
  constexpr double margin = 1 + 1e-9;
  const Vec area = area_vector(p);
  const double cosine = 0.2 + least / 3, along = area * reference.sum; // as following() has it
  const double wanted = cosine * reference.count;
  const bool follows = reference.count > 0 && cosine > 0.11 && along > 0 && // then is not folded
                       along * along > margin * wanted * wanted * (area * area);
  const double most_warp = 0.5 + (1 - least) / 1.4; // as flatness() has it
  if(follows && least < 1 && is_surely_flat(p, area, most_warp))
    return !is_jacobian_below(p, least);
  return Adaptation_state::face_quality(p, reference) >= least;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHANGED_FACE_QUALITY_H
