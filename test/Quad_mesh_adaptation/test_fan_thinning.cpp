// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Where a node has very many faces that are too fine, most of them go at once.

#include "support/growth_shapes.h"
#include "support/state_checks.h"

#include <CGAL/Quad_mesh_adaptation/internal/fan_thinning.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace state_fixture;

Adaptation_state state_with_size(const Shape& shape, double h)
{
  Options o;
  o.size = [h](const Vec&) { return h; };
  return make_state(shape, o);
}

int largest_number_of_faces(const Adaptation_state& s)
{
  int most = 0;
  for(Index v : s.mesh.vertices()) most = (std::max)(most, int(s.mesh.vertex(v).faces));
  return most;
}

// Inner nodes that have neither four faces nor very many.
int slightly_irregular_nodes(const Adaptation_state& s)
{
  int count = 0;
  for(Index v : s.mesh.vertices())
    if(!s.mesh.is_border_vertex(v) && s.mesh.vertex(v).faces < 8)
      count += s.mesh.vertex(v).faces != 4;
  return count;
}

// Thins the fans of a state: the mesh stays one of the same topology with its curves, and the
// energy falls.
void thin(Adaptation_state& s, const std::string& name)
{
  const state_checks::Snapshot before = state_checks::snapshot(s);
  const double energy = core::total_energy(s);
  core::thin_fans(s);
  EXPECT_LT(core::total_energy(s), energy) << name;
  EXPECT_EQ(state_checks::problem_of(s, before, true), "") << name;
}

} // namespace

// Between 13 and 24 faces are left, of any number.
TEST(FanThinning, DiskAndHalfDisk)
{
  for(const Index n : { 25, 64, 101, 1000, 40000 })
    for(const Shape& shape : { growth_shapes::fan(n), growth_shapes::half_fan(n) }) {
      Adaptation_state s = state_with_size(shape, 2);
      thin(s, shape.name);
      EXPECT_EQ(s.mesh.number_of_faces(), largest_number_of_faces(s)) << shape.name << n;
      EXPECT_LE(s.mesh.number_of_faces(), 24) << shape.name << n;
      EXPECT_GE(s.mesh.number_of_faces(), 12) << shape.name << n;
    }
}

// Whole rows go from one pole to the other, or to the border, and all stays regular: but for the
// nodes opposite the centre in each face of a fan, which have three faces in the input, too.
TEST(FanThinning, RowsThatMeet)
{
  for(const Shape& shape :
      { growth_shapes::polar_sphere(96, 5), growth_shapes::polar_disk(96, 5) }) {
    Adaptation_state s = state_with_size(shape, 1);
    const Index fans = shape.name == "polar" ? 1 : 2;
    thin(s, shape.name);
    EXPECT_EQ(largest_number_of_faces(s), 24) << shape.name;
    EXPECT_EQ(s.mesh.number_of_faces(), 24 * (fans + 10)) << shape.name;
    EXPECT_EQ(slightly_irregular_nodes(s), 24 * fans) << shape.name;
  }
}

// Far from the centre faces are as wide as wanted: those about it go alone.
TEST(FanThinning, FacesAboutTheCentreOnly)
{
  Adaptation_state s = state_with_size(growth_shapes::polar_disk(60, 20), 0.1);
  thin(s, "disk");
  EXPECT_EQ(largest_number_of_faces(s), 30);
  EXPECT_EQ(s.mesh.number_of_faces(), 60 + 20 * 120 - 2 * 30);
}

// Fans on both sides of a crease whose spokes meet it at different nodes.
TEST(FanThinning, SpokesByTurns)
{
  for(const Index n : { 40, 101, 400 }) {
    Adaptation_state s = state_with_size(growth_shapes::kites(n), 2);
    thin(s, "kites");
    EXPECT_LE(largest_number_of_faces(s), 24) << n;
    EXPECT_EQ(slightly_irregular_nodes(s), s.mesh.number_of_faces()) << n; // three faces at each
  }
}

// Rows from a face of one fan end in two faces of the other: one of the two is turned first.
TEST(FanThinning, SpokesAtDifferentColumns)
{
  for(const Index n : { 32, 101, 400 })
    for(const Index rings : { 1, 3 }) {
      Adaptation_state s = state_with_size(growth_shapes::can(n, rings), 2);
      thin(s, "can");
      EXPECT_LE(largest_number_of_faces(s), 24) << n;
      EXPECT_EQ(s.mesh.number_of_faces(), largest_number_of_faces(s) * 2 * (1 + rings)) << n;
    }
}

// A face between two huge nodes takes one from each of them.
TEST(FanThinning, FacesFromPoleToPole)
{
  for(const Index n : { 40, 400 }) {
    Adaptation_state s = state_with_size(growth_shapes::slices(n), 2);
    core::thin_fans(s);
    EXPECT_LE(s.mesh.number_of_faces(), 24) << n;
    EXPECT_EQ(largest_number_of_faces(s), s.mesh.number_of_faces()) << n;
  }
}

// Turned in vain: nothing is left of that.
TEST(FanThinning, SpokesAtDifferentColumnsThatMustStay)
{
  Adaptation_state s = state_with_size(growth_shapes::can(40, 1), 2);
  for(Index v = 0; v < s.mesh.vertex_end(); ++v)
    s.mesh.vertex(v).frozen = s.mesh.vertex(v).carrier != core::Carrier::surface;
  const std::vector<core::Quad> before = [&] {
    std::vector<core::Quad> quads;
    for(Index f = 0; f < s.mesh.face_end(); ++f) quads.push_back(s.mesh.quad(f));
    return quads;
  }();
  core::thin_fans(s);
  ASSERT_EQ(s.mesh.number_of_faces(), Index(before.size()));
  for(Index f = 0; f < s.mesh.face_end(); ++f) EXPECT_EQ(s.mesh.quad(f), before[f]);
}

// What is wanted stays, and so do all nodes of fewer faces.
TEST(FanThinning, NothingToDo)
{
  Adaptation_state wanted = state_with_size(growth_shapes::fan(100), 0.03);
  core::thin_fans(wanted);
  EXPECT_EQ(wanted.mesh.number_of_faces(), 100);
  for(Named_state& n : all_states()) {
    n.state.scale_sizes(8);
    const Index faces = n.state.mesh.number_of_faces();
    core::thin_fans(n.state);
    EXPECT_EQ(n.state.mesh.number_of_faces(), faces) << n.name;
  }
}

// Nodes that must not move stay.
TEST(FanThinning, FrozenRim)
{
  Adaptation_state s = state_with_size(growth_shapes::fan(100), 2);
  for(Index v = 1; v < s.mesh.vertex_end(); ++v) s.mesh.vertex(v).frozen = true;
  core::thin_fans(s);
  EXPECT_EQ(s.mesh.number_of_faces(), 100);
}

// Nothing leaves the surface where that is limited.
TEST(FanThinning, DistanceLimited)
{
  Adaptation_state s = state_with_size(growth_shapes::polar_sphere(60, 5), 1);
  const Index faces = s.mesh.number_of_faces();
  s.limit_distance(1e-5);
  core::thin_fans(s);
  EXPECT_EQ(s.mesh.number_of_faces(), faces);
}
