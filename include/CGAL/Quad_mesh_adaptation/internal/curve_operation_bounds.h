// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CURVE_OPERATION_BOUNDS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CURVE_OPERATION_BOUNDS_H

#include <CGAL/Quad_mesh_adaptation/internal/energy_bounds.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/border_half_ring.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/crease_collapse.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Bounds of the change of energy by operations at curves: no outcome can be lower.

inline double border_split_bound(Adaptation_state& s, const Energy_bounds& bounds,
                                 const Border_pair& b)
{
  const Quad_complex& m = s.mesh;
  const double ends = s.cached_energy(m.face(b.left)) + s.cached_energy(m.face(b.right));
  return 6 * s.energy.face + 2 * s.energy.valence + bounds.valence_change(b.p, 1) +
         bounds.valence_change(b.q, 1) - ends;
}

// Faces at the node that is left of a half-ring.
inline int faces_after_half_ring(const Quad_complex& m, const Border_pair& b)
{
  return m.vertex(b.a).faces + m.vertex(b.c).faces + m.vertex(b.m).faces - 4;
}

inline double half_ring_bound(Adaptation_state& s, const Energy_bounds& bounds,
                              const Border_pair& b)
{
  const Quad_complex& m = s.mesh;
  const auto own = [&](Index u) { return s.valence_energy(m.vertex(u).faces, m.vertex(u)); };
  const double ends = s.cached_energy(m.face(b.left)) + s.cached_energy(m.face(b.right));
  const Index keep = carrier_rank(m.vertex(b.a)) > 1   ? b.a
                     : carrier_rank(m.vertex(b.c)) > 1 ? b.c
                                                       : b.v;
  const double valences = s.valence_energy(faces_after_half_ring(m, b), m.vertex(keep)) - own(b.a) -
                          own(b.c) - own(b.m) - (keep == b.v ? own(b.v) : 0.) +
                          bounds.valence_change(b.p, -1) + bounds.valence_change(b.q, -1);
  return valences - bounds.slack(b.a) - bounds.slack(b.c) - bounds.slack(b.m) + ends -
         4 * s.energy.face;
}

// Faces at the node that is left of a crease collapse.
inline int faces_after_crease_collapse(const Quad_complex& m, const Crease_star& star)
{
  return m.vertex(star.first(m)).faces + m.vertex(star.last(m)).faces + m.vertex(star.v).faces - 6;
}

inline double crease_collapse_bound(Adaptation_state& s, const Energy_bounds& bounds,
                                    const Crease_star& star)
{
  const Quad_complex& m = s.mesh;
  double bound = -2 * s.energy.face + s.valence_energy(faces_after_crease_collapse(m, star),
                                                       m.vertex(kept_node(m, star)));
  for(Index u : { star.first(m), star.last(m), star.v }) {
    const Vertex_record& r = m.vertex(u);
    bound -= s.valence_energy(r.faces, r) + side_energy(s, side_difference(s, u)) + bounds.slack(u);
  }
  for(const std::vector<Index>& side : star.spokes)
    for(std::size_t i = 0; i + 1 < side.size(); ++i) {
      const bool is_first = i == 0, is_last = i + 2 == side.size();
      if(!is_first) bound += bounds.valence_change(m.target(side[i]), -1);
      if(is_first == is_last) // alone, or between others
        bound += bounds.valence_change(m.target(m.next(side[i])), is_first ? -1 : 1);
    }
  return bound;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CURVE_OPERATION_BOUNDS_H
