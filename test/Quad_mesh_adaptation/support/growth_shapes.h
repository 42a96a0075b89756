// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_TEST_GROWTH_SHAPES_H
#define QUAD_MESH_ADAPTATION_TEST_GROWTH_SHAPES_H

#include "shape_zoo.h"

// Shapes of any number of faces, each of which would show an algorithm that is quadratic in the
// length of something: a row, an umbrella, a chord, a list of components.
namespace growth_shapes {

using namespace shape_zoo;

/// n faces of side 1 in one row.
Shape strip(Index n);

/// n quads about the centre of a disk of radius 1, one node of valence n.
Shape fan(Index n);

/// Half of it: n quads about a node of the border.
Shape half_fan(Index n);

/// Two cones of n kites each that meet in a circle of 2 n nodes; spokes of both lead to it by
/// turns.
Shape kites(Index n);

/// n quads from one pole of a sphere to the other, which share all of their edges: two nodes of
/// valence n, and n doublets between them.
inline Shape slices(Index n)
{
  Shape s{ "slices", { Vec(0, 0, 1), Vec(0, 0, -1) }, {} };
  for(Index i = 0; i < n; ++i)
    s.points.emplace_back(std::cos(2 * pi * i / n), std::sin(2 * pi * i / n), 0);
  for(Index i = 0; i < n; ++i) s.quads.push_back({ 0, 2 + i, 1, 2 + (i + 1) % n });
  return s;
}

/// A fan of n quads with `rings` rings of 2 n quads about it; point j of each ray is `at(j,
/// angle)`.
template <typename Place>
Shape polar(Index n, Index rings, const Vec& centre, const Place& at)
{
  Shape s{ "polar", { centre }, {} };
  const auto id = [n](Index i, Index j) { return 1 + 2 * n * j + i % (2 * n); };
  for(Index j = 0; j <= rings; ++j)
    for(Index i = 0; i < 2 * n; ++i) s.points.push_back(at(j, pi * i / n));
  for(Index i = 0; i < 2 * n; i += 2)
    s.quads.push_back({ 0, id(i, 0), id(i + 1, 0), id(i + 2, 0) });
  for(Index j = 0; j < rings; ++j)
    for(Index i = 0; i < 2 * n; ++i)
      s.quads.push_back({ id(i, j), id(i, j + 1), id(i + 1, j + 1), id(i + 1, j) });
  return s;
}

/// Disk of this kind.
Shape polar_disk(Index n, Index rings);

/// Sphere of this kind, with a second fan opposite the first.
Shape polar_sphere(Index n, Index rings);

/// A can of radius 1 with a fan of n quads at each end, whose spokes meet the 2 n columns of faces
/// between them by turns.
inline Shape can(Index n, Index rings)
{
  Shape s = polar(n, rings, Vec(0, 0, 1), [rings](Index j, double a) {
    return Vec(std::cos(a), std::sin(a), 1 - double(j) / rings);
  });
  s.name = "can";
  const Index centre = Index(s.points.size()), last = 1 + 2 * n * rings;
  s.points.emplace_back(0, 0, 0);
  for(Index i = 1; i < 2 * n; i += 2)
    s.quads.push_back({ centre, last + (i + 2) % (2 * n), last + (i + 1) % (2 * n), last + i });
  return s;
}

/// A strip of n faces of side about 1 wound up to a screw line on a cylinder, `around` faces to a
/// turn: the chord along it crosses every face and has itself as neighbour on both sides.
Shape screw(Index n, Index around);

/// side x side separate plates of 2 x 2 faces of side 1.
Shape archipelago(Index side);

} // namespace growth_shapes

#endif // QUAD_MESH_ADAPTATION_TEST_GROWTH_SHAPES_H
