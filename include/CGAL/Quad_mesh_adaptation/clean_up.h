// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_CLEAN_UP_H
#define CGAL_QUAD_MESH_ADAPTATION_CLEAN_UP_H

#include <CGAL/Quad_mesh_adaptation/internal/core_calls.h>
#include <CGAL/Quad_mesh_adaptation/internal/run_on_mesh.h>

namespace CGAL {
namespace Quad_mesh_adaptation {

/*!
improves the topology by local operations (face close, face open, edge swap, vertex rotation, their
border variants), each of which lowers one energy of count, size, shape and valence; valences above
five are removed where that is possible.  `number_of_iterations(n)` limits the passes over the
mesh; default 10.

All else, the parameters, refusals, guarantees and the report, is as in `adapt_quad_mesh()`: the
mesh is valid after the call, and unchanged where it is refused or cancelled.
*/
template <typename SizingField, typename QuadMesh,
          typename NamedParameters = parameters::Default_named_parameters>
Adaptation_report clean_up(const SizingField& sizing, QuadMesh& mesh,
                           const NamedParameters& np = parameters::default_values())
{
  return internal::run_on_mesh(
      faces(mesh), false, sizing, mesh, np, internal::Call_kind{ false, false, true },
      [](internal::Adaptation_state& s, const internal::Prepared_run& asked) {
        internal::run_clean_up(s, int(asked.iterations_or(10)));
      });
}

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_CLEAN_UP_H
