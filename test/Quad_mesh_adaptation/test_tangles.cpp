// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Inputs with nodes that have crossed others: what is tangled is no shape to be kept.

#include "support/usual_calls.h"
#include "support/usual_passes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace QMA = CGAL::Quad_mesh_adaptation;

namespace {

using QMA::Adaptation_report;
using shape_zoo::Shape;
using shape_zoo::Vec;
using usual_mesh::Mesh;
using usual_mesh::Point;

constexpr int n = 10;

std::size_t node(int i, int j) { return std::size_t(j * (n + 1) + i); }

// A plate of n x n unit squares in a slanting plane, once its nodes are where they are to be.
Shape slanting(Shape plate)
{
  for(Vec& p : plate.points) p = Vec(0.6 * p.x(), 0.8 * p.x(), p.y());
  return plate;
}

// One inner node beyond its neighbours.
Shape with_one_node_astray()
{
  Shape plate = shape_zoo::plate(n, n);
  plate.points[node(5, 5)] = Vec(6.3, 6.2, 0);
  return slanting(plate);
}

// All inner nodes moved by up to `most` in both directions.
Shape shaken(unsigned seed, double most)
{
  Shape plate = shape_zoo::plate(n, n);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> by(-most, most);
  for(int j = 1; j < n; ++j)
    for(int i = 1; i < n; ++i) {
      Vec& p = plate.points[node(i, j)];
      p = p + Vec(by(random), by(random), 0);
    }
  return slanting(plate);
}

// The area of the plate, to the last digits: nothing is folded any more.
double area(const Mesh& mesh)
{
  double sum = 0;
  for(auto f : mesh.faces()) {
    std::vector<Point> p;
    for(auto v : vertices_around_face(mesh.halfedge(f), mesh)) p.push_back(mesh.point(v));
    sum += 0.5 * std::sqrt(CGAL::cross_product(p[2] - p[0], p[3] - p[1]).squared_length());
  }
  return sum;
}

void expect_untangled(const Shape& shape, const Mesh& mesh, const Adaptation_report& report,
                      double least_jacobian)
{
  ASSERT_TRUE(report.has_valid_mesh()) << report.message;
  zoo_mesh::expect_valid(mesh, mesh_checks::facts_of(shape.points, shape.quads));
  EXPECT_EQ(report.corners, 4u);
  EXPECT_EQ(report.feature_curves, 4u);
  EXPECT_GE(report.after.min_scaled_jacobian, least_jacobian);
  EXPECT_NEAR(area(mesh), double(n * n), 1e-9);
}

bool is_told_of(const Adaptation_report& report)
{
  for(const std::string& text : report.advice)
    if(text.find("the other way round") != std::string::npos) return true;
  return false;
}

} // namespace

TEST(Tangled_plane, OneNodeAstray)
{
  const Shape shape = with_one_node_astray();
  for(double h : { 0.45, 1., 2. }) {
    SCOPED_TRACE(h);
    Mesh mesh = zoo_mesh::make<Mesh, Point>(shape);
    const Adaptation_report report = QMA::adapt_quad_mesh(h, mesh);
    expect_untangled(shape, mesh, report, 0.5);
    EXPECT_TRUE(is_told_of(report));
    EXPECT_EQ(report.after.strict_size_ratio.percent_not_larger(), 100);
  }
}

TEST(Tangled_plane, AllNodesShaken)
{
  for(unsigned seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Shape shape = shaken(seed, 0.8);
    Mesh mesh = zoo_mesh::make<Mesh, Point>(shape);
    expect_untangled(shape, mesh, QMA::adapt_quad_mesh(1., mesh), 0.5);
  }
}

TEST(Tangled_plane, OtherCalls)
{
  const Shape shape = with_one_node_astray();
  Mesh mesh = zoo_mesh::make<Mesh, Point>(shape);
  expect_untangled(shape, mesh, QMA::smooth(1., mesh), 0.1);
  mesh = zoo_mesh::make<Mesh, Point>(shape);
  expect_untangled(shape, mesh, QMA::clean_up(1., mesh), 0.3);
  mesh = zoo_mesh::make<Mesh, Point>(shape);
  expect_untangled(shape, mesh, QMA::adapt_quad_mesh(1., mesh, QMA::schedule(QMA::Schedule::paper)),
                   0.3);
}

// A sheet folded in two has a crease, although all of it lies in a plane.
TEST(Tangled_plane, FoldedSheetKeepsItsFold)
{
  Shape sheet = shape_zoo::plate(n, n);
  for(Vec& p : sheet.points)
    if(p.x() > 0.5 * n) p = Vec(n - p.x(), p.y(), 0);
  Mesh mesh = zoo_mesh::make<Mesh, Point>(sheet);
  const Adaptation_report report = QMA::adapt_quad_mesh(0.6, mesh);
  ASSERT_TRUE(report.has_valid_mesh()) << report.message;
  EXPECT_FALSE(is_told_of(report));
  EXPECT_EQ(report.patches, 2u);
  EXPECT_NEAR(area(mesh), double(n * n), 1e-9);
}

// Nor is a small hem a tangle, if the edges along which it is folded are marked.
TEST(Tangled_plane, MarkedHemStays)
{
  Shape sheet = shape_zoo::plate(n, n);
  for(Vec& p : sheet.points) p = Vec(p.x() > n - 0.5 ? n - 1.5 : p.x(), p.y(), 0);
  Mesh mesh = zoo_mesh::make<Mesh, Point>(sheet);
  auto marked = mesh.add_property_map<Mesh::Edge_index, bool>("e:fold", false).first;
  for(auto e : mesh.edges())
    marked[e] =
        mesh.point(mesh.vertex(e, 0)).x() == n - 1 && mesh.point(mesh.vertex(e, 1)).x() == n - 1;
  const Adaptation_report report =
      QMA::adapt_quad_mesh(0.6, mesh, CGAL::parameters::edge_is_constrained_map(marked));
  ASSERT_TRUE(report.has_valid_mesh()) << report.message;
  EXPECT_FALSE(is_told_of(report));
  EXPECT_EQ(report.patches, 2u);
  EXPECT_NEAR(area(mesh), n * (n - 0.5), 1e-9);
}

