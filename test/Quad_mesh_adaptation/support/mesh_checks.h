// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_TEST_MESH_CHECKS_H
#define QUAD_MESH_ADAPTATION_TEST_MESH_CHECKS_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <cstddef>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

// An independent judge of points and quads: it shares no code with the package but the names of the
// types.
namespace mesh_checks {

using CGAL::Quad_mesh_adaptation::internal::Index;
using CGAL::Quad_mesh_adaptation::internal::Quad;
using CGAL::Quad_mesh_adaptation::internal::Vec;

struct Facts
{
  std::string
      problem; ///< the first breach of "an oriented manifold of quads"; empty when there is none
  std::size_t vertices = 0, edges = 0, faces = 0;
  std::size_t components = 0, boundary_edges = 0, boundary_loops = 0;
  long euler_characteristic = 0;
  std::size_t doublets = 0;                    ///< interior vertices of valence 2
  std::map<std::size_t, std::size_t> valences; ///< of interior vertices -> how many
  double min_scaled_jacobian = 0, area = 0;
};

/// Scaled Jacobian of a quad, at its worst corner, against the cross product of its mid-lines.
double scaled_jacobian(const Vec& a, const Vec& b, const Vec& c, const Vec& d);

/// Half of the absolute cross product of the diagonals.
double area(const Vec& a, const Vec& b, const Vec& c, const Vec& d);

using Directed_edges = std::map<std::pair<Index, Index>, std::size_t>; // -> face on its left

struct Sets
{
  std::vector<Index> parent;
  explicit Sets(std::size_t n) : parent(n) { std::iota(parent.begin(), parent.end(), 0); }
  Index find(Index i) { return parent[i] == i ? i : parent[i] = find(parent[i]); }
  std::size_t count(const std::vector<char>& members)
  {
    std::size_t n = 0;
    for(std::size_t i = 0; i < parent.size(); ++i) n += members[i] && find(Index(i)) == Index(i);
    return n;
  }
};

/// Everything there is to say; counts are only filled when there is no `problem`.
Facts facts_of(const std::vector<Vec>& points, const std::vector<Quad>& quads);

/// The same surface as far as topology goes.
bool same_topology(const Facts& a, const Facts& b);

} // namespace mesh_checks

#endif // QUAD_MESH_ADAPTATION_TEST_MESH_CHECKS_H
