// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_EXAMPLES_POLAR_PLATE_H
#define QUAD_MESH_ADAPTATION_EXAMPLES_POLAR_PLATE_H

#include "Plane_mesh.h"

#include <cmath>

namespace plane_stress {

/// The quarter x >= 0, y >= 0 of the plate [-length,length] x [-width,width] with a hole of
/// radius 1, in `sectors` (even) times `layers` quads, fine at the hole: to check the analysis
/// against handbook values for other shapes than the paper's.
inline Plane_mesh polar_plate(double length, double width, int sectors, int layers)
{
  const double quarter_turn = std::acos(-1.) / 2;
  Plane_mesh mesh;
  for(int i = 0; i <= sectors; ++i) {
    const double t = double(i) / sectors;
    const Eigen::Vector2d hole(i == sectors ? 0 : std::cos(t * quarter_turn),
                               i == 0 ? 0 : std::sin(t * quarter_turn));
    const Eigen::Vector2d far = 2 * i <= sectors ? Eigen::Vector2d(length, 2 * t * width)
                                                 : Eigen::Vector2d(2 * (1 - t) * length, width);
    for(int l = 0; l <= layers; ++l) {
      const double w = std::expm1(3. * l / layers) / std::expm1(3.);
      mesh.nodes.push_back((1 - w) * hole + w * far);
    }
  }
  for(int i = 0; i < sectors; ++i)
    for(int l = 0; l < layers; ++l) {
      const int v = i * (layers + 1) + l;
      mesh.quads.push_back({ v, v + 1, v + layers + 2, v + layers + 1 });
    }
  return mesh;
}

} // namespace plane_stress

#endif // QUAD_MESH_ADAPTATION_EXAMPLES_POLAR_PLATE_H
