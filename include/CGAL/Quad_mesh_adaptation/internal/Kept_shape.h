// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_KEPT_SHAPE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_KEPT_SHAPE_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/Distance_measure.h>
#include <CGAL/Quad_mesh_adaptation/internal/curve_lengths.h>
#include <CGAL/Quad_mesh_adaptation/internal/face_energy.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// What meshes for the same sizes have kept of the given shape, so that none of them is preferred
// for having cut off more: the lengths of curves, and how far parts of the surface are left behind.
// Few faces can do without a limb, and are never so few as then.
class Kept_shape
{
public:
  explicit Kept_shape(const Adaptation_state& s)
      : curves_(curves_that_kept_length(s)), left_behind_(distance_left_behind(s)),
        mean_edge_(mean_edge(s))
  {
  }

  // Does a mesh that is better otherwise keep it?  Then it is preferred, and others are compared
  // with that from now on; small losses do not add up.
  bool accepts(const Adaptation_state& s)
  {
    constexpr double much = 1.5, little = 0.25; // of an edge
    if(!have_kept_length(s, curves_)) return false;
    const double now = distance_left_behind(s);
    if(now > (std::max)(much * left_behind_, little * mean_edge_)) return false;
    curves_ = curves_that_kept_length(s);
    left_behind_ = (std::min)(left_behind_, now);
    return true;
  }

private:
  static double distance_left_behind(const Adaptation_state& s)
  {
    return s.surface.is_planar() ? 0 : Distance_measure(s).from_reference();
  }

  static double mean_edge(const Adaptation_state& s)
  {
    double sum = 0;
    for(Index f : s.mesh.faces()) sum += mean_edge_length(s.corners(f));
    return sum / (std::max)(double(s.mesh.number_of_faces()), 1.);
  }

  std::vector<char> curves_;
  double left_behind_;
  const double mean_edge_; // of the first mesh
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_KEPT_SHAPE_H
