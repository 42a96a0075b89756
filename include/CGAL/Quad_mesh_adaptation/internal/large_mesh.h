// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LARGE_MESH_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LARGE_MESH_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>

#include <algorithm>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// From so many faces of the whole on, rows are taken out and put in quickly where that can be, else
// with care.
constexpr Index large_mesh = 5000;

// As many of the part that is worked on.
inline Index large_part(const Adaptation_state& s) { return large_mesh / Index(s.copies); }

inline bool is_large(const Adaptation_state& s) { return s.mesh.number_of_faces() > large_part(s); }

// As long as it lives, moves of the nodes of a large mesh do not spread far: it has been smoothed
// everywhere, and what is left to gain by small moves is not worth a visit of all nodes.
class Short_smoothing
{
public:
  explicit Short_smoothing(Adaptation_state& s) : s_(s), fine_(s.smoothing.wake)
  {
    constexpr double coarse = 0.02;
    if(is_large(s)) s.smoothing.wake = (std::max)(fine_, coarse);
  }
  Short_smoothing(const Short_smoothing&) = delete;
  ~Short_smoothing() { s_.smoothing.wake = fine_; }

private:
  Adaptation_state& s_;
  double fine_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LARGE_MESH_H
