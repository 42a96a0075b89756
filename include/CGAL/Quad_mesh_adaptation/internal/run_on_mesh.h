// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_RUN_ON_MESH_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_RUN_ON_MESH_H

#include <CGAL/Quad_mesh_adaptation/Adaptation_report.h>
#include <CGAL/Quad_mesh_adaptation/Adaptation_visitor.h>
#include <CGAL/Quad_mesh_adaptation/internal/No_constraints.h>
#include <CGAL/Quad_mesh_adaptation/internal/Phase_clock.h>
#include <CGAL/Quad_mesh_adaptation/internal/build_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/measure.h>
#include <CGAL/Quad_mesh_adaptation/internal/mesh_export.h>
#include <CGAL/Quad_mesh_adaptation/internal/mesh_import.h>
#include <CGAL/Quad_mesh_adaptation/internal/size_guarantee.h>
#include <CGAL/Quad_mesh_adaptation/parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The caller's sizing, a number or a callable on points, as the core's function.
template <typename Point, typename SizingField>
Size_sampler make_sampler(const SizingField& sizing)
{
  if constexpr(std::is_arithmetic_v<SizingField>) {
    const double h = double(sizing);
    if(!(std::isfinite(h) && h > 0)) throw Bad_size{ Vec(0, 0, 0), h };
    return Size_sampler([h](const Vec&) { return h; }, h);
  } else {
    return Size_sampler(
        [&sizing](const Vec& p) { return CGAL::to_double(sizing(Point(p.x(), p.y(), p.z()))); }, 0);
  }
}

inline std::string describe(const Bad_size& e)
{
  std::ostringstream text;
  text << "the size at (" << e.where.x() << ", " << e.where.y() << ", " << e.where.z() << ") is "
       << e.value << ", not a positive finite number";
  return text.str();
}

// Plain values of all named parameters, decoded once.
template <typename QuadMesh, typename NamedParameters>
struct Decoded_parameters
{
  using Vpm = typename CGAL::GetVertexPointMap<QuadMesh, NamedParameters>::type;
  using Point = typename boost::property_traits<Vpm>::value_type;
  using Edge = typename boost::graph_traits<QuadMesh>::edge_descriptor;
  using Vertex = typename boost::graph_traits<QuadMesh>::vertex_descriptor;

  static Vpm vertex_point_map(QuadMesh& mesh, const NamedParameters& np)
  {
    return parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                        get_property_map(CGAL::vertex_point, mesh));
  }
  static auto edge_map(const NamedParameters& np)
  {
    return parameters::choose_parameter(
        parameters::get_parameter(np, internal_np::edge_is_constrained), No_constraints<Edge>());
  }
  static auto vertex_map(const NamedParameters& np)
  {
    return parameters::choose_parameter(
        parameters::get_parameter(np, internal_np::vertex_is_constrained),
        No_constraints<Vertex>());
  }
};

template <typename NamedParameters>
std::optional<Triangle_soup> decode_reference(const NamedParameters& np)
{
  if constexpr(CGAL::parameters::is_default_parameter<NamedParameters, reference_surface_t>::value)
    return std::nullopt;
  else
    return import_reference(parameters::get_parameter(np, reference_surface_tag).get());
}

template <typename T>
T& unwrap(T& t)
{
  return t;
}
template <typename T>
T& unwrap(std::reference_wrapper<T>& t)
{
  return t.get();
}

// Connects visitor and callback of the caller to the state.
template <typename NamedParameters>
void observe(const NamedParameters& np, Adaptation_state& s, Phase_clock& clock)
{
  auto given = parameters::choose_parameter(parameters::get_parameter(np, internal_np::visitor),
                                            Adaptation_visitor());
  auto visitor = std::make_shared<decltype(given)>(given);
  const std::function<bool(double)> callback = parameters::choose_parameter(
      parameters::get_parameter(np, internal_np::callback), std::function<bool(double)>());
  s.report_progress = [visitor, callback](double progress) {
    if(!unwrap(*visitor).go_further() || (callback && !callback(progress))) throw Cancelled();
  };
  s.start_phase = [visitor, &clock](const char* name, std::size_t iteration) {
    clock.start(name);
    unwrap(*visitor).start_phase(name, iteration);
  };
  s.end_phase = [visitor, &clock](const char* name, std::size_t faces) {
    clock.stop(name);
    unwrap(*visitor).end_phase(name, faces);
  };
}

inline std::vector<Triangle> corner_points(const Triangle_soup& soup)
{
  std::vector<Triangle> list;
  list.reserve(soup.triangles.size());
  for(const auto& t : soup.triangles)
    list.push_back({ soup.points[t[0]], soup.points[t[1]], soup.points[t[2]] });
  return list;
}

inline Mesh_measures measure_state(const Adaptation_state& s,
                                   const std::optional<Triangle_soup>& reference)
{
  std::vector<Vec> points(s.mesh.vertex_end(), Vec(0, 0, 0));
  std::vector<Quad> quads;
  double far = 0;
  for(Index v = 0; v < s.mesh.vertex_end(); ++v) {
    if(!s.mesh.is_vertex(v)) continue;
    points[v] = s.mesh.point(v);
    far = (std::max)(far, s.surface.distance_to(points[v]));
  }
  for(Index f = 0; f < s.mesh.face_end(); ++f)
    if(s.mesh.is_face(f)) quads.push_back(s.mesh.quad(f));
  const Size_function size = [&s](const Vec& p) { return s.size.at(p); };
  Mesh_measures m;
  if(reference) {
    const std::vector<Triangle> triangles = corner_points(*reference);
    m = measure(points, quads, size, &triangles);
  } else {
    m = measure(points, quads, size);
  }
  m.max_distance_to_reference = far;
  return m;
}

