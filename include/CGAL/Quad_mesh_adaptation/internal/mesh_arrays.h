// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MESH_ARRAYS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MESH_ARRAYS_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

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

// The points of a mesh in its order; calls `add(numbers of the corners)` for each of its faces.
template <class Mesh, class PointMap, class Add>
std::vector<Vec> points_and_faces(const Mesh& mesh, const PointMap& point_map, const Add& add)
{
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
  std::unordered_map<Vertex, Index> number;
  std::vector<Vec> points;
  for(Vertex v : vertices(mesh)) {
    number.emplace(v, Index(points.size()));
    points.push_back(to_vec(get(point_map, v)));
  }
  std::vector<Index> face;
  for(auto f : faces(mesh)) {
    face.clear();
    for(Vertex v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      face.push_back(number.at(v));
    add(face);
  }
  return points;
}

struct Quad_arrays
{
  std::vector<Vec> points;
  std::vector<Quad> quads;
};

// Exceptions are in the name of `who`.
template <class QuadMesh, class PointMap>
Quad_arrays quad_arrays(const QuadMesh& mesh, const PointMap& point_map, const char* who)
{
  Quad_arrays a;
  a.points = points_and_faces(mesh, point_map, [&](const std::vector<Index>& face) {
    if(face.size() != 4) throw std::invalid_argument(std::string(who) + ": a face is not a quad");
    a.quads.push_back({ face[0], face[1], face[2], face[3] });
  });
  return a;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MESH_ARRAYS_H
