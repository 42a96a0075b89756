// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Large meshes that are far too fine are thinned out quickly: whole chords at once, then faces.

#include "support/state_checks.h"

#include <CGAL/Quad_mesh_adaptation/internal/thinning.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

namespace {

using namespace state_fixture;

// Edges of length 1 or so, wanted `size` times as long.
Adaptation_state fine_state(const Shape& shape, double size, double feature_angle = 40)
{
  Options o;
  const double h = size * zoo_mesh::mean_edge(shape);
  o.size = [h](const Vec&) { return h; };
  o.feature_angle = feature_angle;
  return make_state(shape, o);
}

std::size_t irregular_nodes(const Adaptation_state& s)
{
  std::size_t count = 0;
  for(Index v = 0; v < s.mesh.vertex_end(); ++v)
    if(s.mesh.is_vertex(v) && !s.mesh.is_border_vertex(v) && s.mesh.vertex(v).faces != 4) ++count;
  return count;
}

void expect_sound(const Adaptation_state& s, const state_checks::Snapshot& before)
{
  EXPECT_EQ(state_checks::problem_of(s, before, true), "");
}

} // namespace

// Every other chord of both directions, also where their number is odd.
TEST(Thinning, ChordsOfAPlate)
{
  for(const Index n : { 40, 41 }) {
    Adaptation_state s = fine_state(shape_zoo::plate(n, n + 3), 4);
    const state_checks::Snapshot before = state_checks::snapshot(s);
    const std::size_t removed = core::Chord_thinning(s, 1, 0.35)();
    EXPECT_GT(double(removed), 0.7 * n * (n + 3));
    EXPECT_EQ(irregular_nodes(s), 0u);
    expect_sound(s, before);
  }
}

// Closed chords about a torus and a cylinder, rims and creases of the zoo's other shapes.
TEST(Thinning, ChordsOfTheZoo)
{
  for(Named_state& n : all_states()) {
    n.state.scale_sizes(5);
    const state_checks::Snapshot before = state_checks::snapshot(n.state);
    core::Chord_thinning(n.state, 1, 0.2)();
    EXPECT_EQ(state_checks::problem_of(n.state, before, false), "") << n.name;
  }
}

// Nothing goes that is wanted.
TEST(Thinning, WantedChordsStay)
{
  Adaptation_state s = fine_state(shape_zoo::plate(20, 20), 1);
  EXPECT_EQ(core::Chord_thinning(s, 1, 0.35)(), 0u);
  EXPECT_EQ(core::Face_thinning(s, 0.3).pass(0.7), 0u);
  EXPECT_EQ(s.mesh.number_of_faces(), 400);
}

TEST(Thinning, FacesOfTheZoo)
{
  for(Named_state& n : all_states()) {
    n.state.scale_sizes(6);
    const state_checks::Snapshot before = state_checks::snapshot(n.state);
    for(const double limit : { 0.3, 0.5, 0.7 }) core::Face_thinning(n.state, 0.2).pass(limit);
    n.state.forget_faces();
    EXPECT_EQ(state_checks::problem_of(n.state, before, false), "") << n.name;
  }
}

// A fine torus, until about four times as many faces are left as are wanted.
TEST(Thinning, LargeMesh)
{
  Adaptation_state s = fine_state(shape_zoo::torus(160, 80), 9, 180);
  const state_checks::Snapshot before = state_checks::snapshot(s);
  core::thin_out(s, [] {});
  EXPECT_LT(s.mesh.number_of_faces(), 4000);
  EXPECT_EQ(irregular_nodes(s), 0u);
  expect_sound(s, before);
}

// Small meshes are left to those who look closer.
TEST(Thinning, SmallMesh)
{
  Adaptation_state s = fine_state(shape_zoo::plate(60, 60), 10);
  core::thin_out(s, [] {});
  EXPECT_EQ(s.mesh.number_of_faces(), 3600);
}
