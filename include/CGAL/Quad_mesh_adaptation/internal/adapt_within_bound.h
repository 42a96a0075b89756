// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ADAPT_WITHIN_BOUND_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ADAPT_WITHIN_BOUND_H

#include <CGAL/Quad_mesh_adaptation/internal/Prepared_run.h>
#include <CGAL/Quad_mesh_adaptation/internal/adapt_mirrored.h>
#include <CGAL/Quad_mesh_adaptation/internal/core_calls.h>
#include <CGAL/Quad_mesh_adaptation/internal/same_flat_surface.h>

#include <optional>
#include <utility>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// A separate reference that is the same flat surface as the input is only measured against.
inline void leave_idle_reference(const Input_mesh& in, const Feature_options& features,
                                 Geometry_options& geometry, Adaptation_state& s)
{
  Geometry_options own = geometry;
  own.reference = nullptr;
  if(!own.is_flat_input() || !s.surface.is_planar()) return;
  Adaptation_state flat;
  observe_part(s, 1, flat);
  build_state(in, features, own, flat);
  if(!is_same_flat_surface(s, flat)) return;
  geometry = own;
  s = std::move(flat);
}

// Runs `algorithm(state)` on what was built of the input; where that may be and this is symmetric,
// on a part of it that is mirrored then.
inline void adapt_state(const Input_mesh& in, const Feature_options& features,
                        Geometry_options geometry, const std::optional<Mirror_goal>& mirror,
                        const State_algorithm& algorithm, Adaptation_state& s)
{
  if(mirror && geometry.reference) leave_idle_reference(in, features, geometry, s);
  const auto build = [&](const Input_mesh& input, Adaptation_state& state) {
    build_state(input, features, geometry, state);
  };
  if(!mirror || !geometry.is_flat_input() || !adapt_mirrored(in, *mirror, build, algorithm, s))
    algorithm(s);
}

// Adapts as adapt_state() does, and keeps the result within its bound.
inline void adapt_within_bound(Prepared_run& run, const std::optional<Mirror_goal>& mirror,
                               const State_algorithm& algorithm)
{
  adapt_state(run.in, run.features, run.geometry, mirror, algorithm, run.s);
  keep_within_distance(run.s);
  run.bound->lift();
  keep_sizes_within_distance(run.s);
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ADAPT_WITHIN_BOUND_H
