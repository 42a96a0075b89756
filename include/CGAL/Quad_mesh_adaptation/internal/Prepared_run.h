// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PREPARED_RUN_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PREPARED_RUN_H

#include <CGAL/Quad_mesh_adaptation/internal/Distance_bound.h>
#include <CGAL/Quad_mesh_adaptation/internal/Mirror_goal.h>
#include <CGAL/Quad_mesh_adaptation/internal/Schedule_ingredients.h>
#include <CGAL/Quad_mesh_adaptation/internal/check_feature_angle.h>
#include <CGAL/Quad_mesh_adaptation/internal/compiled_core.h>
#include <CGAL/Quad_mesh_adaptation/internal/core_calls.h>
#include <CGAL/Quad_mesh_adaptation/internal/decode_parameters.h>
#include <CGAL/Quad_mesh_adaptation/internal/judge_sizes.h>
#include <CGAL/Quad_mesh_adaptation/internal/mesh_import.h>
#include <CGAL/Quad_mesh_adaptation/parameters.h>

#include <cstddef>
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
    iterations = decode_iterations(np);
    ingredients = decode_ingredients(np);
    aim = decode_aim(np);
    s.size.scale_by(scale_of(aim));
    s.workers.use_threads(decode_concurrency(np));
    bound_distance(decode_max_distance(np));
  }

  void bound_distance(double allowed);

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

  // What a part that is mirrored must come to, if one may be; `ideal`: number of faces.
  std::optional<Mirror_goal> mirror_goal(bool keeps_symmetry, double ideal, bool is_foretold) const
  {
    if(!keeps_symmetry || bound->is_asked_for()) return std::nullopt;
    return Mirror_goal{ largest_allowed(aim), ideal, is_foretold };
  }

  std::size_t iterations_or(std::size_t usual) const { return iterations.value_or(usual); }

  Aim aim = Aim::not_larger;
  std::optional<std::size_t> iterations; // none: not given
  Schedule_ingredients ingredients;
  Adaptation_state s;
  Input_mesh in;
  std::optional<Triangle_soup> reference;
  Feature_options features;
  Geometry_options geometry;
  std::optional<Distance_bound> bound;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PREPARED_RUN_H
