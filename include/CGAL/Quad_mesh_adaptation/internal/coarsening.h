// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_COARSENING_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_COARSENING_H

#include <CGAL/Quad_mesh_adaptation/internal/Tried_places.h>
#include <CGAL/Quad_mesh_adaptation/internal/chord_coarsening.h>
#include <CGAL/Quad_mesh_adaptation/internal/clean_up.h>
#include <CGAL/Quad_mesh_adaptation/internal/stir_where_irregular.h>
#include <CGAL/Quad_mesh_adaptation/internal/thinning.h>

#include <algorithm>
#include <limits>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Does a crease run through the mesh, or the part of it that is there?
inline bool has_creases(const Adaptation_state& s)
{
  for(Index h : s.mesh.halfedges()) {
    if(s.mesh.curve(h) < 0) continue;
    const Feature_curve& c = s.curves[s.mesh.curve(h)];
    if(!c.is_border() && !c.is_frozen()) return true;
  }
  return false;
}

// In a part of a mesh only about what is too small: what is too large waits to be refined.
inline void stir_to_coarsen(Adaptation_state& s)
{
  stir_where_irregular(s, (std::numeric_limits<double>::infinity)());
}

// What the search for operations does while faces are closed.  The rounds of one call share it.
struct Relaxed_search
{
  bool shortens_creases = false;
  bool was_large = false; // then the first round thins it out quickly, and floors are not renewed
  bool was_rough = false; // then any operation that gains will do, and smoothing is light
  Tried_places relaxed, strict;
};

// One round of closing faces with little weight on valences.
inline void close_faces_relaxed(Adaptation_state& s, const Improvement_options& clean,
                                Relaxed_search& search)
{
  Phase_scope phase(s, "coarsening");
  const double strict = s.energy.valence;
  search.was_large = search.was_large || is_far_too_fine(s);
  if(is_rough_enough(s) && !is_rich_in_curves(s)) search.was_rough = true;
  if(search.was_rough) s.smoothing.wake = (std::max)(s.smoothing.wake, 0.02);
  thin_out(s, [&] { coarsen_by_chords(s, 0.35, is_far_too_fine(s) ? 0.04 : 0); });
  Improvement_options relaxed = clean;
  relaxed.open = relaxed.insertion = false;
  relaxed.crease = search.shortens_creases;
  relaxed.max_valence = 6;
  relaxed.min_jacobian =
      search.shortens_creases ? 0.5 : 0.3; // corners on creases do not open again
  relaxed.first_gain = search.was_rough || is_far_too_fine(s);
  s.energy.valence = 0.05;
  s.forget_energies();
  stir_to_coarsen(s);
  search.relaxed.leave_changed(s);
  Local_improvement(s, relaxed).passes(3);
  if(search.was_rough) search.relaxed.remember(s);
  smooth(s, 3);
  s.energy.valence = strict;
  s.forget_energies();
}

// Makes good what was left out while most nodes were still to go.
inline void smooth_finely(Adaptation_state& s)
{
  Phase_scope phase(s, "clean-up");
  smooth(s, 3);
}

// Coarsening by whole chords first, then by local operations: closing a face of a regular mesh
// makes irregular nodes, so the weight of valences is relaxed while faces are closed and set back
// for the clean-up after it.  When a round closes fewer than 1 % of the faces, creases may lose
// single edges, too: earlier that would break up rows that can go as a whole.  Ends when this does
// not help any more, either.
inline void coarsen_relaxed(Adaptation_state& s, const Improvement_options& clean, int max_rounds)
{
  const double fine = s.smoothing.wake;
  Relaxed_search search;
  for(int round = 0; round < max_rounds; ++round) {
    if(!search.was_large) set_floors(s); // where the mesh is too coarse it stays so for now
    const Index before = s.mesh.number_of_faces();
    close_faces_relaxed(s, clean, search);
    stir_to_coarsen(s);
    search.strict.leave_changed(s);
    clean_up_stirred(s, clean, 3, 3);
    if(search.was_rough) search.strict.remember(s);
    if(s.mesh.number_of_faces() <= 0.99 * before) continue;
    if(search.shortens_creases || !has_creases(s)) break;
    search.shortens_creases = true;
    search.relaxed.forget();
  }
  s.smoothing.wake = fine;
  if(search.was_rough) smooth_finely(s);
  clear_floors(s);
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_COARSENING_H
