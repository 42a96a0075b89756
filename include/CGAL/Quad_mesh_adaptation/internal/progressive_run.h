// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PROGRESSIVE_RUN_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PROGRESSIVE_RUN_H

#include <CGAL/Quad_mesh_adaptation/internal/Known_starts.h>
#include <CGAL/Quad_mesh_adaptation/internal/Mesh_keeper.h>
#include <CGAL/Quad_mesh_adaptation/internal/Refinement_progress.h>
#include <CGAL/Quad_mesh_adaptation/internal/Schedule_ingredients.h>
#include <CGAL/Quad_mesh_adaptation/internal/coarsening.h>
#include <CGAL/Quad_mesh_adaptation/internal/curve_bends.h>
#include <CGAL/Quad_mesh_adaptation/internal/curve_lengths.h>
#include <CGAL/Quad_mesh_adaptation/internal/large_mesh.h>
#include <CGAL/Quad_mesh_adaptation/internal/local_detours.h>
#include <CGAL/Quad_mesh_adaptation/internal/octaves.h>
#include <CGAL/Quad_mesh_adaptation/internal/row_insertion.h>
#include <CGAL/Quad_mesh_adaptation/internal/size_guarantee.h>
#include <CGAL/Quad_mesh_adaptation/internal/stir_where_irregular.h>
#include <CGAL/Quad_mesh_adaptation/internal/trial_halving.h>
#include <CGAL/Quad_mesh_adaptation/internal/work_to_do.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Approaches the sizes from below: halve what is too long, everywhere once, then clean up and
// smooth against the size reached so far.  No place is ever grossly under-resolved while
// operations or smoothing work on it.
inline void refine_progressively(Adaptation_state& s, const Improvement_options& clean,
                                 std::size_t max_passes, const Schedule_ingredients& use = {})
{
  const Growth_limit limit(s);
  Refinement_progress progress(s);
  for(std::size_t pass = 0; pass < max_passes && !limit.is_exceeded(); ++pass) {
    if(progress.is_stuck()) {
      progress.go_back();
      break;
    }
    if(use.edge_marking) {
      clear_floors(s);
      if(s.region.empty()) insert_rows(s);
    }
    {
      Phase_scope phase(s, "refinement");
      const std::size_t cut =
          use.edge_marking ? refine_once(s, Marking_options()) : refine_faces(s, faces_to_press(s));
      if(cut == 0) break;
      ++s.iterations;
      if(use.progressive_sizes) set_floors(s);
      smooth(s, 3);
    }
    if(use.local_operations && use.clean_up_between) clean_up(s, clean, 1, 3);
  }
  clear_floors(s);
}

// Clean-up that may raise the energy by a little, from round to round by less (threshold accepting,
// Dueck and Scheuer 1990).  It carries irregular nodes over the small barriers between them, so
// that pairs meet and vanish, which strict descent never does.  Each round visits a node at most
// twice, so this ends by construction like all else.
inline void anneal(Adaptation_state& s, Improvement_options o, double tolerance, int rounds,
                   int sweeps)
{
  const double fine = s.smoothing.wake;
  s.smoothing.wake = (std::max)(fine, 0.01); // all this will move again
  stir_where_irregular(s);
  for(int round = 0; round < rounds; ++round) {
    o.tolerance = tolerance * (rounds - round) / rounds;
    clean_up_stirred(s, o, 2, sweeps);
  }
  s.smoothing.wake = fine;
  s.disturb_all();
}

// Rounds of clean-up against the final sizes, with smoothing that presses the last faces below
// their size after the first `gentle` ones.
inline void polish(Adaptation_state& s, const Improvement_options& clean, int rounds, int gentle)
{
  std::optional<Pressing> within_sizes;
  for(int round = 0; round < rounds; ++round) {
    if(round == gentle) {
      within_sizes.emplace(s.smoothing);
      s.disturb_all();
    }
    const std::size_t done = clean_up_stirred(s, clean, 6, 4);
    if(done == 0 && round >= 3) break;
  }
}

