// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_TEST_SHAPE_ZOO_H
#define QUAD_MESH_ADAPTATION_TEST_SHAPE_ZOO_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

// Small quad meshes of all kinds of shape, as points and counter-clockwise quads; closed surfaces
// are oriented outwards.
namespace shape_zoo {

using CGAL::Quad_mesh_adaptation::internal::Index;
using CGAL::Quad_mesh_adaptation::internal::Quad;
using CGAL::Quad_mesh_adaptation::internal::Vec;

struct Shape
{
  std::string name;
  std::vector<Vec> points;
  std::vector<Quad> quads;
};

/// n x m grid whose point (i, j), 0 <= i <= n, 0 <= j <= m, is `at(i, j)`; the last column and row
/// are the first again when the grid is closed in that direction.
Shape grid(std::string name, Index n, Index m, const std::function<Vec(Index, Index)>& at,
           bool closed_i = false, bool closed_j = false);

/// Rectangle of n x m faces of side 1.
Shape plate(Index n = 6, Index m = 4);

/// z = x^2 - y^2 over the square of side 2.
Shape saddle(Index n = 6);

inline constexpr double pi = 3.14159265358979323846;

/// Flat ring between the radii 1 and 2.
Shape annulus(Index around = 16, Index across = 3);

/// Side of a cylinder of radius 1 and height 2.
Shape open_cylinder(Index around = 12, Index along = 4);

/// Radii 2 and 1.
Shape torus(Index around = 16, Index tube = 10);

/// Appends `b` to `a`, points at the same place (to 1e-9) becoming one when `glue` is set.
void append(Shape& a, const Shape& b, bool glue);

/// Square of 2n x 2n faces without its upper right quarter: a re-entrant corner at the origin.
Shape l_shape(Index n = 3);

/// Disk of radius 1: a square of n x n faces in the middle, `rings` rings around it.
Shape disk(Index n = 4, Index rings = 3);

/// Surface of a set of unit cells: any genus.  `size` cells per axis, `is_inside` tells which.
/// Cells that meet only along an edge or at a corner make a surface that is not a manifold.
Shape voxels(std::string name, std::array<Index, 3> size,
             const std::function<bool(Index, Index, Index)>& is_inside);

/// n x n faces on each side, each of side 1.
Shape cube(Index n = 3);

/// Unit sphere: the cube's sides, at equal angles.
Shape sphere(Index n = 4);

/// A slab with `genus` square tunnels; a wall between two tunnels is `wall` cells thick.
Shape slab_with_tunnels(Index genus = 2, Index wall = 1);

/// Irregular everywhere: a shaken grid of n x n squares, each cut along a diagonal at random.
Shape irregular(Index n = 5, unsigned seed = 1);

/// Interior vertices of every valence from 3 to 8, of valence 2 as well when asked for.
Shape valences(bool with_doublet = false);

/// A plate and, above it, a cube.
Shape two_components();

/// All of the above that are valid input: manifold, oriented, without doublet.
std::vector<Shape> all();

} // namespace shape_zoo

#endif // QUAD_MESH_ADAPTATION_TEST_SHAPE_ZOO_H
