// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_RUN_ON_MESH_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_RUN_ON_MESH_H

#include <CGAL/Quad_mesh_adaptation/Adaptation_report.h>
#include <CGAL/Quad_mesh_adaptation/internal/Frozen_edges.h>
#include <CGAL/Quad_mesh_adaptation/internal/Positions.h>
#include <CGAL/Quad_mesh_adaptation/internal/Prepared_run.h>
#include <CGAL/Quad_mesh_adaptation/internal/advise_on_reference.h>
#include <CGAL/Quad_mesh_adaptation/internal/advise_on_result.h>
#include <CGAL/Quad_mesh_adaptation/internal/core_calls.h>
#include <CGAL/Quad_mesh_adaptation/internal/decode_parameters.h>
#include <CGAL/Quad_mesh_adaptation/internal/judge_sizes.h>
#include <CGAL/Quad_mesh_adaptation/internal/measure_size_growth.h>
#include <CGAL/Quad_mesh_adaptation/internal/mesh_export.h>
#include <CGAL/Quad_mesh_adaptation/internal/mesh_import.h>
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

// Faces are of the caller's patch that theirs descends from.
template <typename Export, typename Patch, typename FacePatchMap>
void put_patches(const Adaptation_state& s, const Export& written,
                 const std::vector<Patch>& patches, FacePatchMap fpm)
{
  for(Index f : s.mesh.faces())
    put(fpm, written.face_of(f), patches[s.given_patch[s.mesh.patch(f)]]);
}

// What the public functions differ in but for their algorithms.
struct Call_kind
{
  bool is_paper = false;       // sizes are those at the centres of faces
  bool is_foretold = false;    // the default schedule, whose number of faces can be foretold
  bool keeps_symmetry = false; // may run on a part of a symmetric input that is mirrored then
};

// What every public function does around its algorithm: import and check, build the state, run the
// algorithm, measure, and only then write back.
template <typename QuadMesh, typename NamedParameters>
class Run_on_mesh
{
public:
  Run_on_mesh(QuadMesh& mesh, const NamedParameters& np, const Call_kind& kind,
              Adaptation_report& report, Phase_clock& clock)
      : mesh_(mesh), np_(np), kind_(kind), report_(report), clock_(clock),
        vpm_(Decoded::vertex_point_map(mesh, np)), ecm_(Decoded::edge_map(np)),
        fpm_(Decoded::patch_map(np)),
        import_(mesh, vpm_, ecm_, Decoded::vertex_map(np), Decoded::frozen_map(np), fpm_)
  {
  }

  template <typename FaceRange, typename SizingField, typename Algorithm>
  void operator()(const FaceRange& faces, bool is_region, const SizingField& sizing,
                  const Algorithm& algorithm)
  {
    prepare(faces, is_region, sizing);
    measure_input();
    work(algorithm);
    measure_result();
    judge();
    write_back();
  }

  // Names the vertex of the caller's mesh where the core has refused one.
  void put_refusal(const Refused& e)
  {
    report_.status = e.reason == Refusal::invalid_size ? Adaptation_status::sizes_refused
                                                       : Adaptation_status::input_refused;
    report_.reason = e.reason;
    report_.message = e.message;
    report_.entity = e.entity;
    if(e.input_vertex < 0) return;
    report_.entity = position_of(descriptors_.vertices[e.input_vertex], mesh_);
    report_.message = "vertex " + std::to_string(report_.entity) + " " + e.message;
  }

private:
  using Decoded = Decoded_parameters<QuadMesh, NamedParameters>;
  using Point = typename Decoded::Point;
  using Edge_map = decltype(Decoded::edge_map(std::declval<const NamedParameters&>()));
  using Vertex_map = decltype(Decoded::vertex_map(std::declval<const NamedParameters&>()));
  using Frozen_map = decltype(Decoded::frozen_map(std::declval<const NamedParameters&>()));
  using Patch_map = decltype(Decoded::patch_map(std::declval<const NamedParameters&>()));
  using Import =
      Mesh_import<QuadMesh, typename Decoded::Vpm, Edge_map, Vertex_map, Frozen_map, Patch_map>;

  template <typename FaceRange, typename SizingField>
  void prepare(const FaceRange& faces, bool is_region, const SizingField& sizing)
  {
    s_.size = make_sampler<Point>(sizing);
    if(kind_.is_paper) s_.size.sampling = Size_sampling::centre;
    run_.decode_limits(np_);
    import_(faces, is_region, run_.in, descriptors_);
    observe(np_, s_, clock_);
    run_.template build<Point>(np_);
    count_features(s_, report_);
    advise_on_tangles(s_, report_);
    if(run_.reference) advise_on_reference(run_.in, s_, report_);
  }

