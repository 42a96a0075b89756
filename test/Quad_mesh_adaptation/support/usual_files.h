// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_TEST_USUAL_FILES_H
#define QUAD_MESH_ADAPTATION_TEST_USUAL_FILES_H

#include "usual_mesh.h"

#include <CGAL/Quad_mesh_adaptation/IO/read_quad_mesh.h>

#include <string>

// Reading of the usual mesh, see usual_mesh.h.
namespace CGAL {
namespace Quad_mesh_adaptation {

QUAD_MESH_TEST_INSTANCE Read_result read_quad_mesh(const std::string&, usual_mesh::Mesh&);

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // QUAD_MESH_ADAPTATION_TEST_USUAL_FILES_H
