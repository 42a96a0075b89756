// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_AABB_TREES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_AABB_TREES_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_segment_primitive_3.h>
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif

#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Trees into vectors of triangles and of segments, by the names of either CGAL.
using Triangle_iterator = std::vector<Core_kernel::Triangle_3>::const_iterator;
using Segment_iterator = std::vector<Core_kernel::Segment_3>::const_iterator;
#if CGAL_VERSION_NR >= 1060000000
template <typename Primitive>
using Aabb_tree = CGAL::AABB_tree<CGAL::AABB_traits_3<Core_kernel, Primitive>>;
using Triangle_aabb_tree = Aabb_tree<AABB_triangle_primitive_3<Core_kernel, Triangle_iterator>>;
using Segment_aabb_tree = Aabb_tree<AABB_segment_primitive_3<Core_kernel, Segment_iterator>>;
#else
template <typename Primitive>
using Aabb_tree = CGAL::AABB_tree<CGAL::AABB_traits<Core_kernel, Primitive>>;
using Triangle_aabb_tree = Aabb_tree<AABB_triangle_primitive<Core_kernel, Triangle_iterator>>;
using Segment_aabb_tree = Aabb_tree<AABB_segment_primitive<Core_kernel, Segment_iterator>>;
#endif

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_AABB_TREES_H
