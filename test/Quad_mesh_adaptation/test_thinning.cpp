// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Large meshes that are far too fine are thinned out quickly: whole chords at once, then faces.

#include "support/state_checks.h"

#include <CGAL/Quad_mesh_adaptation/internal/Tried_places.h>
#include <CGAL/Quad_mesh_adaptation/internal/changed_face_quality.h>
#include <CGAL/Quad_mesh_adaptation/internal/thinning.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <random>
#include <vector>

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
  std::size_t thinned = 0; // states
  for(Named_state& n : all_states()) {
    n.state.scale_sizes(5);
    const state_checks::Snapshot before = state_checks::snapshot(n.state);
    if(core::Chord_thinning(n.state, 1, 0.2)() > 0) ++thinned;
    EXPECT_EQ(state_checks::problem_of(n.state, before, false), "") << n.name;
  }
  EXPECT_GT(thinned, 5u);
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
  std::size_t thinned = 0; // states
  for(Named_state& n : all_states()) {
    n.state.scale_sizes(6);
    const state_checks::Snapshot before = state_checks::snapshot(n.state);
    std::size_t closed = 0;
    for(const double limit : { 0.3, 0.5, 0.7 })
      closed += core::Face_thinning(n.state, 0.2).pass(limit);
    if(closed > 0) ++thinned;
    n.state.forget_faces();
    EXPECT_EQ(state_checks::problem_of(n.state, before, false), "") << n.name;
  }
  EXPECT_GT(thinned, 5u);
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

namespace {

// A square whose corners are shaken, and where it should look; now and then a corner knows nothing.
class Random_faces
{
public:
  explicit Random_faces(unsigned seed) : random_(seed) {}

  core::Corners corners()
  {
    core::Corners p = { Vec(0, 0, 0), Vec(1, 0, 0), Vec(1, 1, 0), Vec(0, 1, 0) };
    const double much = number(0, 1);
    for(Vec& x : p) x = x + much * much * vector();
    return p;
  }

  core::Facing reference()
  {
    core::Facing reference;
    const double much = number(0, 1.5);
    for(int i = 0; i < 4; ++i)
      reference.add(number(0, 1) < 0.2 ? Vec(0, 0, 0)
                                       : core::normalized(Vec(0, 0, 1) + much * vector()));
    return reference;
  }

private:
  double number(double least, double most)
  {
    return std::uniform_real_distribution<double>(least, most)(random_);
  }
  Vec vector() { return Vec(number(-1, 1), number(-1, 1), number(-1, 1)); }

  std::mt19937 random_;
};

std::size_t number_stirred(const Adaptation_state& s)
{
  return std::size_t(std::count(s.stirred.begin(), s.stirred.end(), 1));
}

} // namespace

// Squares tell the same as the quality itself, also where it is just what is asked for.
TEST(Thinning, QualityBySquares)
{
  const unsigned seed = zoo_mesh::seed();
  std::cout << "seed " << seed << "\n";
  Random_faces random(seed);
  std::size_t enough = 0, too_little = 0;
  for(int i = 0; i < 50000; ++i) {
    const core::Corners p = random.corners();
    const core::Facing reference = random.reference();
    const double quality = Adaptation_state::face_quality(p, reference);
    for(const double least : { 0.01, 0.2, 0.3, 0.7, quality, std::nextafter(quality, 2.) }) {
      ASSERT_EQ(core::has_quality(p, reference, least), quality >= least) << i << ' ' << least;
      ++(quality >= least ? enough : too_little);
    }
  }
  EXPECT_GT(enough, 10000u);
  EXPECT_GT(too_little, 10000u);
}

// After a search in vain only the nodes of faces that have changed are looked at again.
TEST(Thinning, TriedPlaces)
{
  Adaptation_state s = fine_state(shape_zoo::plate(10, 10), 1);
  const auto stir_all = [&] { s.stirred.assign(std::size_t(s.mesh.vertex_end()), 1); };
  core::Tried_places tried;
  stir_all();
  tried.leave_changed(s);
  EXPECT_EQ(number_stirred(s), 121u); // nothing has been tried
  s.stirred.assign(s.stirred.size(), 0);
  tried.remember(s);
  stir_all();
  tried.leave_changed(s);
  EXPECT_EQ(number_stirred(s), 0u);
  core::Vertex_record& r = s.mesh.vertex(60); // in the middle
  const Vec old = r.p;
  const double edge = zoo_mesh::mean_edge(shape_zoo::plate(10, 10));
  r.p = old + Vec(0.04 * edge, 0, 0);
  stir_all();
  tried.leave_changed(s);
  EXPECT_EQ(number_stirred(s), 0u);
  r.p = old + Vec(0.06 * edge, 0, 0);
  stir_all();
  tried.leave_changed(s);
  EXPECT_EQ(number_stirred(s), 9u);
  tried.forget();
  stir_all();
  tried.leave_changed(s);
  EXPECT_EQ(number_stirred(s), 121u);
}
