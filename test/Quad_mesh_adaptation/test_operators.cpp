// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Every operator at every place (or a sample of them) of every shape: what it promises happens, and
// what must not change does not.

#include "support/places.h"

#include <CGAL/Quad_mesh_adaptation/internal/operators/border_half_ring.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/chord_collapse.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/edge_swap.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/face_close.h>

#include <gtest/gtest.h>

#include <iostream>
#include <random>

namespace {

namespace core = CGAL::Quad_mesh_adaptation::internal;
using core::Adaptation_state;
using core::Carrier;
using core::Cavity;
using core::Index;
using core::Quad_complex;
using places::Place;
using shape_zoo::Shape;
using state_fixture::make_state;
using state_fixture::Named_state;

struct Counts
{
  long faces = 0, vertices = 0, border_edges = 0;
};

Counts count(const Quad_complex& m)
{
  Counts c;
  for(Index v = 0; v < m.vertex_end(); ++v) c.vertices += m.is_vertex(v);
  for(Index h : m.halfedges()) {
    c.faces += (h & 3) == 0;
    c.border_edges += m.is_border(h);
  }
  return c;
}

// `fused`: doublets that the operator would have made; each takes one more face and node with it.
void expect_promise(const Quad_complex& before, const Quad_complex& after, const Place& p,
                    long fused)
{
  const Counts a = count(before), b = count(after);
  EXPECT_EQ(b.faces - a.faces, p.faces - fused);
  EXPECT_EQ(b.vertices - a.vertices, p.vertices - fused);
  EXPECT_EQ(b.border_edges - a.border_edges, p.border_edges);
  if(fused != 0) return;
  for(const auto& c : p.corners) {
    ASSERT_TRUE(after.is_vertex(c.first)) << "vertex " << c.first;
    EXPECT_EQ(after.vertex(c.first).faces - before.vertex(c.first).faces, c.second)
        << "vertex " << c.first;
  }
}

enum class Outcome
{
  illegal,
  refused,
  applied
};

// Applies the operator to a copy; `extra` says whether the cavity takes in its halo (bit 0) and is
// relaxed (bit 1).  Relaxation may tangle what was tangled before it: only a replacement without
// turned face is committed then, as everywhere in the package.
Outcome apply(const Adaptation_state& s, const Place& p, int extra,
              const state_checks::Snapshot& before)
{
  Adaptation_state t = s;
  Cavity cavity(t);
  p.describe(t, cavity);
  if(extra & 1) cavity.add_halo();
  const std::size_t quads = cavity.quads.size();
  if(!cavity.close()) return Outcome::illegal;
  const long fused = long(quads) - long(cavity.quads.size());
  if(extra & 2) {
    cavity.relax(2);
    if(cavity.worst_after() < (std::min)(0.35, cavity.worst_before())) return Outcome::refused;
  }
  cavity.commit();
  EXPECT_VALID_STATE(t, before, (extra & 2) != 0);
  expect_promise(s.mesh, t.mesh, p, fused);
  return Outcome::applied;
}

std::size_t apply_all(const Named_state& n, unsigned seed, std::size_t most,
                      void (*find)(const Adaptation_state&, std::vector<Place>&))
{
  std::vector<Place> list;
  find(n.state, list);
  std::mt19937 random(seed);
  const state_checks::Snapshot before = state_checks::snapshot(n.state);
  std::size_t done = 0;
  const std::size_t step = list.size() > most ? list.size() / most : 1;
  for(std::size_t i = list.size() > most ? random() % step : 0; i < list.size(); i += step) {
    const int extra = int(random() % 4);
    SCOPED_TRACE(n.name + ", " + list[i].name + ", variant " + std::to_string(extra) +
                 ", QUAD_MESH_SEED=" + std::to_string(seed));
    done += apply(n.state, list[i], extra, before) == Outcome::applied;
    if(::testing::Test::HasFailure()) break; // the first is enough
  }
  return done;
}

class Operators : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { states_ = state_fixture::all_states(); }
  static void TearDownTestSuite() { states_.clear(); }

  // Applied at least `least` times in all, else the test tests nothing.
  void run(void (*find)(const Adaptation_state&, std::vector<Place>&), std::size_t least)
  {
    const unsigned seed = zoo_mesh::seed();
    std::cout << "QUAD_MESH_SEED=" << seed << std::endl;
    std::size_t done = 0;
    for(const Named_state& n : states_) {
      done += apply_all(n, seed, std::size_t(zoo_mesh::count("QUAD_MESH_PLACES", 60)), find);
      if(HasFailure()) return;
    }
    std::cout << done << " times applied" << std::endl;
    EXPECT_GE(done, least);
  }

  static std::vector<Named_state> states_;
};

std::vector<Named_state> Operators::states_;

} // namespace

TEST_F(Operators, TheStatesAreValidThemselves)
{
  for(const Named_state& n : states_)
    EXPECT_EQ(state_checks::problem_of(n.state, state_checks::snapshot(n.state), true), "")
        << n.name;
}

TEST_F(Operators, FaceClose) { run(places::add_closes, 500); }
TEST_F(Operators, FaceOpen) { run(places::add_opens, 500); }
TEST_F(Operators, EdgeSwap) { run(places::add_swaps, 500); }
TEST_F(Operators, VertexRotation) { run(places::add_rotations, 200); }
TEST_F(Operators, HalfRingCollapseAndBorderSplit) { run(places::add_border_pairs, 100); }
TEST_F(Operators, CreaseCollapse) { run(places::add_crease_collapses, 30); }
TEST_F(Operators, CornerSplit) { run(places::add_corner_splits, 500); }
TEST_F(Operators, QuadInsertion) { run(places::add_insertions, 500); }
TEST_F(Operators, ChordCollapse) { run(places::add_chords, 50); }
TEST_F(Operators, RingCollapse) { run(places::add_rings, 50); }

