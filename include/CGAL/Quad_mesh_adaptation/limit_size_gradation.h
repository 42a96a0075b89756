// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_LIMIT_SIZE_GRADATION_H
#define CGAL_QUAD_MESH_ADAPTATION_LIMIT_SIZE_GRADATION_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>
#include <CGAL/Quad_mesh_adaptation/internal/lower_values.h>
#include <CGAL/Quad_mesh_adaptation/internal/mesh_arrays.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {

namespace internal {

// By vertex, in the order of `number`: those it shares a face with.
template <class PolygonMesh, class Numbers>
std::vector<std::vector<Index>> vertices_of_common_faces(const PolygonMesh& mesh,
                                                         const Numbers& number)
{
  std::vector<std::vector<Index>> neighbours(number.size());
  std::vector<Index> polygon;
  for(auto f : faces(mesh)) {
    polygon.clear();
    for(auto v : vertices_around_face(halfedge(f, mesh), mesh)) polygon.push_back(number.at(v));
    for(Index a : polygon)
      for(Index b : polygon)
        if(a != b) neighbours[a].push_back(b);
  }
  return neighbours;
}

} // namespace internal

/// \brief Lowers nodal sizes until they grow by at most `growth` per unit of length.
///
/// Gives the largest sizes below the given ones with |h(u) - h(v)| <= growth |uv| for any two
/// vertices of a common face, by Dijkstra's algorithm on the graph of edges and face diagonals:
/// the discrete form of Persson's |grad h| <= growth (P.-O. Persson, "Mesh size functions for
/// implicit geometries and PDE-based gradient limiting", 2006).  O(n log n).
///
/// \param mesh a model of `FaceListGraph` and `HalfedgeListGraph`.
/// \param sizes a read-write property map from vertices to positive sizes; changed in place.
///        Infinity is a size, too: that of a vertex which asks for none itself.
/// \param growth the largest slope, not negative; 0.2 to 0.3 suits quad meshes.
/// \param np optional: `vertex_point_map`.
/// \throws std::invalid_argument if `growth` is negative or not finite, a size is not positive (or
///         no number) or a coordinate not finite; `sizes` is then unchanged.
template <class PolygonMesh, class VertexSizeMap, class NP = parameters::Default_named_parameters>
void limit_size_gradation(const PolygonMesh& mesh, VertexSizeMap sizes, double growth,
                          const NP& np = parameters::default_values())
{
  using Vertex = typename boost::graph_traits<PolygonMesh>::vertex_descriptor;
  if(!(std::isfinite(growth) && growth >= 0))
    throw std::invalid_argument("limit_size_gradation: the slope is not a finite number >= 0");
  const auto points = internal::vertex_points(mesh, np);

  std::vector<Vertex> vertex_of;
  std::unordered_map<Vertex, internal::Index> number;
  for(Vertex v : vertices(mesh)) {
    number.emplace(v, internal::Index(vertex_of.size()));
    vertex_of.push_back(v);
  }
  const auto neighbours = internal::vertices_of_common_faces(mesh, number);

  std::vector<double> size(vertex_of.size());
  for(std::size_t v = 0; v < size.size(); ++v) {
    size[v] = CGAL::to_double(get(sizes, vertex_of[v]));
    if(!(size[v] > 0))
      throw std::invalid_argument("limit_size_gradation: the size at vertex " + std::to_string(v) +
                                  " is not positive");
  }
  internal::lower_values(size, [&](double h, internal::Index v, const auto& lower) {
    const auto& p = get(points, vertex_of[v]);
    for(internal::Index w : neighbours[v]) {
      const auto& q = get(points, vertex_of[w]);
      const double length =
          std::hypot(CGAL::to_double(p.x() - q.x()), CGAL::to_double(p.y() - q.y()),
                     CGAL::to_double(p.z() - q.z()));
      if(!std::isfinite(length))
        throw std::invalid_argument("limit_size_gradation: vertex " + std::to_string(v) +
                                    " or one beside it has a coordinate that is not finite");
      const double bound = h + growth * length;
      if(bound < size[w]) lower(w, bound);
    }
  });
  for(std::size_t v = 0; v < size.size(); ++v)
    if(size[v] < CGAL::to_double(get(sizes, vertex_of[v]))) put(sizes, vertex_of[v], size[v]);
}

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_LIMIT_SIZE_GRADATION_H
