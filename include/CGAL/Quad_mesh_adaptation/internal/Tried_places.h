// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TRIED_PLACES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TRIED_PLACES_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// A mesh as it was after a search for operations.  Where it is the same later on, the same search
// would find nothing again.
class Tried_places
{
public:
  void remember(const Adaptation_state& s)
  {
    const Quad_complex& m = s.mesh;
    points_.resize(m.vertex_end());
    for(Index v = 0; v < m.vertex_end(); ++v) points_[v] = m.point(v);
    quads_.assign(m.face_end(), Quad{ -1, -1, -1, -1 });
    for(Index f = 0; f < m.face_end(); ++f)
      if(m.is_face(f)) quads_[f] = m.quad(f);
    untried_ = s.stirred;
  }

  // What is searched for is different now.
  void forget() { *this = Tried_places(); }

  // Of the stirred nodes leaves only those that were not tried since they were stirred last, and
  // those of faces that are others or have another shape; all of them if nothing is remembered.
  void leave_changed(Adaptation_state& s) const
  {
    if(quads_.empty()) return;
    std::vector<char> changed = untried_;
    changed.resize(s.mesh.vertex_end(), 1);
    for(Index f = 0; f < s.mesh.face_end(); ++f)
      if(s.mesh.is_face(f) && has_changed(s, f))
        for(Index v : s.mesh.quad(f)) changed[v] = 1;
    for(Index v = 0; v < Index(s.stirred.size()); ++v)
      s.stirred[v] = s.stirred[v] && (v >= Index(changed.size()) || changed[v]);
  }

private:
  // Smoothing goes on while operations are searched for, so that small moves are everywhere.
  bool has_changed(const Adaptation_state& s, Index f) const
  {
    constexpr double share = 0.05; // of an edge
    const Quad q = s.mesh.quad(f);
    if(f >= Index(quads_.size()) || quads_[f] != q) return true;
    const double enough = share * mean_edge_length(s.corners(f));
    return std::any_of(q.begin(), q.end(), [&](Index v) {
      return (s.mesh.point(v) - points_[v]).squared_length() > enough * enough;
    });
  }

  std::vector<Vec> points_;
  std::vector<Quad> quads_;   // -1 where there was no face
  std::vector<char> untried_; // nodes
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TRIED_PLACES_H
