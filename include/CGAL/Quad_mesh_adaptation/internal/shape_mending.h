// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SHAPE_MENDING_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SHAPE_MENDING_H

#include <CGAL/Quad_mesh_adaptation/internal/size_guarantee.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Faces below `least`, and those about inner nodes of more than five faces.
inline std::vector<Index> faces_to_mend(const Adaptation_state& s, double least)
{
  const Quad_complex& m = s.mesh;
  const auto crowded = [&](Index v) {
    const Vertex_record& r = m.vertex(v);
    const int images = s.images_at(r);
    return images * r.faces > 5 && (r.carrier == Carrier::surface || images > 1) && !r.frozen;
  };
  std::vector<Index> list;
  for(Index f = 0; f < m.face_end(); ++f) {
    if(!m.is_face(f)) continue;
    const Quad q = m.quad(f);
    if(s.face_quality(s.corners(f), s.reference_normal(f)) < least ||
       std::any_of(q.begin(), q.end(), crowded))
      list.push_back(f);
  }
  return list;
}

constexpr double shape_floor = 0.52; // of the quality of faces

// The faces below the floor get what the energy of the whole mesh did not grant them: about them
// shape weighs more from round to round, faces may be added, and no operation or move leaves a face
// above its size that was not.
inline void mend_shapes(Adaptation_state& s, const Improvement_options& o, int max_rounds)
{
  Phase_scope phase(s, "clean-up");
  const Smoothing_weights gentle = s.smoothing;
  const Energy_weights energy = s.energy;
  Improvement_options mending = o;
  mending.keep_within_size = true;
  s.smoothing.keep_within_size = true;
  for(int round = 0; round < max_rounds; ++round) {
    const std::vector<Index> bad = faces_to_mend(s, shape_floor);
    if(bad.empty()) break;
    s.check_cancelled();
    s.energy.shape = (std::min)(2 * s.energy.shape, 16 * energy.shape);
    s.energy.valence = (std::min)(2 * s.energy.valence, 4 * energy.valence);
    s.smoothing.size *= 0.5;
    s.forget_energies();
    if(round % 4 == 3) split_too_large(s, faces_to_mend(s, 0.5)); // for more freedom
    smooth_near(s, faces_to_mend(s, shape_floor));
    mending.tolerance = round % 3 == 1 ? 1.5 : 0; // to get past what keeps it bad
    s.stirred = nodes_around(s, faces_to_mend(s, shape_floor), 2);
    const std::size_t done = Local_improvement(s, mending).passes(3);
    smooth_near(s, faces_to_mend(s, shape_floor));
    if(done == 0 && round > 3) break;
  }
  s.smoothing = gentle;
  s.energy = energy;
  s.forget_energies();
  settle(s, o, 2);
}

// The last resorts in turn: sizes first, then shapes, again where one has undone the other.
inline void enforce_sizes_and_shapes(Adaptation_state& s, const Improvement_options& o)
{
  enforce_sizes(s, o, 16);
  for(int turn = 0; turn < 3; ++turn) {
    mend_shapes(s, o, 12);
    if(faces_to_press(s).empty()) break;
    enforce_sizes(s, o, 12);
  }
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SHAPE_MENDING_H
