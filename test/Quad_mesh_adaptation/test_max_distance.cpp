// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// max_distance(): no face is farther from the reference than asked, by all that the report measures
// and by points of the faces against all triangles of the input.

#include "support/feature_checks.h"
#include "support/more_shapes.h"
#include "support/usual_calls.h"
#include "support/usual_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace {

namespace QMA = CGAL::Quad_mesh_adaptation;
using feature_checks::Quad_distances;
using QMA::Adaptation_report;
using shape_zoo::Index;
using shape_zoo::Quad;
using shape_zoo::Shape;
using shape_zoo::Vec;
using usual_mesh::Mesh;
using usual_mesh::Point;
using usual_mesh::read_shape;

// Cut either way: at least as near as the way that counts.
double off_shape(const Vec& p, const Quad_distances& of)
{
  double least = 1e9;
  for(std::size_t f = 0; f < of.s.quads.size(); ++f) least = of.lesser(least, p, int(f));
  return least;
}

// Of the middles of faces and edges.
double farthest_middle(const Shape& s, const Shape& shape)
{
  const Quad_distances of(shape);
  double largest = 0;
  for(const Quad& q : s.quads) {
    const Vec a = s.points[q[0]], b = s.points[q[1]], c = s.points[q[2]], d = s.points[q[3]];
    largest = (std::max)({ largest, off_shape(0.25 * (a + b + c + d), of),
                           off_shape(0.5 * (a + b), of), off_shape(0.5 * (c + d), of) });
  }
  return largest;
}

// The largest distance of many points of the faces of s, evenly spread.
double farthest_point(const Shape& s, const Shape& of_shape)
{
  constexpr int n = 16;
  const Quad_distances of(of_shape);
  double largest = 0;
  for(const Quad& q : s.quads)
    for(int i = 0; i <= n; ++i)
      for(int j = 0; j <= n; ++j) {
        const double u = double(i) / n, v = double(j) / n;
        largest = (std::max)(largest,
                             off_shape((1 - v) * ((1 - u) * s.points[q[0]] + u * s.points[q[1]]) +
                                           v * (u * s.points[q[2]] + (1 - u) * s.points[q[3]]),
                                       of));
      }
  return largest;
}

Adaptation_report expect_within(const Shape& shape, double factor, double part)
{
  SCOPED_TRACE(shape.name + ", " + std::to_string(part) + " edges");
  Mesh mesh = zoo_mesh::make<Mesh, Point>(shape);
  const double edge = zoo_mesh::mean_edge(shape), bound = part * edge;
  const Adaptation_report report =
      QMA::adapt_quad_mesh(factor * edge, mesh, QMA::max_distance(bound));
  EXPECT_EQ(report.status, QMA::Adaptation_status::sizes_met) << report.message;
  EXPECT_TRUE(report.faces_too_far.empty());
  EXPECT_LE(report.after.mesh_to_reference, bound);
  EXPECT_LE(report.after.reference_to_mesh, bound);
  EXPECT_EQ(report.after.strict_size_ratio.percent_not_larger(), 100);
  EXPECT_GT(report.after.min_scaled_jacobian, 0.2);
  mesh.collect_garbage();
  zoo_mesh::expect_valid(mesh, mesh_checks::facts_of(shape.points, shape.quads));
  if(report.after.faces < 1500) {
    EXPECT_LE(farthest_middle(zoo_mesh::shape_of(mesh), shape), bound);
  }
  return report;
}

} // namespace

TEST(Max_distance, OnShapes)
{
  for(const Shape& shape :
      { shape_zoo::sphere(), shape_zoo::torus(), shape_zoo::saddle(), shape_zoo::open_cylinder(),
        more_shapes::closed_cylinder(6), more_shapes::two_spheres(6, 0.02) })
    for(double part : { 0.3, 0.1, 0.03 }) expect_within(shape, 2, part);
}

TEST(Max_distance, OnMeshesByOthers)
{
  for(const char* name : { "spot", "pawn", "cylinder_hex", "box_cylinder" })
    expect_within(read_shape(name), 2, 0.1);
}

