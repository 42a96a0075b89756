// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The number of faces predicted against the one that comes out.

#include "support/usual_calls.h"
#include "support/usual_files.h"

#include <CGAL/Quad_mesh_adaptation/expected_number_of_faces.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace QMA = CGAL::Quad_mesh_adaptation;

namespace {

using usual_mesh::Mesh;
using usual_mesh::mesh_of;
using usual_mesh::Point;
using usual_mesh::read_mesh;
using usual_mesh::Size;

double mean_edge(const Mesh& mesh) { return zoo_mesh::mean_edge(zoo_mesh::shape_of(mesh)); }

template <class NP = CGAL::parameters::Default_named_parameters>
void expect_near(const std::string& name, Mesh mesh, const Size& size,
                 const NP& np = CGAL::parameters::default_values(), double tolerance = 0.12)
{
  SCOPED_TRACE(name);
  const double expected = QMA::expected_number_of_faces(size, mesh, np);
  const QMA::Adaptation_report report = QMA::adapt_quad_mesh(size, mesh, np);
  ASSERT_TRUE(report.has_valid_mesh()) << report.message;
  std::cout << name << ": " << report.before.faces << " faces, expected " << expected << ", got "
            << report.after.faces << std::endl;
  const double formula = report.expected_number_of_faces;
  EXPECT_NEAR(formula / double(report.after.faces), 1, tolerance);
  if(formula <= QMA::most_rehearsed_faces) {
    EXPECT_EQ(expected, double(report.after.faces));
  } else {
    EXPECT_NEAR(expected, formula, 1e-6 * formula);
  }
}

Size uniform(double h)
{
  return [h](const Point&) { return h; };
}

} // namespace

// Few faces are tried and counted, on all of the mesh or on a mirrored part.
TEST(Expected_number_of_faces, OfSmallOutcomes)
{
  int rehearsed = 0;
  for(const shape_zoo::Shape& shape : shape_zoo::all())
    for(double factor : { 1.4, 3. }) {
      SCOPED_TRACE(shape.name + " x " + std::to_string(factor));
      const Mesh given = mesh_of(shape);
      const double h = factor * mean_edge(given);
      Mesh mesh = given;
      const double expected = QMA::expected_number_of_faces(h, given);
      const QMA::Adaptation_report report = QMA::adapt_quad_mesh(h, mesh);
      if(report.expected_number_of_faces <= QMA::most_rehearsed_faces) {
        ++rehearsed;
        EXPECT_EQ(expected, double(report.after.faces));
      }
      EXPECT_EQ(zoo_mesh::shape_of(given).quads, zoo_mesh::shape_of(mesh_of(shape)).quads);
    }
  EXPECT_GT(rehearsed, 10);
}

TEST(Expected_number_of_faces, OfSmallOutcomesWithParameters)
{
  const Mesh given = mesh_of(shape_zoo::annulus());
  const double h = 0.8 * mean_edge(given);
  for(bool is_symmetric : { false, true })
    for(QMA::Aim aim : { QMA::Aim::not_larger, QMA::Aim::nearest }) {
      const auto np = QMA::aim(aim, QMA::symmetry(is_symmetric));
      Mesh mesh = given;
      const double expected = QMA::expected_number_of_faces(h, given, np);
      EXPECT_EQ(expected, double(QMA::adapt_quad_mesh(h, mesh, np).after.faces));
    }
}

// The function takes what adapt_quad_mesh() takes.
TEST(Expected_number_of_faces, OfSmallOutcomesWithMoreParameters)
{
  const auto expect_same = [](const std::string& name, Mesh mesh, double h, const auto& np) {
    SCOPED_TRACE(name);
    const double expected = QMA::expected_number_of_faces(h, mesh, np);
    const QMA::Adaptation_report report = QMA::adapt_quad_mesh(h, mesh, np);
    EXPECT_EQ(expected, double(report.after.faces));
  };
  const shape_zoo::Shape plate = shape_zoo::plate(12, 12);
  Mesh halves = mesh_of(plate);
  auto patch = halves.add_property_map<Mesh::Face_index, int>("f:patch", 0).first;
  for(Mesh::Face_index f : halves.faces())
    for(Mesh::Vertex_index v : vertices_around_face(halves.halfedge(f), halves))
      if(halves.point(v).x() > 7.5) patch[f] = 1;
  const double without = QMA::expected_number_of_faces(3., halves);
  EXPECT_NE(QMA::expected_number_of_faces(3., halves, CGAL::parameters::face_patch_map(patch)),
            without);
  expect_same("patches", halves, 3, CGAL::parameters::face_patch_map(patch));
  const Mesh sphere = mesh_of(shape_zoo::sphere(6)), torus = mesh_of(shape_zoo::torus());
  expect_same("distance", sphere, 0.8, QMA::max_distance(0.02));
  expect_same("smooth", torus, 0.5, QMA::smooth_reference(true));
  expect_same("iterations", torus, 0.3, CGAL::parameters::number_of_iterations(1));
  const Mesh irregular = mesh_of(shape_zoo::irregular());
  const auto quick = QMA::effort(QMA::Effort::quick);
  int differing = 0; // else this does not show that the effort counts
  for(double factor : { 0.83, 1.3, 1.8 }) {
    const double h = factor * mean_edge(irregular);
    expect_same("effort", irregular, h, quick);
    differing += QMA::expected_number_of_faces(h, irregular, quick) !=
                 QMA::expected_number_of_faces(h, irregular);
  }
  EXPECT_GT(differing, 0);
}

