// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_GEOMETRY_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_GEOMETRY_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>

#include <boost/config.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The heavy code runs on doubles, whatever the kernel of the caller's mesh: one instantiation,
// and a vertex that did not move keeps the caller's point untouched.
using Core_kernel = CGAL::Simple_cartesian<double>;
using Vec = Core_kernel::Vector_3; // a position or a difference of positions
using Index = std::int32_t;        // vertex, face or half-edge number; -1 is none
using Quad = std::array<Index, 4>;
using Corners = std::array<Vec, 4>; // of a face

constexpr double pi = 3.14159265358979323846;

// A point of a surface with its unit normal.
struct Surface_point
{
  Vec point, normal;
};

// The caller's sizing field behind one type: target edge length at a position.
using Size_function = std::function<double(const Vec&)>;

// A point or vector of the caller's kernel.
template <typename Point>
Vec to_vec(const Point& p)
{
  return Vec(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
}

// Small functions are called in the innermost loops, where compilers do not always inline them.
inline double dot(const Vec& a, const Vec& b) { return a * b; }
BOOST_FORCEINLINE Vec cross(const Vec& a, const Vec& b)
{
  return Vec(a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
             a.x() * b.y() - a.y() * b.x());
}
inline double norm(const Vec& a) { return std::sqrt(a * a); }
inline double distance(const Vec& a, const Vec& b) { return norm(a - b); }
BOOST_FORCEINLINE Vec normalized(const Vec& a)
{
  const double n = norm(a);
  return n > 0 ? a / n : Vec(0, 0, 0);
}
// In radians, up to pi; 0 if one of them is zero.
inline double angle_between(const Vec& a, const Vec& b)
{
  return std::atan2(norm(cross(a, b)), a * b);
}
inline bool is_finite(const Vec& a)
{
  return std::isfinite(a.x()) && std::isfinite(a.y()) && std::isfinite(a.z());
}

inline Vec face_centre(const Corners& p) { return 0.25 * (p[0] + p[1] + p[2] + p[3]); }

// Two unit vectors across a unit normal and each other, the same for the same normal.
inline std::array<Vec, 2> tangents(const Vec& normal)
{
  const Vec axis = std::abs(normal.x()) < 0.6 ? Vec(1, 0, 0) : Vec(0, 1, 0);
  const Vec u = normalized(cross(normal, axis));
  return { u, cross(normal, u) };
}

// How far a quadrilateral is from plane: the way between the middles of its diagonals, along the
// normal, over half its mean edge length.
inline double warp(const Corners& p)
{
  double edges = 0;
  for(int i = 0; i < 4; ++i) edges += distance(p[i], p[(i + 1) & 3]);
  const Vec n = normalized(cross(p[2] - p[0], p[3] - p[1]));
  return edges > 0 ? 4 * std::abs((p[0] - p[1] + p[2] - p[3]) * n) / edges : 0.;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_GEOMETRY_H
