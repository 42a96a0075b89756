// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Symmetric meshes with symmetric sizes stay symmetric; all others are adapted as ever.

#include "support/symmetry_fixture.h"

#include <CGAL/Quad_mesh_adaptation/clean_up.h>
#include <CGAL/Quad_mesh_adaptation/refine.h>

#include <gtest/gtest.h>

using namespace symmetry_fixture;

TEST(Symmetry, CircularLoad)
{
  const Shape plate = centred(shape_zoo::plate(10, 10));
  for(double k : { 0.7, 0.35 }) {
    const Outcome o = adapt(plate, [k](const Point& p) {
      return k * (0.1 + std::abs(std::hypot(p.x(), p.y()) - 4.8));
    });
    EXPECT_EQ(unmatched(o.mesh, 0), 0u);
    EXPECT_EQ(unmatched(o.mesh, 1), 0u);
    EXPECT_EQ(unmatched_faces(o.mesh, Vec(1, 0, 0)), 0u);
    EXPECT_EQ(unmatched_faces(o.mesh, Vec(0, 1, 0)), 0u);
    EXPECT_GT(o.report.after.faces, 500u);
  }
}

TEST(Symmetry, Cap)
{
  const Shape shape = cap();
  const Outcome o = adapt(shape, [](const Point& p) { return 0.08 + 0.15 * (3 - p.z()); });
  EXPECT_EQ(unmatched(o.mesh, 0), 0u);
  EXPECT_EQ(unmatched(o.mesh, 1), 0u);
  EXPECT_EQ(unmatched_faces(o.mesh, Vec(1, 0, 0)), 0u);
}

TEST(Symmetry, BoxWithCreases)
{
  const Shape box = centred(shape_zoo::cube(6));
  const Outcome o =
      adapt(box, [](const Point& p) { return 0.22 * (1 + 0.1 * std::abs(p.x() * p.y())); });
  for(int axis = 0; axis < 3; ++axis) EXPECT_EQ(unmatched(o.mesh, axis), 0u);
  EXPECT_EQ(unmatched_faces(o.mesh, Vec(0, 0, 1)), 0u);
  expect_features(box, o.mesh);
}

// The trigonometric functions of the shape leave its input symmetric to some 1e-16 only.
TEST(Symmetry, ClosedSurfaces)
{
  for(const Shape& s : { shape_zoo::torus(24, 12), shape_zoo::sphere(8) }) {
    const Outcome o = adapt(s, uniform(0.3 * zoo_mesh::mean_edge(s)));
    for(const Vec& n : { Vec(1, 0, 0), Vec(0, 1, 0), Vec(0, 0, 1) })
      EXPECT_EQ(unmatched_faces(o.mesh, n), 0u) << s.name;
  }
}

// Symmetry must not cost many faces; where few are asked for, it is given up before.
TEST(Symmetry, CostsFewFaces)
{
  for(const Shape& s : { centred(shape_zoo::cube(6)), shape_zoo::torus(24, 12),
                         shape_zoo::sphere(8), centred(shape_zoo::plate(8, 8)) })
    for(double factor : { 0.9, 1.6, 3.1 }) {
      const Size size = uniform(factor * zoo_mesh::mean_edge(s));
      const Outcome kept = adapt(s, size), free = adapt(s, size, false);
      EXPECT_LE(double(kept.report.after.faces), 1.1 * double(free.report.after.faces))
          << s.name << ", factor " << factor;
    }
}

// Phases alone keep it, too: refined, and cleaned up after that.
TEST(Symmetry, Phases)
{
  const auto size = [](double factor) -> Size {
    return [factor](const Point& p) {
      return factor * (1 + 0.1 * std::abs(std::hypot(p.x(), p.y()) - 8));
    };
  };
  const Shape plate = centred(shape_zoo::plate(24, 24));
  const mesh_checks::Facts facts = mesh_checks::facts_of(plate.points, plate.quads);
  const auto expect_symmetric = [&](const QMA::Adaptation_report& report, const Mesh& mesh) {
    EXPECT_TRUE(report.has_valid_mesh()) << report.message;
    EXPECT_GT(report.operations.size(), 0u);
    zoo_mesh::expect_valid(mesh, facts);
    EXPECT_EQ(unmatched(mesh, 0) + unmatched(mesh, 1), 0u);
  };
  Mesh mesh = zoo_mesh::make<Mesh, Point>(plate);
  expect_symmetric(QMA::refine(size(0.25), mesh), mesh);
  expect_symmetric(QMA::clean_up(size(0.25), mesh), mesh);
  QMA::clean_up(size(0.5), mesh, QMA::symmetry(false));
  EXPECT_GT(unmatched(mesh, 0) + unmatched(mesh, 1), 0u);
}

