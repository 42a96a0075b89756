// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_TEST_GROWTH_SHAPES_H
#define QUAD_MESH_ADAPTATION_TEST_GROWTH_SHAPES_H

#include "shape_zoo.h"

#include <cmath>
#include <vector>

// Shapes of any number of faces, each of which would show an algorithm that is quadratic in the
// length of something: a row, an umbrella, a chord, a list of components.
namespace growth_shapes {

using namespace shape_zoo;

/// n faces of side 1 in one row.
inline Shape strip(Index n)
{
  Shape s = plate(n, 1);
  s.name = "strip";
  return s;
}

/// n quads about the centre of a disk of radius 1, one node of valence n.
inline Shape fan(Index n)
{
  Shape s{ "fan", { Vec(0, 0, 0) }, {} };
  for(Index i = 0; i < 2 * n; ++i)
    s.points.emplace_back(std::cos(pi * i / n), std::sin(pi * i / n), 0);
  for(Index i = 0; i < n; ++i)
    s.quads.push_back({ 0, 2 * i + 1, 2 * i + 2, (2 * i + 2) % (2 * n) + 1 });
  return s;
}

/// A strip of n faces of side about 1 wound up to a screw line on a cylinder, `around` faces to a
/// turn: the chord along it crosses every face and has itself as neighbour on both sides.
inline Shape screw(Index n, Index around)
{
  Shape s{ "screw", {}, {} };
  const double radius = around / (2 * pi);
  for(Index k = 0; k <= n + around; ++k) {
    const double a = 2 * pi * k / around;
    s.points.emplace_back(radius * std::cos(a), radius * std::sin(a), double(k) / around);
  }
  for(Index k = 0; k < n; ++k) s.quads.push_back({ k, k + 1, k + 1 + around, k + around });
  return s;
}

/// side x side separate plates of 2 x 2 faces of side 1.
inline Shape archipelago(Index side)
{
  Shape s{ "archipelago", {}, {} };
  for(Index y = 0; y < side; ++y)
    for(Index x = 0; x < side; ++x)
      append(s, grid("", 2, 2, [=](Index i, Index j) { return Vec(3 * x + i, 3 * y + j, 0); }),
             false);
  return s;
}

} // namespace growth_shapes

#endif // QUAD_MESH_ADAPTATION_TEST_GROWTH_SHAPES_H
