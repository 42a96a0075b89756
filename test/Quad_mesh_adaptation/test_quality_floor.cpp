// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// No face of an adapted mesh has a poor shape unless something of the input forbids a better one,
// and the report says which faces these are and why.

#include "support/more_shapes.h"
#include "support/usual_calls.h"
#include "support/usual_files.h"
#include "support/usual_passes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

namespace {

namespace QMA = CGAL::Quad_mesh_adaptation;
using QMA::Adaptation_report;
using QMA::Poor_face;
using QMA::Shape_limit;
using shape_zoo::Index;
using shape_zoo::Shape;
using shape_zoo::Vec;
using usual_mesh::Mesh;
using usual_mesh::Point;
using usual_mesh::read_shape;

// Kite with n x n faces: the given angle at the origin, about a right one at the other three.
Shape kite(Index n, double degrees)
{
  const double t = std::tan(degrees * 3.14159265358979323846 / 360);
  const Vec a(1, -t, 0), b(1, t, 0), c(1 + t, 0, 0);
  return shape_zoo::grid("kite", n, n, [=](Index i, Index j) {
    const double u = double(i) / n, v = double(j) / n;
    return u * (1 - v) * a + (1 - u) * v * b + u * v * c;
  });
}

// What the list of poor faces says must be true of the mesh.
void expect_true(const Adaptation_report& report, const Mesh& mesh)
{
  std::vector<double> jacobian;
  for(auto f : mesh.faces()) {
    std::array<Vec, 4> p;
    int i = 0;
    for(auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      p[i++] = Vec(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
    jacobian.push_back(mesh_checks::scaled_jacobian(p[0], p[1], p[2], p[3]));
  }
  std::size_t poor = 0;
  for(double j : jacobian)
    if(j < Poor_face::floor) ++poor;
  ASSERT_EQ(report.poor_faces.size(), poor);
  for(const Poor_face& p : report.poor_faces) {
    EXPECT_NEAR(p.scaled_jacobian, jacobian.at(p.face), 1e-9);
    if(p.limit != Shape_limit::feature_angle) continue;
    EXPECT_LT(p.angle, std::asin(Poor_face::floor) * 180 / 3.14159265358979323846);
    const auto meeting = *std::next(mesh.vertices_begin(), long(p.vertex));
    const auto corners =
        mesh.vertices_around_face(mesh.halfedge(*std::next(mesh.faces_begin(), long(p.face))));
    EXPECT_EQ(std::count(corners.begin(), corners.end(), meeting), 1);
  }
}

Adaptation_report adapt(const Shape& s, double factor, Mesh& mesh)
{
  mesh = zoo_mesh::make<Mesh, Point>(s);
  const mesh_checks::Facts before = mesh_checks::facts_of(s.points, s.quads);
  const Adaptation_report report = QMA::adapt_quad_mesh(factor * zoo_mesh::mean_edge(s), mesh);
  EXPECT_EQ(report.status, QMA::Adaptation_status::sizes_met) << report.message;
  expect_true(report, mesh);
  Mesh packed = mesh;
  packed.collect_garbage();
  zoo_mesh::expect_valid(packed, before);
  return report;
}

void expect_good_shapes(const Shape& s, double factor)
{
  SCOPED_TRACE(s.name + ", " + std::to_string(factor));
  Mesh mesh;
  const Adaptation_report report = adapt(s, factor, mesh);
  EXPECT_EQ(report.after.inverted_faces, 0u);
  const auto largest = [](const QMA::Mesh_measures& m) {
    return m.interior_valence.empty() ? 0u : m.interior_valence.rbegin()->first;
  };
  EXPECT_LE(largest(report.after), (std::max)(std::size_t(5), std::size_t(largest(report.before))));
  // a hair below the floor, a face is not worth two: the rim of the closed cylinder has such
  for(const Poor_face& p : report.poor_faces)
    EXPECT_TRUE(p.limit != Shape_limit::none || p.scaled_jacobian > 0.44)
        << "face " << p.face << ", " << p.scaled_jacobian;
}

} // namespace

TEST(Quality_floor, HoldsOnEveryShape)
{
  std::vector<Shape> shapes = shape_zoo::all();
  for(const Shape& s :
      { more_shapes::bracket(), more_shapes::closed_cylinder(4), more_shapes::paraboloid(4),
        more_shapes::ridge(12), more_shapes::two_sheets(0.08), more_shapes::two_spheres(4, 0.02),
        more_shapes::thin_box(0.1), kite(8, 40) })
    shapes.push_back(s);
  for(const Shape& s : shapes)
    for(double factor : { 0.35, 0.6, 1.7, 3. }) expect_good_shapes(s, factor);
}

TEST(Quality_floor, HoldsOnRealMeshes)
{
  for(const char* name : { "box_cylinder", "cylinder_hex", "pawn", "star" })
    for(double factor : { 0.5, 0.8, 2., 5. }) expect_good_shapes(read_shape(name), factor);
}

// Where a row of faces passes a bend of a rim, one face has a flat angle there.
TEST(Quality_floor, HoldsOnSmallRims)
{
  for(double factor : { 0.35, 0.5, 0.7, 1. })
    expect_good_shapes(more_shapes::truncated_cone(4), factor);
}

// Between the features of fingers and toes, in a mesh that is too large to be copied often.
TEST(Quality_floor, HoldsInFolds) { expect_good_shapes(read_shape("makehuman_body"), 2); }

// Small faces have room for good shapes in folds as well, if their nodes look for the surface in
// the right one.
TEST(Quality_floor, SmallFacesInFoldsAreGood)
{
  Mesh mesh;
  const Adaptation_report report = adapt(read_shape("makehuman_body"), 0.5, mesh);
  EXPECT_TRUE(report.poor_faces.empty()) << report.after.min_scaled_jacobian;
}

// A regular mesh that is a little too large everywhere must not get irregular nodes everywhere.
TEST(Quality_floor, AlmostFineEnoughStaysRegular)
{
  for(Index n : { 6, 8, 12, 16 }) {
    const Shape sphere = shape_zoo::sphere(n);
    for(double factor : { 0.97, 0.98, 0.99, 1. }) {
      SCOPED_TRACE(std::to_string(n) + ", " + std::to_string(factor));
      Mesh mesh;
      const Adaptation_report report = adapt(sphere, factor, mesh);
      EXPECT_GE(report.after.efficiency, 0.85);
      EXPECT_LE(double(report.after.irregular_interior_vertices),
                0.12 * double(report.after.interior_vertices));
    }
  }
}

// Creases inside a surface become as coarse as the faces beside them.
TEST(Quality_floor, CreasesAreCoarsened)
{
  double efficiency = 0;
  int runs = 0;
  for(Index n : { 8, 12, 16 })
    for(double factor : { 2., 2.5, 3. }) {
      const Shape dome = more_shapes::dome(n);
      SCOPED_TRACE(std::to_string(n) + ", " + std::to_string(factor));
      Mesh mesh;
      const Adaptation_report report = adapt(dome, factor, mesh);
      EXPECT_GE(report.after.efficiency, 0.5);
      efficiency += report.after.efficiency;
      ++runs;
    }
  EXPECT_GE(efficiency / runs, 0.7);
}

TEST(Quality_floor, SmallAnglesOfFeaturesAreNamed)
{
  for(double degrees : { 12., 18., 25. })
    for(double factor : { 0.4, 0.7, 1.5 }) {
      SCOPED_TRACE(std::to_string(degrees) + ", " + std::to_string(factor));
      Mesh mesh;
      const Adaptation_report report = adapt(kite(8, degrees), factor, mesh);
      ASSERT_EQ(report.poor_faces.size(), 1u);
      const Poor_face& p = report.poor_faces.front();
      EXPECT_EQ(p.limit, Shape_limit::feature_angle);
      EXPECT_NEAR(p.angle, degrees, 1e-6);
      EXPECT_EQ(mesh.point(*std::next(mesh.vertices_begin(), long(p.vertex))), Point(0, 0, 0));
    }
}

// Only the face at the corner is excused: two nodes on either side can lie opposite each other, and
// an angle at an inner node leaves half a turn or more to the faces beyond, so that none of these
// must be poor.
TEST(Quality_floor, FacesBesideASmallAngleAreNotExcused)
{
  for(double degrees : { 1., 2., 3., 5. })
    for(double factor : { 0.4, 0.7, 1. }) {
      SCOPED_TRACE(std::to_string(degrees) + ", " + std::to_string(factor));
      Mesh mesh;
      const Adaptation_report report = adapt(kite(8, degrees), factor, mesh);
      int named = 0;
      for(const Poor_face& p : report.poor_faces) {
        if(p.limit == Shape_limit::none) continue;
        EXPECT_EQ(p.limit, Shape_limit::feature_angle);
        EXPECT_NEAR(p.angle, degrees, 1e-6);
        EXPECT_EQ(mesh.point(*std::next(mesh.vertices_begin(), long(p.vertex))), Point(0, 0, 0));
        ++named;
      }
      EXPECT_EQ(named, 1);
    }
}

TEST(Quality_floor, HeldNodesAreNamed)
{
  Shape s = shape_zoo::plate(6, 6);
  Mesh mesh = zoo_mesh::make<Mesh, Point>(s);
  // a face drawn out of shape and held so
  const auto held = mesh.add_property_map<Mesh::Vertex_index, bool>("v:held", false).first;
  const auto h = mesh.halfedge(Mesh::Face_index(14));
  for(auto v : mesh.vertices_around_face(h)) held[v] = true;
  const Point p = mesh.point(mesh.target(h)), q = mesh.point(mesh.source(mesh.prev(h)));
  mesh.point(mesh.target(h)) =
      Point(p.x() + 0.4 * (q.x() - p.x()), p.y() + 0.4 * (q.y() - p.y()), 0);
  const auto np = CGAL::parameters::vertex_is_constrained_map(held);
  // moving the others does not help that face, operations may
  const Adaptation_report moved = QMA::smooth(1.2, mesh, np);
  expect_true(moved, mesh);
  ASSERT_EQ(moved.poor_faces.size(), 1u);
  EXPECT_EQ(moved.poor_faces[0].face, 14u);
  EXPECT_EQ(moved.poor_faces[0].limit, Shape_limit::held_nodes);
  const Adaptation_report report = QMA::adapt_quad_mesh(1.2, mesh, np);
  ASSERT_TRUE(report.has_valid_mesh()) << report.message;
  expect_true(report, mesh);
  for(const Poor_face& p : report.poor_faces) EXPECT_EQ(p.limit, Shape_limit::held_nodes);
}
