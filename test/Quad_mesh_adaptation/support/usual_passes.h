// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_TEST_USUAL_PASSES_H
#define QUAD_MESH_ADAPTATION_TEST_USUAL_PASSES_H

#include "usual_mesh.h"

#include <CGAL/Quad_mesh_adaptation/clean_up.h>
#include <CGAL/Quad_mesh_adaptation/coarsen.h>
#include <CGAL/Quad_mesh_adaptation/refine.h>
#include <CGAL/Quad_mesh_adaptation/smooth.h>

// The single passes for the usual types, see usual_mesh.h.
#define QUAD_MESH_TEST_PASS(pass)                                                                  \
  QUAD_MESH_TEST_INSTANCE Adaptation_report pass(const double&, usual_mesh::Mesh&,                 \
                                                 const parameters::Default_named_parameters&);     \
  QUAD_MESH_TEST_INSTANCE Adaptation_report pass(const usual_mesh::Size&, usual_mesh::Mesh&,       \
                                                 const parameters::Default_named_parameters&);

namespace CGAL {
namespace Quad_mesh_adaptation {

QUAD_MESH_TEST_PASS(clean_up)
QUAD_MESH_TEST_PASS(coarsen)
QUAD_MESH_TEST_PASS(refine)
QUAD_MESH_TEST_PASS(smooth)

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // QUAD_MESH_ADAPTATION_TEST_USUAL_PASSES_H
