// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_USER_PROJECTOR_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_USER_PROJECTOR_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <cmath>
#include <functional>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The caller's projector: a point of his surface, and its normal or zero if he gives none.
using User_projector = std::function<Surface_point(const Vec&)>;

// Thrown where a projector gives no point, caught at the public header.
struct Bad_projection
{
  Vec where;
};

// What f gives for p, with a unit normal to the side of `facing`.
inline Surface_point checked_projection(const User_projector& f, const Vec& p, const Vec& facing)
{
  Surface_point q = f(p);
  if(!is_finite(q.point) || !is_finite(q.normal)) throw Bad_projection{ p };
  q.normal = normalized(q.normal);
  const double side = q.normal * facing;
  if(!(std::abs(side) > 0)) return { q.point, facing };
  if(side < 0) q.normal = -q.normal;
  return q;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_USER_PROJECTOR_H
