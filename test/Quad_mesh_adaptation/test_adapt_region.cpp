// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// adapt_quad_mesh() on a region, and under constraints.

#include "support/usual_calls.h"
#include "support/usual_measures.h"

#include <CGAL/Polyhedron_3.h>

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace QMA = CGAL::Quad_mesh_adaptation;

namespace {

using usual_mesh::Mesh;
using usual_mesh::Point;
using Polyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>;
using QMA::Adaptation_report;
using shape_zoo::Index;
using shape_zoo::Shape;

template <typename M>
using Face = typename boost::graph_traits<M>::face_descriptor;

template <typename M>
Point centre(const M& mesh, Face<M> f)
{
  double x = 0, y = 0, z = 0;
  for(auto v : vertices_around_face(halfedge(f, mesh), mesh)) {
    const Point& p = get(CGAL::vertex_point, mesh, v);
    x += 0.25 * p.x(), y += 0.25 * p.y(), z += 0.25 * p.z();
  }
  return Point(x, y, z);
}

using Choice = std::function<bool(const Point&)>;

template <typename M>
std::vector<Face<M>> faces_where(const M& mesh, const Choice& inside)
{
  std::vector<Face<M>> list;
  for(auto f : faces(mesh))
    if(inside(centre(mesh, f))) list.push_back(f);
  return list;
}

// A face outside by its descriptor: its vertices, in order, and where they are.
template <typename M>
struct Outside
{
  using Vertex = typename boost::graph_traits<M>::vertex_descriptor;
  std::map<Face<M>, std::vector<std::pair<Vertex, Point>>> faces;

  Outside(const M& mesh, const Choice& inside)
  {
    for(auto f : CGAL::faces(mesh))
      if(!inside(centre(mesh, f))) faces[f] = corners(mesh, f);
  }
  static std::vector<std::pair<Vertex, Point>> corners(const M& mesh, Face<M> f)
  {
    std::vector<std::pair<Vertex, Point>> list;
    for(auto v : vertices_around_face(halfedge(f, mesh), mesh))
      list.emplace_back(v, get(CGAL::vertex_point, mesh, v));
    return list;
  }
  void expect_kept(const M& mesh) const
  {
    std::set<Face<M>> now;
    for(auto f : CGAL::faces(mesh)) now.insert(f);
    for(const auto& f : faces) {
      ASSERT_EQ(now.count(f.first), 1u) << "a face outside lost its descriptor";
      EXPECT_EQ(corners(mesh, f.first), f.second);
    }
  }
};

template <typename M>
Adaptation_report adapt_region(const Shape& shape, const Choice& inside, double size,
                               QMA::Schedule schedule = QMA::Schedule::progressive)
{
  M mesh = zoo_mesh::make<M, Point>(shape);
  const mesh_checks::Facts before = mesh_checks::facts_of(shape.points, shape.quads);
  const Outside<M> outside(mesh, inside);
  const auto region = faces_where(mesh, inside);
  EXPECT_FALSE(region.empty());
  const Adaptation_report report =
      QMA::adapt_quad_mesh(region, size, mesh, QMA::schedule(schedule));
  EXPECT_TRUE(report.has_valid_mesh()) << report.message;
  // the paper's schedule refines again and again beside edges that must not be cut, into slivers
  zoo_mesh::expect_valid(mesh, before, schedule == QMA::Schedule::progressive);
  outside.expect_kept(mesh);
  EXPECT_EQ(faces_where(mesh, [](const Point&) { return true; }).size(),
            outside.faces.size() + report.after.faces);
  return report;
}

struct Case
{
  std::string name;
  Shape shape;
  Choice inside;
};

std::vector<Case> cases()
{
  return {
    { "inside a plate", shape_zoo::plate(10, 10),
      [](const Point& p) { return p.x() > 2 && p.x() < 7 && p.y() > 3 && p.y() < 8; } },
    { "half of a plate", shape_zoo::plate(8, 6), [](const Point& p) { return p.x() < 4; } },
    { "a strip across a plate", shape_zoo::plate(8, 6),
      [](const Point& p) { return p.x() > 2 && p.x() < 5; } },
    { "a corner of a plate", shape_zoo::plate(8, 6),
      [](const Point& p) { return p.x() < 3 && p.y() < 3; } },
    { "all but a hole of a plate", shape_zoo::plate(8, 8),
      [](const Point& p) { return !(p.x() > 3 && p.x() < 5 && p.y() > 3 && p.y() < 5); } },
    { "one face", shape_zoo::plate(5, 5),
      [](const Point& p) { return int(p.x()) == 2 && int(p.y()) == 2; } },
    { "one face at a corner", shape_zoo::plate(5, 5),
      [](const Point& p) { return p.x() < 1 && p.y() < 1; } },
    { "a band of a torus", shape_zoo::torus(16, 8), [](const Point& p) { return p.x() > 0.5; } },
    { "one end of a cylinder", shape_zoo::open_cylinder(16, 8),
      [](const Point& p) { return p.z() < 1; } },
    { "the top of a cube and a little more", shape_zoo::cube(4),
      [](const Point& p) { return p.z() > 2.9; } },
    { "the inner rim of an annulus", shape_zoo::annulus(24, 4),
      [](const Point& p) { return p.x() * p.x() + p.y() * p.y() < 2; } },
    { "two parts that meet in one vertex", shape_zoo::plate(8, 8),
      [](const Point& p) { return (p.x() < 4) == (p.y() < 4); } },
    { "every other face", shape_zoo::plate(6, 6),
      [](const Point& p) { return (int(p.x()) + int(p.y())) % 2 == 0; } },
  };
}

} // namespace

