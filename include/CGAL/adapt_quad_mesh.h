// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ADAPT_QUAD_MESH_H
#define CGAL_ADAPT_QUAD_MESH_H

#include <CGAL/Quad_mesh_adaptation/Adaptation_report.h>
#include <CGAL/Quad_mesh_adaptation/internal/core_calls.h>
#include <CGAL/Quad_mesh_adaptation/internal/run_on_mesh.h>
#include <CGAL/Quad_mesh_adaptation/parameters.h>

#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Quad_mesh_adaptation {

namespace internal {

template <typename FaceRange, typename SizingField, typename QuadMesh, typename NamedParameters>
Adaptation_report adapt_faces(const FaceRange& faces, bool is_region, const SizingField& sizing,
                              QuadMesh& mesh, const NamedParameters& np)
{
  const bool paper = is_paper_schedule(np);
  return run_on_mesh(faces, is_region, sizing, mesh, np, Call_kind{ paper, !paper, !paper },
                     [paper](Adaptation_state& s, const Prepared_run& asked) {
                       const std::size_t n = asked.iterations_or(default_number_of_iterations);
                       if(paper)
                         run_paper_schedule(s, n);
                       else
                         run_default_schedule(s, n, asked.ingredients);
                     });
}

} // namespace internal

/*!
adapts the quad mesh to a sizing field: refines where its faces are larger than asked, coarsens
where they are smaller, into a conforming mesh of quads only.

The default schedule aims at faces no larger than asked, with as few of them as it can.  With
`schedule(Schedule::paper)` the algorithm of Anderson, Benzley and Owen, "Automatic All
Quadrilateral Mesh Adaption through Refinement and Coarsening" (18th International Meshing
Roundtable, 2009), section 3.3, runs step by step.

\tparam SizingField a number, or a callable `FT operator()(const Point_3&) const`: the wanted
  length of edges at a point, in units of the coordinates.  It is called very often, also at points
  near but not on the surface, and must be positive and finite there.
\tparam QuadMesh a model of `MutableFaceGraph`, with an internal property map for
  `CGAL::vertex_point_t` or one given in `np`.
\tparam NamedParameters a sequence of named parameters.

\param np optional:
  - `vertex_point_map(vpm)`, a model of `ReadWritePropertyMap`;
  - `edge_is_constrained_map(ecm)`: these edges form feature curves; their nodes move along them
    and the edges are split or merged along them; new edges on them are marked in `ecm`;
  - `vertex_is_constrained_map(vcm)`: these vertices stay where they are;
  - `face_patch_map(fpm)`, a model of `ReadWritePropertyMap` with any comparable value: edges
    between different patches are feature curves, too, and new faces get the patch of those they
    replace;
  - `number_of_iterations(n)`: the most passes of refinement, in each of the ways to the sizes that
    are tried; default `default_number_of_iterations`.  The paper's schedule ends after 25;
  - `visitor(v)`, see `Adaptation_visitor`; `callback(f)`: `bool f(double)` is told the progress
    from 0 to 1 and cancels by returning `false`;
  - `schedule()`, `aim()`, `effort()`, `symmetry()`, `feature_angle()`, `edge_is_frozen_map()`,
    `reference_surface()`, `smooth_reference()`, `projector()`, `curve_projector()`,
    `max_distance()`, `concurrency()`: see parameters.h.

\returns a report; see `Adaptation_status` for how the call ended.  Faces, edges and vertices that
  did not have to change keep their descriptors; removed ones are marked as such in a
  `Surface_mesh` until `collect_garbage()`.

\pre All faces are quads; the mesh is manifold.  This is checked, also in Release; a mesh that
  cannot be adapted is refused in the report and stays as it is.  Self-intersections are not looked
  for.

Guarantees: the result is all-quad, conforming and manifold, with the Euler characteristic and
border loops of the input; corners keep their position, feature curves and border their support; if
the call is refused or cancelled, or `sizing`, `visitor` or `callback` throws, the mesh is
unchanged.  Not guaranteed: a minimum quality where the features themselves enforce a small angle.

Complexity: near linear in the number of faces of input and output, for bounded valences.
*/
template <typename SizingField, typename QuadMesh,
          typename NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<internal::is_named_parameters<NamedParameters>::value, int> = 0>
Adaptation_report adapt_quad_mesh(const SizingField& sizing, QuadMesh& mesh,
                                  const NamedParameters& np = parameters::default_values())
{
  return internal::adapt_faces(faces(mesh), false, sizing, mesh, np);
}

/*!
the same for a region: only the faces of `region` change.  The edges between the region and the
rest stay as they are, so that the mesh remains conforming; see `edge_is_frozen_map()` for what that
means for faces beside them.

\tparam FaceRange a model of `ConstRange` with value type `face_descriptor`.
*/
template <typename FaceRange, typename SizingField, typename QuadMesh,
          typename NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<!internal::is_named_parameters<QuadMesh>::value, int> = 0>
Adaptation_report adapt_quad_mesh(const FaceRange& region, const SizingField& sizing,
                                  QuadMesh& mesh,
                                  const NamedParameters& np = parameters::default_values())
{
  return internal::adapt_faces(region, true, sizing, mesh, np);
}

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_ADAPT_QUAD_MESH_H
