// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PREPARED_RUN_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PREPARED_RUN_H

#include <CGAL/Quad_mesh_adaptation/internal/Distance_bound.h>
#include <CGAL/Quad_mesh_adaptation/internal/adapt_mirrored.h>
#include <CGAL/Quad_mesh_adaptation/internal/check_feature_angle.h>
#include <CGAL/Quad_mesh_adaptation/internal/core_calls.h>
#include <CGAL/Quad_mesh_adaptation/internal/decode_parameters.h>
#include <CGAL/Quad_mesh_adaptation/internal/judge_sizes.h>
#include <CGAL/Quad_mesh_adaptation/internal/mesh_import.h>
#include <CGAL/Quad_mesh_adaptation/internal/same_flat_surface.h>
#include <CGAL/Quad_mesh_adaptation/parameters.h>

#include <optional>
#include <string>
#include <utility>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Faces adapted to be no larger than asked have size ratios about 0.955 on average; against sizes
// larger by this factor they come to lie around one.
constexpr double nearest_scale = 1.045;

inline double scale_of(Aim aim) { return aim == Aim::nearest ? nearest_scale : 1.; }

template <typename NamedParameters>
Feature_options decode_features(const NamedParameters& np)
{
  Feature_options features;
  features.feature_angle = parameters::choose_parameter(
      parameters::get_parameter(np, feature_angle_tag), features.feature_angle);
  const std::string complaint = check_feature_angle(features.feature_angle);
  if(!complaint.empty()) throw Refused{ Refusal::invalid_parameter, complaint };
  return features;
}

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
template <typename Algorithm>
void adapt_state(const Input_mesh& in, const Feature_options& features, Geometry_options geometry,
                 const std::optional<Mirror_goal>& mirror, const Algorithm& algorithm,
                 Adaptation_state& s)
{
  if(mirror && geometry.reference) leave_idle_reference(in, features, geometry, s);
  const auto build = [&](const Input_mesh& input, Adaptation_state& state) {
    build_state(input, features, geometry, state);
  };
  if(!mirror || !geometry.is_flat_input() || !adapt_mirrored(in, *mirror, build, algorithm, s))
    algorithm(s);
}

// What a run works on: all that was asked for, decoded, and the state built of the mesh.
struct Prepared_run
{
  Prepared_run() = default;
  Prepared_run(const Prepared_run&) = delete; // its parts refer to each other
  Prepared_run& operator=(const Prepared_run&) = delete;

  // Sizes and limits; what is sampled is `s.size` at this time.
  template <typename NamedParameters>
  void decode_limits(const NamedParameters& np)
  {
    aim = decode_aim(np);
    s.size.scale_by(scale_of(aim));
    s.workers.use_threads(decode_concurrency(np));
    bound.emplace(s, decode_max_distance(np));
  }

  // Once the mesh has been imported.
  template <typename Point, typename NamedParameters>
  void build(const NamedParameters& np)
  {
    reference = decode_reference(np);
    features = decode_features(np);
    geometry = decode_geometry<Point>(np);
    geometry.reference = reference ? &*reference : nullptr;
    build_state(in, features, geometry, s);
  }

  // What a part that is mirrored must come to; `ideal`: number of faces.
  template <typename NamedParameters>
  std::optional<Mirror_goal> mirror_goal(const NamedParameters& np, double ideal,
                                         bool is_foretold) const
  {
    if(!decode_symmetry(np) || bound->is_asked_for()) return std::nullopt;
    return Mirror_goal{ largest_allowed(aim), ideal, is_foretold };
  }

  Aim aim = Aim::not_larger;
  Adaptation_state s;
  Input_mesh in;
  std::optional<Triangle_soup> reference;
  Feature_options features;
  Geometry_options geometry;
  std::optional<Distance_bound> bound;
};

// Adapts as adapt_state() does, and keeps the result within its bound.
template <typename Algorithm>
void adapt_within_bound(Prepared_run& run, const std::optional<Mirror_goal>& mirror,
                        const Algorithm& algorithm)
{
  adapt_state(run.in, run.features, run.geometry, mirror, algorithm, run.s);
  keep_within_distance(run.s);
  run.bound->lift();
  keep_sizes_within_distance(run.s);
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PREPARED_RUN_H
