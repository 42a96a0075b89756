// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Curvatures against analytic ones, and the chord error of adapted meshes against the one asked
// for.

#include "support/usual_calls.h"
#include "support/usual_files.h"

#include <CGAL/Quad_mesh_adaptation/Curvature_sizing_field.h>
#include <CGAL/Quad_mesh_adaptation/Graded_sizing_field.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace QMA = CGAL::Quad_mesh_adaptation;
using QMA::Curvature_sizing_field;

namespace {

using shape_zoo::Index;
using shape_zoo::pi;
using shape_zoo::Shape;
using shape_zoo::Vec;
using usual_mesh::Mesh;
using usual_mesh::mesh_of;
using usual_mesh::Point;
using usual_mesh::Size;

// Tube of radius 1 around a circle of radius 3, the whole of it or an open piece.
Shape torus(Index around, Index along)
{
  return shape_zoo::grid(
      "torus", along, around,
      [=](Index i, Index j) {
        const double a = 2 * pi * i / along, b = 2 * pi * j / around, r = 3 + std::cos(b);
        return Vec(r * std::cos(a), r * std::sin(a), std::sin(b));
      },
      true, true);
}

// A part of the side of a cylinder of radius 2, from angle 0 to `angle`, with n faces.
Shape cylinder_patch(Index n, double angle)
{
  return shape_zoo::grid("patch", n, 4, [=](Index i, Index j) {
    return Vec(2 * std::cos(angle * i / n), 2 * std::sin(angle * i / n), j);
  });
}

std::vector<QMA::internal::Principal_curvatures> curvatures(const Shape& s)
{
  const Mesh mesh = mesh_of(s);
  const auto arrays =
      QMA::internal::face_arrays(mesh, get(CGAL::vertex_point, mesh),
                                 QMA::internal::No_constraints<Mesh::Edge_index>(), "test");
  return QMA::internal::Curvature_estimator(arrays, std::cos(50 * pi / 180))();
}

// 9 x 9 points of a bilinear face.
std::vector<Vec> samples(const Shape& s, const shape_zoo::Quad& q)
{
  std::vector<Vec> list;
  for(int i = 0; i <= 8; ++i)
    for(int j = 0; j <= 8; ++j) {
      const double u = i / 8., v = j / 8.;
      list.push_back((1 - v) * ((1 - u) * s.points[q[0]] + u * s.points[q[1]]) +
                     v * ((1 - u) * s.points[q[3]] + u * s.points[q[2]]));
    }
  return list;
}

// Largest distance from the faces to the torus.
double distance_to_torus(const Mesh& mesh)
{
  double far = 0;
  const Shape s = zoo_mesh::shape_of(mesh);
  for(const auto& q : s.quads)
    for(const Vec& p : samples(s, q))
      far = (std::max)(far, std::abs(std::hypot(std::hypot(p.x(), p.y()) - 3, p.z()) - 1));
  return far;
}

// The larger of the distances from the faces to the reference and back, by the error asked for.
double both_ways(const QMA::Adaptation_report& report, double error)
{
  EXPECT_EQ(report.status, QMA::Adaptation_status::sizes_met);
  const QMA::Mesh_measures& m = report.after;
  std::cout << "chord error " << error << ", found " << m.mesh_to_reference << " and back "
            << m.reference_to_mesh << ", " << m.faces << " faces" << std::endl;
  return (std::max)(m.mesh_to_reference, m.reference_to_mesh) / error;
}

} // namespace

TEST(Curvatures, OfASphereOnACoarseMesh)
{
  for(const auto& k : curvatures(shape_zoo::sphere(4))) {
    EXPECT_NEAR(k.largest, 1, 0.08);
    EXPECT_NEAR(k.other, 1, 0.08);
  }
}

TEST(Curvatures, OfACylinderUpToItsBorderAndItsCreases)
{
  // twelve faces around, rims as border; and a patch whose border runs along it
  for(const Shape& s : { shape_zoo::open_cylinder(12, 4) })
    for(const auto& k : curvatures(s)) {
      EXPECT_NEAR(k.largest, 1, 0.04);
      EXPECT_NEAR(k.other, 0, 0.04);
    }
  for(const auto& k : curvatures(cylinder_patch(6, pi / 2))) EXPECT_NEAR(k.largest, 0.5, 0.01);
}

