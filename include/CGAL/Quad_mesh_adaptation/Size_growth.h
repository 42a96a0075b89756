// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_SIZE_GROWTH_H
#define CGAL_QUAD_MESH_ADAPTATION_SIZE_GROWTH_H

#include <array>

namespace CGAL {
namespace Quad_mesh_adaptation {

/// \brief How fast the given size grows over the input mesh, and on how much of it faster than
/// quads can follow with good shape.
///
/// The slope is |h(a) - h(b)| / |a - b| between neighbouring samples: every face is sampled on a
/// regular grid of at least 3 x 3 points, so at the ends and the middle of every edge, and finer
/// where the mesh has few faces.  What lies between the samples is not seen.  In a mesh that has
/// its sizes mostly, faces are sampled at their corners only where the size hardly changes.
struct Size_growth
{
  /// The slope that quads follow with good shape.  In the metric that makes every face a unit
  /// square, a size of slope g that grows in one direction of the plane has g^2 of curvature in
  /// each face, and an irregular vertex of valence 3 or 5 stands for pi/2 of it.  So at least
  /// 2 g^2 / pi of the vertices are irregular, whatever the method: 4 % at 0.25, 16 % at 0.5, 64 %
  /// at 1.  From 0.5 on irregular vertices are too close to each other to be smoothed between, and
  /// the size changes so much within one face that "its size" depends on where it is taken.
  static constexpr double followed_slope = 0.5;
  /// Ratio of the sizes at two neighbouring samples from which the size jumps.
  static constexpr double least_jump = 1.5;

  double largest_slope = 0;
  std::array<double, 3> where = {}; ///< the middle of the samples with the largest slope
  /// Mean of the square over the ideal faces; slopes above one count as one.
  double mean_square_slope = 0;
  double steep_area_share = 0;  ///< share of the area with a slope above `followed_slope`
  double steep_faces_share = 0; ///< the same, as share of the ideal number of faces
  double steep_faces = 0;       ///< the ideal number of faces there
  double largest_jump = 1; ///< largest ratio of the sizes at neighbouring samples that are steep

  /// Is there at least a face's worth of surface that is too steep, or a jump?
  bool is_too_steep() const { return steep_faces >= 1 || largest_jump >= least_jump; }
};

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_SIZE_GROWTH_H
