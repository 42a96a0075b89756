// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// edge_is_frozen_map(): such edges and their ends are after any call what they were before it.

#include "support/usual_calls.h"

#include <CGAL/Polyhedron_3.h>

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace QMA = CGAL::Quad_mesh_adaptation;

namespace {

using usual_mesh::Mesh;
using usual_mesh::Point;
using Polyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>;
using QMA::Adaptation_report;
using shape_zoo::Shape;

template <typename M>
using Edge = typename boost::graph_traits<M>::edge_descriptor;
template <typename M>
using Vertex = typename boost::graph_traits<M>::vertex_descriptor;

// Chosen edges by their descriptors, with their ends and where these are.
template <typename M>
struct Frozen
{
  using Ends = std::set<std::pair<Vertex<M>, Point>>;
  std::map<Edge<M>, Ends> edges;

  template <typename Choice>
  Frozen(const M& mesh, const Choice& chosen)
  {
    for(auto e : CGAL::edges(mesh))
      if(chosen(e)) edges[e] = ends(mesh, e);
  }
  static Ends ends(const M& mesh, Edge<M> e)
  {
    const auto end = [&](Vertex<M> v) {
      return std::make_pair(v, Point(get(CGAL::vertex_point, mesh, v)));
    };
    return { end(source(e, mesh)), end(target(e, mesh)) };
  }
  auto map() const
  {
    return boost::make_function_property_map<Edge<M>>(
        [this](const Edge<M>& e) { return edges.count(e) == 1; });
  }
  void expect_kept(const M& mesh) const
  {
    std::set<Edge<M>> now;
    for(auto e : CGAL::edges(mesh)) now.insert(e);
    for(const auto& e : edges) {
      ASSERT_EQ(now.count(e.first), 1u) << "a frozen edge lost its descriptor";
      EXPECT_EQ(ends(mesh, e.first), e.second);
    }
  }
};

template <typename M, typename Choice>
Adaptation_report adapt(const Shape& shape, const Choice& chosen, double factor,
                        QMA::Schedule schedule = QMA::Schedule::progressive)
{
  M mesh = zoo_mesh::make<M, Point>(shape);
  const mesh_checks::Facts before = mesh_checks::facts_of(shape.points, shape.quads);
  const Frozen<M> frozen(mesh, [&](Edge<M> e) { return chosen(mesh, e); });
  const double h = factor * zoo_mesh::mean_edge(shape);
  const Adaptation_report report =
      QMA::adapt_quad_mesh(h, mesh, QMA::edge_is_frozen_map(frozen.map(), QMA::schedule(schedule)));
  EXPECT_TRUE(report.has_valid_mesh()) << report.message;
  zoo_mesh::expect_valid(mesh, before, schedule == QMA::Schedule::progressive);
  frozen.expect_kept(mesh);
  return report;
}

const auto at_random = [](std::mt19937& random, int one_in) {
  return [&random, one_in](const auto&, const auto&) { return random() % one_in == 0; };
};
const auto on_border = [](const auto& mesh, const auto& e) { return is_border(e, mesh); };

constexpr double factors[] = { 0.5, 2.3 };

} // namespace

TEST(Frozen_edges, AnyOnSurfaceMesh)
{
  std::mt19937 random(zoo_mesh::seed());
  for(const Shape& shape : shape_zoo::all())
    for(double factor : factors) {
      SCOPED_TRACE(shape.name + " x " + std::to_string(factor) +
                   ", QUAD_MESH_SEED=" + std::to_string(zoo_mesh::seed()));
      adapt<Mesh>(shape, at_random(random, 9), factor);
    }
}

TEST(Frozen_edges, AnyOnPolyhedron)
{
  std::mt19937 random(zoo_mesh::seed() + 1);
  for(const Shape& shape : { shape_zoo::plate(), shape_zoo::annulus(), shape_zoo::torus() })
    for(double factor : factors) {
      SCOPED_TRACE(shape.name + " x " + std::to_string(factor));
      adapt<Polyhedron>(shape, at_random(random, 7), factor);
    }
}

TEST(Frozen_edges, PaperSchedule)
{
  std::mt19937 random(zoo_mesh::seed() + 2);
  for(const Shape& shape : { shape_zoo::plate(), shape_zoo::annulus(), shape_zoo::torus() })
    for(double factor : factors) {
      SCOPED_TRACE(shape.name + " x " + std::to_string(factor));
      adapt<Mesh>(shape, at_random(random, 9), factor, QMA::Schedule::paper);
    }
}

// The border of an interface to another mesh: with all of it frozen the inside still changes.
TEST(Frozen_edges, WholeBorder)
{
  const Shape plate = shape_zoo::plate(12, 12);
  const Adaptation_report coarser = adapt<Mesh>(plate, on_border, 3.);
  EXPECT_LT(coarser.after.faces, 110u);
  // about half as long within as on the border: sizes give way there, shapes do not
  for(double factor : { 0.38, 0.4, 0.43, 0.5, 0.54 }) {
    const Adaptation_report finer = adapt<Mesh>(plate, on_border, factor);
    EXPECT_GT(finer.after.faces, factor < 0.45 ? 500u : 400u) << factor;
    EXPECT_GE(finer.after.min_scaled_jacobian, 0.45) << factor;
  }
}

// Faces that frozen edges keep too large are reported, and only those near them; they have a good
// shape, and the caller is told why.
TEST(Frozen_edges, FacesTooLargeAreNamed)
{
  Mesh mesh = zoo_mesh::make<Mesh, Point>(shape_zoo::plate(6, 6));
  const Frozen<Mesh> frozen(mesh, [&](Edge<Mesh> e) {
    const Point a = mesh.point(source(e, mesh)), b = mesh.point(target(e, mesh));
    return a.y() == 3 && b.y() == 3 && a.x() + b.x() == 5;
  });
  ASSERT_EQ(frozen.edges.size(), 1u);
  const Adaptation_report report =
      QMA::adapt_quad_mesh(0.2, mesh, QMA::edge_is_frozen_map(frozen.map()));
  frozen.expect_kept(mesh);
  ASSERT_FALSE(report.faces_too_large.empty());
  std::vector<Mesh::Face_index> faces(mesh.faces().begin(), mesh.faces().end());
  for(std::size_t f : report.faces_too_large)
    for(auto v : mesh.vertices_around_face(mesh.halfedge(faces[f]))) {
      const Point p = mesh.point(v), on(std::clamp(p.x(), 2., 3.), 3, 0);
      EXPECT_LT(CGAL::squared_distance(p, on), 1.) << f;
    }
  EXPECT_GE(report.after.min_scaled_jacobian, 0.45);
  EXPECT_LE(report.after.max_valence, 5u);
  ASSERT_EQ(report.advice.size(), 1u);
  EXPECT_EQ(report.advice[0].find("1 edge that must stay is up to 5 times"), 0u)
      << report.advice[0];
}

TEST(Frozen_edges, SymmetryIsKeptOnlyWhereTheyAreSymmetric)
{
  const Shape plate = shape_zoo::plate(10, 10);
  adapt<Mesh>(
      plate, [](const Mesh& m, Edge<Mesh> e) { return m.point(source(e, m)).x() < 3; }, 0.45);
  adapt<Mesh>(
      plate, [](const Mesh& m, Edge<Mesh> e) { return m.point(source(e, m)).x() == 5; }, 0.45);
}
