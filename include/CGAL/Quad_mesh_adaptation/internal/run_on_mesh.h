// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_RUN_ON_MESH_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_RUN_ON_MESH_H

#include <CGAL/Quad_mesh_adaptation/Adaptation_report.h>
#include <CGAL/Quad_mesh_adaptation/internal/Core_run.h>
#include <CGAL/Quad_mesh_adaptation/internal/Positions.h>
#include <CGAL/Quad_mesh_adaptation/internal/core_calls.h>
#include <CGAL/Quad_mesh_adaptation/internal/decode_parameters.h>
#include <CGAL/Quad_mesh_adaptation/internal/mesh_export.h>
#include <CGAL/Quad_mesh_adaptation/internal/mesh_import.h>
#include <CGAL/Quad_mesh_adaptation/parameters.h>

#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Faces are of the caller's patch that theirs descends from.
template <typename Export, typename Patch, typename FacePatchMap>
void put_patches(const Adaptation_state& s, const Export& written,
                 const std::vector<Patch>& patches, FacePatchMap fpm)
{
  for(Index f : s.mesh.faces())
    put(fpm, written.face_of(f), patches[s.given_patch[s.mesh.patch(f)]]);
}

// What a public function does to the state of a mesh, or of a part of it; `asked`: of the whole.
using Public_algorithm = std::function<void(Adaptation_state&, const Prepared_run& asked)>;

// What every public function does around its algorithm: import and check, build the state, run the
// algorithm, measure, and only then write back.
template <typename QuadMesh, typename NamedParameters>
class Run_on_mesh
{
public:
  Run_on_mesh(QuadMesh& mesh, const NamedParameters& np, const Call_kind& kind,
              Adaptation_report& report, Phase_clock& clock)
      : mesh_(mesh), np_(np), report_(report), clock_(clock),
        vpm_(Decoded::vertex_point_map(mesh, np)), ecm_(Decoded::edge_map(np)),
        fpm_(Decoded::patch_map(np)),
        import_(mesh, vpm_, ecm_, Decoded::vertex_map(np), Decoded::frozen_map(np), fpm_),
        core_(kind, report)
  {
  }

  template <typename FaceRange, typename SizingField>
  void operator()(const FaceRange& faces, bool is_region, const SizingField& sizing,
                  const Public_algorithm& algorithm)
  {
    prepare(faces, is_region, sizing);
    core_.measure_input();
    core_.work(decode_symmetry(np_), [&](Adaptation_state& s) { algorithm(s, core_.run); });
    core_.measure_result();
    core_.judge();
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

  void put_refusal(const Bad_projection& e)
  {
    report_.status = Adaptation_status::input_refused;
    report_.reason = Refusal::invalid_parameter;
    report_.message = describe(e);
    put_place(e.where);
  }

  void put_refusal(const Bad_size& e)
  {
    report_.status = Adaptation_status::sizes_refused;
    report_.reason = Refusal::invalid_size;
    report_.message = describe(e);
    if(e.where) put_place(*e.where);
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
    Prepared_run& run = core_.run;
    run.s.size = make_sampler<Point>(sizing);
    if(core_.kind().is_paper) run.s.size.sampling = Size_sampling::centre;
    run.decode_limits(np_);
    import_(faces, is_region, run.in, descriptors_);
    observe(np_, run.s, clock_);
    run.template build<Point>(np_);
    core_.describe_input();
  }

  void put_place(const Vec& p) { report_.place = std::array<double, 3>{ p.x(), p.y(), p.z() }; }

  void write_back()
  {
    const Adaptation_state& s = core_.run.s;
    Mesh_export<QuadMesh, typename Decoded::Vpm, Edge_map> write(mesh_, vpm_, ecm_, core_.run.in,
                                                                 descriptors_, core_.run.s);
    write(); // from here on nothing of the caller's is called any more but his maps
    put_patches(s, write, import_.patches(), fpm_);
    Positions<decltype(write), QuadMesh> positions(write, mesh_);
    report_.faces_too_large = positions.of_faces(core_.large_faces());
    report_.faces_too_far = positions.of_faces(core_.far_faces());
    report_.poor_faces = numbered(core_.poor_shapes(), positions);
  }

  QuadMesh& mesh_;
  const NamedParameters& np_;
  Adaptation_report& report_;
  Phase_clock& clock_;
  typename Decoded::Vpm vpm_;
  Edge_map ecm_;
  Patch_map fpm_;
  Import import_;
  Mesh_descriptors<QuadMesh> descriptors_;
  Core_run core_;
};

template <typename FaceRange, typename SizingField, typename QuadMesh, typename NamedParameters>
Adaptation_report run_on_mesh(const FaceRange& faces, bool is_region, const SizingField& sizing,
                              QuadMesh& mesh, const NamedParameters& np, const Call_kind& kind,
                              const Public_algorithm& algorithm)
{
  Adaptation_report report;
  Phase_clock clock;
  Run_on_mesh<QuadMesh, NamedParameters> run(mesh, np, kind, report, clock);
  try {
    run(faces, is_region, sizing, algorithm);
  } catch(const Refused& e) {
    run.put_refusal(e);
  } catch(const Bad_projection& e) {
    run.put_refusal(e);
  } catch(const Bad_size& e) {
    run.put_refusal(e);
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
