// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHANGED_FACE_QUALITY_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHANGED_FACE_QUALITY_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>

#include <algorithm>

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

// Quality of the face q with its nodes as node(v) has them.
template <typename Node_of>
double changed_face_quality(const Quad& q, const Node_of& node)
{
  Corners p;
  Facing reference;
  for(int i = 0; i < 4; ++i) {
    const Vertex_record& r = node(q[i]);
    p[i] = r.p;
    reference.add(r.normal);
  }
  return Adaptation_state::face_quality(p, reference);
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHANGED_FACE_QUALITY_H