// The same after nodes have gone to the bends of their curves; in a large mesh about these only.
inline void polish_about_bends(Adaptation_state& s, const Improvement_options& clean)
{
  if(!is_large(s)) return polish(s, clean, 1, 0);
  const Short_smoothing coarse(s);
  const Pressing within_sizes(s.smoothing);
  clean_up_stirred(s, clean, 6, 4);
}

// Takes whole rows out that the sizes can do without.
inline std::size_t spare_rows(Adaptation_state& s)
{
  if(!may_spare_rows(s)) return 0;
  Phase_scope phase(s, "coarsening");
  return coarsen_by_chords(s, 0.5);
}

// From any mesh to one that has the sizes of now nearly everywhere.
inline void approach_sizes(Adaptation_state& s, const Improvement_options& clean,
                           std::size_t max_passes, const Schedule_ingredients& use)
{
  Curve_bends(s).hold();
  smooth(s, 2);
  if(use.coarsening && is_too_fine(s)) {
    s.progress = 0.05;
    coarsen_relaxed(s, clean, 12);
  }
  s.progress = 0.3;
  refine_progressively(s, clean, max_passes, use);
  // where halving has gone too far by the same everywhere, single rows can go again
  if(use.coarsening) spare_rows(s);
  s.progress = 0.5;
  if(use.local_operations && use.annealing)
    anneal(s, clean, use.tolerance, use.annealing_rounds, use.annealing_sweeps);
  if(use.local_operations) polish(s, clean, use.polishing_rounds, use.gentle_rounds);
}

// The same from the input, where that has not been done for these sizes before.
inline void approach_sizes_from_input(Adaptation_state& s, const Improvement_options& clean,
                                      std::size_t max_passes, const Schedule_ingredients& use,
                                      Known_starts* known)
{
  if(known && known->restore(s, max_passes)) return;
  const std::size_t before = s.iterations;
  approach_sizes(s, clean, max_passes, use);
  if(known) known->add(s, s.iterations - before, max_passes);
}

// Has a mesh that will be halved about as many faces as its sizes ask for?
inline bool is_worth_halving(const Adaptation_state& s)
{
  return efficiency(s) > 0.88 && fraction_below(s, far_too_small) < 0.003;
}

// Shapes are mended as long as that does not cost so many faces that halving does not pay.
inline void enforce_before_halving(Adaptation_state& s, const Improvement_options& clean,
                                   const Schedule_ingredients& use)
{
  enforce_sizes(s, clean, 16);
  if(!is_worth_halving(s)) return;
  Mesh_keeper unmended(s);
  Last_resorts_in_vain in_vain{ use.detours };
  enforce_sizes_and_shapes(s, clean, in_vain);
  if(!is_worth_halving(s)) unmended.restore();
}

// What the first larger sizes were met from, where halving would fold faces of their mesh.
struct Refused_octave
{
  std::optional<Mesh_keeper> input;
  double scale = 1;        // of its sizes
  bool is_refused = false; // else there was none
};

// The same for sizes doubled as often as makes sense.  A solution that takes far too many faces
// would do so after each halving; then there is one octave less.  Returns how many octaves are
// left.  `known`: where the mesh is the input, what that led to before.
inline int approach_larger_sizes(Adaptation_state& s, const Improvement_options& clean,
                                 std::size_t max_passes, const Schedule_ingredients& use,
                                 Refused_octave* refused, Known_starts* known)
{
  const int most = use.octaves ? int((std::min)(max_passes, std::size_t(30))) : 0;
  int octaves = stay_near_work(s) ? 0 : octaves_above(s, most);
  const Index given_faces = s.mesh.number_of_faces();
  s.scale_sizes(std::exp2(octaves));
  for(; octaves > 0; --octaves) {
    Mesh_keeper input(s);
    approach_sizes_from_input(s, clean, max_passes - std::size_t(octaves), use, known);
    if(use.last_resorts) enforce_before_halving(s, clean, use);
    const bool is_full =
        is_worth_halving(s) && (s.mesh.number_of_faces() > given_faces || is_made_to_cover(s));
    if(is_full && (!use.trial_halving || is_made_to_halve_well(s))) return octaves;
    if(is_full && refused) {
      refused->is_refused = true;
      if(!refused->input) {
        refused->input.emplace(input);
        refused->scale = s.size.scale();
      }
    }
    input.restore();
    s.scale_sizes(0.5);
  }
  approach_sizes_from_input(s, clean, max_passes, use, known);
  return 0;
}

