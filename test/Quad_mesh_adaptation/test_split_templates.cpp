// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Templates of conforming 2-refinement, and the marks that select them.

#include "support/state_checks.h"

#include <CGAL/Quad_mesh_adaptation/internal/edge_marking.h>
#include <CGAL/Quad_mesh_adaptation/internal/split_templates.h>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <map>
#include <random>

namespace {

namespace core = CGAL::Quad_mesh_adaptation::internal;
using core::Adaptation_state;
using core::Carrier;
using core::Index;
using core::Quad_complex;
using core::Vec;
using state_fixture::make_state;
using state_fixture::Named_state;

constexpr double infinity = std::numeric_limits<double>::infinity();

int number_of_marks(const std::vector<char>& split, Index f)
{
  return split[4 * f] + split[4 * f + 1] + split[4 * f + 2] + split[4 * f + 3];
}

bool is_opposite(const std::vector<char>& split, Index f)
{
  return number_of_marks(split, f) == 2 && split[4 * f] == split[4 * f + 2];
}

void expect_legal(const Quad_complex& m, const std::vector<char>& split)
{
  ASSERT_EQ(split.size(), 4 * std::size_t(m.face_end()));
  for(Index f = 0; f < m.face_end(); ++f) {
    EXPECT_EQ(number_of_marks(split, f) % 2, 0) << "face " << f;
    for(Index h = 4 * f; m.is_face(f) && h < 4 * f + 4; ++h)
      if(m.opposite(h) >= 0) {
        EXPECT_EQ(split[h], split[m.opposite(h)]) << "half-edge " << h;
      }
  }
}

// What the templates promise: how many faces and nodes, and how many faces at each old node.
struct Promise
{
  long faces = 0, vertices = 0;
  std::vector<int> corners; // per old vertex, change of its number of faces
};

Promise promise_of(const Quad_complex& m, const std::vector<char>& split)
{
  Promise p;
  p.corners.assign(m.vertex_end(), 0);
  for(Index f : m.faces()) {
    for(Index h = 4 * f; h < 4 * f + 4; ++h)
      if(split[h] && (m.opposite(h) < h)) ++p.vertices;
    const int marks = number_of_marks(split, f);
    if(marks == 4) {
      p.faces += 3;
      ++p.vertices;
    } else if(is_opposite(split, f)) {
      p.faces += 1;
    } else if(marks == 2) {
      p.faces += 2;
      ++p.vertices;
      for(int i = 0; i < 4;
          ++i) // the corner between the edges that are whole is joined to the new node
        if(!split[4 * f + i] && !split[4 * f + ((i + 3) & 3)]) ++p.corners[m.origin(4 * f + i)];
    }
  }
  return p;
}

void expect_promise(const Quad_complex& before, const Quad_complex& after, const Promise& p,
                    std::size_t vertices_before)
{
  EXPECT_EQ(after.number_of_faces() - before.number_of_faces(), p.faces);
  long vertices = 0;
  for(Index v = 0; v < after.vertex_end(); ++v) vertices += after.is_vertex(v);
  EXPECT_EQ(vertices - long(vertices_before), p.vertices);
  for(Index v : before.vertices()) {
    EXPECT_EQ(after.vertex(v).faces - before.vertex(v).faces, p.corners[v]) << "vertex " << v;
    EXPECT_EQ(after.point(v), before.point(v)) << "vertex " << v;
  }
  for(Index v = before.vertex_end(); v < after.vertex_end(); ++v) {
    if(!after.is_vertex(v)) continue;
    const core::Vertex_record& r = after.vertex(v);
    if(after.is_border_vertex(v)) // a middle of a border edge, of another edge, or a centre
      EXPECT_EQ(r.faces, 2);
    else
      EXPECT_TRUE(r.faces == 4 || r.faces == 3) << r.faces;
  }
}

} // namespace

TEST(Split_templates, EveryLegalMaskOfOneFace)
{
  const int quads_of[] = { 1, 0, 0, 3, 0, 2, 3, 0, 0, 3, 2, 0, 3, 0, 0, 4 }; // 0: odd, not legal
  for(int mask = 0; mask < 16; ++mask) {
    if(quads_of[mask] == 0) continue;
    Adaptation_state s = make_state(shape_zoo::plate(1, 1));
    const state_checks::Snapshot before = state_checks::snapshot(s);
    std::vector<char> split(4);
    for(int i = 0; i < 4; ++i) split[i] = mask >> i & 1;
    const std::size_t cut = core::Split_templates(s, split)();
    EXPECT_EQ(cut, mask == 0 ? 0u : 1u) << mask;
    EXPECT_EQ(s.mesh.number_of_faces(), quads_of[mask]) << mask;
    EXPECT_VALID_STATE(s, before, true) << mask;
    std::vector<Vec> points;
    const auto quads = state_checks::quads_of(s.mesh, points);
    const mesh_checks::Facts facts = mesh_checks::facts_of(points, quads);
    EXPECT_NEAR(facts.area, 1, 1e-12) << mask;
    EXPECT_EQ(facts.boundary_edges, 4u + std::size_t(__builtin_popcount(unsigned(mask))));
    // of a square in halves, quarters, or by the 3-quad template with its node near the middle
    EXPECT_GT(facts.min_scaled_jacobian, 0.6) << mask;
  }
}

