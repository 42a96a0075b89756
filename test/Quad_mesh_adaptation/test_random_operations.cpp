// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Long random sequences of everything that changes a state, checked after each step.
// QUAD_MESH_SEED repeats a run, QUAD_MESH_STEPS sets its length.

#include "support/places.h"

#include <CGAL/Quad_mesh_adaptation/internal/Local_improvement.h>
#include <CGAL/Quad_mesh_adaptation/internal/smoothing.h>
#include <CGAL/Quad_mesh_adaptation/internal/edge_marking.h>
#include <CGAL/Quad_mesh_adaptation/internal/split_templates.h>
#include <CGAL/Quad_mesh_adaptation/internal/total_energy.h>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <map>
#include <random>

namespace {

namespace core = CGAL::Quad_mesh_adaptation::internal;
using core::Adaptation_state;
using core::Cavity;
using core::Index;
using places::Place;
using state_fixture::Named_state;

class Walk
{
public:
  Walk(Adaptation_state& s, unsigned seed)
      : s_(s), cavity_(s), random_(seed), before_(state_checks::snapshot(s))
  {
  }

  // One step; what was done.
  std::string step()
  {
    before_.inverted = state_checks::number_of_inverted(s_);
    const Index faces = s_.mesh.number_of_faces();
    const unsigned kind = random_() % 11;
    if(kind == 0 && faces < 250) return refine();
    if(kind == 1) return "smooth, " + std::to_string(core::smooth(s_, 1)) + " moves";
    if(kind == 2) return improve();
    std::vector<Place> list;
    static void (*const find[])(const Adaptation_state&, std::vector<Place>&) = {
      places::add_closes,       places::add_opens,  places::add_swaps, places::add_rotations,
      places::add_border_pairs, places::add_chords, places::add_rings, places::add_corner_splits
    };
    const unsigned k = kind - 3;
    if(kind == 0 || ((k == 0 || k == 5 || k == 6) && faces < 8)) return "";
    if((k == 1 || k == 7) && faces > 400) return "";
    find[k](s_, list);
    for(int attempt = 0; attempt < 8 && !list.empty(); ++attempt) {
      const Place& p = list[random_() % list.size()];
      if(apply(p)) return p.name;
    }
    return "";
  }

  // Operations after which the energy was what was foretold, and less than that.
  int foretold() const { return foretold_; }
  int exceeded() const { return exceeded_; }

  std::string problem() const { return state_checks::problem_of(s_, before_, true); }

private:
  bool apply(const Place& p)
  {
    p.describe(s_, cavity_);
    if(random_() % 3 == 0) cavity_.add_halo();
    if(!cavity_.close()) return false;
    cavity_.relax(int(random_() % 4));
    if(cavity_.worst_after() < 0.2) return false;
    const double before = core::total_energy(s_);
    const double change = cavity_.energy_after() - cavity_.energy_before();
    cavity_.commit();
    // What the cavity foretells is what the whole mesh gains; energies are kept as floats.  Rarely
    // it is more: a witness finds a better face outside, or a face whose nodes are all on curves
    // is compared with the one it comes from.
    const double after = core::total_energy(s_);
    const double rounding = 1e-5 * (1 + std::abs(before) + std::abs(after));
    EXPECT_LT(after - before, change + rounding) << p.name;
    ++(after - before > change - rounding ? foretold_ : exceeded_);
    return true;
  }

  std::string refine()
  {
    std::vector<double> wish(4 * std::size_t(s_.mesh.face_end()));
    for(Index h = 0; h < Index(wish.size()); ++h) {
      wish[h] = 1e-3 * double(random_() % 1000) * (random_() % 4 == 0 ? -1 : 1);
      if(s_.mesh.is_face(h >> 2) && s_.mesh.curve(h) >= 0 &&
         s_.curves[s_.mesh.curve(h)].is_frozen())
        wish[h] = std::numeric_limits<double>::infinity();
    }
    const std::vector<char> split = core::even_marks(s_.mesh, wish, 0.1);
    if(split.empty()) return "infeasible marks";
    const Adaptation_state copy = s_;
    const std::size_t cut = core::Split_templates(s_, split)();
    const std::string what = "refinement of " + std::to_string(cut) + " faces";
    // a part of a distorted face may be turned over: checked, and taken back to go on from here
    if(state_checks::number_of_inverted(s_) <= before_.inverted) return what;
    before_.inverted = s_.mesh.number_of_faces();
    const std::string problem = state_checks::problem_of(s_, before_, true);
    EXPECT_EQ(problem, "") << what;
    s_ = copy;
    return what;
  }

  std::string improve()
  {
    core::Local_improvement improvement(s_, core::Improvement_options());
    s_.stir_all();
    return "clean-up, " + std::to_string(improvement.pass()) + " operations";
  }

  Adaptation_state& s_;
  Cavity cavity_; // one for all steps: it must clean up behind itself
  std::mt19937 random_;
  state_checks::Snapshot before_;
  int foretold_ = 0, exceeded_ = 0;
};

} // namespace

TEST(Random_operations, InvariantsHoldAfterEachStep)
{
  const unsigned seed = zoo_mesh::seed();
  const int steps = zoo_mesh::count("QUAD_MESH_STEPS", 80);
  std::cout << "QUAD_MESH_SEED=" << seed << std::endl;
  std::map<std::string, int> done; // by the first two words
  int foretold = 0, exceeded = 0;
  for(Named_state& n : state_fixture::all_states()) {
    Walk walk(n.state, seed);
    for(int i = 0; i < steps; ++i) {
      const std::string what = walk.step();
      if(what.empty()) continue;
      ++done[what.substr(0, what.find(' ', what.find(' ') + 1))];
      const std::string problem = walk.problem();
      EXPECT_EQ(problem, "") << n.name << ", step " << i << ": " << what
                             << ", QUAD_MESH_SEED=" << seed;
      if(!problem.empty()) break;
    }
    foretold += walk.foretold();
    exceeded += walk.exceeded();
  }
  EXPECT_GT(foretold, 50 * exceeded) << exceeded;
  for(const char* name :
      { "face close", "face open", "left edge", "right edge", "vertex rotation",
        "half-ring collapse", "border split", "chord collapse", "collapse of", "refinement of" })
    EXPECT_GT(done[name], 0) << name << " was never applied";
}

// The wanted size of a face is kept until a corner moves, and handed on when a cavity is committed.
TEST(Random_operations, KnownSizesOfFacesAreThoseOfNow)
{
  const unsigned seed = zoo_mesh::seed();
  std::size_t known = 0;
  for(Named_state& n : state_fixture::all_states()) {
    Adaptation_state& s = n.state;
    const double h = s.size.at(s.mesh.point(0));
    s.size = core::Size_sampler(
        [h](const core::Vec& p) {
          return h * (1.2 + 0.3 * std::sin(p.x() / h) + 0.2 * std::cos((p.y() - p.z()) / h));
        },
        0);
    for(Index v : s.mesh.vertices()) s.mesh.vertex(v).h = s.size.at(s.mesh.point(v));
    s.forget_values();
    Walk walk(s, seed);
    for(int i = 0; i < 30; ++i) {
      walk.step();
      const std::string problem = state_checks::cache_problem(s);
      ASSERT_EQ(problem, "") << n.name << ", step " << i << ", QUAD_MESH_SEED=" << seed;
      for(Index f = 0; f < s.mesh.face_end(); ++f) known += s.sizes.is_known(f);
    }
  }
  EXPECT_GT(known, 1000u);
}
