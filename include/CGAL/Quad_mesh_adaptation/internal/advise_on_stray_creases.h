// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ADVISE_ON_STRAY_CREASES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ADVISE_ON_STRAY_CREASES_H

#include <CGAL/Quad_mesh_adaptation/Adaptation_report.h>
#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>
#include <CGAL/Quad_mesh_adaptation/internal/number_text.h>

#include <cmath>
#include <string>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Tells of creases that were found and not kept, since they could be meant as some.
inline void advise_on_stray_creases(const Adaptation_state& s, Adaptation_report& report)
{
  const Creases_taken_back& c = s.creases_taken_back;
  if(c.creases == 0) return;
  const bool is_one = c.creases == 1;
  report.advice.push_back(
      std::to_string(c.creases) + (is_one ? " crease of " : " creases of ") +
      std::to_string(c.edges) + (c.edges == 1 ? " edge" : " edges") +
      (is_one ? ", found by its angle, ends" : ", found by their angles, end") +
      " on the surface and " + (is_one ? "turns" : "turn") +
      " less than twice as much as the edges beside: " + (is_one ? "it is" : "they are") +
      " taken for " + (is_one ? "a part" : "parts") +
      " of a smooth surface in few faces and not kept; the sharpest edge turns by " +
      std::to_string(std::lround(180 / pi * c.turn)) + " degrees at " + point_text(c.where) +
      ", mark it as constrained if it is a crease");
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ADVISE_ON_STRAY_CREASES_H
