// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CREASE_SIDES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CREASE_SIDES_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// A node on a curve between two patches wants two faces on either side: one and three are four as
// well, but the one is flat there.  With a and b faces, (a - 2)^2 + (b - 2)^2 is half of
// (a + b - 4)^2 + (a - b)^2; the valence term has the first part in full, this is the second.

inline bool is_on_crease(const Adaptation_state& s, const Vertex_record& r)
{
  return r.carrier == Carrier::curve && !s.curves[r.curve].is_border();
}

inline double side_energy(const Adaptation_state& s, int difference)
{
  return 0.5 * s.energy.valence * difference * difference;
}

// Counts faces by side, which the patches tell apart; where a curve has the same patch on both
// sides they do not, and nothing is asked.
class Side_count
{
public:
  void add(Index patch)
  {
    if(here_ + there_ == 0) patch_ = patch;
    ++(patch == patch_ ? here_ : there_);
  }
  int difference() const { return there_ == 0 ? 0 : here_ - there_; }

private:
  Index patch_ = -1;
  int here_ = 0, there_ = 0;
};

// By how many faces the sides of vertex v differ; 0 if it is on no crease.
inline int side_difference(const Adaptation_state& s, Index v)
{
  const Quad_complex& m = s.mesh;
  if(!is_on_crease(s, m.vertex(v))) return 0;
  Side_count sides;
  for(Index h : m.outgoing(v)) sides.add(m.patch(m.face(h)));
  return sides.difference();
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CREASE_SIDES_H
