// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The thresholds, classes and rules of the paper's section 3.4, on meshes small enough to count.

#include "support/state_checks.h"

#include <CGAL/Quad_mesh_adaptation/internal/paper_schedule.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace {

namespace core = CGAL::Quad_mesh_adaptation::internal;
using core::Adaptation_state;
using core::Index;
using core::Vec;
using state_fixture::make_state;

// Unit faces whose size ratio is 1 / h at their centres.
Adaptation_state plate(Index n, Index m, std::function<double(const Vec&)> ratio)
{
  state_fixture::Options o;
  o.size = [=](const Vec& p) { return 1 / ratio(p); };
  Adaptation_state s = make_state(shape_zoo::plate(n, m), o);
  s.size.sampling = core::Size_sampling::centre;
  return s;
}

} // namespace

TEST(Paper_schedule, Eq3SizeRatio)
{
  const Adaptation_state s = plate(3, 2, [](const Vec& p) { return 0.5 + p.x(); });
  for(Index f = 0; f < 6; ++f) {
    const core::Corners p = s.corners(f);
    EXPECT_NEAR(s.size_ratio(f), 0.5 + (0.25 * (p[0] + p[1] + p[2] + p[3])).x(), 1e-12);
  }
}

TEST(Paper_schedule, Eq4CoarseningThreshold)
{
  const double expected[] = { 1, 0.8, 0.6, 0.4, 0.2, 0, 0, 0 };
  for(std::size_t n = 0; n < 8; ++n)
    EXPECT_NEAR(core::coarsening_threshold(n), expected[n], 1e-12) << n;
  const Adaptation_state tiny = plate(4, 4, [](const Vec&) { return 1e-6; });
  EXPECT_TRUE(core::is_coarsening_needed(tiny, core::coarsening_threshold(4)));
  EXPECT_FALSE(core::is_coarsening_needed(tiny, core::coarsening_threshold(5)))
      << "in the sixth iteration the threshold is gone";
}

TEST(Paper_schedule, Eq5RefinementThreshold)
{
  const double expected[] = { 1.25, 1.2, 1.15, 1.1, 1.05, 1, 1, 1 };
  for(std::size_t n = 0; n < 8; ++n)
    EXPECT_NEAR(core::refinement_threshold(n), expected[n], 1e-12) << n;
}

TEST(Paper_schedule, HighAndLowRefineFaces)
{
  // ten faces in a row with ratios 0.95, 1, 1.05, 1.1 ... 1.4
  const Adaptation_state s =
      plate(10, 1, [](const Vec& p) { return 0.95 + 0.05 * std::floor(p.x()); });
  core::Refine_classes c = core::classify_faces(s, 1.22);
  EXPECT_EQ(c.low, (std::vector<Index>{ 2, 3, 4, 5 }));
  EXPECT_EQ(c.high, (std::vector<Index>{ 6, 7, 8, 9 }));
  c = core::classify_faces(s, 1.0);
  EXPECT_TRUE(c.low.empty()) << "from the sixth iteration on";
  EXPECT_EQ(c.high.size(), 8u);
  c = core::classify_faces(s, 2.);
  EXPECT_TRUE(c.high.empty());
  EXPECT_EQ(c.low.size(), 8u);
}

TEST(Paper_schedule, TenPercentRule)
{
  for(int small : { 0, 9, 10, 11, 40 }) { // of 100 faces
    const Adaptation_state s = plate(10, 10, [=](const Vec& p) {
      return std::floor(p.y()) * 10 + std::floor(p.x()) < small ? 0.7 : 0.9;
    });
    EXPECT_EQ(core::is_coarsening_needed(s, 0.8), small >= 10) << small;
    EXPECT_FALSE(core::is_coarsening_needed(s, 0.6));
  }
}

TEST(Paper_schedule, ThreePercentAndHalfPercentRule)
{
  const auto classes = [](std::size_t high, std::size_t low) {
    core::Refine_classes c;
    c.high.assign(high, 0);
    c.low.assign(low, 0);
    return c;
  };
  EXPECT_TRUE(core::is_refinement_sufficient(classes(0, 0), 1000));
  EXPECT_TRUE(core::is_refinement_sufficient(classes(4, 29), 1000));
  EXPECT_FALSE(core::is_refinement_sufficient(classes(5, 0), 1000));
  EXPECT_FALSE(core::is_refinement_sufficient(classes(0, 30), 1000));
  EXPECT_FALSE(core::is_refinement_sufficient(classes(1, 0), 100));
  EXPECT_TRUE(core::is_refinement_sufficient(classes(0, 2), 100));
}

// Whole faces are cut in four, and conforming templates close the gap to the rest.
TEST(Paper_schedule, RefinesTheFacesAsked)
{
  for(const std::vector<Index>& region :
      { std::vector<Index>{ 24 }, std::vector<Index>{ 24, 25 }, std::vector<Index>{ 16, 24, 25 },
        std::vector<Index>{ 0 }, std::vector<Index>{ 3, 24, 40, 48 } }) {
    Adaptation_state s = make_state(shape_zoo::plate(7, 7));
    const Adaptation_state old = s;
    const state_checks::Snapshot before = state_checks::snapshot(s);
    EXPECT_GE(core::refine_faces(s, region), region.size());
    EXPECT_VALID_STATE(s, before, true);
    // every edge of the region has a node in its middle
    std::set<std::pair<double, double>> points;
    for(Index v : s.mesh.vertices()) points.insert({ s.mesh.point(v).x(), s.mesh.point(v).y() });
    for(Index f : region) {
      const core::Corners p = old.corners(f);
      for(int i = 0; i < 4; ++i) {
        const Vec m = 0.5 * (p[i] + p[(i + 1) & 3]);
        EXPECT_TRUE(points.count({ m.x(), m.y() })) << "face " << f << ", side " << i;
      }
      const Vec c = 0.25 * (p[0] + p[1] + p[2] + p[3]);
      EXPECT_TRUE(points.count({ c.x(), c.y() })) << "face " << f;
    }
  }
}

