// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PROGRESSIVE_SCHEDULE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PROGRESSIVE_SCHEDULE_H

#include <CGAL/Quad_mesh_adaptation/internal/Mesh_keeper.h>
#include <CGAL/Quad_mesh_adaptation/internal/Schedule_ingredients.h>
#include <CGAL/Quad_mesh_adaptation/internal/Work_part.h>
#include <CGAL/Quad_mesh_adaptation/internal/curve_bends.h>
#include <CGAL/Quad_mesh_adaptation/internal/detours.h>
#include <CGAL/Quad_mesh_adaptation/internal/fan_thinning.h>
#include <CGAL/Quad_mesh_adaptation/internal/faults.h>
#include <CGAL/Quad_mesh_adaptation/internal/local_detours.h>
#include <CGAL/Quad_mesh_adaptation/internal/own_triangles.h>
#include <CGAL/Quad_mesh_adaptation/internal/progressive_run.h>
#include <CGAL/Quad_mesh_adaptation/internal/row_trades.h>
#include <CGAL/Quad_mesh_adaptation/internal/work_to_do.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// From so many faces on an input has no detours.
constexpr Index without_detours = 40000;
constexpr Index few_enough_for_trades = 200;

// Where features and size leave room for few faces, the order of operations decides about much. So
// where a small mesh does not come out well, other ways are tried as well, and taken where they are
// better.
inline void run_with_detours(Adaptation_state& s, const Improvement_options& clean,
                             std::size_t max_iterations, const Schedule_ingredients& use,
                             Refused_octave* refused = nullptr)
{
  Known_starts known;
  const auto run = [&](bool from_input) {
    run_progressively(s, clean, max_iterations, use, nullptr, from_input ? &known : nullptr);
  };
  std::optional<Detours> detours;
  if(s.mesh.number_of_faces() <= without_detours && s.region.empty() && use.coarsening &&
     use.detours)
    detours.emplace(s, run);
  const int octaves =
      run_progressively(s, clean, max_iterations, use, refused, detours ? &known : nullptr);
  if(!detours) return;
  (*detours)(octaves > 0);
  if(s.mesh.number_of_faces() <= few_enough_for_trades && !are_sizes_out_of_reach(s))
    Row_trades(s, clean)();
}

// Another way from a mesh that is given; the better outcome of both is kept.
inline void run_other_way(Adaptation_state& s, const Improvement_options& clean,
                          std::size_t max_iterations, const Schedule_ingredients& other,
                          const Refused_octave& given)
{
  Mesh_keeper first(s);
  const double demerits_of_first = demerits(s);
  Mesh_keeper(*given.input).restore();
  const double factor = s.size.scale() / given.scale;
  for(Index v = 0; v < s.mesh.vertex_end(); ++v) s.mesh.vertex(v).h *= factor;
  run_progressively(s, clean, max_iterations, other);
  if(demerits(s) >= demerits_of_first) first.restore();
}

// Where faces of the input are folded over, or nearly, any way may leave some that are: one from a
// mesh for larger sizes, although halving it folds faces, one without such a mesh, and one whose
// annealing has carried nodes over an edge.  So others are tried then.  A large input is kept only
// where an octave has been refused.
inline void run_several_ways(Adaptation_state& s, const Improvement_options& clean,
                             std::size_t max_iterations, const Schedule_ingredients& use)
{
  if(s.surface.is_planar()) return run_with_detours(s, clean, max_iterations, use);
  constexpr double useless = 0.02;
  constexpr Index few_enough = 20000; // for a third run
  const double enough = (std::min)(least_scaled_jacobian(s), useless);
  Refused_octave given;
  given.scale = s.size.scale();
  if(s.mesh.number_of_faces() > without_detours) {
    run_progressively(s, clean, max_iterations, use, &given);
  } else {
    given.input.emplace(s);
    run_with_detours(s, clean, max_iterations, use, &given);
  }
  if(!given.input || (worst_quality(s) > 0 && least_scaled_jacobian(s) >= enough)) return;
  Schedule_ingredients other = use;
  other.trial_halving = false;
  if(given.is_refused) run_other_way(s, clean, max_iterations, other, given);
  if(least_scaled_jacobian(s) >= enough || s.mesh.number_of_faces() > few_enough) return;
  other.annealing = false;
  run_other_way(s, clean, max_iterations, other, given);
}

