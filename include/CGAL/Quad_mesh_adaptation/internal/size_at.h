// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SIZE_AT_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SIZE_AT_H

#include <CGAL/number_utils.h>

#include <type_traits>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// A sizing field is a number or a callable.
template <typename SizingField, typename Point>
double size_at(const SizingField& sizing, const Point& p)
{
  if constexpr(std::is_arithmetic_v<SizingField>)
    return (void(p), double(sizing));
  else
    return CGAL::to_double(sizing(p));
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SIZE_AT_H