TEST(Split_templates, RandomEvenMarks)
{
  const unsigned seed = zoo_mesh::seed();
  std::cout << "QUAD_MESH_SEED=" << seed << std::endl;
  std::mt19937 random(seed);
  std::map<std::string, int> seen;
  for(const Named_state& n : state_fixture::all_states())
    for(unsigned density : { 2u, 3u, 8u }) {
      SCOPED_TRACE(n.name);
      const Quad_complex& m = n.state.mesh;
      std::vector<double> wish(4 * std::size_t(m.face_end()));
      for(Index h = 0; h < Index(wish.size()); ++h) {
        wish[h] = (1 + random() % 1000) * 1e-3 * (random() % density == 0 ? -1 : 1);
        const Index c = m.curve(h);
        if(c >= 0 && n.state.curves[c].is_frozen()) wish[h] = infinity;
      }
      const std::vector<char> split = core::even_marks(m, wish, 0.2);
      expect_legal(m, split);
      for(Index h = 0; h < Index(wish.size()); ++h)
        if(wish[h] == infinity) {
          EXPECT_EQ(split[h], 0) << "a frozen edge is split";
        }
      for(Index f = 0; f < m.face_end(); ++f)
        ++seen[is_opposite(split, f) ? "opposite" : std::to_string(number_of_marks(split, f))];

      Adaptation_state s = n.state;
      const state_checks::Snapshot before = state_checks::snapshot(s);
      std::size_t vertices = 0;
      for(Index v = 0; v < m.vertex_end(); ++v) vertices += m.is_vertex(v);
      core::Split_templates(s, split)();
      EXPECT_VALID_STATE(s, before, false);
      expect_promise(m, s.mesh, promise_of(m, split), vertices);
      if(HasFailure()) return;
    }
  for(const char* what : { "0", "2", "opposite", "4" }) EXPECT_GT(seen[what], 0) << what;
}

TEST(Split_templates, FacesWithoutMarksAreNotTouched)
{
  const Adaptation_state before = make_state(shape_zoo::plate(6, 6));
  Adaptation_state s = before;
  std::vector<char> split(4 * std::size_t(s.mesh.face_end()), 0);
  for(Index h = 0; h < 4; ++h) { // face 0 in four, its two neighbours take up the rest
    split[h] = 1;
    for(Index g = s.mesh.opposite(h); g >= 0;) {
      split[g] = 1;
      const Index across = Quad_complex::next(Quad_complex::next(g));
      split[across] = 1;
      g = s.mesh.opposite(across);
    }
  }
  core::Split_templates(s, split)();
  int same = 0;
  for(Index f = 0; f < before.mesh.face_end(); ++f) {
    if(number_of_marks(split, f) != 0) continue;
    ++same;
    EXPECT_EQ(s.mesh.quad(f), before.mesh.quad(f));
  }
  EXPECT_EQ(same, 25);
}

// The middle of an edge halves the number of edges that a size linear along it asks for.
TEST(Split_templates, MiddleFollowsTheSize)
{
  state_fixture::Options o;
  o.size = [](const Vec& p) { return 0.5 + p.x(); };
  Adaptation_state s = make_state(shape_zoo::plate(1, 1), o);
  for(Index h = 0; h < 4; ++h) {
    const Vec a = s.mesh.point(s.mesh.origin(h)), b = s.mesh.point(s.mesh.target(h));
    const Vec m = core::edge_middle(s, h).p;
    if(a.y() != b.y()) {
      EXPECT_NEAR(m.y(), 0.5, 1e-12);
      continue;
    }
    // integral of dx / (0.5 + x) from 0 to m is half of that to 1, but for the clamp at 0.38
    const double exact = std::sqrt(0.5 * 1.5) - 0.5;
    EXPECT_NEAR(m.x(), (std::max)(exact, 0.38), 1e-12);
  }
}

