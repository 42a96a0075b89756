// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A guard against slower algorithms that no noisy machine can trip: calls of the sizing function
// and of a projector for each face, at N and at 4 N faces.

#include "support/counted_work.h"
#include "support/shape_zoo.h"
#include "support/usual_calls.h"
#include "support/usual_passes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace QMA = CGAL::Quad_mesh_adaptation;

namespace {

using counted_work::Mesh;
using counted_work::Point;
using counted_work::Work;
using shape_zoo::Shape;

// Of quadratic work the ratio between 4 N and N faces is 4 for each face, of N sqrt(N) 2.  Work
// that belongs to the boundary of a graded region falls with N, so that ratios below one are usual.
constexpr double allowed_growth = 1.6;

// Sizes from `length` to eleven times that, growing away from a point.
struct Graded
{
  double length;
  double operator()(const Point& p) const
  {
    return length * (1 + 10 * std::sqrt(CGAL::squared_distance(p, Point(0.3, 0.2, 1))));
  }
};

struct Uniform
{
  double length;
  double operator()(const Point&) const { return length; }
};

// `seen` is what the code did when the test was written, and twice that the limit: a change that
// does much more has to say why.
void expect_work(const Work& small, const Work& large, double seen)
{
  EXPECT_GT(double(large.faces), 3 * double(small.faces));
  EXPECT_LT(large.size_calls_per_face(), allowed_growth * small.size_calls_per_face())
      << "size calls for each face, at " << small.faces << " and " << large.faces << " faces";
  EXPECT_LT(large.size_calls_per_face(), 2 * seen) << "size calls for each face";
  testing::Test::RecordProperty("calls", std::to_string(large.size_calls_per_face()));
}

const auto adapt = [](const auto& size, Mesh& mesh, Work&) {
  return QMA::adapt_quad_mesh(size, mesh);
};
const auto refine = [](const auto& size, Mesh& mesh, Work&) { return QMA::refine(size, mesh); };
const auto coarsen = [](const auto& size, Mesh& mesh, Work&) { return QMA::coarsen(size, mesh); };

// A plate of side 2 in n x n faces.
Shape plate(int n)
{
  Shape s = shape_zoo::plate(n, n);
  for(auto& p : s.points) p = shape_zoo::Vec(2 * p.x() / n - 1, 2 * p.y() / n - 1, 0);
  return s;
}

} // namespace

TEST(Work, Refinement)
{
  expect_work(counted_work::measured(shape_zoo::sphere(6), Graded{ 0.01 }, refine),
              counted_work::measured(shape_zoo::sphere(6), Graded{ 0.005 }, refine), 90);
}

TEST(Work, Coarsening)
{
  expect_work(counted_work::measured(plate(20), Uniform{ 0.5 }, coarsen),
              counted_work::measured(plate(40), Uniform{ 0.25 }, coarsen), 330);
}

TEST(Work, Adaptation_of_a_plate)
{
  expect_work(counted_work::measured(plate(10), Graded{ 0.005 }, adapt),
              counted_work::measured(plate(10), Graded{ 0.0025 }, adapt), 560);
}

TEST(Work, Adaptation_of_a_closed_surface)
{
  expect_work(counted_work::measured(shape_zoo::sphere(6), Graded{ 0.02 }, adapt),
              counted_work::measured(shape_zoo::sphere(6), Graded{ 0.01 }, adapt), 1300);
}

// The caller's projector may be a CAD kernel, and is then what takes the time.
TEST(Work, Projections)
{
  const auto onto_sphere = [](const auto& size, Mesh& mesh, Work& work) {
    const auto project = [&work](const Point& p) {
      ++work.projections;
      const double r = std::sqrt(CGAL::squared_distance(p, Point(0, 0, 0)));
      return Point(p.x() / r, p.y() / r, p.z() / r);
    };
    return QMA::adapt_quad_mesh(size, mesh, QMA::projector(project));
  };
  // meshes of some hundred faces are made several times, see detours.h
  const Work small = counted_work::measured(shape_zoo::sphere(6), Graded{ 0.0106 }, onto_sphere);
  const Work large = counted_work::measured(shape_zoo::sphere(6), Graded{ 0.0053 }, onto_sphere);
  EXPECT_GT(small.projections, small.faces);
  EXPECT_LT(large.projections_per_face(), allowed_growth * small.projections_per_face());
  EXPECT_LT(large.projections_per_face(), 2 * 840.); // seen 840, see expect_work()
}
