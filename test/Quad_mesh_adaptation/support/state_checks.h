// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_TEST_STATE_CHECKS_H
#define QUAD_MESH_ADAPTATION_TEST_STATE_CHECKS_H

#include "mesh_checks.h"
#include "state_fixture.h"

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Everything that must stay true at every commit of an operation.
namespace state_checks {

namespace core = CGAL::Quad_mesh_adaptation::internal;
using core::Adaptation_state;
using core::Carrier;
using core::Index;
using core::Quad;
using core::Quad_complex;
using core::Vec;

using Edge = std::pair<Index, Index>; // lower end first

std::string name(const char* kind, Index i);

// --- the half-edge structure agrees with itself

std::string halfedge_problem(const Quad_complex& m);

// --- topology

struct Component
{
  long euler = 0, loops = 0, faces = 0;
  bool operator<(const Component& o) const
  {
    return euler != o.euler ? euler < o.euler : loops < o.loops;
  }
  bool operator==(const Component& o) const { return euler == o.euler && loops == o.loops; }
};

std::vector<Quad> quads_of(const Quad_complex& m, std::vector<Vec>& points);

std::size_t number_of_inverted(const Adaptation_state& s);

// --- what to compare with

struct Snapshot
{
  std::vector<Component> components;
  std::vector<std::pair<Index, Vec>> fixed; // corners and frozen vertices, where they are
  std::set<Index> doublets;                 // interior vertices with two faces
  std::set<Edge> frozen_edges;
  std::size_t curves = 0, inverted = 0;
};

Snapshot snapshot(const Adaptation_state& s);

// --- all of it

std::string cache_problem(const Adaptation_state& s);

/// The first breach, or nothing.
std::string problem_of(const Adaptation_state& s, const Snapshot& before, bool check_shape);

} // namespace state_checks

/// \a check_shape: also that no more faces are inverted than before.
#define EXPECT_VALID_STATE(state, before, check_shape)                                             \
  EXPECT_EQ(state_checks::problem_of(state, before, check_shape), "")

#endif // QUAD_MESH_ADAPTATION_TEST_STATE_CHECKS_H
