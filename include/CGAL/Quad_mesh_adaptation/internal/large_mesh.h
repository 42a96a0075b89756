// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LARGE_MESH_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LARGE_MESH_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// From so many faces of the whole on, rows are taken out and put in quickly where that can be, else
// with care.
constexpr Index large_mesh = 5000;

// As many of the part that is worked on.
inline Index large_part(const Adaptation_state& s) { return large_mesh / Index(s.copies); }

inline bool is_large(const Adaptation_state& s) { return s.mesh.number_of_faces() > large_part(s); }

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LARGE_MESH_H
