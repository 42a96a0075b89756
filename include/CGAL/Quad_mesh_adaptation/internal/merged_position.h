// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MERGED_POSITION_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MERGED_POSITION_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The least cosine between the normals of the surface at node v and at its neighbours.
inline double flatness_about(const Adaptation_state& s, Index v)
{
  const Quad_complex& m = s.mesh;
  const Vec& n = m.vertex(v).normal;
  double least = 1;
  for(Index h : m.outgoing(v)) {
    const Vec& other = m.vertex(m.target(h)).normal;
    if(other * other > 0) least = (std::min)(least, n * other);
  }
  return least;
}

// Where nodes on the surface that become one come to lie, before that is placed on it: in their
// middle; but where the surface bends sharply, on the one where it does most, so that tips stay.
inline Vec merged_position(const Adaptation_state& s, const std::vector<Index>& nodes)
{
  constexpr double sharp = 0.93;
  Vec sum(0, 0, 0);
  double least = sharp;
  Index sharpest = -1;
  for(Index v : nodes) {
    sum = sum + s.mesh.point(v);
    const double flatness = s.surface.is_planar() ? 1. : flatness_about(s, v);
    if(flatness < least) {
      least = flatness;
      sharpest = v;
    }
  }
  return sharpest >= 0 ? s.mesh.point(sharpest) : 1. / double(nodes.size()) * sum;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MERGED_POSITION_H
