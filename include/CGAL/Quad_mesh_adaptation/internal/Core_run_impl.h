// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CORE_RUN_IMPL_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CORE_RUN_IMPL_H

#include <CGAL/Quad_mesh_adaptation/Mesh_measures.h>
#include <CGAL/Quad_mesh_adaptation/internal/Core_run.h>
#include <CGAL/Quad_mesh_adaptation/internal/Prepared_run.h>
#include <CGAL/Quad_mesh_adaptation/internal/adapt_within_bound.h>
#include <CGAL/Quad_mesh_adaptation/internal/advise_on_reference.h>
#include <CGAL/Quad_mesh_adaptation/internal/advise_on_result.h>
#include <CGAL/Quad_mesh_adaptation/internal/advise_on_stray_creases.h>
#include <CGAL/Quad_mesh_adaptation/internal/judge_sizes.h>
#include <CGAL/Quad_mesh_adaptation/internal/measure_size_growth.h>
#include <CGAL/Quad_mesh_adaptation/internal/measure_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/number_text.h>
#include <CGAL/Quad_mesh_adaptation/most_rehearsed_faces.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Numbers are 32 bit and memory is finite: better refused at once than after an hour.
inline void refuse_too_many(double faces, const std::string& who = "the sizes ask")
{
  if(!(faces > 1e8)) return;
  throw Refused{ Refusal::invalid_size,
                 who + " for about " + rounded_text(faces) + " faces, more than the limit of 1e8" };
}

// Tells the caller where the sizes grow faster than quads can follow.
inline void advise_on_sizes(const Input_mesh& in, const Adaptation_state& s, bool fits_mostly,
                            Adaptation_report& report)
{
  if(s.size.is_constant()) return;
  report.size_growth =
      measure_size_growth(in.points, in.quads, [&s](const Vec& p) { return s.size.unscaled(p); },
                          { &s.mesh, s.size.scale() == 1, fits_mostly });
  const std::string text = advice_on(report.size_growth);
  if(!text.empty()) report.advice.push_back(text);
}

// Most results have none, as is known when they have been measured.
inline std::vector<Poor_face> poor_faces_of(const Adaptation_state& s, const Mesh_measures& result)
{
  constexpr double margin = 1e-6;
  if(result.min_scaled_jacobian > Poor_face::floor + margin) return {};
  return poor_faces(s, Poor_face::floor);
}

// Faces of a plane that face the other way than most of it.
inline std::size_t number_turned_in_plane(const Adaptation_state& s)
{
  const Vec up = s.surface.normal(0);
  std::size_t turned = 0;
  for(Index f : s.mesh.faces())
    if(area_vector(s.corners(f)) * up < 0) ++turned;
  return turned;
}

// Tells of faces that lie upside down, since they could be meant to.
inline void advise_on_tangles(const Adaptation_state& s, Adaptation_report& report)
{
  const bool is_plane = s.surface.is_planar();
  const std::size_t turned = is_plane ? number_turned_in_plane(s) : s.turned_faces;
  if(turned == 0) return;
  const std::string faces = turned == 1 ? " face of the input lies" : " faces of the input lie";
  report.advice.push_back(
      std::to_string(turned) + faces + " the other way round than " +
      (is_plane ? "most in their plane" : "those around them") +
      ": that is taken for a tangle, not for a sheet "
      "that is folded over; mark the edges of the fold as constrained if it is one");
}

// Are few faces too large or far too small, so that most may stay as they are?
inline bool fits_mostly(const Size_ratio_table& ratios)
{
  constexpr std::size_t few = 10; // one face in so many
  const std::size_t fit = ratios.counts[1] + ratios.counts[2] + ratios.counts[3];
  return few * fit >= (few - 1) * ratios.total();
}

inline void count_features(const Adaptation_state& s, Adaptation_report& report)
{
  report.patches = s.given_patch.size();
  report.feature_curves = s.curves.size();
  for(Index v : s.mesh.vertices())
    if(s.mesh.vertex(v).carrier == Carrier::corner) ++report.corners;
}

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL void Prepared_run::bound_distance(double allowed)
{
  bound.emplace(s, allowed);
}

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL void Core_run::describe_input()
{
  count_features(s_, report_);
  advise_on_tangles(s_, report_);
  advise_on_stray_creases(s_, report_);
  if(run.reference) advise_on_reference(run.in, s_, report_);
}

