// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_OWN_TRIANGLES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_OWN_TRIANGLES_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/nodes_around.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// For each face whether two triangles of the surface are its halves.
inline std::vector<char> faces_with_own_triangles(const Adaptation_state& s)
{
  std::vector<char> own(s.mesh.face_end(), 0);
  for(Index f : s.mesh.faces()) own[f] = s.surface.has_halves_of(f, s.corners(f));
  return own;
}

// Are all faces their own two triangles of a surface that is not plane?
inline bool is_all_on_own_triangles(const Adaptation_state& s)
{
  if(s.surface.is_planar()) return false;
  for(Index f : s.mesh.faces())
    if(!s.surface.has_halves_of(f, s.corners(f))) return false;
  return true;
}

// The faces without, and those within some rings of them; all, if there are none.
inline std::vector<char> faces_near_others(const Quad_complex& m, const std::vector<char>& own)
{
  constexpr int rings = 4;
  std::vector<Index> others;
  for(Index f : m.faces())
    if(!own[f]) others.push_back(f);
  std::vector<char> near(m.face_end(), others.empty());
  const std::vector<char> nodes = nodes_around(m, others, rings);
  for(Index f = 0; f < m.face_end() && !others.empty(); ++f) {
    if(!m.is_face(f)) continue;
    const Quad q = m.quad(f);
    near[f] = std::any_of(q.begin(), q.end(), [&](Index v) { return nodes[v]; });
  }
  return near;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_OWN_TRIANGLES_H
