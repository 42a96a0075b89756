// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Random graded sizes on all shapes of the zoo, with both schedules.  QUAD_MESH_SEED repeats a run,
// QUAD_MESH_RUNS asks for more of them.

#include "support/zoo_mesh.h"

#include <CGAL/adapt_quad_mesh.h>
#include <CGAL/Quad_mesh_adaptation/measure_quad_mesh.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <chrono>
#include <iostream>
#include <string>
#include <vector>

namespace QMA = CGAL::Quad_mesh_adaptation;

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using zoo_mesh::Shape;

std::string describe(const zoo_mesh::Bumps& h)
{
  std::string text = "base " + std::to_string(h.base);
  for(const auto& b : h.bumps)
    text += "; at (" + std::to_string(b.centre.x()) + ", " + std::to_string(b.centre.y()) + ", " +
            std::to_string(b.centre.z()) + ") radius " + std::to_string(b.radius) + " factor " +
            std::to_string(b.factor);
  return text;
}

// The report must own up to every face that is too large, and to nothing else.
void expect_honest(const QMA::Adaptation_report& report, const Mesh& mesh,
                   const zoo_mesh::Bumps& size, QMA::Schedule schedule)
{
  const QMA::Mesh_measures fresh = QMA::measure_quad_mesh(mesh, size);
  EXPECT_EQ(report.after.faces, fresh.faces);
  EXPECT_EQ(report.after.strict_size_ratio.counts, fresh.strict_size_ratio.counts);
  if(schedule == QMA::Schedule::paper) return;
  const auto& t = fresh.strict_size_ratio;
  EXPECT_EQ(report.status == QMA::Adaptation_status::sizes_met, t.not_larger() == t.total());
  EXPECT_EQ(report.message.empty(), t.not_larger() == t.total());
}

void run(unsigned seed, const Shape& shape, QMA::Schedule schedule)
{
  std::mt19937 random(seed);
  const zoo_mesh::Bumps size = zoo_mesh::random_bumps(shape, random);
  const char* name = schedule == QMA::Schedule::paper ? "paper" : "progressive";
  SCOPED_TRACE(shape.name + ", " + name + ", QUAD_MESH_SEED=" + std::to_string(seed) + ", " +
               describe(size));
  Mesh mesh = zoo_mesh::make<Mesh, Point>(shape);
  const mesh_checks::Facts before = mesh_checks::facts_of(shape.points, shape.quads);
  const auto start = std::chrono::steady_clock::now();
  const QMA::Adaptation_report report = QMA::adapt_quad_mesh(size, mesh, QMA::schedule(schedule));
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  ASSERT_TRUE(report.has_valid_mesh()) << report.message;
  zoo_mesh::expect_valid(mesh, before);
  expect_honest(report, mesh, size, schedule);
  const auto& t = report.after.strict_size_ratio;
  if(std::getenv("QUAD_MESH_RUNS"))
    std::cout << shape.name << ", " << name << ", seed " << seed << ": faces "
              << report.before.faces << " -> " << t.total() << ", too large "
              << t.total() - t.not_larger() << ", max " << t.max << ", efficiency "
              << report.after.efficiency << ", min jacobian " << report.after.min_scaled_jacobian
              << ", max valence " << report.after.max_valence << ", " << seconds << " s"
              << (::testing::Test::HasFailure() ? " FAILED SO FAR" : "") << std::endl;
}

void run_all(QMA::Schedule schedule)
{
  const unsigned first = zoo_mesh::seed();
  std::cout << "QUAD_MESH_SEED=" << first << std::endl;
  const int runs = zoo_mesh::count("QUAD_MESH_RUNS", 1);
  for(int i = 0; i < runs; ++i)
    for(const Shape& shape : shape_zoo::all()) run(first + unsigned(i), shape, schedule);
}

} // namespace

TEST(Random_sizes, ProgressiveSchedule) { run_all(QMA::Schedule::progressive); }

TEST(Random_sizes, PaperSchedule) { run_all(QMA::Schedule::paper); }
