// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_JUDGE_SIZES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_JUDGE_SIZES_H

#include <CGAL/Quad_mesh_adaptation/Adaptation_report.h>
#include <CGAL/Quad_mesh_adaptation/internal/faults.h>
#include <CGAL/Quad_mesh_adaptation/internal/number_text.h>
#include <CGAL/Quad_mesh_adaptation/parameters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Largest size ratio that a face may have at the end, measured on the size as it was given.
inline double largest_allowed(Aim aim)
{
  return aim == Aim::nearest ? std::sqrt(2.) * size_tolerance : size_tolerance;
}

// How the sizes came out, for status and message.
inline void judge_sizes(Adaptation_report& r, bool paper, Aim aim, std::size_t large)
{
  const std::size_t all = r.after.faces;
  // the paper calls refinement sufficient below 3 % of low-refine and 0.5 % of high-refine faces
  const bool met = paper ? double(large) <= 0.035 * double(all) : large == 0;
  if(met) return;
  const Size_ratio_table& t = paper ? r.after.size_ratio : r.after.strict_size_ratio;
  r.status = Adaptation_status::sizes_not_met;
  r.message = std::to_string(large) + " of " + std::to_string(all) + " faces are " +
              (aim == Aim::nearest ? "more than a factor of sqrt(2) larger than asked"
                                   : "larger than asked") +
              ", the largest " + number_text(t.max) + " times its size";
}

// The same for the distance to the reference, if one was asked for.
inline void judge_distances(Adaptation_report& r, double allowed, std::size_t far)
{
  if(far == 0) return;
  r.status = Adaptation_status::sizes_not_met;
  if(!r.message.empty()) r.message += "; ";
  r.message += std::to_string(far) + " of " + std::to_string(r.after.faces) +
               " faces are farther than " + number_text(allowed) +
               " from the reference, the farthest " +
               number_text((std::max)(r.after.mesh_to_reference, r.after.reference_to_mesh));
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_JUDGE_SIZES_H
