// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CORE_CALLS_IMPL_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CORE_CALLS_IMPL_H

#include <CGAL/Quad_mesh_adaptation/internal/Phase_scope.h>
#include <CGAL/Quad_mesh_adaptation/internal/boundary_coarsening.h>
#include <CGAL/Quad_mesh_adaptation/internal/build_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/clean_up.h>
#include <CGAL/Quad_mesh_adaptation/internal/coarsening.h>
#include <CGAL/Quad_mesh_adaptation/internal/core_calls.h>
#include <CGAL/Quad_mesh_adaptation/internal/distance_mending.h>
#include <CGAL/Quad_mesh_adaptation/internal/expected_count.h>
#include <CGAL/Quad_mesh_adaptation/internal/fan_thinning.h>
#include <CGAL/Quad_mesh_adaptation/internal/measure_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/paper_schedule.h>
#include <CGAL/Quad_mesh_adaptation/internal/poor_shapes.h>
#include <CGAL/Quad_mesh_adaptation/internal/progressive_schedule.h>
#include <CGAL/Quad_mesh_adaptation/internal/refinement_schedule.h>
#include <CGAL/Quad_mesh_adaptation/internal/ring_coarsening.h>
#include <CGAL/Quad_mesh_adaptation/internal/smoothing.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL void build_state(const Input_mesh& in,
                                                     const Feature_options& features,
                                                     const Geometry_options& geometry,
                                                     Adaptation_state& s)
{
  State_builder(in, features, s)(geometry);
}

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL Mesh_measures
measured_state(const Adaptation_state& s, const std::optional<Triangle_soup>& reference,
               Figures_of_faces* kept)
{
  return measure_state(s, reference, kept);
}

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL std::vector<Poor_face> poor_faces(const Adaptation_state& s,
                                                                      double floor)
{
  return poor_shapes(s, floor);
}

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL double expected_faces(const Adaptation_state& s,
                                                          double ideal_number_of_faces,
                                                          double mean_square_slope, double scale)
{
  return expected_count(s, ideal_number_of_faces, mean_square_slope, scale);
}

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL void run_default_schedule(Adaptation_state& s,
                                                              std::size_t max_iterations,
                                                              const Schedule_ingredients& use)
{
  progressive_schedule(s, max_iterations, use);
}

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL void keep_within_distance(Adaptation_state& s)
{
  mend_distances(s, Improvement_options());
}

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL void keep_sizes_within_distance(Adaptation_state& s)
{
  enforce_sizes_within_bound(s, Improvement_options());
}

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL void run_paper_schedule(Adaptation_state& s,
                                                            std::size_t max_iterations)
{
  paper_schedule(s, max_iterations);
}

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL void run_refinement(Adaptation_state& s, std::size_t passes)
{
  refine_by_octaves(s, Marking_options(), passes);
}

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL void run_coarsening(Adaptation_state& s, bool paper)
{
  if(paper) {
    coarsen_by_rings(s, 1.0, Improvement_options());
  } else {
    thin_fans(s);
    coarsen_relaxed(s, Improvement_options(), 12);
  }
}

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL void run_boundary_coarsening(Adaptation_state& s)
{
  coarsen_boundary(s);
}

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL void run_clean_up(Adaptation_state& s, int passes)
{
  clean_up(s, Improvement_options(), passes, 3);
}

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL void run_smoothing(Adaptation_state& s, int sweeps)
{
  Phase_scope phase(s, "smoothing");
  smooth(s, sweeps);
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CORE_CALLS_IMPL_H