TEST(Adapt_region, RefinedOnSurfaceMesh)
{
  for(const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const Adaptation_report r =
        adapt_region<Mesh>(c.shape, c.inside, 0.5 * zoo_mesh::mean_edge(c.shape));
    // between four edges that must not be cut there is no way to refine
    if(c.name.find("face") == std::string::npos) {
      EXPECT_GT(r.after.faces, r.before.faces);
    }
  }
}

TEST(Adapt_region, CoarsenedOnSurfaceMesh)
{
  for(const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const Adaptation_report r =
        adapt_region<Mesh>(c.shape, c.inside, 2.5 * zoo_mesh::mean_edge(c.shape));
    EXPECT_LE(r.after.faces, r.before.faces);
  }
}

TEST(Adapt_region, Polyhedron)
{
  for(const Case& c : cases())
    for(double factor : { 0.7, 2.5 }) {
      SCOPED_TRACE(c.name + ", factor " + std::to_string(factor));
      adapt_region<Polyhedron>(c.shape, c.inside, factor * zoo_mesh::mean_edge(c.shape));
    }
}

TEST(Adapt_region, PaperSchedule)
{
  for(const Case& c : cases())
    for(double factor : { 0.6, 2.5 }) {
      SCOPED_TRACE(c.name + ", factor " + std::to_string(factor));
      adapt_region<Mesh>(c.shape, c.inside, factor * zoo_mesh::mean_edge(c.shape),
                         QMA::Schedule::paper);
    }
}

// The edges of unit length about the region cannot be cut: what stays too large is named by its
// position in the mesh.
TEST(Adapt_region, FacesTooLargeAreNamed)
{
  const double h = 0.1;
  Mesh mesh = zoo_mesh::make<Mesh, Point>(shape_zoo::plate(7, 7));
  const auto region = faces_where(
      mesh, [](const Point& p) { return p.x() > 2 && p.x() < 5 && p.y() > 2 && p.y() < 5; });
  std::set<Face<Mesh>> outside(mesh.faces().begin(), mesh.faces().end());
  for(auto f : region) outside.erase(f);
  const Adaptation_report report = QMA::adapt_quad_mesh(region, h, mesh);
  ASSERT_EQ(report.status, QMA::Adaptation_status::sizes_not_met);
  EXPECT_FALSE(report.message.empty());
  std::vector<std::size_t> large;
  std::size_t position = 0;
  for(auto f : mesh.faces()) {
    double sum = 0;
    for(auto e : mesh.halfedges_around_face(mesh.halfedge(f)))
      sum +=
          std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(e)), mesh.point(mesh.target(e))));
    if(outside.count(f) == 0 && sum > 4 * h * (1 + 1e-9)) large.push_back(position);
    ++position;
  }
  EXPECT_GE(large.size(), 12u);
  EXPECT_EQ(report.faces_too_large, large);
  EXPECT_GE(report.after.min_scaled_jacobian, 0.45);
  ASSERT_EQ(report.advice.size(), 1u);
  EXPECT_EQ(report.advice[0].find("12 edges that must stay are up to 10 times"), 0u)
      << report.advice[0];
}

// --- constraints

