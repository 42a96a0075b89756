// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_STIR_WHERE_IRREGULAR_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_STIR_WHERE_IRREGULAR_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/nodes_around.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Where is there something to gain by operations that raise the energy at first?  Everywhere, but
// in a mesh of which only a part is worked on, only about irregular nodes and faces that do not
// have their size: the rest of the part has been halved and is as good as it was.  `large`: the
// size ratio from which on a face is too large.
inline void stir_where_irregular(Adaptation_state& s, double large = 1.02)
{
  constexpr int rings = 3;
  constexpr double small = 0.75;
  if(s.region.empty()) return s.stir_all();
  const auto is_irregular = [&](Index v) {
    const Vertex_record& r = s.mesh.vertex(v);
    return r.faces != r.ideal_faces;
  };
  std::vector<Index> list;
  for(Index f : s.mesh.faces()) {
    const Quad q = s.mesh.quad(f);
    if(!std::any_of(q.begin(), q.end(), [&](Index v) { return s.is_to_work_on(v); })) continue;
    const double ratio = s.size_ratio(f);
    if(ratio < small || ratio > large || std::any_of(q.begin(), q.end(), is_irregular))
      list.push_back(f);
  }
  s.stirred = nodes_around(s.mesh, list, rings);
  for(Index v = 0; v < s.mesh.vertex_end(); ++v)
    if(!s.is_to_work_on(v)) s.stirred[v] = 0;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_STIR_WHERE_IRREGULAR_H
