// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_STATE_OPTIONS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_STATE_OPTIONS_H

#include <CGAL/Quad_mesh_adaptation/internal/Input_mesh.h>
#include <CGAL/Quad_mesh_adaptation/internal/User_projector.h>
#include <CGAL/Quad_mesh_adaptation/parameters.h>

#include <functional>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

struct Feature_options
{
  double feature_angle = default_feature_angle; // degrees
};

// What nodes are to stay on, beside the input itself.
struct Geometry_options
{
  const Triangle_soup* reference = nullptr;
  bool smooth = false;
  User_projector projector;                  // empty: none
  std::function<Vec(const Vec&)> curve_lift; // empty: none

  // Nodes stay on the facets and polylines of the input.
  bool is_flat_input() const { return !reference && !smooth && !projector && !curve_lift; }
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_STATE_OPTIONS_H