TEST(Symmetry, InAnyPosition)
{
  const Shape plate = centred(shape_zoo::plate(8, 6));
  const Shape shape = moved(plate, [](const Vec& p) { return turned(p) - turned(Vec(0, 0, 0)); });
  const Vec x = shape.points[1] - shape.points[0], y = shape.points[9] - shape.points[0];
  const Outcome o = adapt(
      shape, [x](const Point& p) { return 0.1 + 0.03 * std::abs(Vec(p.x(), p.y(), p.z()) * x); });
  EXPECT_EQ(unmatched_faces(o.mesh, x), 0u);
  EXPECT_EQ(unmatched_faces(o.mesh, y), 0u);
}

TEST(Symmetry, OnePlaneOnly)
{
  const Shape shape = centred(shape_zoo::plate(8, 5));
  const Outcome o = adapt(shape, [](const Point& p) { return 0.15 + 0.02 * (p.y() + 3); });
  EXPECT_EQ(unmatched(o.mesh, 0), 0u);
  EXPECT_GT(unmatched(o.mesh, 1), 0u);
}

// What looks symmetric to the samples but is not: the result must not be.
TEST(Symmetry, SizeUnsymmetricBetweenTheSamples)
{
  const Shape shape = centred(shape_zoo::plate(4, 4));
  for(double side : { -1., 1. }) {
    const Size size = [side](const Point& p) {
      const double x = side * p.x() - 0.75, y = p.y() - 0.75;
      return x * x + y * y < 0.04 ? 0.05 : 0.5;
    };
    state_fixture::Options o;
    o.size = [&](const Vec& p) { return size(Point(p.x(), p.y(), p.z())); };
    ASSERT_EQ(planes_of(shape, o), 2u);
    const Shape before = zoo_mesh::shape_of(zoo_mesh::make<Mesh, Point>(shape));
    Mesh mesh = zoo_mesh::make<Mesh, Point>(shape);
    const QMA::Adaptation_report r = QMA::adapt_quad_mesh(size, mesh);
    ASSERT_TRUE(r.has_valid_mesh());
    zoo_mesh::expect_valid(mesh, mesh_checks::facts_of(before.points, before.quads));
    EXPECT_GT(unmatched(mesh, 0), 0u);
  }
}

TEST(Symmetry, CanBeSwitchedOff)
{
  const Shape plate = centred(shape_zoo::plate(10, 10));
  const Size size = [](const Point& p) { return 0.1 + std::abs(std::hypot(p.x(), p.y()) - 4.8); };
  EXPECT_GT(unmatched(adapt(plate, size, false).mesh, 0), 0u);
}

// A mesh without a plane is adapted to the last bit as if symmetry had not been asked for.
TEST(Symmetry, OthersAreNotTouched)
{
  const Shape shape = shape_zoo::irregular();
  const Outcome a = adapt(shape, uniform(0.3)), b = adapt(shape, uniform(0.3), false);
  EXPECT_TRUE(zoo_mesh::is_same(a.mesh, b.mesh));
}

// Descriptors of what did not change survive on both sides alike, and so do points.
TEST(Symmetry, DescriptorsSurvive)
{
  const Shape shape = centred(shape_zoo::plate(24, 12));
  const Mesh before = zoo_mesh::make<Mesh, Point>(shape);
  Mesh mesh = before;
  const Size size = [](const Point& p) { return std::abs(p.x()) > 9 ? 0.25 : 1.02; };
  ASSERT_TRUE(QMA::adapt_quad_mesh(size, mesh).has_valid_mesh());
  std::size_t left = 0, right = 0;
  for(auto f : before.faces()) {
    if(mesh.is_removed(f)) continue;
    const auto u = CGAL::vertices_around_face(before.halfedge(f), before);
    const auto w = CGAL::vertices_around_face(mesh.halfedge(f), mesh);
    if(!std::equal(u.begin(), u.end(), w.begin(), w.end())) continue;
    ++(before.point(*u.begin()).x() + before.point(*std::next(u.begin(), 2)).x() > 0 ? right
                                                                                     : left);
  }
  EXPECT_EQ(left, right);
  EXPECT_GT(left + right, before.number_of_faces() / 4);
  EXPECT_EQ(unmatched(mesh, 0), 0u);
  EXPECT_EQ(unmatched(mesh, 1), 0u);
}

// A second call with the same sizes changes nothing.
TEST(Symmetry, IsRepeatable)
{
  Outcome o = adapt(centred(shape_zoo::cube(4)), uniform(0.31));
  o.mesh.collect_garbage();
  const Mesh first = o.mesh;
  QMA::adapt_quad_mesh(uniform(0.31), o.mesh);
  EXPECT_TRUE(zoo_mesh::is_same(first, o.mesh));
}
