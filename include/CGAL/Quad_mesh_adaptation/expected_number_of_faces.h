// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_EXPECTED_NUMBER_OF_FACES_H
#define CGAL_QUAD_MESH_ADAPTATION_EXPECTED_NUMBER_OF_FACES_H

#include <CGAL/Quad_mesh_adaptation/internal/Core_run.h>
#include <CGAL/Quad_mesh_adaptation/internal/run_on_mesh.h>
#include <CGAL/Quad_mesh_adaptation/most_rehearsed_faces.h>
#include <CGAL/Quad_mesh_adaptation/parameters.h>

#include <stdexcept>
#include <type_traits>

namespace CGAL {
namespace Quad_mesh_adaptation {

namespace internal {

template <typename FaceRange, typename SizingField, typename QuadMesh, typename NamedParameters>
double expected_number_of_faces(const FaceRange& faces, bool is_region, const SizingField& sizing,
                                const QuadMesh& mesh, const NamedParameters& np)
{
  using Decoded = Decoded_parameters<QuadMesh, NamedParameters>;
  const auto vpm =
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                   get_const_property_map(CGAL::vertex_point, mesh));
  const auto ecm = Decoded::edge_map(np);
  const auto vcm = Decoded::vertex_map(np);
  const auto efm = Decoded::frozen_map(np);
  const auto fpm = Decoded::patch_map(np);
  using Vpm = std::decay_t<decltype(vpm)>;
  using Point = typename boost::property_traits<Vpm>::value_type;
  try {
    Prepared_run run;
    run.s.size = make_sampler<Point>(sizing);
    run.decode_limits(np);
    Mesh_descriptors<QuadMesh> descriptors;
    Mesh_import<QuadMesh, Vpm, std::decay_t<decltype(ecm)>, std::decay_t<decltype(vcm)>,
                std::decay_t<decltype(efm)>, std::decay_t<decltype(fpm)>>
        import(mesh, vpm, ecm, vcm, efm, fpm);
    import(faces, is_region, run.in, descriptors);
    run.build<Point>(np);
    return foretold_faces(run, decode_symmetry(np));
  } catch(const Refused& e) {
    throw std::invalid_argument("expected_number_of_faces: " + e.message);
  } catch(const Bad_projection& e) {
    throw std::invalid_argument("expected_number_of_faces: " + describe(e));
  } catch(const Bad_size& e) {
    throw std::domain_error("expected_number_of_faces: " + describe(e));
  }
}

} // namespace internal

/*!
predicts how many faces `adapt_quad_mesh(sizing, mesh, np)` will leave, without doing it.

The number follows from the integral of 1/h^2 over the surface, the curves that must be kept, the
growth of the size, the aim, and the places where faces cannot be as large as asked: where the
surface turns too much for them, as on fingers, and at feature curves shorter than the size.  A mesh
that has the sizes already keeps its faces, and one whose faces only have to be halved alike keeps
its pattern.  Of 128 runs that gave a hundred faces or more, many of them on models of which
features and sizes leave little room, 108 came within 15 % of the formula; see the manual.

Where at most `most_rehearsed_faces` are expected, single rows of faces count, which no formula
foretells: there a mesh of at most twenty times as many faces is adapted in memory and the faces are
counted.  Then the outcome is the number.  The paper's schedule leaves about twice as many faces as
the default one, for which the number is.  Sizes that ask for more than 1e8 faces, which
`adapt_quad_mesh()` refuses, get a number here.

\param sizing a number, or a callable `FT operator()(const Point_3&) const`, as for
  `adapt_quad_mesh()`.
\param mesh a model of `FaceListGraph` and `HalfedgeListGraph`; it is not changed.
\param np optional: all that `adapt_quad_mesh()` takes.  Visitor, callback and schedule are ignored,
  and `aim()` beside `schedule(Schedule::paper)`, which has no other aim than the default;
  `number_of_iterations` counts only where the faces are counted.

\throws std::invalid_argument for a mesh or parameters that `adapt_quad_mesh()` would refuse, with
  its message; std::domain_error if a size is not a positive finite number;
  exceptions of `sizing` and of projectors pass through.

Complexity: linear in the number of faces but for building the reference surface and for sizes that
must grow from where they are held small (n log n in their number); some 6e4 evaluations of `sizing`
at least.  Some seconds, as long as adapting takes, where
the faces are counted.
*/
template <typename SizingField, typename QuadMesh,
          typename NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<internal::is_named_parameters<NamedParameters>::value, int> = 0>
double expected_number_of_faces(const SizingField& sizing, const QuadMesh& mesh,
                                const NamedParameters& np = parameters::default_values())
{
  return internal::expected_number_of_faces(faces(mesh), false, sizing, mesh, np);
}

/*!
the same for a region: the number of faces that those of `region` will become.

\tparam FaceRange a model of `ConstRange` with value type `face_descriptor`.
*/
template <typename FaceRange, typename SizingField, typename QuadMesh,
          typename NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<!internal::is_named_parameters<QuadMesh>::value, int> = 0>
double expected_number_of_faces(const FaceRange& region, const SizingField& sizing,
                                const QuadMesh& mesh,
                                const NamedParameters& np = parameters::default_values())
{
  return internal::expected_number_of_faces(region, true, sizing, mesh, np);
}

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_EXPECTED_NUMBER_OF_FACES_H
