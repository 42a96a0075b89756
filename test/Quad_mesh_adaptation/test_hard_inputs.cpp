// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Where nothing helps any more, rounds end by count, and what was tried in vain is not tried again.

#include "support/state_fixture.h"

#include <CGAL/Quad_mesh_adaptation/internal/Refinement_progress.h>
#include <CGAL/Quad_mesh_adaptation/internal/local_detours.h>
#include <CGAL/Quad_mesh_adaptation/internal/octaves.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <vector>

namespace {

using namespace state_fixture;

constexpr Index n = 20;

Adaptation_state plate_state(double size)
{
  Options o;
  o.size = [size](const Vec&) { return size; };
  return make_state(shape_zoo::plate(n, n), o);
}

// A plate of unit squares with inner nodes moved by up to `most`: from 1 on faces are folded.
Adaptation_state shaken_state(double most)
{
  Shape plate = shape_zoo::plate(n, n);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> by(-most, most);
  for(Vec& p : plate.points)
    if(p.x() > 0 && p.x() < n && p.y() > 0 && p.y() < n) p = p + Vec(by(random), by(random), 0);
  Options o;
  o.size = [](const Vec&) { return 1.; };
  return make_state(plate, o);
}

std::size_t operations(const Adaptation_state& s)
{
  std::size_t sum = 0;
  for(const auto& o : s.operations) sum += o.second;
  return sum;
}

} // namespace

// Four passes are not judged, the fifth is what the next three are compared with.
TEST(Hard_inputs, RefinementEndsAfterPassesInVain)
{
  Adaptation_state s = plate_state(0.1);
  core::Refinement_progress progress(s);
  int passes = 0;
  while(passes < 100 && !progress.is_stuck()) ++passes;
  EXPECT_EQ(passes, 7);
}

TEST(Hard_inputs, RefinementThatPaysGoesOn)
{
  Options o;
  o.size = [](const Vec&) { return 0.01; };
  Adaptation_state s = make_state(shape_zoo::plate(2, 2), o);
  core::Refinement_progress progress(s);
  int passes = 0;
  for(; !core::faces_to_press(s).empty(); ++passes) {
    ASSERT_FALSE(progress.is_stuck()) << passes;
    core::cut_all_faces(s);
  }
  EXPECT_EQ(passes, 7);
}

TEST(Hard_inputs, MeshOfTheLastPassThatPaidIsBack)
{
  Adaptation_state s = plate_state(0.6);
  core::Refinement_progress progress(s);
  for(int pass = 0; pass < 5; ++pass) ASSERT_FALSE(progress.is_stuck());
  const Index faces = s.mesh.number_of_faces();
  core::cut_all_faces(s);
  progress.go_back();
  EXPECT_EQ(s.mesh.number_of_faces(), faces);
}

// One cycle of rounds without a gain is enough, where many faces are poor.
TEST(Hard_inputs, MendingEndsWhereNothingFalls)
{
  const Adaptation_state s = shaken_state(1.5);
  core::Mending_progress many, few;
  int rounds = 0;
  while(rounds < 100 && !many.is_stuck(s, 500)) ++rounds;
  EXPECT_EQ(rounds, 3);
  for(int round = 0; round < 12; ++round) EXPECT_FALSE(few.is_stuck(s, 20)) << round;
}

TEST(Hard_inputs, PlacesAreTriedOnceUnlessTheyChange)
{
  Adaptation_state s = plate_state(1);
  core::Places_in_vain in_vain;
  EXPECT_TRUE(in_vain.changed_nodes(s).empty());
  const Index f = n * n / 2 + n / 2, other = 0;
  in_vain.remember(s, { f }); // few may be tried again
  EXPECT_TRUE(core::is_about(s, f, in_vain.changed_nodes(s)));
  std::vector<Index> upper_half;
  for(Index k = n * n / 2; k < n * n; ++k) upper_half.push_back(k);
  ASSERT_GT(upper_half.size(), 100u);
  in_vain.remember(s, upper_half);
  EXPECT_FALSE(core::is_about(s, f, in_vain.changed_nodes(s)));
  EXPECT_TRUE(core::is_about(s, other, in_vain.changed_nodes(s)));
  core::Vertex_record& node = s.mesh.vertex(s.mesh.quad(f)[0]);
  node.p = node.p + Vec(0.02, 0, 0);
  EXPECT_FALSE(core::is_about(s, f, in_vain.changed_nodes(s)));
  node.p = node.p + Vec(0.1, 0, 0);
  EXPECT_TRUE(core::is_about(s, f, in_vain.changed_nodes(s)));
}

// What one call of mending leaves, the next one does not work on.
TEST(Hard_inputs, MendingTheSameMeshAgainDoesNothing)
{
  Adaptation_state s = shaken_state(1.2);
  // as held by the caller, so that poor faces stay
  for(Index v = 0; v < s.mesh.vertex_end(); ++v) s.mesh.vertex(v).frozen = true;
  const core::Improvement_options o;
  core::Places_in_vain in_vain;
  core::mend_shapes(s, o, 12, in_vain);
  ASSERT_FALSE(core::faces_to_mend(s, core::shape_floor).empty());
  const std::size_t done = operations(s);
  const Index faces = s.mesh.number_of_faces();
  core::mend_shapes(s, o, 12, in_vain);
  EXPECT_EQ(operations(s), done);
  EXPECT_EQ(s.mesh.number_of_faces(), faces);
}
