// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SAME_FLAT_SURFACE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SAME_FLAT_SURFACE_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

inline bool runs_along(const Feature_curve& a, const Feature_curve& b, double tolerance)
{
  for(const Vec& p : a.points())
    if(distance(b.point(b.nearest(p)), p) > tolerance) return false;
  return true;
}

// Do two states of the same input, one built with a separate reference surface and one without,
// put all nodes on the same flat surface with the same curves?  The reference then says nothing
// that the input does not say.
inline bool is_same_flat_surface(const Adaptation_state& a, const Adaptation_state& b)
{
  if(!a.surface.is_planar() || !b.surface.is_planar()) return false;
  if(a.curves.size() != b.curves.size() || a.mesh.vertex_end() != b.mesh.vertex_end()) return false;
  double length = 0;
  for(const Feature_curve& c : a.curves) length += c.length();
  const double tolerance = 1e-12 * length;
  for(std::size_t i = 0; i < a.curves.size(); ++i) {
    const Feature_curve &c = a.curves[i], &d = b.curves[i];
    if(c.is_closed() != d.is_closed() || std::abs(c.length() - d.length()) > tolerance ||
       !runs_along(c, d, tolerance) || !runs_along(d, c, tolerance))
      return false;
  }
  for(Index v = 0; v < a.mesh.vertex_end(); ++v)
    if(distance(a.mesh.point(v), b.mesh.point(v)) > tolerance) return false;
  return true;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SAME_FLAT_SURFACE_H
