// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SHAPE_MENDING_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SHAPE_MENDING_H

#include <CGAL/Quad_mesh_adaptation/internal/size_guarantee.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

inline std::vector<Index> faces_of_bad_shape(const Adaptation_state& s, double least)
{
  std::vector<Index> list;
  for(Index f = 0; f < s.mesh.face_end(); ++f)
    if(s.mesh.is_face(f) && s.face_quality(s.corners(f), s.reference_normal(f)) < least)
      list.push_back(f);
  return list;
}

// The faces below the floor get what the energy of the whole mesh did not grant them: about them
// shape weighs more from round to round, faces may be added, and no operation or move leaves a face
// above its size that was not.
inline void mend_shapes(Adaptation_state& s, const Improvement_options& o, int max_rounds)
{
  constexpr double floor = 0.55;
  Phase_scope phase(s, "clean-up");
  const Smoothing_weights gentle = s.smoothing;
  const Energy_weights energy = s.energy;
  Improvement_options mending = o;
  mending.keep_within_size = true;
  s.smoothing.keep_within_size = true;
  for(int round = 0; round < max_rounds; ++round) {
    const std::vector<Index> bad = faces_of_bad_shape(s, floor);
    if(bad.empty()) break;
    s.check_cancelled();
    s.energy.shape *= 2;
    s.smoothing.size *= 0.5;
    s.forget_energies();
    smooth_near(s, bad);
    const std::vector<char> near = nodes_around(s, bad, 2);
    mending.tolerance = round % 3 == 1 ? 1.5 : 0; // to get past what keeps it bad
    Local_improvement improvement(s, mending);
    for(Index v = 0; v < Index(near.size()); ++v)
      if(near[v]) improvement.activate(v);
    std::size_t done = 0;
    for(int pass = 0; pass < 3; ++pass) done += improvement.pass();
    smooth_near(s, faces_of_bad_shape(s, floor));
    if(done == 0 && round > 3) break;
  }
  s.smoothing = gentle;
  s.energy = energy;
  s.forget_energies();
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SHAPE_MENDING_H
