// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_TEST_MORE_SHAPES_H
#define QUAD_MESH_ADAPTATION_TEST_MORE_SHAPES_H

#include "shape_zoo.h"

// Shapes for the tests of features, of close sheets and of true geometry.
namespace more_shapes {

using namespace shape_zoo;

Shape moved(Shape s, const Vec& by);

/// Closed cylinder of radius 1 and height 2 with flat ends, 4 n faces around; n is even.
Shape closed_cylinder(Index n);

/// The same with a top of a fifth of the width.
Shape truncated_cone(Index n);

/// Dome on a flat disk that meet in a sharp rim of 4 n edges; n is even.  The meshes of both have
/// different patterns, so that hardly any chord is a whole row.
Shape dome(Index n);

/// z = 2 r^2 over the unit disk: about the paper's nosecone.
Shape paraboloid(Index n);

/// Two slopes that meet in a sharp ridge over the curve y = ridge_at(x), 0 <= x <= 6.
double ridge_at(double x);

Shape ridge(Index n);

/// Two plates of side 8 back to back, `gap` apart, the upper one at z = 0 looking up.
Shape two_sheets(double gap);

/// Unit spheres about the origin and at x = 2 + gap.
Shape two_spheres(Index n, double gap);

/// Box of 8 x 8 x thickness, one face through the thickness.
Shape thin_box(double thickness);

/// L-shaped bracket, 4 x 4 x 4 outside and 2 thick, with a square hole through its foot.
Shape bracket();

} // namespace more_shapes

#endif // QUAD_MESH_ADAPTATION_TEST_MORE_SHAPES_H
