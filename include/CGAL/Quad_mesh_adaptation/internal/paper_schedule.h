// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PAPER_SCHEDULE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PAPER_SCHEDULE_H

#include <CGAL/Quad_mesh_adaptation/internal/boundary_coarsening.h>
#include <CGAL/Quad_mesh_adaptation/internal/refinement.h>
#include <CGAL/Quad_mesh_adaptation/internal/ring_coarsening.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Eq. 4: faces below it are too small; from the sixth iteration on it is gone.
inline double coarsening_threshold(std::size_t n) { return (std::max)(0., 1.0 - 0.2 * double(n)); }

// Eq. 5: parts high-refine from low-refine faces, down to 1.
inline double refinement_threshold(std::size_t n)
{
  return (std::max)(1.0, 1.25 - 0.05 * double(n));
}

// Fewer than 10 % of the faces below the threshold: coarsening is complete, for good.
inline bool is_coarsening_needed(const Adaptation_state& s, double threshold)
{
  return threshold > 0 && fraction_below(s, threshold) >= 0.10;
}

// How many faces the paper calls high-refine and low-refine.
struct Refine_classes
{
  std::vector<Index> high, low;
};

// f_s > 1 and above t_r (eq. 5): high; f_s > 1 and up to t_r: low.
inline Refine_classes classify_faces(const Adaptation_state& s, double threshold)
{
  Refine_classes c;
  for(Index f : s.mesh.faces()) {
    const double r = s.size_ratio(f);
    // splitting what frozen edges hold would go on for ever
    if(r > size_tolerance && !is_beyond_help(s, f)) (r > threshold ? c.high : c.low).push_back(f);
  }
  return c;
}

// Fewer than 3 % low-refine and 0.5 % high-refine faces.
inline bool is_refinement_sufficient(const Refine_classes& c, Index number_of_faces)
{
  const double all = double(number_of_faces);
  return double(c.low.size()) < 0.03 * all && double(c.high.size()) < 0.005 * all;
}

// Section 3.3 of the paper, step by step.
inline void paper_schedule(Adaptation_state& s, std::size_t max_iterations)
{
  s.smoothing.size = 0; // isotropic: the paper's smoothing does not know the size
  s.coverage.switch_off();
  Improvement_options clean;
  clean.max_valence = 6;
  s.energy.oversize = 0; // its clean-up improves quality only
  s.energy.face = 0;

  coarsen_boundary(s); // step 2
  bool coarsening = true;
  for(std::size_t n = 0; n < (std::min)(max_iterations, std::size_t(25)); ++n) { // step 6
    ++s.iterations;
    s.progress = (std::min)(0.95, 0.15 * double(n));
    const double t_c = coarsening_threshold(n), t_r = refinement_threshold(n);
    if(coarsening && is_coarsening_needed(s, t_c)) // step 3
      coarsen_by_rings(s, t_c, clean);
    else
      coarsening = false;
    const Refine_classes classes = classify_faces(s, t_r);
    if(is_refinement_sufficient(classes, s.mesh.number_of_faces())) {
      if(!coarsening) break;
      continue;
    }
    {
      Phase_scope phase(s, "refinement"); // step 4
      if(refine_faces(s, classes.high.empty() ? classes.low : classes.high) == 0) break;
    }
    clean_up(s, clean, 6, 5); // step 5
  }
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PAPER_SCHEDULE_H
