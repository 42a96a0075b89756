// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_MOST_REHEARSED_FACES_H
#define CGAL_QUAD_MESH_ADAPTATION_MOST_REHEARSED_FACES_H

namespace CGAL {
namespace Quad_mesh_adaptation {

/// The number of faces up to which `expected_number_of_faces()` tries what comes out.
constexpr double most_rehearsed_faces = 1000;

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_MOST_REHEARSED_FACES_H