TEST(Curvatures, OfATorus)
{
  const Shape s = torus(32, 96);
  const auto found = curvatures(s);
  for(std::size_t v = 0; v < s.points.size(); ++v) {
    const Vec& p = s.points[v];
    const double r = std::hypot(p.x(), p.y()), other = (r - 3) / r; // k2, k1 is 1
    EXPECT_NEAR(found[v].largest, 1, 0.03);
    EXPECT_NEAR(found[v].other, (std::max)(0., other), 0.03);
  }
}

TEST(Curvatures, FlatSidesOfACubeAreFlatAndRoundBordersAreNot)
{
  for(const auto& k : curvatures(shape_zoo::cube(3))) EXPECT_NEAR(k.largest, 0, 1e-9);
  const Shape annulus = shape_zoo::annulus(16, 4);
  const auto found = curvatures(annulus);
  for(std::size_t v = 0; v < found.size(); ++v) {
    const double r = std::hypot(annulus.points[v].x(), annulus.points[v].y());
    const bool is_border = std::abs(r - 1) < 1e-9 || std::abs(r - 2) < 1e-9;
    EXPECT_NEAR(found[v].largest, is_border ? 1 / r : 0, 1e-9);
  }
}

TEST(Curvatures, ForgiveALittleNoise)
{
  Shape s = torus(48, 144);
  std::mt19937 random(5);
  std::uniform_real_distribution<> shift(-1, 1);
  const double edge = 2 * pi / 48;
  for(Vec& p : s.points) p = p + 0.01 * edge * Vec(shift(random), shift(random), shift(random));
  for(const auto& k : curvatures(s)) EXPECT_NEAR(k.largest, 1, 0.3);
}

TEST(Curvature_sizing_field, AsksForElementsInACircle)
{
  const Mesh mesh = mesh_of(shape_zoo::open_cylinder(24, 8));
  const auto size = Curvature_sizing_field::elements_per_circle(mesh, 40);
  const double h = 2 * std::sin(pi / 40);
  for(const auto v : mesh.vertices()) EXPECT_NEAR(size(mesh.point(v)) / h, 1, 0.02);
  const auto bounded = Curvature_sizing_field::elements_per_circle(mesh, 40, { 0.2, 0.5 });
  EXPECT_NEAR(bounded(Point(1, 0, 1)), 0.2, 1e-9);
  const auto other = Curvature_sizing_field::elements_per_circle(mesh, 4, { 0.2, 0.5 });
  EXPECT_NEAR(other(Point(1, 0, 1)), 0.5, 1e-9);
}

TEST(Curvature_sizing_field, FlatSurfacesGetTheLargestSize)
{
  const Mesh mesh = mesh_of(shape_zoo::plate(3, 4));
  const auto size = Curvature_sizing_field::chord_error(mesh, 0.1);
  EXPECT_NEAR(size(Point(1, 1, 0)), 5, 1e-9);
  EXPECT_NEAR(Curvature_sizing_field::chord_error(mesh, 0.1, { 0, 0.7 })(Point(1, 1, 0)), 0.7,
              1e-9);
}

TEST(Curvature_sizing_field, MeetsTheChordErrorOnATorus)
{
  const Mesh fine = mesh_of(torus(96, 288));
  for(const double error : { 0.03, 0.01 }) {
    Mesh mesh = mesh_of(torus(12, 36));
    const auto size = Curvature_sizing_field::chord_error(fine, error);
    const QMA::Adaptation_report report =
        QMA::adapt_quad_mesh(size, mesh, QMA::reference_surface(fine));
    EXPECT_EQ(report.status, QMA::Adaptation_status::sizes_met);
    const double found = distance_to_torus(mesh), larger = both_ways(report, error);
    std::cout << "to the exact torus " << found << ", expected " << report.expected_number_of_faces
              << " faces" << std::endl;
    EXPECT_LE(found, 1.1 * error);
    EXPECT_LE(larger, 1.1);
    EXPECT_GE(larger, 0.7); // not by far too fine
  }
}

// Facets are the reference here, and errors are from well above to below what these are off the
// torus: then each fold counts on its own.
TEST(Curvature_sizing_field, MeetsTheChordErrorOnFacetsBothWays)
{
  const Mesh facets = mesh_of(torus(16, 48));
  for(const double error : { 0.06, 0.03, 0.015 }) {
    Mesh mesh = facets;
    const auto size = Curvature_sizing_field::chord_error(facets, error);
    const double found = both_ways(QMA::adapt_quad_mesh(Size(std::cref(size)), mesh), error);
    EXPECT_LE(found, 1.1);
    EXPECT_GE(found, 0.6);
  }
}

