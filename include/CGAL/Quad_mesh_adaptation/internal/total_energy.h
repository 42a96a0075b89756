// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TOTAL_ENERGY_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TOTAL_ENERGY_H

#include <CGAL/Quad_mesh_adaptation/internal/crease_sides.h>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// What every accepted operation lowers.
inline double total_energy(Adaptation_state& s)
{
  s.prepare_coverage();
  double sum = 0;
  for(Index f : s.mesh.faces()) sum += s.cached_energy(f) + s.coverage.cost(f);
  for(Index v : s.mesh.vertices())
    sum += s.valence_energy(s.mesh.vertex(v).faces, s.mesh.vertex(v)) +
           side_energy(s, side_difference(s, v));
  return sum;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TOTAL_ENERGY_H
