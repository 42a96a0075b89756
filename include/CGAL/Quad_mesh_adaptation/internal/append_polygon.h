// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_APPEND_POLYGON_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_APPEND_POLYGON_H

#include <CGAL/Quad_mesh_adaptation/internal/Value_tree.h>
#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

struct Valued_point
{
  Vec point;
  double value = 0;
};

// Triangles without an area are left out: nothing can lie inside them.
inline void append_triangle(const Valued_point& a, const Valued_point& b, const Valued_point& c,
                            std::vector<Valued_triangle>& soup)
{
  const Valued_triangle t = { { a.point, b.point, c.point }, { a.value, b.value, c.value } };
  if(t.has_area()) soup.push_back(t);
}

// A polygon as triangles: a quad is cut along the diagonal that keeps these well oriented, one with
// more corners around their mean.
inline void append_polygon(const std::vector<Valued_point>& p, std::vector<Valued_triangle>& soup)
{
  if(p.size() == 3) return append_triangle(p[0], p[1], p[2], soup);
  if(p.size() == 4) {
    const Vec normal = cross(p[2].point - p[0].point, p[3].point - p[1].point);
    const auto area = [&](std::size_t i, std::size_t j, std::size_t k) {
      return cross(p[j].point - p[i].point, p[k].point - p[i].point) * normal;
    };
    const auto least_area = [&](std::size_t i) { // of the two triangles at the diagonal from i
      const std::size_t far = (i + 2) % 4;
      return (std::min)(area(i, i + 1, far), area(i, far, (i + 3) % 4));
    };
    const std::size_t i = least_area(0) >= least_area(1) ? 0 : 1;
    append_triangle(p[i], p[i + 1], p[(i + 2) % 4], soup);
    append_triangle(p[i], p[(i + 2) % 4], p[(i + 3) % 4], soup);
    return;
  }
  Valued_point mean = { Vec(0, 0, 0), 0. };
  for(const Valued_point& c : p) {
    mean.point = mean.point + c.point / double(p.size());
    mean.value += c.value / double(p.size());
  }
  for(std::size_t i = 0; i < p.size(); ++i)
    append_triangle(mean, p[i], p[(i + 1) % p.size()], soup);
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_APPEND_POLYGON_H