constexpr Index worth_a_part = 10000; // faces of the whole

// Where a large mesh has few faces to work on, and these can be.
inline void take_part_out(Adaptation_state& s, const std::vector<Index>& work, bool is_on_own,
                          std::optional<Work_part>& part)
{
  if(work.empty() || s.mesh.number_of_faces() <= worth_a_part) return;
  const Part_choice choice(s.mesh, work);
  if(choice.is_separable(s)) part.emplace(s, work, choice, rings_to_work_on, is_on_own);
}

// The faces to work on, none if these are not few.  Where a part can be taken out for them only
// that has to know what it covers of the surface; as long as all faces lie on it, none of them has
// left a witness behind.
inline std::vector<Index> find_work(Adaptation_state& s, std::optional<Work_part>& part,
                                    bool& is_adapted)
{
  const bool is_on_own = s.mesh.number_of_faces() > worth_a_part && is_all_on_own_triangles(s);
  if(!is_on_own) s.prepare_coverage();
  std::vector<Index> work = faces_to_work_on(s);
  if(is_on_own && is_local(s, work)) take_part_out(s, work, true, part);
  if(part) return part->work();
  if(is_on_own) {
    s.prepare_coverage();
    if(!s.coverage.is_empty()) work = faces_to_work_on(s);
  }
  is_adapted = work.empty() && !is_too_fine(s);
  if(!is_local(s, work)) work.clear();
  take_part_out(s, work, false, part);
  return part ? part->work() : work;
}

// Where there is little to work on the fans about that only.
inline void thin_fans_near(Adaptation_state& s, const std::vector<Index>& work)
{
  if(huge_nodes(s.mesh).empty()) return;
  const std::vector<char> region = s.region; // a part that was taken out has one
  if(region.empty() && !work.empty()) s.region = nodes_around(s.mesh, work, rings_to_work_on);
  thin_fans(s);
  s.region = region;
}

// The default schedule.
inline void progressive_schedule(Adaptation_state& s, std::size_t max_iterations,
                                 const Schedule_ingredients& use = {})
{
  std::optional<Work_part> part;
  bool adapted = false;
  const std::vector<Index> work = find_work(s, part, adapted);
  if(adapted && !(use.coarsening && may_spare_rows(s))) return;
  if(!part) s.forget_ratios();
  Schedule_ingredients use_here = use;
  if(part) {
    use_here = made_light(use);
    use_here.coarsening = use.coarsening && are_many_too_small(s, work);
  }
  Good_mesh_keeper input(s, work);
  if(adapted && spare_rows(s) == 0) return;
  const Improvement_options clean;
  if(!use.size_aware) s.smoothing.size = 0;
  const double fine = s.smoothing.wake;
  if(part) s.smoothing.wake = (std::max)(fine, 0.02);
  if(use_here.coarsening) thin_fans_near(s, work);
  if(has_boundless_fan(s.mesh)) use_here.detours = false; // features hold it as it is
  if(use.last_resorts) {
    run_several_ways(s, clean, max_iterations, use_here);
    Curve_bends(s).hold_all();
    Local_detours last(s, clean);
    if(use_here.detours)
      last.in_the_end();
    else
      last.move_in_the_end();
    release_bends(s);
  } else {
    run_progressively(s, clean, max_iterations, use_here);
  }
  s.smoothing.wake = fine;
  input.restore_unless_better();
  if(part) part->put_back();
  s.region.clear();
  s.progress = 1;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PROGRESSIVE_SCHEDULE_H
