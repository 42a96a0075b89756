// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_TEST_PLACES_H
#define QUAD_MESH_ADAPTATION_TEST_PLACES_H

#include "state_checks.h"

#include <CGAL/Quad_mesh_adaptation/internal/Cavity.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

// All operators behind one type: where each may be applied, and what its comment promises.
namespace places {

namespace core = CGAL::Quad_mesh_adaptation::internal;
using core::Adaptation_state;
using core::Cavity;
using core::Index;
using core::Quad_complex;

struct Place
{
  std::string name;
  std::function<void(Adaptation_state&, Cavity&)> describe;
  long faces = 0, vertices = 0, border_edges = 0; // promised changes
  std::map<Index, int> corners; // vertex that stays -> promised change of its number of faces
};

void add_closes(const Adaptation_state& s, std::vector<Place>& list);

void add_opens(const Adaptation_state& s, std::vector<Place>& list);

void add_swaps(const Adaptation_state& s, std::vector<Place>& list);

void add_corner_splits(const Adaptation_state& s, std::vector<Place>& list);

void add_insertions(const Adaptation_state& s, std::vector<Place>& list);

void add_rotations(const Adaptation_state& s, std::vector<Place>& list);

void add_border_pairs(const Adaptation_state& s, std::vector<Place>& list);

void add_crease_collapses(const Adaptation_state& s, std::vector<Place>& list);

void add_chords(const Adaptation_state& s, std::vector<Place>& list);

// Rings about every face and about rows of two and four faces.
void add_rings(const Adaptation_state& s, std::vector<Place>& list);

std::vector<Place> all_places(const Adaptation_state& s);

} // namespace places

#endif // QUAD_MESH_ADAPTATION_TEST_PLACES_H