namespace {

Mesh::Property_map<Mesh::Edge_index, bool> mark_line(Mesh& mesh, double x)
{
  auto marked = mesh.add_property_map<Mesh::Edge_index, bool>("e:line", false).first;
  for(auto e : mesh.edges())
    marked[e] = mesh.point(mesh.vertex(e, 0)).x() == x && mesh.point(mesh.vertex(e, 1)).x() == x;
  return marked;
}

} // namespace

TEST(Adapt_constrained, ConstrainedEdgesStayACurve)
{
  for(double factor : { 0.35, 0.8, 1.7 })
    for(QMA::Schedule schedule : { QMA::Schedule::progressive, QMA::Schedule::paper }) {
      SCOPED_TRACE(std::to_string(factor));
      const Shape shape = shape_zoo::plate(9, 8);
      Mesh mesh = zoo_mesh::make<Mesh, Point>(shape);
      auto marked = mark_line(mesh, 4);
      const Adaptation_report report = QMA::adapt_quad_mesh(
          factor, mesh, QMA::schedule(schedule, CGAL::parameters::edge_is_constrained_map(marked)));
      ASSERT_TRUE(report.has_valid_mesh()) << report.message;
      zoo_mesh::expect_valid(mesh, mesh_checks::facts_of(shape.points, shape.quads));
      mesh.collect_garbage();
      double length = 0;
      for(auto e : mesh.edges()) {
        const Point p = mesh.point(mesh.vertex(e, 0)), q = mesh.point(mesh.vertex(e, 1));
        if(marked[e]) {
          EXPECT_EQ(p.x(), 4);
          EXPECT_EQ(q.x(), 4);
          length += std::abs(p.y() - q.y());
        } else {
          EXPECT_FALSE((p.x() < 4 && q.x() > 4) || (p.x() > 4 && q.x() < 4)) << "crosses the line";
        }
      }
      EXPECT_NEAR(length, 8, 1e-9);
    }
}

// Every vertex that is constrained keeps descriptor and position, at the border and inside.
TEST(Adapt_constrained, ConstrainedVerticesStay)
{
  for(double factor : { 0.4, 2.5 }) {
    const Shape shape = shape_zoo::plate(9, 8);
    Mesh mesh = zoo_mesh::make<Mesh, Point>(shape);
    auto fixed = mesh.add_property_map<Mesh::Vertex_index, bool>("v:fixed", false).first;
    std::map<Mesh::Vertex_index, Point> where;
    for(int i : { 3, 25, 44, 47, 82 }) {
      const Mesh::Vertex_index v(i);
      fixed[v] = true;
      where[v] = mesh.point(v);
    }
    const Adaptation_report report =
        QMA::adapt_quad_mesh(factor, mesh, CGAL::parameters::vertex_is_constrained_map(fixed));
    ASSERT_TRUE(report.has_valid_mesh()) << report.message;
    zoo_mesh::expect_valid(mesh, mesh_checks::facts_of(shape.points, shape.quads));
    for(const auto& w : where) {
      ASSERT_FALSE(mesh.is_removed(w.first));
      EXPECT_EQ(mesh.point(w.first), w.second);
    }
  }
}

// An own map of points is read and written in place of the one inside the mesh.
TEST(Adapt_constrained, OwnPointMap)
{
  const Shape shape = shape_zoo::plate();
  Mesh mesh = zoo_mesh::make<Mesh, Point>(shape);
  auto own = mesh.add_property_map<Mesh::Vertex_index, Point>("v:own").first;
  for(auto v : mesh.vertices()) {
    const Point p = mesh.point(v);
    own[v] = Point(2 * p.x(), 2 * p.y(), 1);
    mesh.point(v) = Point(0, 0, 0);
  }
  const auto np = CGAL::parameters::vertex_point_map(own);
  const Adaptation_report report = QMA::adapt_quad_mesh(0.9, mesh, np);
  ASSERT_EQ(report.status, QMA::Adaptation_status::sizes_met) << report.message;
  EXPECT_EQ(QMA::measure_quad_mesh(mesh, 0.9, np).faces, report.after.faces);
  EXPECT_GT(report.after.faces, 100u);
  for(auto v : mesh.vertices()) {
    EXPECT_EQ(own[v].z(), 1);
    if(std::size_t(v) < shape.points.size()) {
      EXPECT_EQ(mesh.point(v), Point(0, 0, 0));
    }
  }
}
