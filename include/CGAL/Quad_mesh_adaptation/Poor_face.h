// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_POOR_FACE_H
#define CGAL_QUAD_MESH_ADAPTATION_POOR_FACE_H

#include <cstddef>

namespace CGAL {
namespace Quad_mesh_adaptation {

/// What keeps a face from a better shape.
enum class Shape_limit
{
  none,          ///< nothing that is known
  feature_angle, ///< two feature edges meet at one of its corners, at a smaller angle than the
                 ///< shape asks for; faces beside it could be better, whatever the angle
  held_nodes,    ///< three or four of its nodes are corners of features or held by the caller
  curved_surface ///< the surface turns by more than 60 degrees within the face
};

/// A face with a scaled Jacobian below `floor`, and why.
struct Poor_face
{
  static constexpr double floor = 0.45;

  std::size_t face = 0; ///< position in the iteration order of the mesh's faces
  double scaled_jacobian = 0;
  Shape_limit limit = Shape_limit::none;
  double angle = 0;       ///< between the feature edges, degrees; `Shape_limit::feature_angle` only
  std::size_t vertex = 0; ///< where they meet, as a position; `Shape_limit::feature_angle` only
};

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_POOR_FACE_H
