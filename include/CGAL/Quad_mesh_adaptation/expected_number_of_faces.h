// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_EXPECTED_NUMBER_OF_FACES_H
#define CGAL_QUAD_MESH_ADAPTATION_EXPECTED_NUMBER_OF_FACES_H

#include <CGAL/Quad_mesh_adaptation/internal/core_calls.h>
#include <CGAL/Quad_mesh_adaptation/internal/measure_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/run_on_mesh.h>
#include <CGAL/Quad_mesh_adaptation/parameters.h>

#include <optional>
#include <stdexcept>
#include <type_traits>

namespace CGAL {
namespace Quad_mesh_adaptation {

/// The number of faces up to which `expected_number_of_faces()` tries what comes out.
constexpr double most_rehearsed_faces = 1000;

/*!
predicts how many faces `adapt_quad_mesh(sizing, mesh, np)` will leave, without doing it.

The number follows from the integral of 1/h^2 over the surface, the curves that must be kept, the
growth of the size and the aim; a mesh that has the sizes already keeps its faces, and one whose
faces only have to be halved alike keeps its pattern.  On sizes that the factors were not fitted to,
the outcome of the default schedule is within 10 % in 361 of 413 cases of a hundred faces or more
and within 15 % in 393, coarsening included.  It is off further where curves close to each other
hold faces that the size does not ask for.

Where at most `most_rehearsed_faces` are expected, single rows of faces count, which no formula
foretells: there a mesh of at most twenty times as many faces is adapted in memory and the faces are
counted.  Then the outcome is the number, unless lifts to a smooth or true surface or a bound on
the distance change it.  The paper's schedule leaves about twice as many faces.

\param sizing a number, or a callable `FT operator()(const Point_3&) const`, as for
  `adapt_quad_mesh()`.
\param mesh a model of `FaceListGraph` and `HalfedgeListGraph`; it is not changed.
\param np optional: `vertex_point_map`, `edge_is_constrained_map`, `vertex_is_constrained_map`,
  `edge_is_frozen_map()`, `aim()`, `symmetry()`, `feature_angle()`, `reference_surface()`, as for
  `adapt_quad_mesh()`.

\throws std::invalid_argument for a mesh that `adapt_quad_mesh()` would refuse, with its message;
  std::domain_error if a size is not a positive finite number;
  exceptions of `sizing` pass through.

Complexity: linear in the number of faces but for building the reference surface; some 6e4
evaluations of `sizing` at least.  A few seconds at most where the faces are counted.
*/
template <typename SizingField, typename QuadMesh,
          typename NamedParameters = parameters::Default_named_parameters>
double expected_number_of_faces(const SizingField& sizing, const QuadMesh& mesh,
                                const NamedParameters& np = parameters::default_values())
{
  using namespace internal;
  using Decoded = Decoded_parameters<QuadMesh, NamedParameters>;
  const auto vpm =
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                   get_const_property_map(CGAL::vertex_point, mesh));
  const auto ecm = Decoded::edge_map(np);
  const auto vcm = Decoded::vertex_map(np);
  const auto efm = Decoded::frozen_map(np);
  using Vpm = std::decay_t<decltype(vpm)>;
  const Aim aim = decode_aim(np);
  const double scale = scale_of(aim);
  try {
    Adaptation_state s;
    s.size = make_sampler<typename boost::property_traits<Vpm>::value_type>(sizing);
    s.size.scale_by(scale);
    Input_mesh in;
    Mesh_descriptors<QuadMesh> descriptors;
    Mesh_import<QuadMesh, Vpm, std::decay_t<decltype(ecm)>, std::decay_t<decltype(vcm)>,
                std::decay_t<decltype(efm)>>
        import(mesh, vpm, ecm, vcm, efm);
    import(faces(mesh), false, in, descriptors);
    const std::optional<Triangle_soup> reference = decode_reference(np);
    Geometry_options geometry; // lifts to a smooth or true surface hardly change the count
    geometry.reference = reference ? &*reference : nullptr;
    const Feature_options features = decode_features(np);
    build_state(in, features, geometry, s);
    const Size_function size = [&s](const Vec& p) { return s.size.unscaled(p); };
    const double ideal = reference ? ideal_number_of_faces(corner_points(*reference), size)
                                   : ideal_number_of_faces(Quad_halves(in.points, in.quads), size);
    const double slope = s.size.is_constant()
                             ? 0.
                             : measure_size_growth(in.points, in.quads, size).mean_square_slope;
    const double expected = expected_faces(s, ideal, slope, scale);
    if(expected > most_rehearsed_faces || in.quads.size() > 20 * most_rehearsed_faces)
      return expected;
    std::optional<Mirror_goal> mirror;
    if(decode_symmetry(np)) mirror = Mirror_goal{ largest_allowed(aim), ideal, true };
    adapt_state(
        in, features, geometry, mirror,
        [](Adaptation_state& part) { run_default_schedule(part, default_number_of_iterations); },
        s);
    return double(s.mesh.number_of_faces());
  } catch(const Refused& e) {
    throw std::invalid_argument("expected_number_of_faces: " + e.message);
  } catch(const Bad_size& e) {
    throw std::domain_error("expected_number_of_faces: " + describe(e));
  }
}

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_EXPECTED_NUMBER_OF_FACES_H
