// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_COARSEN_H
#define CGAL_QUAD_MESH_ADAPTATION_COARSEN_H

#include <CGAL/Quad_mesh_adaptation/internal/core_calls.h>
#include <CGAL/Quad_mesh_adaptation/internal/run_on_mesh.h>

namespace CGAL {
namespace Quad_mesh_adaptation {

/*!
makes faces larger where they are smaller than asked, without refining anything.  By default fans of
faces are thinned, whole dual chords removed, nodes smoothed, and faces closed by local operations
while the energy falls, in turns; with `schedule(Schedule::paper)` rings of faces are collapsed
inside the regions of too small faces, with clean-up (step 3 of section 3.3 of Anderson, Benzley and
Owen, 2009).

All else, the parameters, refusals, guarantees and the report, is as in `adapt_quad_mesh()`: the
mesh is valid after the call, and unchanged where it is refused or cancelled.
`number_of_iterations()` does not matter.
*/
template <typename SizingField, typename QuadMesh,
          typename NamedParameters = parameters::Default_named_parameters>
Adaptation_report coarsen(const SizingField& sizing, QuadMesh& mesh,
                          const NamedParameters& np = parameters::default_values())
{
  const bool paper = internal::is_paper_schedule(np);
  return internal::run_on_mesh(
      faces(mesh), false, sizing, mesh, np, internal::Call_kind{ paper, false, false },
      [paper](internal::Adaptation_state& s, const internal::Prepared_run&) {
        internal::run_coarsening(s, paper);
      });
}

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_COARSEN_H