// --- what must be refused

TEST(Refused_operations, TwoCornersNeverMeet)
{
  const Adaptation_state plate = make_state(shape_zoo::plate(1, 1));
  for(Index h = 0; h < 4; ++h) {
    EXPECT_FALSE(core::is_face_close_allowed(plate, h));
    EXPECT_FALSE(core::is_rung_collapsible(plate, h));
  }
  // a cube of one face per side has nothing but corners
  const Adaptation_state cube = make_state(shape_zoo::cube(1));
  for(Index h = 0; h < 24; ++h) {
    ASSERT_EQ(cube.mesh.vertex(cube.mesh.origin(h)).carrier, Carrier::corner);
    EXPECT_FALSE(core::is_face_close_allowed(cube, h));
    EXPECT_FALSE(core::is_chord_collapse_allowed(cube, core::chord_through(cube.mesh, h)));
  }
}

TEST(Refused_operations, CurveNodesMeetOnTheirCommonEdgeOnly)
{
  // across a strip two curves face each other
  const Adaptation_state strip = make_state(shape_zoo::plate(5, 1));
  const Quad_complex& m = strip.mesh;
  int across = 0, along = 0;
  for(Index h = 0; h < 4 * m.face_end(); ++h) {
    const bool inner_ends = m.vertex(m.origin(h)).carrier == Carrier::curve &&
                            m.vertex(m.target(h)).carrier == Carrier::curve;
    if(!inner_ends) continue;
    EXPECT_FALSE(core::is_face_close_allowed(strip, h));
    if(m.curve(h) < 0) {
      ++across;
      EXPECT_FALSE(core::is_rung_collapsible(strip, h));
      EXPECT_FALSE(core::is_chord_collapse_allowed(strip, core::chord_through(m, h)));
    } else {
      ++along;
      EXPECT_TRUE(core::is_rung_collapsible(strip, h));
      EXPECT_TRUE(core::is_chord_collapse_allowed(strip, core::chord_through(m, h)));
    }
  }
  EXPECT_EQ(across, 8);
  EXPECT_EQ(along, 6);
}

// Edge swaps, whatever the shape, until a chord of the plate crosses itself.
TEST(Refused_operations, ChordThatCrossesItself)
{
  std::mt19937 random(7);
  Adaptation_state s = make_state(shape_zoo::plate());
  Cavity cavity(s);
  std::size_t found = 0;
  for(int swaps = 0; swaps < 500 && found < 10; ++swaps) {
    const Index h = Index(random() % (4 * std::size_t(s.mesh.face_end())));
    if(!core::is_edge_swap_allowed(s, h)) continue;
    core::describe_edge_swap(s, h, random() % 2 == 0, cavity);
    const std::size_t quads = cavity.quads.size();
    if(!cavity.close() || cavity.quads.size() != quads) continue;
    cavity.commit();
    for(Index g = 0; g < 4 * s.mesh.face_end(); ++g) {
      const core::Chord chord = core::chord_through(s.mesh, g);
      const std::set<Index> once(chord.faces.begin(), chord.faces.end());
      if(once.size() == chord.faces.size()) continue;
      ++found;
      EXPECT_FALSE(core::is_chord_collapse_allowed(s, chord)) << "half-edge " << g;
    }
  }
  EXPECT_GT(found, 0u);
}

TEST(Refused_operations, ClosedCurveKeepsFourEdges)
{
  state_fixture::Options smooth;
  smooth.feature_angle = 180;
  for(Index around : { 5, 8, 12, 15 }) {
    Adaptation_state s = make_state(shape_zoo::open_cylinder(around, 2), smooth);
    ASSERT_EQ(s.curves.size(), 2u);
    ASSERT_TRUE(s.curves[0].is_closed());
    const state_checks::Snapshot before = state_checks::snapshot(s);
    Cavity cavity(s);
    for(bool again = true; again;) { // as many chords as it lets go
      again = false;
      for(Index h = 0; h < 4 * s.mesh.face_end() && !again; ++h) {
        if(!s.mesh.is_face(h >> 2) || !s.mesh.is_border(h)) continue;
        const core::Chord chord = core::chord_through(s.mesh, h);
        if(!core::is_chord_collapse_allowed(s, chord)) continue;
        core::describe_chord_collapse(s, chord, cavity);
        if(!cavity.close()) continue;
        cavity.commit();
        again = true;
        ASSERT_EQ(state_checks::problem_of(s, before, false), "") << around << " around";
      }
    }
    EXPECT_GE(count(s.mesh).border_edges, 8) << around << " around";
    if(around > 8) {
      EXPECT_LT(count(s.mesh).border_edges, 2 * around) << "nothing was removed";
    }
  }
}

TEST(Refused_operations, FrozenCurvesStay)
{
  state_fixture::Options o;
  const Shape plate = shape_zoo::plate();
  for(const auto& q : plate.quads)
    for(int i = 0; i < 4; ++i) {
      const Index u = q[i], v = q[(i + 1) % 4];
      if(plate.points[u].y() == 0 && plate.points[v].y() == 0) o.frozen.insert(std::minmax(u, v));
    }
  ASSERT_EQ(o.frozen.size(), 6u);
  const Adaptation_state s = make_state(plate, o);
  for(Index h = 0; h < 4 * s.mesh.face_end(); ++h)
    if(s.mesh.curve(h) >= 0 && s.curves[s.mesh.curve(h)].is_frozen()) {
      EXPECT_FALSE(core::is_rung_collapsible(s, h));
      core::Border_pair b;
      EXPECT_FALSE(core::find_border_pair(s.mesh, s.mesh.origin(h), b));
    }
}