// How the sizes came out, for status and message.
inline void judge_sizes(Adaptation_report& r, bool paper)
{
  const Size_ratio_table& t = paper ? r.after.size_ratio : r.after.strict_size_ratio;
  const std::size_t large = t.total() - t.not_larger();
  // the paper calls refinement sufficient below 3 % of low-refine and 0.5 % of high-refine faces
  const bool met = paper ? large <= std::size_t(0.03 * double(t.total())) : large == 0;
  if(met || !r.message.empty()) {
    if(!met) r.status = Adaptation_status::sizes_not_met;
    return;
  }
  r.status = Adaptation_status::sizes_not_met;
  r.message = std::to_string(large) + " of " + std::to_string(t.total()) +
              " faces are larger than asked, the largest " + std::to_string(t.max) +
              " times its size";
}

template <typename NamedParameters>
bool is_paper_schedule(const NamedParameters& np)
{
  return parameters::choose_parameter(parameters::get_parameter(np, schedule_tag),
                                      Schedule::progressive) == Schedule::paper;
}

// Numbers are 32 bit and memory is finite: better refused at once than after an hour.
inline void refuse_too_many(double faces)
{
  if(!(faces > 1e8)) return;
  std::ostringstream text;
  text << "the sizes ask for about " << faces << " faces, more than the limit of 1e8";
  throw Refused{ Refusal::invalid_size, text.str(), -1, -1 };
}

template <typename Vertex, typename QuadMesh>
long position_of(const Vertex& wanted, const QuadMesh& mesh)
{
  long position = 0;
  for(const auto& v : vertices(mesh)) {
    if(v == wanted) return position;
    ++position;
  }
  return -1;
}

// Where the faces of the state stand in the iteration over the caller's mesh.
template <typename Export, typename QuadMesh>
std::vector<std::size_t> positions_of(const std::vector<Index>& faces_of_state,
                                      const Export& written, const QuadMesh& mesh)
{
  std::vector<std::size_t> list;
  if(faces_of_state.empty()) return list;
  auto marked = get(CGAL::dynamic_face_property_t<bool>(), mesh);
  for(auto f : faces(mesh)) put(marked, f, false);
  for(Index f : faces_of_state) put(marked, written.face_of(f), true);
  std::size_t position = 0;
  for(auto f : faces(mesh)) {
    if(get(marked, f)) list.push_back(position);
    ++position;
  }
  return list;
}

// What every public function does around its algorithm: import and check, build the state, run
// `algorithm(state)`, measure, and only then write back.
template <typename FaceRange, typename SizingField, typename QuadMesh, typename NamedParameters,
          typename Algorithm>
Adaptation_report run_on_mesh(const FaceRange& faces, bool is_region, const SizingField& sizing,
                              QuadMesh& mesh, const NamedParameters& np, bool paper,
                              const Algorithm& algorithm)
{
  using Decoded = Decoded_parameters<QuadMesh, NamedParameters>;
  Adaptation_report report;
  Phase_clock clock;
  auto vpm = Decoded::vertex_point_map(mesh, np);
  auto ecm = Decoded::edge_map(np);
  auto vcm = Decoded::vertex_map(np);
  Mesh_descriptors<QuadMesh> descriptors;
  try {
    Adaptation_state s;
    s.size = make_sampler<typename Decoded::Point>(sizing);
    if(paper) s.size.sampling = Size_sampling::centre;
    Input_mesh in;
    Mesh_import<QuadMesh, decltype(vpm), decltype(ecm), decltype(vcm)> import(mesh, vpm, ecm, vcm);
    import(faces, is_region, in, descriptors);
    const std::optional<Triangle_soup> reference = decode_reference(np);
    Feature_options features;
    features.feature_angle = parameters::choose_parameter(
        parameters::get_parameter(np, feature_angle_tag), features.feature_angle);
    if(!(features.feature_angle > 0))
      throw Refused{ Refusal::invalid_parameter, "the feature angle must be positive", -1 };
    observe(np, s, clock);
    State_builder(in, features, s)(reference ? &*reference : nullptr);
    report.before = measure_state(s, reference);
    refuse_too_many(report.before.ideal_number_of_faces);
    algorithm(s, report);
    report.after = measure_state(s, reference);
    s.report_progress(1);
    report.iterations = s.iterations;
    for(const auto& o : s.operations) report.operations.push_back({ o.first, o.second });
    judge_sizes(report, paper);
    const std::vector<Index> large = faces_too_large(s);
    Mesh_export<QuadMesh, decltype(vpm), decltype(ecm)> write(mesh, vpm, ecm, in, descriptors, s);
    write(); // from here on nothing of the caller's is called any more but his maps
    report.faces_too_large = positions_of(large, write, mesh);
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
