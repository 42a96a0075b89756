// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CLOSEST_POINT_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CLOSEST_POINT_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <array>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

enum class Triangle_feature
{
  inside,
  edge,
  corner
};

struct Closest_on_triangle
{
  Vec point;
  Triangle_feature feature = Triangle_feature::inside;
  int index = 0; // of the edge (from corner index to index + 1) or of the corner
  bool is_edge() const { return feature == Triangle_feature::edge; }
};

// Closest point of a triangle and the feature it lies on, by Voronoi regions (Ericson, Real-Time
// Collision Detection, section 5.1.5).
inline Closest_on_triangle closest_on_triangle(const Vec& p, const std::array<Vec, 3>& c)
{
  const Vec ab = c[1] - c[0], ac = c[2] - c[0], ap = p - c[0];
  const double d1 = ab * ap, d2 = ac * ap;
  if(d1 <= 0 && d2 <= 0) return { c[0], Triangle_feature::corner, 0 };
  const Vec bp = p - c[1];
  const double d3 = ab * bp, d4 = ac * bp;
  if(d3 >= 0 && d4 <= d3) return { c[1], Triangle_feature::corner, 1 };
  const Vec cp = p - c[2];
  const double d5 = ab * cp, d6 = ac * cp;
  if(d6 >= 0 && d5 <= d6) return { c[2], Triangle_feature::corner, 2 };
  const double vc = d1 * d4 - d3 * d2;
  if(vc <= 0 && d1 >= 0 && d3 <= 0)
    return { c[0] + (d1 / (d1 - d3)) * ab, Triangle_feature::edge, 0 };
  const double vb = d5 * d2 - d1 * d6;
  if(vb <= 0 && d2 >= 0 && d6 <= 0)
    return { c[0] + (d2 / (d2 - d6)) * ac, Triangle_feature::edge, 2 };
  const double va = d3 * d6 - d5 * d4;
  if(va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    return { c[1] + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c[2] - c[1]), Triangle_feature::edge,
             1 };
  const double w = 1 / (va + vb + vc);
  return { c[0] + (vb * w) * ab + (vc * w) * ac, Triangle_feature::inside, 0 };
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CLOSEST_POINT_H
