// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CORE_CALLS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CORE_CALLS_H

#include <CGAL/Quad_mesh_adaptation/Mesh_measures.h>
#include <CGAL/Quad_mesh_adaptation/Poor_face.h>
#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/Face_figures.h>
#include <CGAL/Quad_mesh_adaptation/internal/state_options.h>

#include <cstddef>
#include <optional>
#include <vector>

// The calls from the templates over the caller's mesh down into the core, which knows no such
// template.  They are inline, and the package header-only, unless
// QUAD_MESH_ADAPTATION_COMPILED_CORE is defined: then one source file, that includes
// core_calls_impl.h, compiles the core for all others, which takes most of their compile time away.
// The programs of this project are built so.
#ifdef QUAD_MESH_ADAPTATION_COMPILED_CORE
#define CGAL_QUAD_MESH_ADAPTATION_CORE_CALL
#else
#define CGAL_QUAD_MESH_ADAPTATION_CORE_CALL inline
#endif

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL void build_state(const Input_mesh& in,
                                                     const Feature_options& features,
                                                     const Geometry_options& geometry,
                                                     Adaptation_state& s);

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL Mesh_measures
measured_state(const Adaptation_state& s, const std::optional<Triangle_soup>& reference,
               Figures_of_faces* kept = nullptr);

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL std::vector<Poor_face> poor_faces(const Adaptation_state& s,
                                                                      double floor);

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL double expected_faces(const Adaptation_state& s,
                                                          double ideal_number_of_faces,
                                                          double mean_square_slope, double scale);

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL void run_default_schedule(Adaptation_state& s,
                                                              std::size_t max_iterations);

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL void keep_within_distance(Adaptation_state& s);

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL void keep_sizes_within_distance(Adaptation_state& s);

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL void run_paper_schedule(Adaptation_state& s,
                                                            std::size_t max_iterations);

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#ifndef QUAD_MESH_ADAPTATION_COMPILED_CORE
#include <CGAL/Quad_mesh_adaptation/internal/core_calls_impl.h>
#endif

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CORE_CALLS_H
