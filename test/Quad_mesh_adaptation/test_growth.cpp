// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// No quadratic corner: shapes that are extreme in one respect, at N and at 8 N faces.

#include "support/counted_work.h"
#include "support/growth_shapes.h"
#include "support/usual_calls.h"
#include "support/usual_passes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace QMA = CGAL::Quad_mesh_adaptation;

namespace {

using counted_work::Mesh;
using counted_work::Point;
using counted_work::Work;
using growth_shapes::Shape;

// Time and calls for each face must not grow as the number of faces does.  Linear work gives 1 for
// both, quadratic work 8, N sqrt(N) 2.8.  Time is of one process on one machine, small and large
// one after the other, the better of two runs each; caches account for some growth, and the
// course of an adaptation differs between N and 8 N, hence the margins.
constexpr double allowed_growth_of_time = 4, allowed_growth_of_calls = 2.5;

struct Adapt
{
  template <typename Size>
  QMA::Adaptation_report operator()(const Size& size, Mesh& mesh, Work&) const
  {
    return QMA::adapt_quad_mesh(size, mesh);
  }
};

struct Refine
{
  template <typename Size>
  QMA::Adaptation_report operator()(const Size& size, Mesh& mesh, Work&) const
  {
    return QMA::refine(size, mesh);
  }
};

struct Uniform
{
  double length;
  double operator()(const Point&) const { return length; }
};

template <typename Size, typename Operation>
Work best_of_two(const Shape& shape, const Size& size, const Operation& operation)
{
  const Work a = counted_work::measured(shape, size, operation);
  const Work b = counted_work::measured(shape, size, operation);
  EXPECT_EQ(a.size_calls, b.size_calls) << "two runs differ";
  return a.seconds < b.seconds ? a : b;
}

void expect_linear(const Work& small, const Work& large)
{
  const double grown = double(large.faces) / double(small.faces);
  EXPECT_GT(grown, 5) << small.faces << " and " << large.faces << " faces are no test of growth";
  const double calls = large.size_calls_per_face() / small.size_calls_per_face();
  const double time = large.seconds_per_face() / small.seconds_per_face();
  EXPECT_LT(calls, allowed_growth_of_calls)
      << small.size_calls_per_face() << " -> " << large.size_calls_per_face()
      << " size calls for each face";
  EXPECT_LT(time, allowed_growth_of_time) << 1e6 * small.seconds_per_face() << " -> "
                                          << 1e6 * large.seconds_per_face() << " us for each face";
  testing::Test::RecordProperty("growth_of_calls", std::to_string(calls));
  testing::Test::RecordProperty("growth_of_time", std::to_string(time));
}

template <typename Size, typename Operation>
void expect_linear(const Shape& small, const Shape& large, const Size& size,
                   const Operation& operation)
{
  expect_linear(best_of_two(small, size, operation), best_of_two(large, size, operation));
}

} // namespace

TEST(Growth, Long_thin_strip_refined)
{
  expect_linear(growth_shapes::strip(1500), growth_shapes::strip(12000), Uniform{ 0.5 }, Adapt());
}

TEST(Growth, Long_thin_strip_coarsened)
{
  expect_linear(growth_shapes::strip(200), growth_shapes::strip(1600), Uniform{ 4 }, Adapt());
}

TEST(Growth, Long_chord_refined)
{
  expect_linear(growth_shapes::screw(400, 30), growth_shapes::screw(3200, 30), Uniform{ 0.5 },
                Adapt());
}

TEST(Growth, Long_chord_coarsened)
{
  expect_linear(growth_shapes::screw(400, 30), growth_shapes::screw(3200, 30), Uniform{ 3 },
                Adapt());
}

TEST(Growth, Ten_thousand_components_refined)
{
  expect_linear(growth_shapes::archipelago(35), growth_shapes::archipelago(100), Uniform{ 0.5 },
                Adapt());
}

TEST(Growth, Ten_thousand_components_coarsened)
{
  expect_linear(growth_shapes::archipelago(35), growth_shapes::archipelago(100), Uniform{ 4 },
                Adapt());
}

// Inside a disk the size is a thousandth of that outside, without transition.
TEST(Growth, Size_that_jumps_by_a_thousand)
{
  const auto run = [](double length) {
    const auto size = [length](const Point& p) {
      return std::hypot(p.x() - 3.013, p.y() - 3.021) < 1 ? length : 1000 * length;
    };
    return best_of_two(growth_shapes::plate(6, 6), size, Adapt());
  };
  expect_linear(run(0.2), run(0.2 / std::sqrt(8.)));
}

// Every face is a patch of its own, all edges are curves and all vertices corners.
TEST(Growth, As_many_patches_as_faces)
{
  const auto adapt = [](const auto& size, Mesh& mesh, Work&) {
    auto patch = mesh.add_property_map<Mesh::Face_index, int>("f:patch", 0).first;
    for(auto f : mesh.faces()) patch[f] = int(f);
    return QMA::refine(size, mesh, CGAL::parameters::face_patch_map(patch));
  };
  expect_linear(growth_shapes::plate(30, 30), growth_shapes::plate(85, 85), Uniform{ 0.5 }, adapt);
}

TEST(Growth, Huge_valence_refined)
{
  expect_linear(growth_shapes::fan(1000), growth_shapes::fan(8000), Uniform{ 0.3 }, Refine());
}

// Far too fine about a node: most faces there go before anything looks at them one by one.
TEST(Growth, Huge_valence_adapted)
{
  expect_linear(growth_shapes::fan(30), growth_shapes::fan(240), Uniform{ 2 }, Adapt());
}

TEST(Growth, Huge_valence_on_the_border_adapted)
{
  expect_linear(growth_shapes::half_fan(30), growth_shapes::half_fan(240), Uniform{ 0.5 }, Adapt());
}

TEST(Growth, Two_huge_valences_adapted)
{
  expect_linear(growth_shapes::kites(30), growth_shapes::kites(240), Uniform{ 2 }, Adapt());
}

// The spokes at both ends of a can meet its columns by turns.
TEST(Growth, Fans_that_do_not_fit_each_other_adapted)
{
  expect_linear(growth_shapes::can(40, 1), growth_shapes::can(320, 1), Uniform{ 0.5 }, Adapt());
}
