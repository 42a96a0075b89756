// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The relaxation of single nodes: its derivatives, and what it never does.

#include "support/state_checks.h"

#include <CGAL/Quad_mesh_adaptation/internal/smoothing.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

struct Node_relaxation_access
{
  // Derivatives at node r in the directions t; returns how many there are.
  static int derivatives(Node_relaxation& relax, const Vertex_record& r, Local_model& m, Vec t[2])
  {
    const int dofs = relax.directions(r);
    for(int i = 0; i < dofs; ++i) t[i] = relax.t_[i];
    relax.evaluate(r, &m);
    return dofs;
  }

  static bool keeps_within_size(Node_relaxation& relax, const Vertex_record& r, const Vec& now)
  {
    relax.largest_now_ = -1;
    return relax.keeps_within_size(r, now);
  }
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

namespace {

namespace core = CGAL::Quad_mesh_adaptation::internal;
using core::Adaptation_state;
using core::Carrier;
using core::Index;
using core::Node_relaxation;
using core::Vec;
using core::Vertex_record;
using state_fixture::make_state;
using state_fixture::Named_state;

struct Random
{
  explicit Random(unsigned seed) : engine(seed) {}
  double operator()(double a, double b)
  {
    return a + (b - a) * (engine() / double(std::mt19937::max()));
  }
  std::mt19937 engine;
};

// Moves every node that may move, surface nodes by up to `share` of the shortest edge at them.
void shake(Adaptation_state& s, Random& random, double share)
{
  std::vector<Index> out;
  for(Index v : s.mesh.vertices()) {
    Vertex_record& r = s.mesh.vertex(v);
    if(r.frozen || r.carrier == Carrier::corner) continue;
    double reach = 1e9;
    s.mesh.outgoing(v, out);
    for(Index h : out)
      for(Index u : { s.mesh.target(h), s.mesh.origin(s.mesh.prev(h)) })
        reach = (std::min)(reach, core::distance(r.p, s.mesh.point(u)));
    if(r.carrier == Carrier::curve) {
      if(!s.curves[r.curve].is_frozen()) r.param += share * reach * random(-1, 1);
    } else {
      r.p = r.p + share * reach * Vec(random(-1, 1), random(-1, 1), random(-1, 1));
    }
    s.place(r);
  }
  s.forget_faces();
}

enum class Size
{
  constant,
  linear
};

// Compares with differences of the objective at every node of a shaken irregular mesh in the
// plane, where the normals do not depend on the node; returns the number of comparisons.
int compare_derivatives(Adaptation_state& s, Random& random, bool hessian)
{
  int compared = 0;
  shake(s, random, 0.25);
  Node_relaxation relax(s);
  for(Index v = 0; v < s.mesh.vertex_end(); ++v) {
    const Vertex_record r = s.mesh.vertex(v);
    if(r.carrier == Carrier::corner) continue;
    core::gather_star(s, v, relax.star());
    core::Local_model m;
    Vec t[2];
    const int dofs = core::Node_relaxation_access::derivatives(relax, r, m, t);
    EXPECT_EQ(dofs, r.carrier == Carrier::curve ? 1 : 2);
    const auto value = [&](double a, double b) {
      Vertex_record x = r;
      x.p = r.p + a * t[0] + (dofs > 1 ? b * t[1] : Vec(0, 0, 0));
      x.h = s.size.at(x.p);
      return relax.objective(x);
    };
    const double e = 1e-5, scale = 1 + std::abs(m.g[0]) + std::abs(m.g[1]);
    EXPECT_NEAR(m.g[0], (value(e, 0) - value(-e, 0)) / (2 * e), 1e-5 * scale) << "node " << v;
    if(dofs > 1) {
      EXPECT_NEAR(m.g[1], (value(0, e) - value(0, -e)) / (2 * e), 1e-5 * scale) << "node " << v;
    }
    ++compared;
    if(!hessian) continue;
    const double d = 1e-4, f = value(0, 0);
    const double tolerance = 1e-3 * (1 + std::abs(m.H[0]) + std::abs(m.H[1]) + std::abs(m.H[2]));
    EXPECT_NEAR(m.H[0], (value(d, 0) - 2 * f + value(-d, 0)) / (d * d), tolerance) << "node " << v;
    if(dofs < 2) continue;
    EXPECT_NEAR(m.H[1], (value(d, d) - value(d, -d) - value(-d, d) + value(-d, -d)) / (4 * d * d),
                tolerance)
        << "node " << v;
    EXPECT_NEAR(m.H[2], (value(0, d) - 2 * f + value(0, -d)) / (d * d), tolerance) << "node " << v;
  }
  return compared;
}

double worst_corner(const Adaptation_state& s, Index v)
{
  std::vector<Index> out;
  s.mesh.outgoing(v, out);
  double worst = 1;
  for(Index h : out) {
    const core::Corners p = s.corners(s.mesh.face(h));
    worst = (std::min)(worst, mesh_checks::scaled_jacobian(p[0], p[1], p[2], p[3]));
  }
  return worst;
}

} // namespace

TEST(Node_relaxation, GradientAndHessianOfConstantSize)
{
  Random random(zoo_mesh::seed());
  for(double factor : { 0.7, 1., 3. })
    for(double hinge : { 0., 50. }) {
      state_fixture::Options o;
      const double h = factor * zoo_mesh::mean_edge(shape_zoo::irregular());
      o.size = [h](const Vec&) { return h; };
      Adaptation_state s = make_state(shape_zoo::irregular(), o);
      s.smoothing.hinge = hinge;
      EXPECT_GT(compare_derivatives(s, random, hinge == 0), 50);
    }
}

TEST(Node_relaxation, GradientOfLinearSize)
{
  Random random(zoo_mesh::seed());
  state_fixture::Options o;
  o.size = [](const Vec& p) { return 0.3 + 0.1 * p.x() + 0.07 * p.y(); };
  Adaptation_state s = make_state(shape_zoo::irregular(), o);
  s.size.sampling = core::Size_sampling::centre;
  EXPECT_GT(compare_derivatives(s, random, false), 50);
}

TEST(Node_relaxation, SizeGradientIsExactForLinearSizes)
{
  Random random(3);
  for(int i = 0; i < 50; ++i) {
    const core::Corners p = { Vec(random(-.2, .2), random(-.2, .2), 0),
                              Vec(1 + random(-.2, .2), random(-.2, .2), 0),
                              Vec(1 + random(-.2, .2), 1 + random(-.2, .2), 0),
                              Vec(random(-.2, .2), 1 + random(-.2, .2), 0) };
    const Vec g(random(-1, 1), random(-1, 1), 0);
    const Vec found =
        core::size_gradient(p, { 5 + g * p[0], 5 + g * p[1], 5 + g * p[2], 5 + g * p[3] });
    EXPECT_NEAR(core::distance(found, g), 0, 1e-12);
  }
}

// One move after the other, on all shapes, from tame and from wild starts.
TEST(Node_relaxation, NeverWorseNeverOffItsCarrier)
{
  const unsigned seed = zoo_mesh::seed();
  std::cout << "QUAD_MESH_SEED=" << seed << std::endl;
  Random random(seed);
  std::size_t moves = 0;
  for(Named_state& n : state_fixture::all_states())
    for(double share : { 0.1, 0.4 }) {
      SCOPED_TRACE(n.name + ", shaken by " + std::to_string(share));
      Adaptation_state s = n.state;
      shake(s, random, share);
      Node_relaxation relax(s);
      for(int sweep = 0; sweep < 3; ++sweep)
        for(Index v : s.mesh.vertices()) {
          Vertex_record& r = s.mesh.vertex(v);
          const Vertex_record old = r;
          core::gather_star(s, v, relax.star());
          const double before = relax.objective(r), worst = worst_corner(s, v);
          const bool moved = relax(r);
          if(!moved) {
            EXPECT_EQ(r.p, old.p);
            continue;
          }
          ++moves;
          EXPECT_FALSE(old.frozen || old.carrier == Carrier::corner) << "node " << v;
          EXPECT_LT(relax.objective(r), before) << "node " << v;
          if(worst > 0.01) {
            EXPECT_GT(worst_corner(s, v), 0) << "node " << v;
          }
          EXPECT_EQ(int(r.carrier), int(old.carrier));
          if(r.carrier == Carrier::curve) {
            EXPECT_EQ(r.curve, old.curve);
            EXPECT_EQ(r.p, s.curves[r.curve].point(r.param));
          } else {
            EXPECT_LT(s.surface.distance_to(r.p), 1e-9) << "node " << v;
          }
          EXPECT_EQ(r.h, s.size.at(r.p));
          if(HasFailure()) return;
        }
    }
  EXPECT_GT(moves, 1000u);
}

// The answer that takes few values of the size is that of all of them.
TEST(Node_relaxation, KeepsWithinSizeByItsDefinition)
{
  Random random(zoo_mesh::seed());
  int answers[2] = { 0, 0 }, allowed_above = 0;
  for(double h : { 0.7, 0.95, 1.2 }) {
    state_fixture::Options o;
    o.size = [h](const Vec& p) {
      return h * (1 + 0.2 * std::sin(3 * p.x()) * std::cos(2 * p.y()));
    };
    Adaptation_state s = make_state(shape_zoo::plate(8, 6), o);
    shake(s, random, 0.2);
    Node_relaxation relax(s);
    for(Index v = 0; v < s.mesh.vertex_end(); ++v)
      for(int i = 0; i < 5; ++i) {
        const Vertex_record old = s.mesh.vertex(v);
        core::gather_star(s, v, relax.star());
        if(i % 2)
          for(core::Star_face& f : relax.star()) f.face = -1; // as in a cavity
        Vertex_record r = old;
        r.p = old.p + Vec(random(-.2, .2), random(-.2, .2), 0);
        r.h = s.size.at(r.p);
        double before = 0, after = 0;
        for(const core::Star_face& f : relax.star()) {
          const core::Corners p = { old.p, f.q1, f.q2, f.q3 }, q = { r.p, f.q1, f.q2, f.q3 };
          before = (std::max)(before, core::mean_edge_length(p) / s.size.at_face(p));
          after = (std::max)(after, core::mean_edge_length(q) / s.size.at_face(q));
        }
        const bool keeps = after <= (std::max)(before, 1.);
        EXPECT_EQ(core::Node_relaxation_access::keeps_within_size(relax, r, old.p), keeps);
        ++answers[keeps];
        allowed_above += keeps && after > 1;
      }
  }
  EXPECT_GT(answers[0], 50);
  EXPECT_GT(answers[1], 50);
  EXPECT_GT(allowed_above, 20);
}

TEST(Smoothing, KeepsTheState)
{
  Random random(zoo_mesh::seed());
  for(Named_state& n : state_fixture::all_states()) {
    const state_checks::Snapshot before = state_checks::snapshot(n.state);
    shake(n.state, random, 0.2);
    const std::size_t inverted = state_checks::number_of_inverted(n.state);
    core::smooth(n.state, 8);
    EXPECT_VALID_STATE(n.state, before, false) << n.name;
    EXPECT_LE(state_checks::number_of_inverted(n.state), inverted) << n.name;
  }
}

// A shaken regular plate finds back to squares.
TEST(Smoothing, ShakenPlateBecomesRegular)
{
  Random random(11);
  Adaptation_state s = make_state(shape_zoo::plate(8, 6));
  shake(s, random, 0.35);
  core::smooth(s, 60);
  for(Index f = 0; f < s.mesh.face_end(); ++f) {
    const core::Corners p = s.corners(f);
    EXPECT_GT(mesh_checks::scaled_jacobian(p[0], p[1], p[2], p[3]), 0.99) << "face " << f;
    EXPECT_NEAR(core::mean_edge_length(p), 1, 0.02) << "face " << f;
  }
}

// Nodes gather where the size is small.
TEST(Smoothing, FollowsTheSize)
{
  state_fixture::Options o;
  o.size = [](const Vec& p) { return 0.6 + 0.15 * p.x(); };
  Adaptation_state s = make_state(shape_zoo::plate(8, 4), o);
  core::smooth(s, 60);
  double left = 0, right = 0;
  for(Index f = 0; f < s.mesh.face_end(); ++f) {
    const core::Corners p = s.corners(f);
    const double x = 0.25 * (p[0] + p[1] + p[2] + p[3]).x();
    (x < 4 ? left : right) += 1;
  }
  EXPECT_GT(left, right);
}
