// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_RUN_ON_MESH_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_RUN_ON_MESH_H

#include <CGAL/Quad_mesh_adaptation/Adaptation_report.h>
#include <CGAL/Quad_mesh_adaptation/internal/Distance_bound.h>
#include <CGAL/Quad_mesh_adaptation/internal/Frozen_edges.h>
#include <CGAL/Quad_mesh_adaptation/internal/Positions.h>
#include <CGAL/Quad_mesh_adaptation/internal/advise_on_reference.h>
#include <CGAL/Quad_mesh_adaptation/internal/advise_on_result.h>
#include <CGAL/Quad_mesh_adaptation/internal/check_feature_angle.h>
#include <CGAL/Quad_mesh_adaptation/internal/core_calls.h>
#include <CGAL/Quad_mesh_adaptation/internal/adapt_mirrored.h>
#include <CGAL/Quad_mesh_adaptation/internal/decode_parameters.h>
#include <CGAL/Quad_mesh_adaptation/internal/judge_sizes.h>
#include <CGAL/Quad_mesh_adaptation/internal/measure_size_growth.h>
#include <CGAL/Quad_mesh_adaptation/internal/mesh_export.h>
#include <CGAL/Quad_mesh_adaptation/internal/mesh_import.h>
#include <CGAL/Quad_mesh_adaptation/internal/same_flat_surface.h>
#include <CGAL/Quad_mesh_adaptation/parameters.h>

#include <cstddef>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Numbers are 32 bit and memory is finite: better refused at once than after an hour.
inline void refuse_too_many(double faces, const std::string& who = "the sizes ask")
{
  if(!(faces > 1e8)) return;
  std::ostringstream text;
  text << who << " for about " << faces << " faces, more than the limit of 1e8";
  throw Refused{ Refusal::invalid_size, text.str(), -1, -1 };
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
  for(Index f = 0; f < s.mesh.face_end(); ++f)
    if(s.mesh.is_face(f) && area_vector(s.corners(f)) * up < 0) ++turned;
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
  for(Index v = 0; v < s.mesh.vertex_end(); ++v)
    if(s.mesh.is_vertex(v) && s.mesh.vertex(v).carrier == Carrier::corner) ++report.corners;
}

// Faces are of the caller's patch that theirs descends from.
template <typename Export, typename Patch, typename FacePatchMap>
void put_patches(const Adaptation_state& s, const Export& written,
                 const std::vector<Patch>& patches, FacePatchMap fpm)
{
  for(Index f = 0; f < s.mesh.face_end(); ++f)
    if(s.mesh.is_face(f)) put(fpm, written.face_of(f), patches[s.given_patch[s.mesh.patch(f)]]);
}

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

// The same, and what keeps the result within its bound.
template <typename Algorithm>
void adapt_within_bound(const Input_mesh& in, const Feature_options& features,
                        const Geometry_options& geometry, const std::optional<Mirror_goal>& mirror,
                        const Algorithm& algorithm, Distance_bound& bound, Adaptation_state& s)
{
  adapt_state(in, features, geometry, mirror, algorithm, s);
  keep_within_distance(s);
  bound.lift();
  keep_sizes_within_distance(s);
}

// What the public functions differ in but for their algorithms.
struct Call_kind
{
  bool is_paper = false;       // sizes are those at the centres of faces
  bool is_foretold = false;    // the default schedule, whose number of faces can be foretold
  bool keeps_symmetry = false; // may run on a part of a symmetric input that is mirrored then
};

// What every public function does around its algorithm: import and check, build the state, run
// `algorithm(state)`, measure, and only then write back.
template <typename FaceRange, typename SizingField, typename QuadMesh, typename NamedParameters,
          typename Algorithm>
