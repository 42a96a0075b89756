// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_KNOWN_FACES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_KNOWN_FACES_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>

#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Faces of a mesh as they were once, to tell which of them are the same later on.
class Known_faces
{
public:
  bool is_empty() const { return faces_.empty(); }

  // Those for which `is_wanted` is true.
  template <typename Is_wanted>
  void remember(const Adaptation_state& s, const Is_wanted& is_wanted)
  {
    faces_.clear();
    for(Index f : s.mesh.faces())
      if(is_wanted(f)) faces_.push_back({ f, s.mesh.quad(f), s.corners(f) });
  }

  // All that are others, have another shape or are not known.
  std::vector<Index> changed(const Adaptation_state& s) const
  {
    std::vector<Index> list;
    auto old = faces_.begin();
    for(Index f = 0; f < s.mesh.face_end(); ++f) {
      while(old != faces_.end() && old->number < f) ++old;
      const bool is_known = old != faces_.end() && old->number == f;
      if(s.mesh.is_face(f) && !(is_known && is_unchanged(s, *old))) list.push_back(f);
    }
    return list;
  }

private:
  struct Face
  {
    Index number;
    Quad quad;
    Corners corners;
  };

  // Smoothing goes on all the time, so that small moves are everywhere.
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

  std::vector<Face> faces_; // in order; of a mesh that was thinned out few numbers are in use
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_KNOWN_FACES_H