// Two plates side by side, one of them turned over, are not tangled.
TEST(Tangled_plane, PartTurnedOverStays)
{
  Shape both = shape_zoo::plate(n, n), other = shape_zoo::plate(2, 2);
  const auto shift = decltype(both.quads)::value_type::value_type(both.points.size());
  for(const Vec& p : other.points) both.points.push_back(p + Vec(n + 1, 0, 0));
  for(auto q : other.quads)
    both.quads.push_back({ q[0] + shift, q[3] + shift, q[2] + shift, q[1] + shift });
  Mesh mesh = zoo_mesh::make<Mesh, Point>(both);
  const Adaptation_report report = QMA::adapt_quad_mesh(0.6, mesh);
  ASSERT_TRUE(report.has_valid_mesh()) << report.message;
  EXPECT_FALSE(is_told_of(report));
  EXPECT_NEAR(area(mesh), double(n * n + 4), 1e-9);
  EXPECT_GE(report.after.min_scaled_jacobian, 0.45);
}

// On curved surfaces the edges about nodes that have slid over others are no creases, either.
TEST(Tangled_surface, NodesAstray)
{
  for(const Shape& smooth : { shape_zoo::torus(24, 12), shape_zoo::torus(48, 24) })
    for(unsigned seed = 1; seed <= 3; ++seed) {
      SCOPED_TRACE(smooth.name + ", seed " + std::to_string(seed));
      Shape shape = smooth;
      std::mt19937 random(seed);
      for(int k = 0; k < 5; ++k) {
        const auto& q = smooth.quads[random() % smooth.quads.size()];
        const Vec from = smooth.points[q[0]], to = smooth.points[q[1]];
        shape.points[q[0]] = to + 0.4 * (to - from);
      }
      Mesh mesh = zoo_mesh::make<Mesh, Point>(shape);
      const Adaptation_report report = QMA::adapt_quad_mesh(zoo_mesh::mean_edge(smooth), mesh);
      ASSERT_TRUE(report.has_valid_mesh()) << report.message;
      zoo_mesh::expect_valid(mesh, mesh_checks::facts_of(shape.points, shape.quads));
      EXPECT_EQ(report.feature_curves, 0u);
      EXPECT_GE(report.after.min_scaled_jacobian, 0.45);
    }
}

// Swaps the places of two opposite corners of a quad, which lies upside down then.
void turn_over(Shape& shape, std::size_t f)
{
  const auto& q = shape.quads[f];
  std::swap(shape.points[q[1]], shape.points[q[3]]);
}

TEST(Tangled_surface, QuadsTurnedOver)
{
  const Shape smooth = shape_zoo::torus(48, 24);
  for(unsigned seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Shape shape = smooth;
    std::mt19937 random(seed);
    for(int k = 0; k < 4; ++k) turn_over(shape, random() % smooth.quads.size());
    Mesh mesh = zoo_mesh::make<Mesh, Point>(shape);
    const Adaptation_report report = QMA::adapt_quad_mesh(zoo_mesh::mean_edge(smooth), mesh);
    ASSERT_TRUE(report.has_valid_mesh()) << report.message;
    zoo_mesh::expect_valid(mesh, mesh_checks::facts_of(shape.points, shape.quads));
    EXPECT_TRUE(is_told_of(report));
    EXPECT_EQ(report.feature_curves, 0u);
    EXPECT_GE(report.after.min_scaled_jacobian, 0.45);
  }
}

// Nor do they hide the creases beside them.
TEST(Tangled_surface, QuadsTurnedOverBesideCreases)
{
  const Shape cube = shape_zoo::cube(n);
  std::size_t turned = 0;
  for(std::size_t f = 0; f < cube.quads.size(); f += 31) {
    const auto inside = [&](auto v) { // of a side of the cube
      const Vec& p = cube.points[v];
      int free = 0;
      for(int i = 0; i < 3; ++i) free += p[i] > 0.5 && p[i] < n - 0.5;
      return free == 2;
    };
    const auto& q = cube.quads[f];
    if(!std::all_of(q.begin(), q.end(), inside)) continue;
    SCOPED_TRACE("face " + std::to_string(f));
    ++turned;
    Shape shape = cube;
    turn_over(shape, f);
    Mesh mesh = zoo_mesh::make<Mesh, Point>(shape);
    const Adaptation_report report = QMA::adapt_quad_mesh(0.8, mesh);
    ASSERT_TRUE(report.has_valid_mesh()) << report.message;
    EXPECT_TRUE(is_told_of(report));
    EXPECT_EQ(report.feature_curves, 12u);
    EXPECT_EQ(report.corners, 8u);
    EXPECT_EQ(report.patches, 6u);
    EXPECT_GE(report.after.min_scaled_jacobian, 0.45);
  }
  EXPECT_GT(turned, 3u);
}

// A plane without tangles is nothing to speak of.
TEST(Tangled_plane, OthersAreNotToldOf)
{
  Mesh mesh = zoo_mesh::make<Mesh, Point>(slanting(shape_zoo::plate(n, n)));
  EXPECT_FALSE(is_told_of(QMA::adapt_quad_mesh(0.7, mesh)));
}