// Step 2: chords through short border edges go, in the order of the paper, before all else.
TEST(Paper_schedule, BoundaryCoarsening)
{
  // size 2 on the left part, 1 elsewhere: the short edges are on the lines y = 0 and y = 4 there
  state_fixture::Options o;
  o.size = [](const Vec& p) { return p.x() < 6 ? 2.2 : 1.; };
  Adaptation_state s = make_state(shape_zoo::plate(12, 4), o);
  s.size.sampling = core::Size_sampling::centre;
  const state_checks::Snapshot before = state_checks::snapshot(s);
  const std::size_t removed = core::coarsen_boundary(s);
  EXPECT_GE(removed, 2u);
  EXPECT_EQ(s.operation_counts()["chord collapse"], removed);
  EXPECT_LT(s.mesh.number_of_faces(), 48);
  EXPECT_VALID_STATE(s, before, true);
  // no chord that is left could go
  for(Index h = 0; h < 4 * s.mesh.face_end(); ++h)
    if(s.mesh.is_face(h >> 2) && s.mesh.is_border(h)) {
      EXPECT_LT(core::edge_ratio(s, h), 1.35) << "coarsened too far";
    }
}

// What is kept of faces whose nodes have been moved is that of now.
TEST(Paper_schedule, SizesAfterBoundaryCoarsening)
{
  state_fixture::Options o;
  o.size = [](const Vec& p) { return 1.3 + 0.1 * p.x(); };
  Adaptation_state s = make_state(shape_zoo::plate(12, 4), o);
  for(Index f = 0; f < s.mesh.face_end(); ++f) s.size_ratio(f); // known from now on
  ASSERT_GT(core::coarsen_boundary(s), 0u);
  Adaptation_state fresh = s;
  fresh.forget_sizes();
  for(Index f : s.mesh.faces()) {
    EXPECT_EQ(s.size_ratio(f), fresh.size_ratio(f)) << "face " << f;
  }
}

// A closed border has no end to walk to.
TEST(Paper_schedule, NodesAlongCurves)
{
  for(const shape_zoo::Shape& shape : { shape_zoo::annulus(), shape_zoo::plate(6, 3) }) {
    Adaptation_state s = make_state(shape);
    const auto all = core::border_nodes(s);
    for(std::size_t c = 0; c < all.size(); ++c)
      for(const core::Border_node& n : all[c])
        for(const int reach : { 1, 2, 1000 }) {
          std::set<Index> found;
          const auto near = core::border_nodes_near(s, Index(c), n.node, reach);
          for(const core::Border_node& k : near)
            EXPECT_TRUE(found.insert(k.node).second) << "twice";
          EXPECT_TRUE(found.count(n.node));
          EXPECT_LE(found.size(), std::size_t(2 * reach));
          if(reach == 1000) {
            EXPECT_EQ(found.size(), all[c].size());
          }
        }
  }
}

TEST(Paper_schedule, NothingToDo)
{
  Adaptation_state s = plate(6, 6, [](const Vec&) { return 0.97; });
  s.size = core::Size_sampler([](const Vec&) { return 1 / 0.97; }, 0);
  s.size.sampling = core::Size_sampling::centre;
  const Adaptation_state before = s;
  core::paper_schedule(s, 40);
  // t_c = 1 finds all faces a little too small, but no ring may go
  EXPECT_GE(s.mesh.number_of_faces(), 30);
  EXPECT_EQ(state_checks::problem_of(s, state_checks::snapshot(before), true), "");
}

// After coarsening is complete it does not start again; refinement may.
TEST(Paper_schedule, PhasesInOrder)
{
  state_fixture::Options o;
  o.size = [](const Vec& p) {
    const double d = std::hypot(p.x() - 5, p.y() - 5);
    return 0.15 + 0.6 * std::abs(d - 3);
  };
  Adaptation_state s = make_state(shape_zoo::plate(10, 10), o);
  s.size.sampling = core::Size_sampling::centre;
  std::vector<std::string> phases;
  s.start_phase = [&](const char* name, std::size_t) { phases.push_back(name); };
  const state_checks::Snapshot before = state_checks::snapshot(s);
  core::paper_schedule(s, 40);
  EXPECT_VALID_STATE(s, before, true);
  ASSERT_FALSE(phases.empty());
  EXPECT_EQ(phases[0], "boundary coarsening");
  EXPECT_EQ(std::count(phases.begin(), phases.end(), "boundary coarsening"), 1);
  EXPECT_GT(std::count(phases.begin(), phases.end(), "refinement"), 1);
  EXPECT_LE(std::count(phases.begin(), phases.end(), "coarsening"), 5);
  for(std::size_t i = 0; i + 1 < phases.size(); ++i)
    if(phases[i] == "refinement") {
      EXPECT_EQ(phases[i + 1], "clean-up");
    }
  const core::Refine_classes c = core::classify_faces(s, 1.0);
  EXPECT_LE(double(c.high.size()), 0.035 * s.mesh.number_of_faces()) << "not refined enough";
}
