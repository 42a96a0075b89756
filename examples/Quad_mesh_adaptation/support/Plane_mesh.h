// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_EXAMPLES_PLANE_MESH_H
#define QUAD_MESH_ADAPTATION_EXAMPLES_PLANE_MESH_H

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <vector>

namespace plane_stress {

/// Bilinear quads in the plane, corners counter-clockwise.
struct Plane_mesh
{
  std::vector<Eigen::Vector2d> nodes;
  std::vector<std::array<int, 4>> quads;

  std::array<Eigen::Vector2d, 4> corners(std::size_t element) const
  {
    const auto& q = quads[element];
    return { nodes[q[0]], nodes[q[1]], nodes[q[2]], nodes[q[3]] };
  }
  Eigen::Vector2d centre(std::size_t element) const
  {
    const auto c = corners(element);
    return 0.25 * (c[0] + c[1] + c[2] + c[3]);
  }
  double mean_edge_length(std::size_t element) const
  {
    const auto c = corners(element);
    double sum = 0;
    for(int i = 0; i < 4; ++i) sum += (c[(i + 1) % 4] - c[i]).norm();
    return sum / 4;
  }
};

/// The mesh of a quad mesh in the plane z = const, nodes in the order of its vertices; throws
/// `std::invalid_argument` if a face is not a quad.
template <class QuadMesh>
Plane_mesh plane_mesh(const QuadMesh& mesh)
{
  using Vertex = typename boost::graph_traits<QuadMesh>::vertex_descriptor;
  const auto points = get(CGAL::vertex_point, mesh);
  Plane_mesh result;
  std::unordered_map<Vertex, int> number;
  for(Vertex v : vertices(mesh)) {
    number.emplace(v, int(result.nodes.size()));
    result.nodes.emplace_back(get(points, v).x(), get(points, v).y());
  }
  for(auto f : faces(mesh)) {
    std::vector<int> corners;
    for(Vertex v : vertices_around_face(halfedge(f, mesh), mesh)) corners.push_back(number.at(v));
    if(corners.size() != 4) throw std::invalid_argument("plane_mesh: a face is not a quad");
    result.quads.push_back({ corners[0], corners[1], corners[2], corners[3] });
  }
  return result;
}

/// Directed edges of one element only, the body to their left.
inline std::vector<std::pair<int, int>> boundary_edges(const Plane_mesh& mesh)
{
  std::map<std::pair<int, int>, int> uses;
  for(const auto& q : mesh.quads)
    for(int i = 0; i < 4; ++i) ++uses[std::minmax(q[i], q[(i + 1) % 4])];
  std::vector<std::pair<int, int>> edges;
  for(const auto& q : mesh.quads)
    for(int i = 0; i < 4; ++i)
      if(uses.at(std::minmax(q[i], q[(i + 1) % 4])) == 1) edges.emplace_back(q[i], q[(i + 1) % 4]);
  return edges;
}

/// The node nearest to a point.
inline int nearest_node(const Plane_mesh& mesh, const Eigen::Vector2d& p)
{
  const auto nearer = [&p](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return (a - p).squaredNorm() < (b - p).squaredNorm();
  };
  return int(std::min_element(mesh.nodes.begin(), mesh.nodes.end(), nearer) - mesh.nodes.begin());
}

} // namespace plane_stress

#endif // QUAD_MESH_ADAPTATION_EXAMPLES_PLANE_MESH_H
