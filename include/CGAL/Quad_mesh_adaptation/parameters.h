// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_PARAMETERS_H
#define CGAL_QUAD_MESH_ADAPTATION_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>

#include <functional>
#include <type_traits>

namespace CGAL {
namespace Quad_mesh_adaptation {

/// The order and aim of the phases.
enum class Schedule
{
  progressive, ///< the default: sizes approached by levels, one energy, size-aware smoothing, last
               ///< resort
  paper        ///< section 3.3 of Anderson, Benzley and Owen (2009), step by step
};

/// What to pursue between too large and too small.
enum class Aim
{
  not_larger, ///< the default: no face larger than asked, with as few faces as that takes
  nearest     ///< faces as near as possible to their size, for those who want the count right
};

// The package's own named parameters.  CGAL's chain members are generated inside CGAL, so each
// of these is a free function that starts a chain, or takes the rest of the chain as second
// argument: `schedule(Schedule::paper).number_of_iterations(9)`, `feature_angle(40, np)`.

enum schedule_t
{
  schedule_tag
};
enum feature_angle_t
{
  feature_angle_tag
};
enum aim_t
{
  aim_tag
};
enum reference_surface_t
{
  reference_surface_tag
};

/// Which schedule to run; default `Schedule::progressive`.
inline Named_function_parameters<Schedule, schedule_t> schedule(Schedule s)
{
  return Named_function_parameters<Schedule, schedule_t>(s);
}
template <typename NP>
Named_function_parameters<Schedule, schedule_t, NP> schedule(Schedule s, const NP& np)
{
  return Named_function_parameters<Schedule, schedule_t, NP>(s, np);
}

/// What the default schedule pursues; default `Aim::not_larger`.  With `Aim::nearest` size ratios
/// lie around one, and the sizes count as met when no face is more than sqrt(2) times its size.
inline Named_function_parameters<Aim, aim_t> aim(Aim a)
{
  return Named_function_parameters<Aim, aim_t>(a);
}
template <typename NP>
Named_function_parameters<Aim, aim_t, NP> aim(Aim a, const NP& np)
{
  return Named_function_parameters<Aim, aim_t, NP>(a, np);
}

/// Degrees, see `feature_angle()`.
constexpr double default_feature_angle = 50;

/// Angle in degrees at and above which the turn of the surface across an edge makes that edge a
/// feature curve, and the turn of a curve at a vertex makes that vertex a corner; default
/// `default_feature_angle`; 180 detects nothing.
inline Named_function_parameters<double, feature_angle_t> feature_angle(double degrees)
{
  return Named_function_parameters<double, feature_angle_t>(degrees);
}
template <typename NP>
Named_function_parameters<double, feature_angle_t, NP> feature_angle(double degrees, const NP& np)
{
  return Named_function_parameters<double, feature_angle_t, NP>(degrees, np);
}

/// A finer surface (any `FaceListGraph` of triangles, quads or polygons with the internal
/// `vertex_point` map) to stay on; its border curves replace those of the input.  Default: the
/// input.
template <typename SurfaceMesh>
Named_function_parameters<std::reference_wrapper<const SurfaceMesh>, reference_surface_t>
reference_surface(const SurfaceMesh& surface)
{
  return Named_function_parameters<std::reference_wrapper<const SurfaceMesh>, reference_surface_t>(
      std::cref(surface));
}
template <typename SurfaceMesh, typename NP>
Named_function_parameters<std::reference_wrapper<const SurfaceMesh>, reference_surface_t, NP>
reference_surface(const SurfaceMesh& surface, const NP& np)
{
  return Named_function_parameters<std::reference_wrapper<const SurfaceMesh>, reference_surface_t,
                                   NP>(std::cref(surface), np);
}

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_PARAMETERS_H
