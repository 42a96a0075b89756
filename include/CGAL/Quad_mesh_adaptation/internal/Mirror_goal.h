// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MIRROR_GOAL_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MIRROR_GOAL_H

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// What is asked of a mesh made of images.
struct Mirror_goal
{
  double limit = 1;          // the largest size ratio allowed
  double ideal_faces = 0;    // what the sizes ask for
  bool counts_faults = true; // or is any valid outcome as good as another of as many faces?
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MIRROR_GOAL_H
