// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_KNOWN_STARTS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_KNOWN_STARTS_H

#include <CGAL/Quad_mesh_adaptation/internal/Mesh_keeper.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Several ways begin from the input alike: it is brought to the same larger sizes, which is a third
// of the work.  The meshes that that led to are kept for those that come later.
class Known_starts
{
public:
  // The mesh of s, which is the input, becomes the one that is known for the sizes and the order of
  // now, if any; that must not have taken as many passes as are allowed.
  bool restore(const Adaptation_state& s, std::size_t max_passes) const
  {
    for(const Start& x : starts_) {
      if(x.scale != s.size.scale() || x.order != s.order || x.passes >= max_passes) continue;
      Mesh_keeper(x.mesh).restore();
      return true;
    }
    return false;
  }

  // What the input has become after so many passes.
  void add(Adaptation_state& s, std::size_t passes, std::size_t max_passes)
  {
    constexpr Index many = 40000; // no other ways follow then
    if(passes < max_passes && s.mesh.number_of_faces() <= many)
      starts_.push_back({ s.size.scale(), s.order, passes, Mesh_keeper(s) });
  }

private:
  struct Start
  {
    double scale; // of the sizes
    int order;    // of walks
    std::size_t passes;
    Mesh_keeper mesh;
  };

  std::vector<Start> starts_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_KNOWN_STARTS_H
