// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_TEST_FEATURE_CHECKS_H
#define QUAD_MESH_ADAPTATION_TEST_FEATURE_CHECKS_H

#include "shape_zoo.h"

#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

// Features of a mesh whose faces have patch numbers, found without the package: the curves are the
// edges on the border and between patches.
namespace feature_checks {

using shape_zoo::Index;
using shape_zoo::Quad;
using shape_zoo::Shape;
using shape_zoo::Vec;

using Edge = std::pair<Index, Index>;

/// Where two patches meet.
struct Seam
{
  std::size_t edges = 0;
  double length = 0;
};

struct Features
{
  std::vector<Edge> edges;
  std::set<Edge> neighbours;  // patches that share an edge; -1 is the outside
  std::vector<Index> corners; // vertices where other than two of the edges meet
  double length = 0;          // of the edges
  std::map<Edge, Seam> seams; // by the two patches
};

double norm(const Vec& v);

/// Patches of faces that no edge parts across which the normals differ by more than `angle`
/// degrees.
std::vector<int> patches(const Shape& s, double angle);

Features features(const Shape& s, const std::vector<int>& patch);

/// Largest distance from the nodes of the curves of one mesh to the edges of those of another.
double nodes_off_curves(const Shape& s, const Features& f, const Shape& of, const Features& curves);

double distance_to_triangle(const Vec& p, const Vec& a, const Vec& b, const Vec& c);

/// Distances to the quads of a mesh, cut in two either way.
struct Quad_distances
{
  explicit Quad_distances(const Shape& s);
  /// The lesser of `least` and the distance from p to face f; a ball about the face often tells.
  double lesser(double least, const Vec& p, Index f) const;

  const Shape& s;
  std::vector<std::pair<Vec, double>> balls;
};

/// Largest distance from a node of a face to the triangles (of quads cut in two, either way) of the
/// same patch of another mesh: a node on a wrong sheet is far from those of its own.
double nodes_off_patches(const Shape& s, const std::vector<int>& patch, const Shape& of,
                         const std::vector<int>& of_patch);

double size_of(const Shape& s);

} // namespace feature_checks

#endif // QUAD_MESH_ADAPTATION_TEST_FEATURE_CHECKS_H
