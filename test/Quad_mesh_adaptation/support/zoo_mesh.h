// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_TEST_ZOO_MESH_H
#define QUAD_MESH_ADAPTATION_TEST_ZOO_MESH_H

#include "mesh_checks.h"
#include "shape_zoo.h"

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <vector>

// Shapes of the zoo as graphs of CGAL, and back.
namespace zoo_mesh {

using shape_zoo::Index;
using shape_zoo::Quad;
using shape_zoo::Shape;
using shape_zoo::Vec;

/// The seed of random tests; the environment variable QUAD_MESH_SEED repeats a run.
unsigned seed(unsigned otherwise = 20091u);

/// A number of repetitions that an environment variable may replace.
int count(const char* variable, int otherwise);

template <typename Mesh, typename Point>
Mesh make(const Shape& s)
{
  Mesh mesh;
  auto vpm = get(CGAL::vertex_point, mesh);
  std::vector<typename boost::graph_traits<Mesh>::vertex_descriptor> v;
  for(const Vec& p : s.points) {
    v.push_back(add_vertex(mesh));
    put(vpm, v.back(), Point(p.x(), p.y(), p.z()));
  }
  for(const Quad& q : s.quads)
    CGAL::Euler::add_face(
        std::vector<typename boost::graph_traits<Mesh>::vertex_descriptor>{ v[q[0]], v[q[1]],
                                                                            v[q[2]], v[q[3]] },
        mesh);
  return mesh;
}

/// Points and polygons of a graph in the order of iteration; faces that are not quads are left out.
template <typename Mesh>
Shape shape_of(const Mesh& mesh)
{
  Shape s;
  auto vpm = get(CGAL::vertex_point, mesh);
  std::map<typename boost::graph_traits<Mesh>::vertex_descriptor, Index> number;
  for(auto v : vertices(mesh)) {
    number[v] = Index(s.points.size());
    const auto& p = get(vpm, v);
    s.points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }
  for(auto f : faces(mesh)) {
    std::vector<Index> q;
    for(auto v : vertices_around_face(halfedge(f, mesh), mesh)) q.push_back(number.at(v));
    if(q.size() == 4) s.quads.push_back({ q[0], q[1], q[2], q[3] });
  }
  return s;
}

/// The same graph: vertices, their points to the last bit, and faces in the same order.
template <typename Mesh>
bool is_same(const Mesh& a, const Mesh& b)
{
  if(num_vertices(a) != num_vertices(b) || num_faces(a) != num_faces(b) ||
     num_halfedges(a) != num_halfedges(b))
    return false;
  const Shape s = shape_of(a), t = shape_of(b);
  return s.points == t.points && s.quads == t.quads;
}

/// What every adapted mesh must be, against the facts of the mesh it was made from; `check_shape`:
/// also without turned face, if that had none.
template <typename Mesh>
void expect_valid(const Mesh& mesh, const mesh_checks::Facts& before, bool check_shape = true)
{
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  EXPECT_TRUE(CGAL::is_quad_mesh(mesh));
  EXPECT_EQ(CGAL::is_closed(mesh), before.boundary_loops == 0);
  const Shape s = shape_of(mesh);
  const mesh_checks::Facts after = mesh_checks::facts_of(s.points, s.quads);
  EXPECT_EQ(after.problem, "");
  EXPECT_TRUE(mesh_checks::same_topology(before, after))
      << "components " << before.components << " -> " << after.components << ", loops "
      << before.boundary_loops << " -> " << after.boundary_loops << ", Euler "
      << before.euler_characteristic << " -> " << after.euler_characteristic;
  EXPECT_LE(after.doublets, before.doublets);
  if(check_shape && before.min_scaled_jacobian > 0) {
    EXPECT_GT(after.min_scaled_jacobian, 0);
  }
}

/// A smooth size with bumps: far away `base`, near the centre of bump i its own size.
struct Bumps
{
  struct Bump
  {
    Vec centre;
    double radius, factor;
  };
  double base = 1;
  std::vector<Bump> bumps;

  template <typename Point>
  double operator()(const Point& q) const
  {
    const Vec p(CGAL::to_double(q.x()), CGAL::to_double(q.y()), CGAL::to_double(q.z()));
    double log_h = std::log(base);
    for(const Bump& b : bumps)
      log_h +=
          std::log(b.factor) * std::exp(-(p - b.centre).squared_length() / (b.radius * b.radius));
    return std::exp(log_h);
  }
};

double mean_edge(const Shape& s);

/// Bumps at points of a shape; sizes from about a fifth to about five times its mean edge.
Bumps random_bumps(const Shape& s, std::mt19937& random);

} // namespace zoo_mesh

#endif // QUAD_MESH_ADAPTATION_TEST_ZOO_MESH_H