// From a mesh that has twice the sizes to one that has them, nearly everywhere.
inline void descend_one_octave(Adaptation_state& s, const Improvement_options& clean,
                               std::size_t max_passes, const Schedule_ingredients& use)
{
  halve_all(s, 0); // all nodes move in the end, and those between smooth ones lie well until then
  refine_progressively(s, clean, max_passes, use);
  const Short_smoothing coarse(s);
  if(use.local_operations) polish(s, clean, 1, 0);
}

// Curves whose edges have been split can have gained a node for every bend; operations that make
// room for these can take one from another bend.
inline void fit_bends_left(Adaptation_state& s, const Improvement_options& clean,
                           Last_resorts_in_vain& in_vain)
{
  constexpr int most = 5;
  std::size_t left = (std::numeric_limits<std::size_t>::max)();
  for(int round = 0; round < most && !are_sizes_out_of_reach(s); ++round) {
    const std::size_t moved = Curve_bends(s).fit();
    if(moved > 0) enforce_sizes_and_shapes(s, clean, in_vain);
    if(moved == 0 || moved >= left) return;
    left = moved;
  }
}

// Where features stand close, rows that go around them come to light only when all else is done.
// They go if that leaves no more faces far too small elsewhere, and no curve shorter.
inline void spare_rows_left(Adaptation_state& s, const Improvement_options& clean,
                            Last_resorts_in_vain& in_vain)
{
  constexpr int most = 3;
  for(int round = 0; round < most && may_spare_rows(s) && !are_sizes_out_of_reach(s); ++round) {
    const double before = energy_and_faults(s), small = fraction_below(s, far_too_small);
    const std::vector<char> kept = curves_that_kept_length(s);
    Mesh_keeper rows(s);
    Curve_bends(s).hold_all();
    const bool any = spare_rows(s) > 0;
    if(any) polish_about_bends(s, clean);
    if(any) enforce_sizes_and_shapes(s, clean, in_vain);
    release_bends(s);
    if(!any) return;
    if(energy_and_faults(s) >= before || fraction_below(s, far_too_small) > small ||
       !have_kept_length(s, kept))
      return rows.restore();
  }
}

// Returns how often the sizes that were met first have been halved.
inline int run_progressively(Adaptation_state& s, const Improvement_options& clean,
                             std::size_t max_iterations, const Schedule_ingredients& use,
                             Refused_octave* refused = nullptr, Known_starts* known = nullptr)
{
  const std::size_t last = s.iterations + max_iterations;
  release_bends(s);
  const int octaves = approach_larger_sizes(s, clean, max_iterations, use, refused, known);
  for(int left = octaves; left > 0; --left) {
    s.progress = 0.9 - 0.3 * left / octaves;
    if(left < octaves && use.last_resorts) enforce_sizes(s, clean, 16);
    descend_one_octave(s, clean, last - s.iterations - std::size_t(left), use);
  }
  s.progress = 0.9;
  s.surface.forget_tree(); // coarse faces ask it, fine ones hardly ever
  if(Curve_bends(s).fit() > 0 && use.local_operations) polish_about_bends(s, clean);
  if(use.last_resorts) {
    Last_resorts_in_vain in_vain{ use.detours };
    enforce_sizes_and_shapes(s, clean, in_vain);
    fit_bends_left(s, clean, in_vain);
    if(use.coarsening && s.region.empty()) spare_rows_left(s, clean, in_vain);
  }
  release_bends(s);
  return octaves;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PROGRESSIVE_RUN_H
