// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_PARAMETERS_H
#define CGAL_QUAD_MESH_ADAPTATION_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <cstddef>
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

/// How much time to spend on a better mesh.
enum class Effort
{
  full, ///< the default: where a small or medium mesh does not come out well, other ways are tried
  quick ///< one way only
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
enum effort_t
{
  effort_tag
};
enum reference_surface_t
{
  reference_surface_tag
};
enum concurrency_t
{
  concurrency_tag
};
enum symmetry_t
{
  symmetry_tag
};
enum smooth_reference_t
{
  smooth_reference_tag
};
enum projector_t
{
  projector_tag
};
enum curve_projector_t
{
  curve_projector_tag
};
enum max_distance_t
{
  max_distance_tag
};
enum edge_is_frozen_t
{
  edge_is_frozen_tag
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

/// How much time the default schedule spends; default `Effort::full`.  With `Effort::quick` it does
/// not look for other ways, neither for the whole mesh nor about single faces that are poor or far
/// too small; what is guaranteed is the same.
inline Named_function_parameters<Effort, effort_t> effort(Effort e)
{
  return Named_function_parameters<Effort, effort_t>(e);
}
template <typename NP>
Named_function_parameters<Effort, effort_t, NP> effort(Effort e, const NP& np)
{
  return Named_function_parameters<Effort, effort_t, NP>(e, np);
}

/// Passes of refinement at most, in each way that is tried, unless `number_of_iterations()` says
/// otherwise.
constexpr std::size_t default_number_of_iterations = 40;

/// Degrees, see `feature_angle()`.
constexpr double default_feature_angle = 50;

/// Angle in degrees at and above which the turn of the surface across an edge makes that edge a
/// feature curve, and the turn of a curve at a vertex makes that vertex a corner; default
/// `default_feature_angle`; above 0 and up to 180, which detects nothing.
/// A detected curve with an end on the smooth surface counts only if it turns, on average, at least
/// twice as much as the rows of edges beside it.
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
/// `vertex_point` map) to stay on.  Its border curves replace those of the input, and so do its
/// creases (edges at or above `feature_angle()`) where a feature curve of the input runs along them
/// within half an edge; corners move to the ends of those curves.  Creases detected on the input
/// where the surface has none are no feature curves.  Default: the input.
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

/// With `true` the nodes stay on a smooth surface through the vertices of the input (or of the
/// `reference_surface()`) instead of on its facets, and on smooth curves instead of polylines:
/// refining a coarse mesh makes it rounder.  Vertices, corners, flat parts and straight edges stay
/// as they are, feature curves stay sharp.  Where a mesh samples a smooth surface at distances h
/// below its radii of curvature, the error falls with h^4 inside and h^3 near curves; where facets
/// turn by more than about 60 degrees over an edge that is no feature, they are kept.  Default:
/// `false`.
inline Named_function_parameters<bool, smooth_reference_t> smooth_reference(bool smooth)
{
  return Named_function_parameters<bool, smooth_reference_t>(smooth);
}
template <typename NP>
Named_function_parameters<bool, smooth_reference_t, NP> smooth_reference(bool smooth, const NP& np)
{
  return Named_function_parameters<bool, smooth_reference_t, NP>(smooth, np);
}

/// The surface to stay on as a function `f(p)`: for a point on the input (or on the
/// `reference_surface()`) the point of the true surface that belongs to it, as `Point_3` or as
/// `std::pair<Point_3, Vector_3>` with the normal there, of any length and either sense.  `f` must
/// be continuous; the nearest point of an analytic or CAD surface is.  It is never asked for points
/// away from the facets, so that the nearest point is on the right side of a thin wall as long as
/// the input itself is.  Corners and feature curves do not follow `f`, see `curve_projector()`.
/// What `f` throws passes through, the mesh unchanged.  Default: none.
template <typename Projector>
Named_function_parameters<Projector, projector_t> projector(const Projector& f)
{
  return Named_function_parameters<Projector, projector_t>(f);
}
template <typename Projector, typename NP>
Named_function_parameters<Projector, projector_t, NP> projector(const Projector& f, const NP& np)
{
  return Named_function_parameters<Projector, projector_t, NP>(f, np);
}

/// The same for feature curves and borders: `f(p)` is the point of the true curve that belongs to a
/// point `p` of an input's feature curve.  Corners stay.  Default: none, nodes stay on the
/// polylines.
template <typename Projector>
Named_function_parameters<Projector, curve_projector_t> curve_projector(const Projector& f)
{
  return Named_function_parameters<Projector, curve_projector_t>(f);
}
template <typename Projector, typename NP>
Named_function_parameters<Projector, curve_projector_t, NP> curve_projector(const Projector& f,
                                                                            const NP& np)
{
  return Named_function_parameters<Projector, curve_projector_t, NP>(f, np);
}

/// How far faces may be from the reference surface and its curves, and these from the faces.  Sizes
/// are lowered where the curvature asks for it, and grow from there by at most 0.3 per unit of
/// length; faces found too far in the end are split.  The report compares with the sizes given, as
/// ever, so that its efficiency falls with the bound.  What stays too far, on references that are
/// rough or do not fit the curves, is listed in `faces_too_far`.  Where the bound is below what the
/// flat facets of the reference are off the smooth surface that they stand for, the number of faces
/// grows as its inverse square: a finer reference, or `smooth_reference()`, needs far fewer.
/// Default: no bound.
inline Named_function_parameters<double, max_distance_t> max_distance(double d)
{
  return Named_function_parameters<double, max_distance_t>(d);
}
template <typename NP>
Named_function_parameters<double, max_distance_t, NP> max_distance(double d, const NP& np)
{
  return Named_function_parameters<double, max_distance_t, NP>(d, np);
}

/// Edges that stay as they are, with both their ends: neither moved, nor split, nor merged with
/// others, also on the border.  A model of `ReadablePropertyMap` with the `edge_descriptor` as key
/// and `bool` as value.  Beside an edge more than 1.8 times as long as asked faces are as large as
/// a good shape requires: 0.7 of its length on average, and from there their size falls by 0.75 per
/// unit of length at most.  The report names those that are larger than asked.  Default: none.
template <typename EdgeFrozenMap>
Named_function_parameters<EdgeFrozenMap, edge_is_frozen_t>
edge_is_frozen_map(const EdgeFrozenMap& efm)
{
  return Named_function_parameters<EdgeFrozenMap, edge_is_frozen_t>(efm);
}
template <typename EdgeFrozenMap, typename NP>
Named_function_parameters<EdgeFrozenMap, edge_is_frozen_t, NP>
edge_is_frozen_map(const EdgeFrozenMap& efm, const NP& np)
{
  return Named_function_parameters<EdgeFrozenMap, edge_is_frozen_t, NP>(efm, np);
}

/// `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag` to work with the threads of TBB; the
/// former needs it.  The result is, to the last bit, that of one thread, for any number of threads.
/// Sizing fields and projectors are then asked by several threads at the same time; maps, visitors
/// and callbacks are not.  How many threads there are is set in TBB (`tbb::global_control`).
/// Default: `CGAL::Sequential_tag`.
template <typename Concurrency>
Named_function_parameters<Concurrency, concurrency_t> concurrency(Concurrency tag)
{
  return Named_function_parameters<Concurrency, concurrency_t>(tag);
}
template <typename Concurrency, typename NP>
Named_function_parameters<Concurrency, concurrency_t, NP> concurrency(Concurrency tag, const NP& np)
{
  return Named_function_parameters<Concurrency, concurrency_t, NP>(tag, np);
}

/// Whether `adapt_quad_mesh()` with the default schedule, `refine()` and `clean_up()`
/// keep mirror symmetry; default `true`.
///
/// Looked for are planes in which vertices (to 1e-9 of the diameter), faces, features, constraints,
/// patches and sizes (to 1e-9 of the size, at vertices, middles of edges and centres of faces) are
/// mirror images of themselves, and that cut no face.  Up to three of them, at right angles to each
/// other, are kept: one part is adapted, the others are its images, which also saves their time.
/// A new node is then the exact reflection of its partner (up to rounding if the plane is not
/// perpendicular to an axis), nodes on a plane are on it, and a vertex that did not move keeps its
/// point, as symmetric as the input had it.
///
/// A plane is given up if the images do not make a valid mesh, or if the sizes differ by more than
/// 1e-6 on what comes out.  Where a part would have less than some 250 faces, fewer planes and none
/// are tried as well, and planes are kept only if they cost no more than six of a hundred faces.
/// Not kept: planes that cut faces, rotations, and anything with `smooth_reference()`,
/// `projector()`, `curve_projector()`, `max_distance()` or a `reference_surface()`, unless that is
/// the same flat surface as the input.
inline Named_function_parameters<bool, symmetry_t> symmetry(bool keep)
{
  return Named_function_parameters<bool, symmetry_t>(keep);
}
template <typename NP>
Named_function_parameters<bool, symmetry_t, NP> symmetry(bool keep, const NP& np)
{
  return Named_function_parameters<bool, symmetry_t, NP>(keep, np);
}

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_PARAMETERS_H