// What the report says is what many more points say than it looks at.
TEST(Max_distance, IsMeasuredBetweenSamples)
{
  const Shape cylinder = shape_zoo::open_cylinder(17, 4);
  for(double size : { 0.2, 0.3, 0.35, 0.4 }) {
    SCOPED_TRACE(size);
    Mesh mesh = zoo_mesh::make<Mesh, Point>(cylinder);
    const Adaptation_report report = QMA::adapt_quad_mesh(size, mesh);
    mesh.collect_garbage();
    const Shape result = zoo_mesh::shape_of(mesh);
    const double there = farthest_point(result, cylinder), back = farthest_point(cylinder, result);
    EXPECT_GT(report.after.mesh_to_reference, 0.97 * there);
    EXPECT_GT(report.after.reference_to_mesh, 0.97 * back);
    EXPECT_LT(report.after.mesh_to_reference, 1.001 * (std::max)(there, back));
  }
}

TEST(Max_distance, IsKeptBetweenSamples)
{
  const Shape cylinder = shape_zoo::open_cylinder(17, 4);
  for(double bound : { 0.025, 0.02, 0.015 }) {
    SCOPED_TRACE(bound);
    Mesh mesh = zoo_mesh::make<Mesh, Point>(cylinder);
    const Adaptation_report report = QMA::adapt_quad_mesh(0.3, mesh, QMA::max_distance(bound));
    mesh.collect_garbage();
    const Shape result = zoo_mesh::shape_of(mesh);
    EXPECT_EQ(report.status, QMA::Adaptation_status::sizes_met) << report.message;
    EXPECT_LE(farthest_point(result, cylinder), 1.01 * bound);
    EXPECT_LE(farthest_point(cylinder, result), 1.01 * bound);
  }
}

// Facets that fold by up to 35 degrees in both directions: what smoothing and operations make of
// split faces may be farther off than a look at few points tells, again and again.
TEST(Max_distance, IsKeptOnFolds)
{
  const Shape waves = shape_zoo::grid("waves", 16, 16, [](Index i, Index j) {
    return Vec(0.25 * i, 0.25 * j, 0.15 * std::sin(1.3 * i + 0.4 * j) * std::sin(1.1 * j));
  });
  for(double part : { 0.06, 0.045 }) expect_within(waves, 2, part);
}

// Where it can not be kept the report tells of a distance that is larger, not only of the faces.
TEST(Max_distance, WhereItIsMissedTheReportSaysByHowMuch)
{
  const Shape folds = shape_zoo::grid("folds", 7, 7, [](Index i, Index j) {
    return Vec(0.25 * i, 0.25 * j, 0.6 * std::sin(1.9 * i + 0.4 * j) * std::sin(1.7 * j));
  });
  Mesh mesh = zoo_mesh::make<Mesh, Point>(folds);
  constexpr double bound = 0.01;
  const Adaptation_report report = QMA::adapt_quad_mesh(0.5, mesh, QMA::max_distance(bound));
  ASSERT_FALSE(report.faces_too_far.empty()); // there are facets that turn by a right angle
  EXPECT_EQ(report.status, QMA::Adaptation_status::sizes_not_met);
  EXPECT_GT((std::max)(report.after.mesh_to_reference, report.after.reference_to_mesh), bound);
}

// A bound that asks for nothing changes little, and one that does takes more faces.
TEST(Max_distance, TakesFacesWhereItMust)
{
  const Shape torus = shape_zoo::torus();
  Mesh mesh = zoo_mesh::make<Mesh, Point>(torus);
  const auto free = QMA::adapt_quad_mesh(2 * zoo_mesh::mean_edge(torus), mesh);
  const std::size_t loose = expect_within(torus, 2, 1).after.faces,
                    tight = expect_within(torus, 2, 0.1).after.faces,
                    tighter = expect_within(torus, 2, 0.05).after.faces;
  EXPECT_NEAR(double(loose) / double(free.after.faces), 1, 0.3);
  EXPECT_GT(tight, 4 * loose);
  EXPECT_GT(tighter, tight);
}

// A flat surface with straight borders asks for nothing.
TEST(Max_distance, OnAPlane)
{
  const Shape plate = shape_zoo::plate(12, 12);
  EXPECT_LT(expect_within(plate, 3, 1e-6).after.faces, 30u);
}
