// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ADVISE_ON_REFERENCE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ADVISE_ON_REFERENCE_H

#include <CGAL/Quad_mesh_adaptation/Adaptation_report.h>
#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/Input_mesh.h>
#include <CGAL/Quad_mesh_adaptation/internal/number_text.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

inline double mean_edge_length(const Input_mesh& in)
{
  double sum = 0;
  for(const Quad& q : in.quads)
    sum += mean_edge_length(
        Corners{ in.points[q[0]], in.points[q[1]], in.points[q[2]], in.points[q[3]] });
  return sum / double(in.quads.size());
}

// Tells of vertices that had to go far to come to the reference surface: no coarse mesh of it has
// them farther away than an edge is long, but one of another part, or in other units, has.
inline void advise_on_reference(const Input_mesh& in, const Adaptation_state& s,
                                Adaptation_report& report)
{
  const double edge = mean_edge_length(in);
  double farthest = 0;
  Index which = -1;
  for(Index v = 0; v < Index(in.points.size()); ++v) {
    if(!s.mesh.is_vertex(v)) continue;
    const double moved = distance(in.points[v], s.mesh.point(v));
    if(moved <= farthest) continue;
    farthest = moved;
    which = v;
  }
  if(farthest <= edge) return;
  report.advice.push_back(
      "the vertex of the input at " + point_text(in.points[std::size_t(which)]) + " lies " +
      number_text(farthest) + " away from the reference surface, " + rounded_text(farthest / edge) +
      " mean edge lengths: are both of the same part, at the same place and in the same units?");
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ADVISE_ON_REFERENCE_H
