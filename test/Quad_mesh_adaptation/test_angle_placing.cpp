// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Moves for the sake of angles alone: what they mend, and what they never do.

#include "support/state_checks.h"

#include <CGAL/Quad_mesh_adaptation/internal/Angle_placing.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace {

namespace QMA = CGAL::Quad_mesh_adaptation;
using namespace state_fixture;

constexpr double far_larger = 10; // size that no face comes near

Adaptation_state state_of(const Shape& shape, double size)
{
  Options o;
  o.size = [size](const Vec&) { return size; };
  return make_state(shape, o);
}

// Three quads in a wedge of 20 degrees.  The one at the tip is poor in any case; the others are for
// the node between them having slid away from it.
Shape wedge(double x_of_node)
{
  const double w = std::tan(10 * 3.14159265358979 / 180);
  return { "wedge",
           { Vec(0, 0, 0), Vec(2, -2 * w, 0), Vec(x_of_node, 0, 0), Vec(2, 2 * w, 0),
             Vec(4, -4 * w, 0), Vec(4, 0, 0), Vec(4, 4 * w, 0) },
           { { 0, 1, 2, 3 }, { 1, 4, 5, 2 }, { 2, 5, 6, 3 } } };
}

std::size_t number_unexcused(const Adaptation_state& s)
{
  std::size_t n = 0;
  for(Index f : s.mesh.faces())
    if(core::is_unexcused(s, f)) ++n;
  return n;
}

void place_all(Adaptation_state& s)
{
  core::Angle_placing place(s);
  for(Index f : s.mesh.faces()) place(f);
}

} // namespace

TEST(Angle_placing, MendsFacesBesideOneThatFeaturesKeepPoor)
{
  Adaptation_state s = state_of(wedge(3.9), far_larger);
  ASSERT_EQ(number_unexcused(s), 2u);
  ASSERT_EQ(core::shape_limit(s, 0, QMA::Poor_face::floor).limit, QMA::Shape_limit::feature_angle);
  const state_checks::Snapshot before = state_checks::snapshot(s);
  place_all(s);
  EXPECT_EQ(number_unexcused(s), 0u);
  EXPECT_GT(core::scaled_jacobian(s.corners(0)), 0.15); // has not paid with all it had
  EXPECT_EQ(state_checks::problem_of(s, before, true), "");
}

TEST(Angle_placing, MovesNothingForFacesThatAreGoodOrExcused)
{
  for(const Shape& shape : { shape_zoo::plate(6, 6), wedge(2.4) }) {
    Adaptation_state s = state_of(shape, far_larger);
    ASSERT_EQ(number_unexcused(s), 0u) << shape.name;
    place_all(s);
    for(Index v = 0; v < s.mesh.vertex_end(); ++v)
      EXPECT_EQ(s.mesh.point(v), shape.points[v]) << shape.name << ", " << v;
  }
}

TEST(Angle_placing, KeepsSizesAndTheWorstShape)
{
  std::size_t before = 0, after = 0;
  for(unsigned seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    Adaptation_state s = state_of(shape_zoo::irregular(8, seed), 0.62);
    const std::size_t unexcused = number_unexcused(s);
    const double least = core::least_scaled_jacobian(s);
    std::vector<double> ratios;
    for(Index f = 0; f < s.mesh.face_end(); ++f) ratios.push_back(s.size_ratio(f));
    const double largest = (std::max)(1., *std::max_element(ratios.begin(), ratios.end()));
    const state_checks::Snapshot snapshot = state_checks::snapshot(s);
    place_all(s);
    EXPECT_LE(number_unexcused(s), unexcused);
    EXPECT_GE(core::least_scaled_jacobian(s), (std::min)(least, QMA::Poor_face::floor) - 1e-6);
    for(Index f = 0; f < s.mesh.face_end(); ++f) EXPECT_LE(s.size_ratio(f), largest + 1e-9);
    EXPECT_EQ(state_checks::problem_of(s, snapshot, true), "");
    before += unexcused;
    after += number_unexcused(s);
  }
  EXPECT_LT(2 * after, before);
}

TEST(Angle_placing, LeavesFrozenNodesWhereTheyAre)
{
  Options o;
  o.size = [](const Vec&) { return far_larger; };
  o.frozen_vertices = { 2 };
  const Shape shape = wedge(3.9);
  Adaptation_state s = make_state(shape, o);
  place_all(s);
  EXPECT_EQ(s.mesh.point(2), shape.points[2]);
}
