// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_TEST_USUAL_MEASURES_H
#define QUAD_MESH_ADAPTATION_TEST_USUAL_MEASURES_H

#include "usual_mesh.h"

#include <CGAL/Quad_mesh_adaptation/measure_quad_mesh.h>

// measure_quad_mesh() for the usual types, see usual_mesh.h.
namespace CGAL {
namespace Quad_mesh_adaptation {

QUAD_MESH_TEST_INSTANCE Mesh_measures measure_quad_mesh(
    const usual_mesh::Mesh&, const double&, const parameters::Default_named_parameters&);
QUAD_MESH_TEST_INSTANCE Mesh_measures measure_quad_mesh(
    const usual_mesh::Mesh&, const usual_mesh::Size&, const parameters::Default_named_parameters&);

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // QUAD_MESH_ADAPTATION_TEST_USUAL_MEASURES_H
