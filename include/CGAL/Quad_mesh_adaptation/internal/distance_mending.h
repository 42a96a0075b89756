// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISTANCE_MENDING_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISTANCE_MENDING_H

#include <CGAL/Quad_mesh_adaptation/internal/Distance_measure.h>
#include <CGAL/Quad_mesh_adaptation/internal/Mesh_keeper.h>
#include <CGAL/Quad_mesh_adaptation/internal/distance_guard.h>
#include <CGAL/Quad_mesh_adaptation/internal/shape_mending.h>
#include <CGAL/Quad_mesh_adaptation/internal/size_guarantee.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The edges of a face that are off the reference by a good part of what is allowed; its longer ones
// if none is.
inline std::vector<Index> edges_off_reference(const Adaptation_state& s, Index f)
{
  constexpr double part = 0.5;
  std::vector<Index> list;
  for(Index h = 4 * f; h < 4 * f + 4; ++h)
    if(distance_of_edge(s, h) > part * s.max_distance) list.push_back(h);
  return list.empty() ? longer_edges(s, f) : list;
}

// The faces farther from the reference than allowed, and by how much in all.
struct Far_faces
{
  std::vector<Index> faces;
  double excess = 0; // sum of d / allowed - 1

  explicit Far_faces(const Adaptation_state& s)
  {
    const Distance_measure distances(s, s.max_distance);
    for(Index f : s.mesh.faces()) {
      if(!(distances.of(f) > s.max_distance)) continue;
      faces.push_back(f);
      excess += distances.of(f) / s.max_distance - 1;
    }
  }
};

// The part of the bound that the guard holds after so many rounds of splits.
inline double guarded_part(int round)
{
  constexpr double first = 0.8, last = 0.2, step = 0.1;
  constexpr int gentle = 3; // rounds, enough in most cases
  return (std::max)(last, first - step * (std::max)(round + 1 - gentle, 0));
}

// Splits faces that are too far from the reference, until none is, which it tells, or that does not
// help.  What comes after a round of splits is kept within the bound by the guard that all moves
// and operations pass.  That looks at few points, and from the faces only; so what it lets pass may
// be too far nevertheless, and it lets less pass from round to round.
inline bool split_in_rounds(Adaptation_state& s, const Improvement_options& o)
{
  constexpr int max_rounds = 16, most_in_vain = 4; // in a row
  const double allowed = s.max_distance;
  std::optional<Mesh_keeper> best;
  double least = 0;
  for(int round = 0, in_vain = 0; round < max_rounds; ++round) {
    s.check_cancelled();
    const Far_faces far(s);
    if(far.faces.empty()) return true;
    in_vain = best && far.excess >= 0.9 * least ? in_vain + 1 : 0;
    if(in_vain == most_in_vain) break;
    if(!best || far.excess < least) {
      best.emplace(s);
      least = far.excess;
    }
    s.restless.assign(s.mesh.vertex_end(), 0);
    s.stirred.assign(s.mesh.vertex_end(), 0);
    if(split_too_large(s, far.faces, edges_off_reference) == 0) break;
    s.limit_distance(guarded_part(round) * allowed);
    smooth(s, 3);
    Local_improvement(s, o).passes(2);
    smooth(s, 3);
    s.limit_distance(allowed);
  }
  const double excess = Far_faces(s).excess;
  if(excess > least) best->restore();
  return excess == 0;
}

// The same, where no face becomes too large by what follows the splits.
inline bool split_faces_too_far(Adaptation_state& s, Improvement_options o)
{
  const bool is_kept = s.smoothing.keep_within_size;
  o.keep_within_size = s.smoothing.keep_within_size = true;
  const bool is_done = split_in_rounds(s, o);
  s.smoothing.keep_within_size = is_kept;
  return is_done;
}

// The last resort where faces are farther from the reference than allowed, with shapes mended then;
// for any other mesh, nothing.
inline void mend_distances(Adaptation_state& s, const Improvement_options& o)
{
  if(!is_distance_limited(s) || Far_faces(s).faces.empty()) return;
  Phase_scope phase(s, "distance bound");
  const bool within = split_faces_too_far(s, o);
  Mesh_keeper split(s);
  Places_in_vain in_vain;
  mend_shapes(s, o, 8, in_vain);
  if(!split_faces_too_far(s, o) && within) split.restore();
}

// With the sizes given, not those lowered for the distance: faces that are larger are pressed upon
// as far as the bound leaves room.
inline void enforce_sizes_within_bound(Adaptation_state& s, const Improvement_options& o)
{
  if(!is_distance_limited(s) || faces_to_press(s).empty()) return;
  const bool within = Far_faces(s).faces.empty();
  Mesh_keeper before(s);
  enforce_sizes(s, o, 12);
  if(!split_faces_too_far(s, o) && within) before.restore();
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISTANCE_MENDING_H
