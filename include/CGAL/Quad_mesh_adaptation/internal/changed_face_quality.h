// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHANGED_FACE_QUALITY_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHANGED_FACE_QUALITY_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>

#include <limits>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Quality of the face q with its nodes as node(v) has them, less than any where it is longer than
// `limit` sizes.
template <typename Node_of>
double changed_face_quality(const Quad& q, const Node_of& node, double limit)
{
  Corners p;
  Facing reference;
  double sizes = 0;
  for(int i = 0; i < 4; ++i) {
    const Vertex_record& r = node(q[i]);
    p[i] = r.p;
    reference.add(r.normal);
    sizes += r.h;
  }
  return mean_edge_length(p) > 0.25 * limit * sizes ? -(std::numeric_limits<double>::infinity)()
                                                    : Adaptation_state::face_quality(p, reference);
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHANGED_FACE_QUALITY_H