// Sizes are bounded by what was asked for, and what must not change, from then on.
CGAL_QUAD_MESH_ADAPTATION_CORE_CALL void Core_run::measure_input()
{
  kept_.emplace(run.in);
  report_.before = measured_state(s_, run.reference, &*kept_);
  const bool is_small_change = fits_mostly(report_.before.strict_size_ratio);
  if(!is_small_change) kept_.reset();
  if(!is_small_change || !kind_.is_foretold || run.bound->is_asked_for()) s_.forget_ratios();
  advise_on_sizes(run.in, s_, is_small_change, report_);
  run.bound->start();
  frozen_.emplace(s_, run.in);
  if(frozen_->is_any()) report_.advice.push_back(frozen_->advice());
  ideal_ = report_.before.ideal_number_of_faces;
  refuse_too_many(ideal_);
  if(!run.bound->is_asked_for() && !frozen_->is_any()) return;
  ideal_ = measured_state(s_, run.reference).ideal_number_of_faces;
  refuse_too_many(ideal_, "the distance allowed asks");
}

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL void Core_run::work(bool keeps_symmetry,
                                                        const State_algorithm& algorithm)
{
  if(kind_.is_foretold) {
    report_.expected_number_of_faces =
        expected_faces(s_, ideal_, report_.size_growth.mean_square_slope, scale_of(run.aim));
    s_.foretell(report_.expected_number_of_faces);
  }
  const bool mirrors = kind_.keeps_symmetry && keeps_symmetry;
  adapt_within_bound(run, run.mirror_goal(mirrors, ideal_, kind_.is_foretold), algorithm);
  frozen_->put_sizes_back();
  s_.forget_work(); // its memory is needed to measure
}

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL void Core_run::measure_result()
{
  report_.after = measured_state(s_, run.reference, kept_ ? &*kept_ : nullptr);
  kept_.reset();
  s_.report_progress(1);
  report_.iterations = s_.iterations;
  for(const auto& o : s_.operation_counts()) report_.operations.push_back({ o.first, o.second });
}

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL void Core_run::judge()
{
  if(s_.size.scale() != 1) {
    s_.size.scale_by(1);
    s_.forget_sizes();
  }
  large_ = faces_too_large(s_, largest_allowed(run.aim));
  judge_sizes(report_, kind_.is_paper, run.aim, large_.size());
  advise_on_features(s_, report_);
  far_ = run.bound->faces_too_far(report_.after);
  judge_distances(report_, run.bound->allowed(), far_.size());
  poor_ = poor_faces_of(s_, report_.after);
  s_.forget_surface(); // its memory is needed to write
}

// The integral of 1/h^2 over the reference or, without one, over the mesh.
inline double ideal_faces(const Adaptation_state& s, const Input_mesh& in,
                          const std::optional<Triangle_soup>& reference)
{
  const Size_function size = [&s](const Vec& p) { return s.size.unscaled(p); };
  if(reference) return ideal_number_of_faces(corner_points(*reference), size);
  const auto corners_of = [&](std::size_t k) { return s.corners(Index(k)); }; // as they came
  std::vector<Integral_and_error> asked(in.quads.size());
  for(std::size_t k = 0; k < asked.size(); ++k) {
    const Corners p = corners_of(k);
    asked[k] = inverse_square_on(p, sizes_of_face(p, size), size);
  }
  return ideal_number_on(
      asked.size(), [&](std::size_t k) { return asked[k]; }, corners_of, size);
}

inline double mean_square_slope(const Adaptation_state& s, const Input_mesh& in)
{
  if(s.size.is_constant()) return 0;
  const Size_function size = [&s](const Vec& p) { return s.size.unscaled(p); };
  return measure_size_growth(in.points, in.quads, size).mean_square_slope;
}

// Few faces are tried and counted, unless that takes many to begin with.
inline bool is_rehearsed(double expected_faces, std::size_t given_faces)
{
  return expected_faces <= most_rehearsed_faces && double(given_faces) <= 20 * most_rehearsed_faces;
}

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL double foretold_faces(Prepared_run& run, bool keeps_symmetry)
{
  Adaptation_state& s = run.s;
  const double slope = mean_square_slope(s, run.in);
  run.bound->start();
  const Frozen_edges frozen(s, run.in);
  const double ideal = ideal_faces(s, run.in, run.reference);
  const double expected = expected_faces(s, ideal, slope, scale_of(run.aim));
  if(!is_rehearsed(expected, run.in.quads.size())) return expected;
  adapt_within_bound(run, run.mirror_goal(keeps_symmetry, ideal, true),
                     [&run](Adaptation_state& part) {
                       run_default_schedule(part, run.iterations_or(default_number_of_iterations),
                                            run.ingredients);
                     });
  return double(s.mesh.number_of_faces());
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CORE_RUN_IMPL_H
