// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_TEST_USUAL_CALLS_H
#define QUAD_MESH_ADAPTATION_TEST_USUAL_CALLS_H

#include "usual_mesh.h"

#include <CGAL/adapt_quad_mesh.h>

// adapt_quad_mesh() for the usual types and one named parameter at most, see usual_mesh.h.
#define QUAD_MESH_TEST_ADAPT(Parameters)                                                           \
  QUAD_MESH_TEST_INSTANCE Adaptation_report adapt_quad_mesh(const double&, usual_mesh::Mesh&,      \
                                                            const Parameters&);                    \
  QUAD_MESH_TEST_INSTANCE Adaptation_report adapt_quad_mesh(const usual_mesh::Size&,               \
                                                            usual_mesh::Mesh&, const Parameters&);

namespace CGAL {
namespace Quad_mesh_adaptation {

QUAD_MESH_TEST_ADAPT(parameters::Default_named_parameters)
QUAD_MESH_TEST_ADAPT(decltype(parameters::number_of_iterations(0)))
QUAD_MESH_TEST_ADAPT(decltype(aim(Aim::nearest)))
QUAD_MESH_TEST_ADAPT(decltype(feature_angle(0.)))
QUAD_MESH_TEST_ADAPT(decltype(max_distance(0.)))
QUAD_MESH_TEST_ADAPT(decltype(schedule(Schedule::paper)))
QUAD_MESH_TEST_ADAPT(decltype(smooth_reference(true)))
QUAD_MESH_TEST_ADAPT(decltype(symmetry(true)))

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // QUAD_MESH_ADAPTATION_TEST_USUAL_CALLS_H
