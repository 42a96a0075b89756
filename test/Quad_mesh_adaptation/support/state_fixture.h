// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_TEST_STATE_FIXTURE_H
#define QUAD_MESH_ADAPTATION_TEST_STATE_FIXTURE_H

#include "shape_zoo.h"
#include "zoo_mesh.h"

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/Input_mesh.h>

#include <cstddef>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

// States of the core made from shapes of the zoo.
namespace state_fixture {

namespace core = CGAL::Quad_mesh_adaptation::internal;
using core::Adaptation_state;
using core::Carrier;
using core::Index;
using core::Quad_complex;
using core::Vec;
using shape_zoo::Shape;

struct Options
{
  double feature_angle = 40;
  std::function<double(const Vec&)> size; // default: the mean edge length of the shape
  std::set<std::pair<Index, Index>> constrained, frozen; // edges by their ends, lower one first
  std::set<Index> frozen_vertices;
};

core::Input_mesh input_of(const Shape& shape, const Options& o);

Adaptation_state make_state(const Shape& shape, const Options& o = Options());

/// Inner nodes without four faces.
std::size_t irregular_nodes(const Adaptation_state& s);

// States that together show all kinds of carriers: the zoo, creases inside a surface, frozen
// borders and vertices.
struct Named_state
{
  std::string name;
  Adaptation_state state;
};

Options with_crease(const Shape& shape);

std::vector<Named_state> all_states();

} // namespace state_fixture

#endif // QUAD_MESH_ADAPTATION_TEST_STATE_FIXTURE_H
