// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TRIED_PLACES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TRIED_PLACES_H

#include <CGAL/Quad_mesh_adaptation/internal/Known_faces.h>

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
    faces_.remember(s, [](Index) { return true; });
    untried_ = s.stirred;
  }

  // What is searched for is different now.
  void forget() { *this = Tried_places(); }

  // Of the stirred nodes leaves only those that were not tried since they were stirred last, and
  // those of faces that are others or have another shape; all of them if nothing is remembered.
  void leave_changed(Adaptation_state& s) const
  {
    if(faces_.is_empty()) return;
    std::vector<char> changed = untried_;
    changed.resize(s.mesh.vertex_end(), 1);
    for(Index f : faces_.changed(s))
      for(Index v : s.mesh.quad(f)) changed[v] = 1;
    for(Index v = 0; v < Index(s.stirred.size()); ++v)
      s.stirred[v] = s.stirred[v] && (v >= Index(changed.size()) || changed[v]);
  }

private:
  Known_faces faces_;
  std::vector<char> untried_; // nodes
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TRIED_PLACES_H
