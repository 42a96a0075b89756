// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHECK_FEATURE_ANGLE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHECK_FEATURE_ANGLE_H

#include <CGAL/Quad_mesh_adaptation/internal/number_text.h>

#include <string>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// What is wrong with a value of `feature_angle()`; empty if nothing is.
inline std::string check_feature_angle(double degrees)
{
  if(degrees > 0 && degrees <= 180) return {};
  return "feature_angle(" + number_text(degrees) +
         ") is not an angle above 0 and up to 180 degrees";
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHECK_FEATURE_ANGLE_H
