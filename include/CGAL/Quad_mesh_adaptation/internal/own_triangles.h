// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_OWN_TRIANGLES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_OWN_TRIANGLES_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/nodes_around.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Are two triangles of the surface the halves of face f with corners p, as they are of an input
// that is its own reference?
inline bool has_own_triangles(const Adaptation_state& s, Index f, const Corners& p)
{
  const auto& all = s.surface.triangles();
  if(s.surface.has_lift() || 2 * std::size_t(f) + 1 >= all.size()) return false;
  const std::array<Index, 3>&a = all[2 * f], &b = all[2 * f + 1];
  const std::vector<Vec>& at = s.surface.points();
  if(a[0] != b[0] || a[2] != b[1]) return false;
  const int i = at[a[0]] == p[0] ? 0 : 1;
  return at[a[0]] == p[i] && at[a[1]] == p[i + 1] && at[a[2]] == p[i + 2] &&
         at[b[2]] == p[(i + 3) & 3];
}

// For each face whether it has such triangles.
inline std::vector<char> faces_with_own_triangles(const Adaptation_state& s)
{
  std::vector<char> own(s.mesh.face_end(), 0);
  for(Index f = 0; f < s.mesh.face_end(); ++f)
    if(s.mesh.is_face(f)) own[f] = has_own_triangles(s, f, s.corners(f));
  return own;
}

// The faces without, and those within some rings of them; all, if there are none.
inline std::vector<char> faces_near_others(const Quad_complex& m, const std::vector<char>& own)
{
  constexpr int rings = 4;
  std::vector<Index> others;
  for(Index f = 0; f < m.face_end(); ++f)
    if(m.is_face(f) && !own[f]) others.push_back(f);
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
