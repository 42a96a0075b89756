// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MIRROR_PLANE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MIRROR_PLANE_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// A plane in which a mesh is its own mirror image, and what is mapped to what.  It cuts the mesh
// along edges: every face lies on one side.
struct Mirror_plane
{
  Vec normal = Vec(0, 0, 0); // unit length
  double offset = 0;         // normal * p of the points p of the plane
  int axis = -1;             // 0, 1, 2: the normal is exactly that axis; -1: any other
  std::vector<Index> vertex_partner, face_partner; // a vertex of the plane is its own partner
  std::vector<signed char> side;                   // of each face: 1 where the normal points to

  double height(const Vec& p) const { return normal * p - offset; }

  // In a coordinate plane all other coordinates keep their last bit.
  Vec reflect(const Vec& p) const
  {
    if(axis < 0) return p - 2 * height(p) * normal;
    return with_coordinate(p, 2 * offset - p[axis]);
  }
  Vec reflect_direction(const Vec& d) const
  {
    if(axis < 0) return d - 2 * (normal * d) * normal;
    return with_coordinate(d, -d[axis]);
  }
  Vec project(const Vec& p) const
  {
    if(axis < 0) return p - height(p) * normal;
    return with_coordinate(p, offset);
  }

  bool has_vertex(Index v) const
  {
    return v < Index(vertex_partner.size()) && vertex_partner[v] == v;
  }

  // The partner of original vertex v on the other side; -1 where there is none.
  Index other(Index v) const
  {
    return v < Index(vertex_partner.size()) && vertex_partner[v] != v ? vertex_partner[v]
                                                                      : Index(-1);
  }

private:
  Vec with_coordinate(const Vec& p, double x) const
  {
    std::array<double, 3> c = { p.x(), p.y(), p.z() };
    c[std::size_t(axis)] = x;
    return Vec(c[0], c[1], c[2]);
  }
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MIRROR_PLANE_H