TEST(Expected_number_of_faces, OfARegion)
{
  Mesh mesh = mesh_of(shape_zoo::plate(12, 12));
  std::vector<Mesh::Face_index> region;
  for(Mesh::Face_index f : mesh.faces())
    if(mesh.point(mesh.source(mesh.halfedge(f))).x() < 6) region.push_back(f);
  for(double h : { 0.4, 3. }) {
    Mesh copy = mesh;
    const double expected = QMA::expected_number_of_faces(region, h, mesh);
    EXPECT_EQ(expected, double(QMA::adapt_quad_mesh(region, h, copy).after.faces));
  }
}

// Fingers, toes and ears that are thinner than the size, and many short creases.
TEST(Expected_number_of_faces, OfABodyInFewFaces)
{
  const Mesh body = read_mesh("makehuman_body");
  const Point p0 = body.point(target(halfedge(*body.faces().begin(), body), body));
  const double edge = mean_edge(body);
  expect_near(
      "body, graded", body,
      [=](const Point& p) { return edge + 0.125 * std::sqrt(CGAL::squared_distance(p, p0)); },
      CGAL::parameters::default_values(), 0.15);
}

TEST(Expected_number_of_faces, OfRefinements)
{
  const Mesh torus = mesh_of(shape_zoo::torus()), sphere = mesh_of(shape_zoo::sphere()),
             cube = mesh_of(shape_zoo::cube()), disk = mesh_of(shape_zoo::disk()),
             icf = read_mesh("icf");
  expect_near("torus, 0.4", torus, uniform(0.4 * mean_edge(torus)));
  expect_near("sphere, graded", sphere, [](const Point& p) { return 0.05 + 0.08 * (1 + p.z()); });
  expect_near("cube, 0.24", cube, uniform(0.24 * mean_edge(cube)));
  expect_near("disk, graded", disk,
              [](const Point& p) { return 0.1 + 0.2 * std::hypot(p.x(), p.y()); });
  expect_near("icf, half", icf, uniform(0.5 * mean_edge(icf)));
  const Mesh annulus = mesh_of(shape_zoo::annulus(36, 5)), pawn = read_mesh("pawn");
  expect_near("annulus, linear", annulus,
              [](const Point& p) { return 0.07 + 0.03 * std::abs(p.x()); });
  expect_near("pawn, 0.8", pawn, uniform(0.8 * mean_edge(pawn)));
}

TEST(Expected_number_of_faces, OfCoarsenings)
{
  const Mesh disk = mesh_of(shape_zoo::disk(12, 9)), torus = mesh_of(shape_zoo::torus()),
             sphere = mesh_of(shape_zoo::sphere(12)),
             ellipse = read_mesh("rotated_ellipse_with_subregions");
  expect_near("disk, three times", disk, uniform(3 * mean_edge(disk)));
  const double edge = mean_edge(torus);
  expect_near("torus, graded", torus,
              [edge](const Point& p) { return edge * (1.3 + 0.3 * p.x()); });
  expect_near("sphere, three times", sphere, uniform(3 * mean_edge(sphere)));
  expect_near("ellipse, three times", ellipse, uniform(3 * mean_edge(ellipse)));
}

TEST(Expected_number_of_faces, OfASteepSizeAndOfTheOtherAim)
{
  const Mesh plate = mesh_of(shape_zoo::plate(10, 10));
  expect_near("plate, steep", plate,
              [](const Point& p) { return 0.15 + std::abs(std::hypot(p.x() - 5, p.y() - 5) - 4); });
  expect_near(
      "plate, nearest", plate, [](const Point& p) { return 0.3 + 0.05 * p.x(); },
      QMA::aim(QMA::Aim::nearest));
}

TEST(Expected_number_of_faces, AnAdaptedMeshKeepsItsFaces)
{
  Mesh mesh = mesh_of(shape_zoo::plate(10, 10));
  const Size size = [](const Point& p) { return 0.4 + 0.1 * p.x(); };
  QMA::adapt_quad_mesh(size, mesh);
  mesh.collect_garbage();
  EXPECT_EQ(QMA::expected_number_of_faces(size, mesh), double(mesh.number_of_faces()));
}

TEST(Expected_number_of_faces, ThrowsWhereTheMeshWouldBeRefused)
{
  EXPECT_THROW(QMA::expected_number_of_faces(1, Mesh()), std::invalid_argument);
  Mesh triangle;
  triangle.add_face(triangle.add_vertex(Point(0, 0, 0)), triangle.add_vertex(Point(1, 0, 0)),
                    triangle.add_vertex(Point(0, 1, 0)));
  EXPECT_THROW(QMA::expected_number_of_faces(1, triangle), std::invalid_argument);
  const Mesh plate = mesh_of(shape_zoo::plate());
  EXPECT_THROW(QMA::expected_number_of_faces(-1, plate), std::domain_error);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(QMA::expected_number_of_faces(uniform(nan), plate), std::domain_error);
  struct Mine
  {
  };
  const auto throws = [](const Point&) -> double { throw Mine(); };
  EXPECT_THROW(QMA::expected_number_of_faces(throws, plate), Mine);
}
