// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "support/usual_mesh.h"

#include <CGAL/Quad_mesh_adaptation/Graded_sizing_field.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <limits>
#include <map>
#include <memory>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

namespace QMA = CGAL::Quad_mesh_adaptation;
using QMA::Graded_sizing_field;

namespace {

using usual_mesh::Mesh;
using usual_mesh::Point;
using Vector = CGAL::Simple_cartesian<double>::Vector_3;

Mesh plate(int n = 8) { return zoo_mesh::make<Mesh, Point>(shape_zoo::plate(n, n)); }

// Fine enough to be a sphere up to 0.2 %.
Mesh sphere() { return zoo_mesh::make<Mesh, Point>(shape_zoo::sphere(24)); }

double on_sphere(const Point& p, const Point& q)
{
  const double chord = std::sqrt(CGAL::squared_distance(p, q));
  return 2 * std::asin((std::min)(1., chord / 2));
}

std::vector<Point> points_on_plate(int n, int number)
{
  std::mt19937 random(zoo_mesh::seed());
  std::uniform_real_distribution<> in(0., n);
  std::vector<Point> points;
  for(int i = 0; i < number; ++i) points.emplace_back(in(random), in(random), 0);
  return points;
}

std::vector<Point> points_on_sphere(int number)
{
  std::mt19937 random(zoo_mesh::seed());
  std::normal_distribution<> normal;
  std::vector<Point> points;
  for(int i = 0; i < number; ++i) {
    const Vector v(normal(random), normal(random), normal(random));
    points.push_back(CGAL::ORIGIN + v / std::sqrt(v.squared_length()));
  }
  return points;
}

// The promise: no larger than given, and between any two points no steeper than the growth, up to
// a share of the smaller size.
template <class Graded, class Given, class Distance>
void expect_graded(const Graded& graded, const Given& given, const std::vector<Point>& points,
                   double growth, const Distance& distance, double tolerance)
{
  std::vector<double> size;
  for(const Point& p : points) {
    size.push_back(graded(p));
    ASSERT_GT(size.back(), 0);
    ASSERT_LE(size.back(), given(p));
  }
  double worst = 0;
  for(std::size_t i = 0; i < points.size(); ++i)
    for(std::size_t j = 0; j < i; ++j) {
      const double allowed = growth * distance(points[i], points[j]);
      worst =
          (std::max)(worst, (std::abs(size[i] - size[j]) - allowed) / (std::min)(size[i], size[j]));
    }
  EXPECT_LE(worst, tolerance);
  testing::Test::RecordProperty("worst_excess", std::to_string(worst));
}

double in_plane(const Point& p, const Point& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

} // namespace

TEST(Graded_sizing_field, a_uniform_size_stays_as_it_is)
{
  const Mesh mesh = plate();
  const Graded_sizing_field number(mesh, 0.7, 0.25);
  const auto one = [](const Point&) { return 0.7; };
  const Graded_sizing_field function(mesh, one, 0.);
  for(const Point& p : points_on_plate(8, 1000)) {
    EXPECT_NEAR(number(p), 0.7, 1e-12);
    EXPECT_NEAR(function(p), 0.7, 1e-12);
  }
  EXPECT_EQ(number.lowered_share(), 0);
  EXPECT_TRUE(number.is_resolved());
}

TEST(Graded_sizing_field, a_gentle_size_stays_as_it_is)
{
  const auto gentle = [](const Point& p) { return 0.2 + 0.24 * std::abs(p.x() - 3.3); };
  const Graded_sizing_field graded(plate(), gentle, 0.25);
  for(const Point& p : points_on_plate(8, 1000)) {
    EXPECT_LE(graded(p), gentle(p));
    EXPECT_GE(graded(p), 0.999 * gentle(p));
  }
  EXPECT_EQ(graded.lowered_share(), 0);
}

TEST(Graded_sizing_field, a_kink_gets_the_slope_asked_for)
{
  const auto steep = [](const Point& p) { return 0.1 + std::abs(p.x() - 4.1); };
  const Graded_sizing_field graded(plate(), steep, 0.25);
  for(const Point& p : points_on_plate(8, 2000)) {
    const double exact = 0.1 + 0.25 * std::abs(p.x() - 4.1);
    EXPECT_LE(graded(p), 1.03 * exact + 0.1 / 12); // slope one between the samples
    EXPECT_GE(graded(p), 0.98 * exact);
  }
  EXPECT_GT(graded.lowered_share(), 0.9);
  expect_graded(graded, steep, points_on_plate(8, 600), 0.25, in_plane, 0.09);
}

TEST(Graded_sizing_field, a_jump_by_fifty_becomes_a_slope)
{
  const double growth = 0.25;
  const auto jump = [](const Point& p) { return p.x() + 0.3 * p.y() < 3.21 ? 0.06 : 3.; };
  const Graded_sizing_field graded(plate(), jump, growth);
  ASSERT_TRUE(graded.is_resolved());
  for(const Point& p : points_on_plate(8, 2000)) {
    const double beyond = (std::max)(0., (p.x() + 0.3 * p.y() - 3.21) / std::hypot(1, 0.3));
    // the line meets the lower side of the plate at a right angle only nearly: a distance along it
    const double exact = (std::min)(jump(p), 0.06 + growth * beyond);
    EXPECT_GE(graded(p), 0.98 * exact);
    if(p.y() > 0.3 * beyond + 0.1) {
      EXPECT_LE(graded(p), 1.05 * exact + growth * 0.03);
    }
  }
  expect_graded(graded, jump, points_on_plate(8, 600), growth, in_plane, 0.25);
}

TEST(Graded_sizing_field, a_spot_spreads_as_a_round_cone)
{
  const double growth = 0.2;
  const Point centre(3.1, 4.4, 0);
  const auto spot = [&](const Point& p) { return in_plane(p, centre) < 0.3 ? 0.05 : 2.5; };
  const Graded_sizing_field graded(plate(), spot, growth);
  for(const Point& p : points_on_plate(8, 2000)) {
    const double exact = 0.05 + growth * (std::max)(0., in_plane(p, centre) - 0.3);
    EXPECT_GE(graded(p), 0.98 * (std::min)(spot(p), exact));
    EXPECT_LE(graded(p), 1.04 * exact + growth * 0.025);
  }
}

TEST(Graded_sizing_field, distances_are_taken_over_a_closed_sphere)
{
  const double growth = 0.25;
  const Point pole(0, 0, 1);
  const auto spot = [&](const Point& p) { return p.z() > 0.98 ? 0.03 : 1.5; };
  const Graded_sizing_field graded(sphere(), spot, growth);
  ASSERT_TRUE(graded.is_resolved());
  for(const Point& p : points_on_sphere(2000)) {
    const double exact = 0.03 + growth * (std::max)(0., on_sphere(p, pole) - std::acos(0.98));
    EXPECT_GE(graded(p), 0.97 * (std::min)(spot(p), exact));
    EXPECT_LE(graded(p), 1.04 * exact + growth * 0.015);
  }
  expect_graded(graded, spot, points_on_sphere(600), growth, on_sphere, 0.2);
}

TEST(Graded_sizing_field, close_sheets_do_not_influence_each_other)
{
  // two plates of side 8 at a distance of 0.05, joined along x = 0 as a folded sheet
  Mesh mesh;
  std::vector<std::vector<Mesh::Vertex_index>> rows;
  for(int i = -8; i <= 8; ++i) {
    rows.emplace_back();
    for(int j = 0; j <= 8; ++j)
      rows.back().push_back(mesh.add_vertex(Point(std::abs(i), j,
                                                  i < 0   ? 0
                                                  : i > 0 ? 0.05
                                                          : 0.025)));
  }
  for(std::size_t i = 0; i + 1 < rows.size(); ++i)
    for(int j = 0; j < 8; ++j)
      mesh.add_face(rows[i][j], rows[i + 1][j], rows[i + 1][j + 1], rows[i][j + 1]);
  const double growth = 0.25;
  const auto size = [](const Point& p) { // small at the far side of the upper sheet
    return p.z() > 0.03 && p.x() > 7 ? 0.05 : 4.;
  };
  const Graded_sizing_field graded(mesh, size, growth);
  for(double x = 2; x < 7.9; x += 0.37)
    for(double y = 0.1; y < 8; y += 0.6) {
      const double lower = 0.05 + growth * (7 + x); // around the fold
      EXPECT_NEAR(graded(Point(x, y, 0)), (std::min)(4., lower), 0.05 * lower);
      if(x < 7) {
        EXPECT_NEAR(graded(Point(x, y, 0.05)), 0.05 + growth * (7 - x), 0.1 * lower);
      }
    }
}

TEST(Graded_sizing_field, noise_is_bounded_over_the_zoo)
{
  const double growth = 0.3;
  for(const shape_zoo::Shape& shape : shape_zoo::all()) {
    SCOPED_TRACE(shape.name);
    const double edge = zoo_mesh::mean_edge(shape);
    const auto rough = [edge](const Point& p) {
      return edge * (0.5 + std::abs(std::sin(2 * p.x() / edge) + std::cos(2.5 * p.y() / edge) +
                                    std::sin(2.2 * p.z() / edge)));
    };
    const Mesh mesh = zoo_mesh::make<Mesh, Point>(shape);
    const Graded_sizing_field graded(mesh, rough, growth);
    EXPECT_GT(graded.lowered_share(), 0.1);
    // along every edge, where the distance over the surface is the length or less; the slope of
    // up to 6 between samples a sixth of a size apart costs what is allowed beyond the growth
    for(auto e : mesh.edges()) {
      const Point a = mesh.point(mesh.vertex(e, 0)), b = mesh.point(mesh.vertex(e, 1));
      const Vector step = (b - a) / 8;
      for(int i = 0; i < 8; ++i) {
        const double here = graded(a + i * step), next = graded(a + (i + 1) * step);
        EXPECT_LE(std::abs(here - next),
                  growth * std::sqrt(step.squared_length()) + 0.3 * (std::min)(here, next));
      }
    }
  }
}

TEST(Graded_sizing_field, says_when_the_samples_are_too_few)
{
  const auto fine = [](const Point& p) { return 0.01 + std::abs(p.x() - 4.1); };
  const Graded_sizing_field few(plate(), fine, 0.25, CGAL::parameters::default_values(), 12000);
  EXPECT_FALSE(few.is_resolved());
  EXPECT_GT(few.largest_spacing(), 0.5);
  EXPECT_LE(few.number_of_samples(), 12000u);
  for(const Point& p : points_on_plate(8, 500)) EXPECT_LE(few(p), fine(p));
  const Graded_sizing_field enough(plate(), fine, 0.25);
  EXPECT_TRUE(enough.is_resolved());
  EXPECT_LE(enough.largest_spacing(), 0.5);
}

TEST(Graded_sizing_field, answers_the_same_from_several_threads_and_outlives_its_mesh)
{
  const auto steep = [](const Point& p) { return 0.2 + std::abs(p.x() - 4.1); };
  auto mesh = std::make_unique<Mesh>(plate());
  const Graded_sizing_field graded(*mesh, steep, 0.25);
  const auto copy = graded;
  mesh.reset();
  const auto sum = [&](const auto& field) {
    double s = 0;
    for(const Point& p : points_on_plate(8, 3000)) s += field(p);
    return s;
  };
  auto other = std::async(std::launch::async, [&] { return sum(copy); });
  EXPECT_EQ(sum(graded), other.get());
}

TEST(Graded_sizing_field, refuses_what_it_cannot_grade)
{
  const Mesh mesh = plate(2);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Graded_sizing_field(mesh, 1., -0.1), std::invalid_argument);
  EXPECT_THROW(Graded_sizing_field(mesh, 1., nan), std::invalid_argument);
  EXPECT_THROW(Graded_sizing_field(mesh, 0., 0.2), std::domain_error);
  EXPECT_THROW(Graded_sizing_field(mesh, nan, 0.2), std::domain_error);
  EXPECT_THROW(Graded_sizing_field(Mesh(), 1., 0.2), std::invalid_argument);
  Mesh broken = mesh;
  broken.point(Mesh::Vertex_index(4)) = Point(1, nan, 0);
  EXPECT_THROW(Graded_sizing_field(broken, 1., 0.2), std::invalid_argument);
}

