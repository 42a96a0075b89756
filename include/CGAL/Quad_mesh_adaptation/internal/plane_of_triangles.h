// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PLANE_OF_TRIANGLES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PLANE_OF_TRIANGLES_H

#include <CGAL/Quad_mesh_adaptation/internal/Linked_triangles.h>
#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

struct Plane
{
  Vec normal = Vec(0, 0, 1), point = Vec(0, 0, 0);
};

// Do two triangles show at once that there is no plane?  None that is not tiny is turned by so
// much against a plane on which it lies.
inline bool is_clearly_bent(const Linked_triangles& m)
{
  constexpr std::size_t most = 64;
  constexpr double tiny = 1e-8, turned = 1e-3;
  double size2 = 0;
  for(const Vec& q : m.points()) size2 = (std::max)(size2, (q - m.points()[0]).squared_length());
  Vec first(0, 0, 0);
  for(std::size_t i = 0; i < most; ++i) {
    const std::array<Vec, 3> c = m.triangle(Index(i * m.number_of_triangles() / most));
    const Vec n = cross(c[1] - c[0], c[2] - c[0]);
    const double longest2 =
        (std::max)({ (c[1] - c[0]).squared_length(), (c[2] - c[1]).squared_length(),
                     (c[0] - c[2]).squared_length() });
    // 2 sizes are more than the largest distance from any corner
    if(!(n * n > 4 * tiny * tiny * size2 * longest2)) continue;
    if(first * first > 0 && norm(cross(first, normalized(n))) > turned) return true;
    if(!(first * first > 0)) first = normalized(n);
  }
  return false;
}

// Twice the area of a triangle as seen from above the plane.
inline double signed_area(const Linked_triangles& m, Index t, const Plane& plane)
{
  const std::array<Vec, 3> c = m.triangle(t);
  return cross(c[1] - c[0], c[2] - c[0]) * plane.normal;
}

// Triangles that face the other way, with twice so large an area, are no part of the shape of a
// plane where they are few and no patch consists of them.
inline bool is_only_tangled(const Linked_triangles& m, const Plane& plane, double backward)
{
  constexpr double few = 0.1;
  std::vector<double> area; // of patches, twice
  double all = 0;
  for(Index t = 0; t < Index(m.number_of_triangles()); ++t) {
    const double a = signed_area(m, t, plane);
    const std::size_t patch = std::size_t(m.patch(t));
    if(patch >= area.size()) area.resize(patch + 1, 0);
    area[patch] += a;
    all += std::abs(a);
  }
  return backward <= few * all &&
         std::all_of(area.begin(), area.end(), [](double a) { return a >= 0; });
}

inline bool lie_on(const Linked_triangles& m, const Plane& plane, double tolerance)
{
  const auto is_on = [&](const Vec& q) {
    return std::abs((q - plane.point) * plane.normal) <= tolerance;
  };
  // one after the other is quicker; if one is off, there may be no triangle there
  const bool are_all_on = std::all_of(m.points().begin(), m.points().end(), is_on);
  double backward = 0;
  for(Index t = 0; t < Index(m.number_of_triangles()); ++t) {
    const std::array<Vec, 3> c = m.triangle(t);
    if(!are_all_on && !std::all_of(c.begin(), c.end(), is_on)) return false;
    backward -= (std::min)(signed_area(m, t, plane), 0.);
  }
  return backward == 0 || is_only_tangled(m, plane, backward);
}

// The plane on which all triangles lie, if there is one.
inline std::optional<Plane> plane_of(const Linked_triangles& m)
{
  if(is_clearly_bent(m)) return std::nullopt;
  Plane plane;
  plane.point = m.triangle(0)[0];
  Vec n(0, 0, 0);
  double size = 0;
  for(Index t = 0; t < Index(m.number_of_triangles()); ++t) {
    const std::array<Vec, 3> c = m.triangle(t);
    n = n + cross(c[1] - c[0], c[2] - c[0]);
    size = (std::max)(size, (c[0] - plane.point).squared_length());
  }
  plane.normal = normalized(n);
  if(n * n > 0 && lie_on(m, plane, 1e-12 * std::sqrt(size))) return plane;
  return std::nullopt;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PLANE_OF_TRIANGLES_H
