// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_REFINE_H
#define CGAL_QUAD_MESH_ADAPTATION_REFINE_H

#include <CGAL/Quad_mesh_adaptation/internal/core_calls.h>
#include <CGAL/Quad_mesh_adaptation/internal/run_on_mesh.h>

namespace CGAL {
namespace Quad_mesh_adaptation {

/*!
halves edges that are too long, with templates that keep the mesh conforming, and smooths with
respect to the size after every pass; no clean-up, no coarsening.  It goes on until no
edge asks for a split, but for `number_of_iterations(n)` passes at most, by default
`default_number_of_iterations`.  Parity is solved for the whole
mesh as a minimum-weight T-join.  Edges that must not change are never split, and then a solution
always exists; what stays larger than asked because of them is listed in the report.
Where all faces are well above their size, nothing is frozen and the size grows slowly, the sizes
are met at twice to many times their scale first, and all faces are then cut in four as often as is
left to do; each time counts as a pass.

All else, the parameters, refusals, guarantees and the report, is as in `adapt_quad_mesh()`: the
mesh is valid after the call, and unchanged where it is refused or cancelled.
*/
template <typename SizingField, typename QuadMesh,
          typename NamedParameters = parameters::Default_named_parameters>
Adaptation_report refine(const SizingField& sizing, QuadMesh& mesh,
                         const NamedParameters& np = parameters::default_values())
{
  return internal::run_on_mesh(
      faces(mesh), false, sizing, mesh, np, internal::Call_kind{ false, false, true },
      [](internal::Adaptation_state& s, const internal::Prepared_run& asked) {
        internal::run_refinement(s, asked.iterations_or(default_number_of_iterations));
      });
}

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_REFINE_H
