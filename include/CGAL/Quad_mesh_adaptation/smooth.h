// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_SMOOTH_H
#define CGAL_QUAD_MESH_ADAPTATION_SMOOTH_H

#include <CGAL/Quad_mesh_adaptation/internal/core_calls.h>
#include <CGAL/Quad_mesh_adaptation/internal/run_on_mesh.h>

namespace CGAL {
namespace Quad_mesh_adaptation {

/*!
moves nodes, on the surface and along curves, to places where shapes and sizes of the faces around
are best; topology stays.  No corner gets worse than the worst around it was (or than a scaled
Jacobian of about 0.45).  `number_of_iterations(n)` is the number of sweeps; default 10.

All else, the parameters, refusals, guarantees and the report, is as in `adapt_quad_mesh()`: the
mesh is valid after the call, and unchanged where it is refused or cancelled.
*/
template <typename SizingField, typename QuadMesh,
          typename NamedParameters = parameters::Default_named_parameters>
Adaptation_report smooth(const SizingField& sizing, QuadMesh& mesh,
                         const NamedParameters& np = parameters::default_values())
{
  return internal::run_on_mesh(
      faces(mesh), false, sizing, mesh, np, internal::Call_kind(),
      [](internal::Adaptation_state& s, const internal::Prepared_run& asked) {
        internal::run_smoothing(s, int(asked.iterations_or(10)));
      });
}

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_SMOOTH_H
