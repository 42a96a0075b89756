// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Random sizes on all shapes of the zoo: graded ones and steep ones, and with both schedules.
// QUAD_MESH_SEED repeats a run, QUAD_MESH_RUNS asks for more of them (scripts/test.sh --long).

#include "support/usual_calls.h"
#include "support/usual_measures.h"

#include <CGAL/Quad_mesh_adaptation/Graded_sizing_field.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace QMA = CGAL::Quad_mesh_adaptation;

namespace shape_zoo {

void PrintTo(const Shape& shape, std::ostream* out) { *out << shape.name; }

} // namespace shape_zoo

namespace {

using usual_mesh::Mesh;
using usual_mesh::Point;
using usual_mesh::Size;
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

// Positions of the faces whose mean edge length exceeds the smaller of the size at the centre and
// its inverse root mean square at the 2 x 2 Gauss points, but for what is within `tolerance` of it.
template <typename Size>
std::vector<std::size_t> faces_larger_than(const Shape& s, const Size& size, double tolerance)
{
  const double g = 1 / std::sqrt(3.);
  std::vector<std::size_t> list;
  for(std::size_t f = 0; f < s.quads.size(); ++f) {
    const auto p = [&](int i) { return s.points[s.quads[f][std::size_t(i % 4)]]; };
    const auto size_at = [&](double u, double v) { // both from -1 to 1
      const auto x = 0.25 * ((1 - u) * (1 - v) * p(0) + (1 + u) * (1 - v) * p(1) +
                             (1 + u) * (1 + v) * p(2) + (1 - u) * (1 + v) * p(3));
      return size(Point(x.x(), x.y(), x.z()));
    };
    double length = 0, density = 0;
    for(int i = 0; i < 4; ++i) length += 0.25 * std::sqrt((p(i + 1) - p(i)).squared_length());
    for(double u : { -g, g })
      for(double v : { -g, g }) density += 0.25 * std::pow(size_at(u, v), -2);
    if(length > (1 + tolerance) * (std::min)(size_at(0, 0), 1 / std::sqrt(density)))
      list.push_back(f);
  }
  return list;
}

// The report must own up to every face that is too large, and to nothing else.
void expect_honest(const QMA::Adaptation_report& report, const Mesh& mesh, const Size& size,
                   QMA::Schedule schedule)
{
  const QMA::Mesh_measures fresh = QMA::measure_quad_mesh(mesh, size);
  EXPECT_EQ(report.after.faces, fresh.faces);
  EXPECT_EQ(report.after.strict_size_ratio.counts, fresh.strict_size_ratio.counts);
  if(schedule == QMA::Schedule::paper) return;
  const auto& t = fresh.strict_size_ratio;
  EXPECT_EQ(report.status == QMA::Adaptation_status::sizes_met, t.not_larger() == t.total());
  EXPECT_EQ(report.message.empty(), t.not_larger() == t.total());
  // between the list with and the list without what rounding can change
  const Shape s = zoo_mesh::shape_of(mesh);
  const auto surely = faces_larger_than(s, size, 1e-8), perhaps = faces_larger_than(s, size, -1e-8);
  const auto& listed = report.faces_too_large;
  EXPECT_TRUE(std::includes(listed.begin(), listed.end(), surely.begin(), surely.end()))
      << surely.size() << " faces are too large, " << listed.size() << " are listed";
  EXPECT_TRUE(std::includes(perhaps.begin(), perhaps.end(), listed.begin(), listed.end()))
      << perhaps.size() << " faces may be too large, " << listed.size() << " are listed";
  if(!listed.empty()) {
    EXPECT_EQ(report.message.find(std::to_string(listed.size()) + " of "), 0u) << report.message;
  }
}

enum class Kind
{
  graded, // by a Graded_sizing_field of a random slope
  steep,
  paper // steep, and the paper's schedule
};

void report_run(const Shape& shape, const char* name, unsigned seed,
                const QMA::Adaptation_report& report)
{
  if(!std::getenv("QUAD_MESH_RUNS")) return;
  const auto& t = report.after.strict_size_ratio;
  double seconds = 0;
  for(const auto& phase : report.times) seconds += phase.seconds;
  std::cout << shape.name << ", " << name << ", seed " << seed << ": faces " << report.before.faces
            << " -> " << t.total() << ", too large " << t.total() - t.not_larger() << ", max "
            << t.max << ", efficiency " << report.after.efficiency << ", min jacobian "
            << report.after.min_scaled_jacobian << ", max valence " << report.after.max_valence
            << ", slope " << report.size_growth.largest_slope << ", " << seconds << " s"
            << (::testing::Test::HasFailure() ? " FAILED SO FAR" : "") << std::endl;
}

void run(unsigned seed, const Shape& shape, Mesh mesh, const Size& size, Kind kind)
{
  const QMA::Schedule schedule =
      kind == Kind::paper ? QMA::Schedule::paper : QMA::Schedule::progressive;
  const mesh_checks::Facts before = mesh_checks::facts_of(shape.points, shape.quads);
  const QMA::Adaptation_report report = QMA::adapt_quad_mesh(size, mesh, QMA::schedule(schedule));
  ASSERT_TRUE(report.has_valid_mesh()) << report.message;
  zoo_mesh::expect_valid(mesh, before);
  expect_honest(report, mesh, size, schedule);
  report_run(shape,
             kind == Kind::paper    ? "paper"
             : kind == Kind::graded ? "graded"
                                    : "steep",
             seed, report);
}

void run(unsigned seed, const Shape& shape, Kind kind)
{
  std::mt19937 random(seed);
  const zoo_mesh::Bumps size = zoo_mesh::random_bumps(shape, random);
  const double slope = 0.1 + 0.3 * (random() / double(std::mt19937::max()));
  SCOPED_TRACE(shape.name + ", kind " + std::to_string(int(kind)) +
               ", QUAD_MESH_SEED=" + std::to_string(seed) + ", " + describe(size));
  const Mesh mesh = zoo_mesh::make<Mesh, Point>(shape);
  if(kind == Kind::graded)
    run(seed, shape, mesh, QMA::Graded_sizing_field(mesh, size, slope), kind);
  else
    run(seed, shape, mesh, size, kind);
}

class Random_sizes : public testing::TestWithParam<Shape>
{
protected:
  void run_kind(Kind kind)
  {
    const unsigned first = zoo_mesh::seed();
    std::cout << "QUAD_MESH_SEED=" << first << std::endl;
    const int runs = zoo_mesh::count("QUAD_MESH_RUNS", 1);
    for(int i = 0; i < runs; ++i) run(first + unsigned(i), GetParam(), kind);
  }
};

TEST_P(Random_sizes, Graded) { run_kind(Kind::graded); }

TEST_P(Random_sizes, Steep) { run_kind(Kind::steep); }

TEST_P(Random_sizes, PaperSchedule) { run_kind(Kind::paper); }

INSTANTIATE_TEST_SUITE_P(Zoo, Random_sizes, testing::ValuesIn(shape_zoo::all()),
                         [](const testing::TestParamInfo<Shape>& info) {
                           std::string name = info.param.name;
                           for(char& c : name)
                             if(!std::isalnum(static_cast<unsigned char>(c))) c = '_';
                           return name;
                         });

} // namespace
