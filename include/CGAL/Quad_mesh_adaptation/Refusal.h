// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_REFUSAL_H
#define CGAL_QUAD_MESH_ADAPTATION_REFUSAL_H

namespace CGAL {
namespace Quad_mesh_adaptation {

/// Why an input was refused.
enum class Refusal
{
  none,
  empty_mesh,
  not_all_quads,
  non_manifold,
  non_orientable,
  degenerate_face,
  non_finite_coordinate,
  invalid_size,
  invalid_parameter,
  unreadable_file,
  unwritable_file
};

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_REFUSAL_H
