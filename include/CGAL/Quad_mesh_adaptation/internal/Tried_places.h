// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TRIED_PLACES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TRIED_PLACES_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>

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
    faces_.clear();
    for(Index f = 0; f < s.mesh.face_end(); ++f)
      if(s.mesh.is_face(f)) faces_.push_back({ f, s.mesh.quad(f), s.corners(f) });
    untried_ = s.stirred;
  }

  // What is searched for is different now.
  void forget() { *this = Tried_places(); }

  // Of the stirred nodes leaves only those that were not tried since they were stirred last, and
  // those of faces that are others or have another shape; all of them if nothing is remembered.
  void leave_changed(Adaptation_state& s) const
  {
    if(faces_.empty()) return;
    std::vector<char> changed = untried_;
    changed.resize(s.mesh.vertex_end(), 1);
    auto old = faces_.begin();
    for(Index f = 0; f < s.mesh.face_end(); ++f) {
      while(old != faces_.end() && old->number < f) ++old;
      const bool is_known = old != faces_.end() && old->number == f;
      if(s.mesh.is_face(f) && !(is_known && is_unchanged(s, *old)))
        for(Index v : s.mesh.quad(f)) changed[v] = 1;
    }
    for(Index v = 0; v < Index(s.stirred.size()); ++v)
      s.stirred[v] = s.stirred[v] && (v >= Index(changed.size()) || changed[v]);
  }

private:
  struct Face
  {
    Index number;
    Quad quad;
    Corners corners;
  };

  // Smoothing goes on while operations are searched for, so that small moves are everywhere.
  static bool is_unchanged(const Adaptation_state& s, const Face& old)
  {
    constexpr double share = 0.05; // of an edge
    if(old.quad != s.mesh.quad(old.number)) return false;
    const Corners p = s.corners(old.number);
    const double enough = share * mean_edge_length(p);
    for(int i = 0; i < 4; ++i)
      if((p[i] - old.corners[i]).squared_length() > enough * enough) return false;
    return true;
  }

  std::vector<Face> faces_;   // in order; of a mesh that was thinned out few numbers are in use
  std::vector<char> untried_; // nodes
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TRIED_PLACES_H