TEST(Sample_triangles, stay_conforming_with_bounded_angles_under_any_marks)
{
  using QMA::internal::Vec;
  const shape_zoo::Shape shape = shape_zoo::plate(4, 3);
  QMA::internal::Sample_triangles samples(shape.points, shape.quads);
  std::mt19937 random(zoo_mesh::seed());
  for(int pass = 0; pass < 12; ++pass) {
    std::vector<char> is_marked(samples.edges().size());
    for(char& mark : is_marked) mark = random() % 20 == 0;
    const std::size_t before = samples.triangles().size();
    samples.split(is_marked);
    EXPECT_GT(samples.triangles().size(), before);
  }
  std::map<std::pair<int, int>, int> uses; // of directed edges
  double area = 0;
  for(const auto& t : samples.triangles()) {
    const Vec &a = samples.points()[t[0]], &b = samples.points()[t[1]], &c = samples.points()[t[2]];
    const Vec normal = QMA::internal::cross(b - a, c - a);
    EXPECT_GT(normal.z(), 0);
    area += normal.z() / 2;
    const double longest =
        (std::max)({ QMA::internal::distance(a, b), QMA::internal::distance(b, c),
                     QMA::internal::distance(c, a) });
    EXPECT_NEAR(normal.z() / (longest * longest), 0.5, 1e-9); // right-angled and isosceles for ever
    for(int i = 0; i < 3; ++i) ++uses[{ t[i], t[(i + 1) % 3] }];
  }
  EXPECT_NEAR(area, 12, 1e-9);
  for(const auto& [edge, number] : uses) {
    EXPECT_EQ(number, 1);
    if(uses.count({ edge.second, edge.first })) continue;
    const Vec &p = samples.points()[edge.first], &q = samples.points()[edge.second];
    const bool is_border = (p.x() == q.x() && (p.x() == 0 || p.x() == 4)) ||
                           (p.y() == q.y() && (p.y() == 0 || p.y() == 3));
    EXPECT_TRUE(is_border); // no hanging node inside
  }
}
