// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_RESERVE_IN_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_RESERVE_IN_H

#include <CGAL/boost/graph/helpers.h>

#include <cstddef>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Room for so many more in a graph, for models that have it: arrays that grow as they like may take
// twice what is needed.
template <typename Graph>
auto reserve_in(Graph& g, std::size_t vertices, std::size_t edges, std::size_t faces, int)
    -> decltype(reserve(g, vertices, edges, faces), void())
{
  reserve(g, num_vertices(g) + vertices, num_edges(g) + edges, num_faces(g) + faces);
}
template <typename Graph>
void reserve_in(Graph&, std::size_t, std::size_t, std::size_t, long)
{
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_RESERVE_IN_H
