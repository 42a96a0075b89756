// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Symmetry together with what else can be asked for: constraints, regions, patches, references.

#include "support/symmetry_fixture.h"

#include <gtest/gtest.h>

using namespace symmetry_fixture;

// Constrained edges along a plane stay marked, those across it as well.
TEST(SymmetryWith, ConstrainedEdges)
{
  const Shape shape = centred(shape_zoo::plate(8, 8));
  Mesh mesh = zoo_mesh::make<Mesh, Point>(shape);
  auto marks = mesh.add_property_map<Mesh::Edge_index, bool>("e:marked", false).first;
  const auto on_cross = [&](Mesh::Edge_index e) {
    const Point p = mesh.point(mesh.vertex(e, 0)), q = mesh.point(mesh.vertex(e, 1));
    const auto flat = [](double a, double b, double c) {
      return std::abs(a - c) < 1e-9 && std::abs(b - c) < 1e-9;
    };
    return flat(p.x(), q.x(), 0) || flat(p.y(), q.y(), 2) || flat(p.y(), q.y(), -2);
  };
  for(auto e : mesh.edges()) marks[e] = on_cross(e);
  const double before = 8 * 3;
  const Size size = [](const Point& p) { return 0.12 + 0.04 * std::abs(p.x()); };
  const auto report =
      QMA::adapt_quad_mesh(size, mesh, CGAL::parameters::edge_is_constrained_map(marks));
  ASSERT_TRUE(report.has_valid_mesh());
  double length = 0;
  for(auto e : mesh.edges()) {
    EXPECT_EQ(marks[e], on_cross(e));
    if(marks[e])
      length += std::sqrt(
          CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  }
  EXPECT_NEAR(length, before, 1e-9);
  EXPECT_EQ(unmatched(mesh, 0), 0u);
  EXPECT_EQ(unmatched(mesh, 1), 0u);
}

// Without corners in the plane of the border, too.
TEST(SymmetryWith, NoFeatureAngle)
{
  const Shape shape = centred(shape_zoo::cube(6));
  Mesh mesh = zoo_mesh::make<Mesh, Point>(shape);
  const auto report = QMA::adapt_quad_mesh(0.3, mesh, QMA::feature_angle(180));
  ASSERT_TRUE(report.has_valid_mesh());
  zoo_mesh::expect_valid(mesh, mesh_checks::facts_of(shape.points, shape.quads));
  for(int axis = 0; axis < 3; ++axis) EXPECT_EQ(unmatched(mesh, axis), 0u);
}

TEST(SymmetryWith, Region)
{
  const Shape shape = centred(shape_zoo::plate(16, 16));
  Mesh mesh = zoo_mesh::make<Mesh, Point>(shape);
  std::vector<Mesh::Face_index> region;
  for(auto f : mesh.faces()) {
    double x = 0;
    for(auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh)) x += mesh.point(v).x() / 4;
    if(std::abs(x) < 4) region.push_back(f);
  }
  const auto report = QMA::adapt_quad_mesh(region, 0.3, mesh);
  ASSERT_TRUE(report.has_valid_mesh()) << report.message;
  zoo_mesh::expect_valid(mesh, mesh_checks::facts_of(shape.points, shape.quads));
  EXPECT_EQ(unmatched(mesh, 0), 0u);
  EXPECT_EQ(unmatched(mesh, 1), 0u);
}

// Faces of all images are of the patch they descend from.
TEST(SymmetryWith, Patches)
{
  const Shape shape = centred(shape_zoo::plate(8, 8));
  Mesh mesh = zoo_mesh::make<Mesh, Point>(shape);
  auto patch = mesh.add_property_map<Mesh::Face_index, int>("f:number", 0).first;
  const auto wanted = [&](Mesh::Face_index f) {
    double y = 0;
    for(auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh)) y += mesh.point(v).y() / 4;
    return std::abs(y) < 2 ? 7 : 3;
  };
  for(auto f : mesh.faces()) patch[f] = wanted(f);
  const Size size = [](const Point& p) { return 0.12 + 0.04 * std::abs(p.x()); };
  ASSERT_TRUE(
      QMA::adapt_quad_mesh(size, mesh, CGAL::parameters::face_patch_map(patch)).has_valid_mesh());
  for(auto f : mesh.faces()) EXPECT_EQ(patch[f], wanted(f));
  EXPECT_EQ(unmatched(mesh, 0), 0u);
  EXPECT_EQ(unmatched(mesh, 1), 0u);
}

// A reference that is the input's own plane, in triangles of its own, does not stand in the way;
// one with another border does.
TEST(SymmetryWith, FlatReference)
{
  const Shape shape = centred(shape_zoo::plate(10, 10));
  const Size size = [](const Point& p) {
    return 0.7 * (0.1 + std::abs(std::hypot(p.x(), p.y()) - 4.8));
  };
  Mesh square;
  std::vector<Mesh::Vertex_index> c;
  for(const Point& p : { Point(-5, -5, 0), Point(5, -5, 0), Point(5, 5, 0), Point(-5, 5, 0) })
    c.push_back(square.add_vertex(p));
  square.add_face(c[0], c[1], c[2]);
  square.add_face(c[0], c[2], c[3]);
  Mesh mesh = zoo_mesh::make<Mesh, Point>(shape);
  ASSERT_TRUE(QMA::adapt_quad_mesh(size, mesh, QMA::reference_surface(square)).has_valid_mesh());
  EXPECT_EQ(unmatched(mesh, 0), 0u);
  EXPECT_EQ(unmatched(mesh, 1), 0u);

  square.point(c[2]) = Point(5.1, 5.1, 0);
  Mesh bent = zoo_mesh::make<Mesh, Point>(shape);
  ASSERT_TRUE(QMA::adapt_quad_mesh(size, bent, QMA::reference_surface(square)).has_valid_mesh());
  EXPECT_GT(unmatched(bent, 0), 0u);
  const Shape out = zoo_mesh::shape_of(bent);
  EXPECT_TRUE(
      std::any_of(out.points.begin(), out.points.end(), [](const Vec& p) { return p.x() > 5.05; }));
}

// Exceptions of the caller leave the mesh as it was.
TEST(SymmetryWith, ExceptionsPass)
{
  const Shape shape = centred(shape_zoo::plate(8, 8));
  Mesh mesh = zoo_mesh::make<Mesh, Point>(shape);
  const Mesh before = mesh;
  int calls = 0;
  const Size size = [&](const Point&) {
    if(++calls > 20000) throw 7;
    return 0.2;
  };
  EXPECT_THROW(QMA::adapt_quad_mesh(size, mesh), int);
  EXPECT_TRUE(zoo_mesh::is_same(mesh, before));
}
