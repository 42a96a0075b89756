// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "support/more_shapes.h"
#include "support/state_checks.h"
#include "support/state_fixture.h"

#include <CGAL/Quad_mesh_adaptation/internal/curve_bends.h>
#include <CGAL/Quad_mesh_adaptation/internal/octaves.h>
#include <CGAL/Quad_mesh_adaptation/internal/total_energy.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {

namespace core = CGAL::Quad_mesh_adaptation::internal;
using core::Adaptation_state;
using core::Carrier;
using core::Curve_bends;
using core::Feature_curve;
using core::Index;
using core::Vec;

constexpr double pi = 3.14159265358979323846;

Feature_curve polygon(int n)
{
  std::vector<Vec> p;
  for(int i = 0; i <= n; ++i)
    p.push_back(Vec(std::cos(2 * pi * (i % n) / n), std::sin(2 * pi * (i % n) / n), 0));
  return Feature_curve(p, true, true, false);
}

// A cylinder with flat ends, whose rims have 16 edges each, for sizes `factor` times its own.
Adaptation_state rim_state(double factor)
{
  const shape_zoo::Shape shape = more_shapes::closed_cylinder(4);
  state_fixture::Options o;
  const double size = factor * zoo_mesh::mean_edge(shape);
  o.size = [size](const Vec&) { return size; };
  return state_fixture::make_state(shape, o);
}

int number_held(const Adaptation_state& s)
{
  int held = 0;
  for(Index v = 0; v < s.mesh.vertex_end(); ++v)
    held += s.mesh.is_vertex(v) && core::is_held_at_bend(s.mesh.vertex(v));
  return held;
}

double length_of_creases(const Adaptation_state& s)
{
  double sum = 0;
  for(Index h = 0; h < 4 * s.mesh.face_end(); ++h)
    if(s.mesh.is_face(h >> 2) && s.mesh.curve(h) >= 0)
      sum += core::distance(s.mesh.point(s.mesh.origin(h)), s.mesh.point(s.mesh.target(h))) /
             (s.mesh.is_border(h) ? 1 : 2);
  return sum;
}

int number_of_bends(const Adaptation_state& s)
{
  int bends = 0;
  for(const Feature_curve& c : s.curves) bends += int(core::bends_of(c).size());
  return bends;
}

} // namespace

TEST(Curve_bends, OnlyThoseThatMatter)
{
  EXPECT_EQ(core::bends_of(polygon(12)).size(), 12u);
  EXPECT_EQ(core::bends_of(polygon(400)).size(), 0u) << "an edge that passes one loses 3e-5";
  const Feature_curve straight({ Vec(0, 0, 0), Vec(1, 0, 0), Vec(3, 0, 0) }, false, true, false);
  EXPECT_TRUE(core::bends_of(straight).empty());
  const Feature_curve corner({ Vec(0, 0, 0), Vec(1, 0, 0), Vec(1, 2, 0) }, false, true, false);
  ASSERT_EQ(core::bends_of(corner).size(), 1u);
  EXPECT_EQ(core::bends_of(corner)[0].arc, 1);
  EXPECT_EQ(core::bends_of(corner)[0].shorter, 1);
  EXPECT_EQ(core::bends_of(corner)[0].mean_length, 1.5);
}

TEST(Curve_bends, HeldWhereTheCurveGetsMoreNodes)
{
  Adaptation_state finer = rim_state(0.3), same = rim_state(1.5);
  const int bends = number_of_bends(finer);
  ASSERT_GT(bends, 10);
  EXPECT_EQ(int(Curve_bends(finer).hold()), bends);
  EXPECT_EQ(number_held(finer), bends);
  EXPECT_EQ(Curve_bends(finer).hold(), 0u) << "held already";
  EXPECT_EQ(Curve_bends(same).hold(), 0u);
  core::smooth(finer, 5);
  EXPECT_EQ(number_held(finer), bends);
  core::release_bends(finer);
  EXPECT_EQ(number_held(finer), 0);
}

// Nodes that have slid off the bends come back, and the curve has its length again.
TEST(Curve_bends, FoundAgain)
{
  Adaptation_state s = rim_state(0.25);
  const double length = length_of_creases(s);
  core::halve_all(s);
  core::halve_all(s);
  for(Index v = 0; v < s.mesh.vertex_end(); ++v) { // by two fifths of an edge
    core::Vertex_record& r = s.mesh.vertex(v);
    if(!s.mesh.is_vertex(v) || r.carrier != Carrier::curve) continue;
    r.param += 0.4 * 0.25 * s.curves[r.curve].length() / 16;
    s.place(r);
  }
  s.forget_faces();
  ASSERT_LT(length_of_creases(s), 0.998 * length);
  const state_checks::Snapshot before = state_checks::snapshot(s);
  EXPECT_EQ(int(Curve_bends(s).fit()), number_of_bends(s));
  EXPECT_EQ(number_held(s), number_of_bends(s));
  EXPECT_NEAR(length_of_creases(s), length, 1e-12 * length);
  EXPECT_EQ(state_checks::problem_of(s, before, true), "");
}

// A curve with just a node for every bend gets one each, also where two bends are nearest to the
// same node, and whatever the size is.
TEST(Curve_bends, ANodeForEach)
{
  for(double factor : { 0.6, 1., 1.8 }) {
    Adaptation_state s = rim_state(factor);
    const double length = length_of_creases(s);
    for(Index v = 0; v < s.mesh.vertex_end(); ++v) { // by 0.2 to 0.6 of an edge
      core::Vertex_record& r = s.mesh.vertex(v);
      if(!s.mesh.is_vertex(v) || r.carrier != Carrier::curve) continue;
      const Feature_curve& c = s.curves[r.curve];
      const double way = 0.4 + 0.2 * std::cos(2 * pi * r.param / c.length());
      r.param = std::fmod(r.param + way * c.length() / 16, c.length());
      s.place(r);
    }
    s.forget_faces();
    ASSERT_LT(length_of_creases(s), 0.99 * length);
    const state_checks::Snapshot before = state_checks::snapshot(s);
    EXPECT_EQ(int(Curve_bends(s).fit()), number_of_bends(s)) << factor;
    EXPECT_NEAR(length_of_creases(s), length, 1e-12 * length) << factor;
    EXPECT_EQ(state_checks::problem_of(s, before, true), "");
  }
}

// Two faces on either side cost nothing, one and three do.
TEST(Crease_sides, CountedByPatch)
{
  Adaptation_state s = rim_state(1);
  int even = 0;
  for(Index v : s.mesh.vertices()) {
    const core::Vertex_record& r = s.mesh.vertex(v);
    const int d = core::side_difference(s, v);
    if(r.carrier != Carrier::curve) {
      EXPECT_EQ(d, 0);
      continue;
    }
    EXPECT_EQ((r.faces + d) % 2, 0);
    even += d == 0;
  }
  EXPECT_GT(even, 0);
  EXPECT_EQ(core::side_energy(s, 0), 0);
  EXPECT_EQ(core::side_energy(s, 2), 2 * s.energy.valence);
  core::Side_count sides;
  for(Index patch : { 3, 1, 1, 1 }) sides.add(patch);
  EXPECT_EQ(sides.difference(), -2);
  core::Side_count one;
  for(Index patch : { 3, 3, 3 }) one.add(patch);
  EXPECT_EQ(one.difference(), 0);
}