// A loop with a single corner: the corner stands for both ends of the curve, even where its
// neighbour is beyond the middle.
TEST(Split_templates, UnevenLoopWithOneCorner)
{
  state_fixture::Options o;
  o.feature_angle = 180;
  o.frozen_vertices = { 1 }; // on the outer circle
  for(bool reverse : { false, true }) {
    Adaptation_state s = make_state(shape_zoo::annulus(8, 1), o);
    ASSERT_EQ(s.mesh.vertex(1).carrier, Carrier::corner);
    for(Index v = 0; v < s.mesh.vertex_end(); ++v) {
      core::Vertex_record& r = s.mesh.vertex(v);
      if(r.carrier != Carrier::curve || s.curves[r.curve].is_closed()) continue;
      const double L = s.curves[r.curve].length(), t = r.param / L;
      r.param = L * (reverse ? 0.4 * t : 0.6 + 0.4 * t);
      s.place(r);
    }
    const state_checks::Snapshot before = state_checks::snapshot(s);
    ASSERT_EQ(state_checks::problem_of(s, before, false), "");
    core::Split_templates(s, std::vector<char>(4 * std::size_t(s.mesh.face_end()), 1))();
    EXPECT_VALID_STATE(s, before, false);
  }
}

// --- marks

TEST(Even_marks, WishesThatFitAreGranted)
{
  const Adaptation_state s = make_state(shape_zoo::irregular());
  const std::size_t n = 4 * std::size_t(s.mesh.face_end());
  const std::vector<char> all = core::even_marks(s.mesh, std::vector<double>(n, -1.), 0.1);
  EXPECT_EQ(all, std::vector<char>(n, 1));
  const std::vector<char> none = core::even_marks(s.mesh, std::vector<double>(n, 1.), 0.1);
  EXPECT_EQ(none, std::vector<char>(n, 0));
}

// One edge of a strip: either it goes without, or the cut runs on to the border.
TEST(Even_marks, TheCheaperWayOut)
{
  const Adaptation_state s = make_state(shape_zoo::plate(5, 1));
  const Quad_complex& m = s.mesh;
  Index inner = -1;
  for(Index h = 0; h < 4 * m.face_end() && inner < 0; ++h)
    if(m.opposite(h) > h) inner = h;
  ASSERT_GE(inner, 0);
  for(double weight : { 0.5, 100. }) {
    std::vector<double> wish(4 * std::size_t(m.face_end()), 1.);
    wish[inner] = -weight;
    const std::vector<char> split = core::even_marks(m, wish, 0.25);
    expect_legal(m, split);
    EXPECT_EQ(split[inner], weight > 1 ? 1 : 0);
  }
}

// So large that only what is near odd faces is looked at: where that has no solution, as about one
// odd face far from the others, it must be found farther off.
TEST(Even_marks, FewOddFacesOfALargeMesh)
{
  const Adaptation_state s = make_state(shape_zoo::plate(60, 60));
  const Quad_complex& m = s.mesh;
  std::vector<double> wish(4 * std::size_t(m.face_end()), 1.);
  const auto lower = [&](Index h) {
    return m.opposite(h) >= 0 && m.opposite(h) < h ? m.opposite(h) : h;
  };
  for(Index f : { 30 * 60 + 30, 30 * 60 + 31, 5 * 60 + 40, 50 * 60 + 12 })
    wish[lower(4 * f + 1)] = -1000.;
  const std::vector<char> split = core::even_marks(m, wish, 0.25);
  expect_legal(m, split);
  for(std::size_t h = 0; h < wish.size(); ++h)
    if(wish[h] < 0) {
      EXPECT_EQ(split[h], 1);
    }
  for(double& w : wish) w = w > 0 ? infinity : -infinity; // no way left
  EXPECT_TRUE(core::even_marks(m, wish, 0.25).empty());
}

TEST(Even_marks, NothingWhereThereIsNoSolution)
{
  const Adaptation_state s = make_state(shape_zoo::plate(3, 1));
  std::vector<double> wish(12, 1.);
  for(Index h = 0; h < 4; ++h) { // face 0: one edge must be split, no other may be
    const Index o = s.mesh.opposite(h);
    wish[o >= 0 && o < h ? o : h] = infinity;
  }
  wish[3] = -infinity;
  ASSERT_LT(s.mesh.opposite(3), 0);
  EXPECT_TRUE(core::even_marks(s.mesh, wish, 0.1).empty());
  wish[3] = infinity; // nothing to be split: feasible again
  EXPECT_EQ(core::even_marks(s.mesh, wish, 0.1), std::vector<char>(12, 0));
}
