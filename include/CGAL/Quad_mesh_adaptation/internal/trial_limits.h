// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TRIAL_LIMITS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TRIAL_LIMITS_H

#include <CGAL/Quad_mesh_adaptation/internal/operation_candidates.h>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// How far the energy of a trial may be from a gain for it to go on.  Relaxing is most of the work
// of the whole schedule, so hopeless trials are to end early.  From the logs of runs on plates,
// nosecone, hole, spot and pawn, refined and coarsened: of the trials that paid in the end, 995 of
// a thousand were within these limits.
struct Trial_limits
{
  double after_a_sweep;           // relax once more
  double for_a_halo;              // try again with more nodes free to move: what that gains at most
  double after_a_sweep_with_halo; // relax once more with these
};

// The sweeps free more energy where shape weighs more, as it does where shapes are mended.
inline Trial_limits trial_limits(Operation_kind k, const Energy_weights& energy)
{
  const double weight = energy.shape / Energy_weights().shape;
  switch(k) {
  case Operation_kind::close:
    return { 3.8 * weight, 3, 0.5 * weight };
  case Operation_kind::open:
    return { 6.3 * weight, 4, 0.8 * weight };
  case Operation_kind::rotate:
    return { 6.3 * weight, 4, weight };
  default:
    return { 7.3 * weight, 6, 1.5 * weight };
  }
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TRIAL_LIMITS_H
