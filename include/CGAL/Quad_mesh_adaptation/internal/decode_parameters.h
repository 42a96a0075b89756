// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DECODE_PARAMETERS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DECODE_PARAMETERS_H

#include <CGAL/Quad_mesh_adaptation/Adaptation_visitor.h>
#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/No_constraints.h>
#include <CGAL/Quad_mesh_adaptation/internal/Phase_clock.h>
#include <CGAL/Quad_mesh_adaptation/internal/Schedule_ingredients.h>
#include <CGAL/Quad_mesh_adaptation/internal/size_at.h>
#include <CGAL/Quad_mesh_adaptation/internal/state_options.h>
#include <CGAL/Quad_mesh_adaptation/internal/mesh_import.h>
#include <CGAL/Quad_mesh_adaptation/internal/number_text.h>
#include <CGAL/Quad_mesh_adaptation/parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The caller's sizing, a number or a callable on points, as the core's function.
template <typename Point, typename SizingField>
Size_sampler make_sampler(const SizingField& sizing)
{
  double constant = 0; // is none
  if constexpr(std::is_arithmetic_v<SizingField>) {
    constant = double(sizing);
    if(!(std::isfinite(constant) && constant > 0)) throw Bad_size{ constant, {} };
  }
  return Size_sampler(size_function<Point>(sizing), constant);
}

inline std::string describe(const Bad_projection& e)
{
  return "the projector gave no finite point for " + point_text(e.where);
}

inline std::string describe(const Bad_size& e)
{
  return "the size" + (e.where ? " at " + point_text(*e.where) : std::string()) + " is " +
         number_text(e.value) + ", not a positive finite number";
}