TEST(Curvature_sizing_field, MeetsTheChordErrorOnAnEllipsoid)
{
  Shape s = shape_zoo::sphere(8);
  for(Vec& p : s.points) p = Vec(p.x(), 2 * p.y(), 3 * p.z());
  const Mesh facets = mesh_of(s);
  for(const double error : { 0.04, 0.02 }) {
    Mesh mesh = facets;
    const auto size = Curvature_sizing_field::chord_error(facets, error);
    const double found = both_ways(QMA::adapt_quad_mesh(Size(std::cref(size)), mesh), error);
    EXPECT_LE(found, 1.1);
    EXPECT_GE(found, 0.5);
  }
}

// A shape by others, coarse and with folds of two or three faces at its legs and ears, some of
// which turn by more than the feature angle and are no features all the same; with and without a
// gradation, and for errors at which those folds alone decide.
TEST(Curvature_sizing_field, MeetsTheChordErrorOnACowBothWays)
{
  Mesh cow;
  const auto read = QMA::read_quad_mesh(QUAD_MESH_DATA_DIR "/meshes/spot.off", cow);
  ASSERT_TRUE(read.ok()) << read.message;
  for(double error : { 0.018, 0.01, 0.005 }) {
    const Curvature_sizing_field size = Curvature_sizing_field::chord_error(cow, error);
    Mesh mesh = cow, graded = cow;
    const double found = both_ways(QMA::adapt_quad_mesh(Size(std::cref(size)), mesh), error);
    EXPECT_LE(found, 1.1);
    EXPECT_GE(found, 0.6);
    const QMA::Graded_sizing_field slow(cow, size, 0.3);
    EXPECT_LE(both_ways(QMA::adapt_quad_mesh(Size(std::cref(slow)), graded), error), 1.1);
  }
}

// On a smooth surface through the vertices nothing is folded.
TEST(Curvature_sizing_field, FoldsDoNotCountOnASmoothReference)
{
  const Mesh facets = mesh_of(torus(16, 48));
  const double error = 0.004;
  const Point inner(2, 0, 0);
  const auto flat = Curvature_sizing_field::chord_error(facets, error);
  const auto smooth =
      Curvature_sizing_field::chord_error(facets, error, {}, QMA::smooth_reference(true));
  EXPECT_NEAR(smooth(inner), 2 * std::sqrt(2 * error) / 1.48, 0.005);
  EXPECT_LT(flat(inner), 0.6 * smooth(inner));
  Mesh mesh = facets;
  QMA::adapt_quad_mesh(Size(std::cref(smooth)), mesh, QMA::smooth_reference(true));
  EXPECT_LE(distance_to_torus(mesh), 1.1 * error);
}

// Folds count in full: faces that turn by 0.6 at one edge only, on a strip that is flat beside it.
TEST(Curvature_sizing_field, SeesASingleFold)
{
  const double turn = 0.6, error = 0.1;
  const Mesh mesh = mesh_of(shape_zoo::grid("fold", 16, 4, [=](Index i, Index j) {
    const double x = i - 8.;
    return Vec(std::cos(turn / 2) * x, j, -std::sin(turn / 2) * std::abs(x));
  }));
  const auto size = Curvature_sizing_field::chord_error(mesh, error);
  const double h = size(Point(0, 2, 0));
  EXPECT_LE(h * turn / 4, error); // an edge straight over it
  EXPECT_GE(h * turn / 4, 0.4 * error);
  EXPECT_GT(size(Point(6, 2, -6 * std::tan(turn / 2))), 5 * h);
}

TEST(Curvature_sizing_field, RefusesWhatMakesNoSense)
{
  const Mesh mesh = mesh_of(shape_zoo::plate());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for(const double bad : { 0., -1., nan })
    EXPECT_THROW(Curvature_sizing_field::chord_error(mesh, bad), std::invalid_argument);
  for(const double bad : { 2., -5., nan })
    EXPECT_THROW(Curvature_sizing_field::elements_per_circle(mesh, bad), std::invalid_argument);
  EXPECT_THROW(Curvature_sizing_field::chord_error(mesh, 1, { 2, 1 }), std::invalid_argument);
  EXPECT_THROW(Curvature_sizing_field::chord_error(mesh, 1, { nan, 1 }), std::invalid_argument);
  EXPECT_THROW(Curvature_sizing_field::chord_error(Mesh(), 1), std::invalid_argument);
  for(const double bad : { 0., 200., nan })
    EXPECT_THROW(Curvature_sizing_field::chord_error(mesh, 1, {}, QMA::feature_angle(bad)),
                 std::invalid_argument);
}
