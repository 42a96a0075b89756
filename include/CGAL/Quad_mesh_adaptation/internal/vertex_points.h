// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_VERTEX_POINTS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_VERTEX_POINTS_H

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The parameter `vertex_point_map` or, by default, the internal map of the mesh.
template <class Graph, class NP>
auto vertex_points(const Graph& mesh, const NP& np)
{
  return parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                      get_const_property_map(vertex_point, mesh));
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_VERTEX_POINTS_H
