// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SCHEDULE_INGREDIENTS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SCHEDULE_INGREDIENTS_H

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The ingredients of the default schedule; the benchmark switches them off one by one, to show what
// each is worth.
struct Schedule_ingredients
{
  bool coarsening = true;        // before refinement, with relaxed valences
  bool edge_marking = true;      // else faces too large are cut in four
  bool octaves = true;           // first a mesh for sizes larger by powers of two
  bool trial_halving = true;     // of such a mesh, to see whether it lies well on the surface then
  bool progressive_sizes = true; // floors where the mesh is too coarse yet
  bool size_aware = true;        // smoothing knows the size
  bool local_operations = true;  // clean-up between levels, annealing and polishing
  bool clean_up_between = true;  // the first of these
  bool annealing = true;
  bool last_resorts = true; // enforcement of sizes, mending of shapes
  bool detours = true;      // other ways for the whole, and about single faces

  double tolerance = 2.5;                      // of the first round of annealing
  int annealing_rounds = 10;                   // see anneal()
  int annealing_sweeps = 2;                    // of smoothing after each of these
  int polishing_rounds = 5, gentle_rounds = 2; // see polish()
};

// For a part of a large mesh: most of it is halved, and what is not has been adapted before.
inline Schedule_ingredients made_light(Schedule_ingredients use)
{
  use.clean_up_between = false; // annealing comes at once
  use.tolerance = 1.25;
  use.annealing_rounds = 4;
  use.annealing_sweeps = 1;
  use.polishing_rounds = 1;
  use.gentle_rounds = 0;
  return use;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SCHEDULE_INGREDIENTS_H
