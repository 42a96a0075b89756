// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SIZE_AT_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SIZE_AT_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <CGAL/number_utils.h>

#include <type_traits>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// A sizing field is a number or a callable on points.
template <typename SizingField, typename Point>
double size_at(const SizingField& sizing, const Point& p)
{
  if constexpr(std::is_arithmetic_v<SizingField>)
    return (void(p), double(sizing));
  else
    return CGAL::to_double(sizing(p));
}

// The same on positions, for a callable on `Point`, which must still be there then.
template <typename Point, typename SizingField>
Size_function size_function(const SizingField& sizing)
{
  if constexpr(std::is_arithmetic_v<SizingField>)
    return [sizing](const Vec&) { return double(sizing); };
  else
    return [&sizing](const Vec& p) { return CGAL::to_double(sizing(Point(p.x(), p.y(), p.z()))); };
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SIZE_AT_H