Adaptation_report run_on_mesh(const FaceRange& faces, bool is_region, const SizingField& sizing,
                              QuadMesh& mesh, const NamedParameters& np, const Call_kind& kind,
                              const Algorithm& algorithm)
{
  using Decoded = Decoded_parameters<QuadMesh, NamedParameters>;
  const Aim aim = decode_aim(np);
  Adaptation_report report;
  Phase_clock clock;
  auto vpm = Decoded::vertex_point_map(mesh, np);
  auto ecm = Decoded::edge_map(np);
  auto vcm = Decoded::vertex_map(np);
  auto efm = Decoded::frozen_map(np);
  auto fpm = Decoded::patch_map(np);
  Mesh_descriptors<QuadMesh> descriptors;
  try {
    Adaptation_state s;
    s.size = make_sampler<typename Decoded::Point>(sizing);
    if(kind.is_paper) s.size.sampling = Size_sampling::centre;
    s.size.scale_by(scale_of(aim));
    s.workers.use_threads(decode_concurrency(np));
    Distance_bound bound(s, decode_max_distance(np));
    Input_mesh in;
    Mesh_import<QuadMesh, decltype(vpm), decltype(ecm), decltype(vcm), decltype(efm), decltype(fpm)>
        import(mesh, vpm, ecm, vcm, efm, fpm);
    import(faces, is_region, in, descriptors);
    const std::optional<Triangle_soup> reference = decode_reference(np);
    const Feature_options features = decode_features(np);
    observe(np, s, clock);
    Geometry_options geometry = decode_geometry<typename Decoded::Point>(np);
    geometry.reference = reference ? &*reference : nullptr;
    build_state(in, features, geometry, s);
    count_features(s, report);
    advise_on_tangles(s, report);
    if(reference) advise_on_reference(in, s, report);
    std::optional<Figures_of_faces> kept(in);
    report.before = measured_state(s, reference, &*kept);
    const bool is_small_change = fits_mostly(report.before.strict_size_ratio);
    if(!is_small_change) kept.reset();
    if(!is_small_change || !kind.is_foretold || bound.is_asked_for()) s.forget_ratios();
    advise_on_sizes(in, s, is_small_change, report);
    bound.start();
    Frozen_edges frozen(s, in);
    if(frozen.is_any()) report.advice.push_back(frozen.advice());
    const double ideal = bound.is_asked_for() || frozen.is_any()
                             ? measured_state(s, reference).ideal_number_of_faces
                             : report.before.ideal_number_of_faces;
    refuse_too_many(report.before.ideal_number_of_faces);
    refuse_too_many(ideal, "the distance allowed asks");
    if(kind.is_foretold)
      report.expected_number_of_faces =
          expected_faces(s, ideal, report.size_growth.mean_square_slope, scale_of(aim));
    std::optional<Mirror_goal> mirror;
    if(kind.keeps_symmetry && decode_symmetry(np) && !bound.is_asked_for())
      mirror = Mirror_goal{ largest_allowed(aim), ideal, kind.is_foretold };
    adapt_within_bound(in, features, geometry, mirror, algorithm, bound, s);
    frozen.put_sizes_back();
    s.forget_work(); // its memory is needed to measure
    report.after = measured_state(s, reference, kept ? &*kept : nullptr);
    kept.reset();
    s.report_progress(1);
    report.iterations = s.iterations;
    for(const auto& o : s.operation_counts()) report.operations.push_back({ o.first, o.second });
    if(s.size.scale() != 1) {
      s.size.scale_by(1);
      s.forget_sizes();
    }
    const std::vector<Index> large = faces_too_large(s, largest_allowed(aim));
    judge_sizes(report, kind.is_paper, aim, large.size());
    advise_on_features(s, report);
    const std::vector<Index> far = bound.faces_too_far();
    judge_distances(report, bound.allowed(), far.size());
    const std::vector<Poor_face> poor = poor_faces_of(s, report.after);
    s.forget_surface(); // its memory is needed to write
    Mesh_export<QuadMesh, decltype(vpm), decltype(ecm)> write(mesh, vpm, ecm, in, descriptors, s);
    write(); // from here on nothing of the caller's is called any more but his maps
    put_patches(s, write, import.patches(), fpm);
    Positions<decltype(write), QuadMesh> positions(write, mesh);
    report.faces_too_large = positions.of_faces(large);
    report.faces_too_far = positions.of_faces(far);
    report.poor_faces = numbered(poor, positions);
  } catch(const Refused& e) {
    report.status = e.reason == Refusal::invalid_size ? Adaptation_status::sizes_refused
                                                      : Adaptation_status::input_refused;
    report.reason = e.reason;
    report.message = e.message;
    report.entity = e.entity;
    if(e.input_vertex >= 0) {
      report.entity = position_of(descriptors.vertices[e.input_vertex], mesh);
      report.message = "vertex " + std::to_string(report.entity) + " " + e.message;
    }
  } catch(const Bad_projection& e) {
    report.status = Adaptation_status::input_refused;
    report.reason = Refusal::invalid_parameter;
    report.message = describe(e);
  } catch(const Bad_size& e) {
    report.status = Adaptation_status::sizes_refused;
    report.reason = Refusal::invalid_size;
    report.message = describe(e);
  } catch(const Cancelled&) {
    report.status = Adaptation_status::cancelled;
    report.message = "cancelled by the caller";
  }
  report.times = clock.times();
  return report;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_RUN_ON_MESH_H
