// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CORE_CALLS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CORE_CALLS_H

#include <CGAL/Quad_mesh_adaptation/Mesh_measures.h>
#include <CGAL/Quad_mesh_adaptation/Poor_face.h>
#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/Face_figures.h>
#include <CGAL/Quad_mesh_adaptation/internal/Schedule_ingredients.h>
#include <CGAL/Quad_mesh_adaptation/internal/compiled_core.h>
#include <CGAL/Quad_mesh_adaptation/internal/state_options.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

// The calls from the templates over the caller's mesh down into the core, see compiled_core.h.
namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// What is done to the state of a mesh.
using State_algorithm = std::function<void(Adaptation_state&)>;

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
                                                              std::size_t max_iterations,
                                                              const Schedule_ingredients& use);

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL void keep_within_distance(Adaptation_state& s);

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL void keep_sizes_within_distance(Adaptation_state& s);

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL void run_paper_schedule(Adaptation_state& s,
                                                            std::size_t max_iterations);

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL void run_refinement(Adaptation_state& s, std::size_t passes);

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL void run_coarsening(Adaptation_state& s, bool paper);

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL void run_boundary_coarsening(Adaptation_state& s);

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL void run_clean_up(Adaptation_state& s, int passes);

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL void run_smoothing(Adaptation_state& s, int sweeps);

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#ifndef QUAD_MESH_ADAPTATION_COMPILED_CORE
#include <CGAL/Quad_mesh_adaptation/internal/core_calls_impl.h>
#endif

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CORE_CALLS_H
