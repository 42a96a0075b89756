// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What the report says of sizes that grow faster than quads can follow.

#include "support/usual_calls.h"
#include "support/usual_measures.h"
#include "support/usual_passes.h"

#include <CGAL/Quad_mesh_adaptation/Graded_sizing_field.h>
#include <CGAL/Quad_mesh_adaptation/internal/measure_size_growth.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace QMA = CGAL::Quad_mesh_adaptation;

namespace {

using usual_mesh::Mesh;
using usual_mesh::Point;
using usual_mesh::Size;

// n x n faces over [-5, 5]^2
Mesh plate(int n)
{
  return zoo_mesh::make<Mesh, Point>(
      shape_zoo::grid("plate", n, n, [n](shape_zoo::Index i, shape_zoo::Index j) {
        return shape_zoo::Vec(10. * i / n - 5, 10. * j / n - 5, 0);
      }));
}

QMA::Size_growth growth_of(const std::function<double(const Point&)>& size, int n = 10)
{
  const Mesh mesh = plate(n);
  const QMA::internal::Quad_arrays a =
      QMA::internal::quad_arrays(mesh, get(CGAL::vertex_point, mesh), "test");
  return QMA::internal::measure_size_growth(a.points, a.quads,
                                            QMA::internal::checked_size<Point>(size));
}

} // namespace

TEST(Size_growth, FindsTheSlopeOfALinearSizeInAnyDirection)
{
  for(const double angle : { 0., 0.3, 0.8, 1.2, 2.5 }) {
    const QMA::Size_growth g = growth_of([=](const Point& p) {
      return 20 + 0.8 * (std::cos(angle) * p.x() + std::sin(angle) * p.y());
    });
    EXPECT_LE(g.largest_slope, 0.8 + 1e-9);
    EXPECT_GE(g.largest_slope, 0.8 * std::cos(std::acos(-1.) / 8) - 1e-9);
    EXPECT_NEAR(g.steep_area_share, 1, 1e-9);
    EXPECT_NEAR(g.steep_faces_share, 1, 1e-9);
    EXPECT_FALSE(g.is_too_steep()); // the whole plate asks for less than one face
  }
}

TEST(Size_growth, MeasuresTheSteepPart)
{
  // slope 0.7 where |x| < 1, a fifth of the area
  const auto size = [](const Point& p) { return 0.2 + 0.7 * (std::min)(1., std::abs(p.x())); };
  const QMA::Size_growth g = growth_of(size, 20);
  EXPECT_NEAR(g.largest_slope, 0.7, 1e-9);
  EXPECT_NEAR(g.steep_area_share, 0.2, 1e-9);
  // 20 times the integral of 1/h^2 from 0 to 1, and 80 / 0.9^2 on the rest
  const double steep = 20 * (1 / 0.2 - 1 / 0.9) / 0.7, rest = 80 / 0.81;
  EXPECT_NEAR(g.steep_faces, steep, 0.05 * steep);
  EXPECT_NEAR(g.steep_faces_share, steep / (steep + rest), 0.02);
  EXPECT_LT(std::abs(g.where[0]), 1);
  EXPECT_TRUE(g.is_too_steep());
}

TEST(Size_growth, AJumpIsTooSteepHoweverFineTheMesh)
{
  for(const int n : { 2, 10, 100 })
    EXPECT_TRUE(growth_of([](const Point& p) { return p.x() < 0.123 ? 1 : 2; }, n).is_too_steep());
}

TEST(Size_growth, TheReportAdvisesOnThePapersPlate)
{
  Mesh mesh = plate(10);
  const Size size = [](const Point& p) { return 0.1 + std::abs(std::hypot(p.x(), p.y()) - 4.9); };
  const QMA::Adaptation_report report = QMA::adapt_quad_mesh(size, mesh);
  EXPECT_EQ(report.status, QMA::Adaptation_status::sizes_met);
  EXPECT_TRUE(report.message.empty());
  EXPECT_NEAR(report.size_growth.largest_slope, 1, 0.02);
  EXPECT_GT(report.size_growth.steep_faces_share, 0.9);
  ASSERT_EQ(report.advice.size(), 1u);
  EXPECT_NE(report.advice[0].find("Graded_sizing_field"), std::string::npos);
  EXPECT_NE(report.advice[0].find("per unit of length"), std::string::npos);

  // the cure that the sentence names
  Mesh again = plate(10);
  const QMA::Adaptation_report cured =
      QMA::smooth(Size(QMA::Graded_sizing_field(again, size, 0.25)), again);
  EXPECT_TRUE(cured.advice.empty());
  EXPECT_LE(cured.size_growth.largest_slope, 0.3);
}

TEST(Size_growth, MildSizesAndNumbersGetNoAdvice)
{
  Mesh mesh = plate(10);
  QMA::Adaptation_report report = QMA::adapt_quad_mesh(
      Size([](const Point& p) { return 0.4 + 0.2 * std::abs(std::hypot(p.x(), p.y()) - 4.9); }),
      mesh);
  EXPECT_TRUE(report.advice.empty());
  EXPECT_NEAR(report.size_growth.largest_slope, 0.2, 0.01);
  report = QMA::clean_up(0.7, mesh, CGAL::parameters::number_of_iterations(std::size_t(-1)));
  EXPECT_TRUE(report.advice.empty());
  EXPECT_EQ(report.size_growth.largest_slope, 0);
}
