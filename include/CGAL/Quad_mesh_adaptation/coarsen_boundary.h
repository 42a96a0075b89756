// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_COARSEN_BOUNDARY_H
#define CGAL_QUAD_MESH_ADAPTATION_COARSEN_BOUNDARY_H

#include <CGAL/Quad_mesh_adaptation/internal/core_calls.h>
#include <CGAL/Quad_mesh_adaptation/internal/run_on_mesh.h>

namespace CGAL {
namespace Quad_mesh_adaptation {

/*!
removes dual chords that end in boundary edges too short for their size, then smooths each coarsened
curve: step 2 of section 3.3 of Anderson, Benzley and Owen (2009).  Corners and the curves'
support are kept; a chord that crosses or touches itself, or whose removal would change the
topology, stays.  Complexity: a few scans of the half-edges and the chords removed.

As in the paper, and whatever `schedule()` says, a face is judged by the size at its centre alone,
and the status is `sizes_met` where all faces are within their size but for the paper's
tolerance, 3.5 % of them.

All else, the parameters, refusals, guarantees and the report, is as in `adapt_quad_mesh()`: the
mesh is valid after the call, and unchanged where it is refused or cancelled.
`number_of_iterations()` does not matter.
*/
template <typename SizingField, typename QuadMesh,
          typename NamedParameters = parameters::Default_named_parameters>
Adaptation_report coarsen_boundary(const SizingField& sizing, QuadMesh& mesh,
                                   const NamedParameters& np = parameters::default_values())
{
  return internal::run_on_mesh(faces(mesh), false, sizing, mesh, np,
                               internal::Call_kind{ true, false, false },
                               [](internal::Adaptation_state& s, const internal::Prepared_run&) {
                                 internal::run_boundary_coarsening(s);
                               });
}

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_COARSEN_BOUNDARY_H