  // Sizes are bounded by what was asked for, and what must not change, from then on.
  void measure_input()
  {
    kept_.emplace(run_.in);
    report_.before = measured_state(s_, run_.reference, &*kept_);
    const bool is_small_change = fits_mostly(report_.before.strict_size_ratio);
    if(!is_small_change) kept_.reset();
    if(!is_small_change || !kind_.is_foretold || run_.bound->is_asked_for()) s_.forget_ratios();
    advise_on_sizes(run_.in, s_, is_small_change, report_);
    run_.bound->start();
    frozen_.emplace(s_, run_.in);
    if(frozen_->is_any()) report_.advice.push_back(frozen_->advice());
    ideal_ = report_.before.ideal_number_of_faces;
    refuse_too_many(ideal_);
    if(!run_.bound->is_asked_for() && !frozen_->is_any()) return;
    ideal_ = measured_state(s_, run_.reference).ideal_number_of_faces;
    refuse_too_many(ideal_, "the distance allowed asks");
  }

  template <typename Algorithm>
  void work(const Algorithm& algorithm)
  {
    if(kind_.is_foretold)
      report_.expected_number_of_faces =
          expected_faces(s_, ideal_, report_.size_growth.mean_square_slope, scale_of(run_.aim));
    std::optional<Mirror_goal> mirror;
    if(kind_.keeps_symmetry) mirror = run_.mirror_goal(np_, ideal_, kind_.is_foretold);
    adapt_within_bound(run_, mirror, algorithm);
    frozen_->put_sizes_back();
    s_.forget_work(); // its memory is needed to measure
  }

  void measure_result()
  {
    report_.after = measured_state(s_, run_.reference, kept_ ? &*kept_ : nullptr);
    kept_.reset();
    s_.report_progress(1);
    report_.iterations = s_.iterations;
    for(const auto& o : s_.operation_counts()) report_.operations.push_back({ o.first, o.second });
  }

  void judge()
  {
    if(s_.size.scale() != 1) {
      s_.size.scale_by(1);
      s_.forget_sizes();
    }
    large_ = faces_too_large(s_, largest_allowed(run_.aim));
    judge_sizes(report_, kind_.is_paper, run_.aim, large_.size());
    advise_on_features(s_, report_);
    far_ = run_.bound->faces_too_far();
    judge_distances(report_, run_.bound->allowed(), far_.size());
    poor_ = poor_faces_of(s_, report_.after);
    s_.forget_surface(); // its memory is needed to write
  }

  void write_back()
  {
    Mesh_export<QuadMesh, typename Decoded::Vpm, Edge_map> write(mesh_, vpm_, ecm_, run_.in,
                                                                 descriptors_, s_);
    write(); // from here on nothing of the caller's is called any more but his maps
    put_patches(s_, write, import_.patches(), fpm_);
    Positions<decltype(write), QuadMesh> positions(write, mesh_);
    report_.faces_too_large = positions.of_faces(large_);
    report_.faces_too_far = positions.of_faces(far_);
    report_.poor_faces = numbered(poor_, positions);
  }

  QuadMesh& mesh_;
  const NamedParameters& np_;
  const Call_kind kind_;
  Adaptation_report& report_;
  Phase_clock& clock_;
  typename Decoded::Vpm vpm_;
  Edge_map ecm_;
  Patch_map fpm_;
  Import import_;
  Mesh_descriptors<QuadMesh> descriptors_;
  Prepared_run run_;
  Adaptation_state& s_ = run_.s;
  std::optional<Figures_of_faces> kept_; // of the input, while it may be left as it is mostly
  std::optional<Frozen_edges> frozen_;
  double ideal_ = 0; // number of faces
  std::vector<Index> large_, far_;
  std::vector<Poor_face> poor_;
};

template <typename FaceRange, typename SizingField, typename QuadMesh, typename NamedParameters,
          typename Algorithm>
Adaptation_report run_on_mesh(const FaceRange& faces, bool is_region, const SizingField& sizing,
                              QuadMesh& mesh, const NamedParameters& np, const Call_kind& kind,
                              const Algorithm& algorithm)
{
  Adaptation_report report;
  Phase_clock clock;
  Run_on_mesh<QuadMesh, NamedParameters> run(mesh, np, kind, report, clock);
  try {
    run(faces, is_region, sizing, algorithm);
  } catch(const Refused& e) {
    run.put_refusal(e);
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