// Plain values of all named parameters, decoded once.
template <typename QuadMesh, typename NamedParameters>
struct Decoded_parameters
{
  using Vpm = typename CGAL::GetVertexPointMap<QuadMesh, NamedParameters>::type;
  using Point = typename boost::property_traits<Vpm>::value_type;
  using Edge = typename boost::graph_traits<QuadMesh>::edge_descriptor;
  using Vertex = typename boost::graph_traits<QuadMesh>::vertex_descriptor;
  using Face = typename boost::graph_traits<QuadMesh>::face_descriptor;

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
  static auto frozen_map(const NamedParameters& np)
  {
    return parameters::choose_parameter(parameters::get_parameter(np, edge_is_frozen_tag),
                                        No_constraints<Edge>());
  }
  static auto patch_map(const NamedParameters& np)
  {
    return parameters::choose_parameter(parameters::get_parameter(np, internal_np::face_patch),
                                        One_patch<Face>());
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

// The caller's function from points to points, or to pairs of point and normal, as the core's.
template <typename Point, typename Function>
User_projector make_projector(Function f)
{
  return [f](const Vec& p) {
    const auto q = f(Point(p.x(), p.y(), p.z()));
    if constexpr(std::is_convertible_v<decltype(q), Point>)
      return Surface_point{ to_vec(Point(q)), Vec(0, 0, 0) };
    else
      return Surface_point{ to_vec(q.first), to_vec(q.second) };
  };
}

template <typename Point, typename NamedParameters>
Geometry_options decode_geometry(const NamedParameters& np)
{
  using CGAL::parameters::is_default_parameter;
  Geometry_options g;
  g.smooth =
      parameters::choose_parameter(parameters::get_parameter(np, smooth_reference_tag), false);
  if constexpr(!is_default_parameter<NamedParameters, projector_t>::value)
    g.projector = make_projector<Point>(parameters::get_parameter(np, projector_tag));
  if constexpr(!is_default_parameter<NamedParameters, curve_projector_t>::value)
    g.curve_lift = [f = make_projector<Point>(parameters::get_parameter(np, curve_projector_tag))](
                       const Vec& p) {
      const Vec q = f(p).point;
      if(!is_finite(q)) throw Bad_projection{ p };
      return q;
    };
  if(g.smooth && g.projector)
    throw Refused{ Refusal::invalid_parameter,
                   "smooth_reference() and projector() cannot be asked for at once" };
  return g;
}

// Infinite: no bound was asked for.
template <typename NamedParameters>
double decode_max_distance(const NamedParameters& np)
{
  const double d = parameters::choose_parameter(parameters::get_parameter(np, max_distance_tag),
                                                std::numeric_limits<double>::infinity());
  if(d > 0) return d;
  throw Refused{ Refusal::invalid_parameter,
                 "max_distance(" + number_text(d) + "): the largest distance must be positive" };
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
  // what is tried a second time has got further before
  s.report_progress = [visitor, callback, furthest = std::make_shared<double>(0)](double progress) {
    *furthest = (std::max)(*furthest, progress);
    if(!unwrap(*visitor).go_further() || (callback && !callback(*furthest))) throw Cancelled();
  };
  s.foretell = [visitor](double faces) { unwrap(*visitor).foretell(faces); };
  s.start_phase = [visitor, &clock](const char* name, std::size_t iteration) {
    clock.start(name);
    unwrap(*visitor).start_phase(name, iteration);
  };
  s.end_phase = [visitor, &clock](const char* name, std::size_t faces) {
    clock.stop(name);
    unwrap(*visitor).end_phase(name, faces);
  };
}

// Are several threads asked for?
template <typename NamedParameters>
constexpr bool decode_concurrency(const NamedParameters& np)
{
  using Tag = std::decay_t<decltype(parameters::choose_parameter(
      parameters::get_parameter(np, concurrency_tag), CGAL::Sequential_tag()))>;
  constexpr bool several = std::is_convertible_v<Tag, CGAL::Parallel_tag>;
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!several, "CGAL::Parallel_tag needs TBB: link CGAL::TBB_support");
#endif
  return several;
}

// Tells a chain of named parameters from a mesh.
template <typename T>
struct is_named_parameters : std::false_type
{
};
template <typename T, typename Tag, typename Base>
struct is_named_parameters<Named_function_parameters<T, Tag, Base>> : std::true_type
{
};
template <typename T>
struct is_named_parameters<const T> : is_named_parameters<T>
{
};

// None where they are not given, at most what an int holds.
template <typename NamedParameters>
std::optional<std::size_t> decode_iterations(const NamedParameters& np)
{
  using CGAL::parameters::is_default_parameter;
  if constexpr(is_default_parameter<NamedParameters, internal_np::number_of_iterations_t>::value) {
    return std::nullopt;
  } else {
    const auto n = parameters::get_parameter(np, internal_np::number_of_iterations);
    if constexpr(std::is_signed_v<std::decay_t<decltype(n)>>)
      if(n < 0)
        throw Refused{ Refusal::invalid_parameter, "number_of_iterations(" + std::to_string(n) +
                                                       "): the number of passes is negative" };
    constexpr std::size_t most = (std::numeric_limits<int>::max)();
    return (std::min)(most, std::size_t(n));
  }
}

template <typename NamedParameters>
bool is_paper_schedule(const NamedParameters& np)
{
  return parameters::choose_parameter(parameters::get_parameter(np, schedule_tag),
                                      Schedule::progressive) == Schedule::paper;
}

template <typename NamedParameters>
Schedule_ingredients decode_ingredients(const NamedParameters& np)
{
  Schedule_ingredients use;
  use.detours = parameters::choose_parameter(parameters::get_parameter(np, effort_tag),
                                             Effort::full) != Effort::quick;
  return use;
}

template <typename NamedParameters>
bool decode_symmetry(const NamedParameters& np)
{
  return parameters::choose_parameter(parameters::get_parameter(np, symmetry_tag), true);
}

template <typename NamedParameters>
Aim decode_aim(const NamedParameters& np)
{
  if(is_paper_schedule(np)) return Aim::not_larger;
  return parameters::choose_parameter(parameters::get_parameter(np, aim_tag), Aim::not_larger);
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DECODE_PARAMETERS_H
