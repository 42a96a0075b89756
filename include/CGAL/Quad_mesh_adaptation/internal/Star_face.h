// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_STAR_FACE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_STAR_FACE_H

#include <CGAL/Quad_mesh_adaptation/internal/Witness.h>
#include <CGAL/Quad_mesh_adaptation/internal/face_energy.h>
#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// A face as seen from one of its corners, the node that moves, with what does not move with it.
struct Star_face
{
  Index face = -1;      // its number; -1: it is not in the mesh as it is here
  Vec q1, q2, q3;       // the other corners, counter-clockwise
  Facing reference;     // where the face should look, without the share of the node
  Vec grad_h;           // of the size, along the face; for the derivative only
  double floor = 0;     // of the wanted size, see Vertex_record
  double factor = 0.25; // wanted size of the face over the sum of the sizes at its corners
  double sizes = 0;     // sum of the sizes at the other corners

  Vec e1, e3, cross2;    // from q1 to q2, from q3 to q2, edge vectors at q2 multiplied
  double n1 = 0, n3 = 0; // squared lengths of e1 and e3
  double l = 0;          // sum of their lengths

  void set_corners(const Vec& a, const Vec& b, const Vec& c)
  {
    q1 = a;
    q2 = b;
    q3 = c;
    e1 = b - a;
    e3 = b - c;
    cross2 = cross(e3, e1);
    n1 = e1 * e1;
    n3 = e3 * e3;
    l = std::sqrt(n1) + std::sqrt(n3);
  }

  // Wanted size with size h at the node.
  double target(double h) const { return (std::max)(factor * (sizes + h), floor); }
};

// A witness of the reference surface on a face of the star, which pulls that face towards itself.
struct Pull
{
  const Witness* witness;
  int face;       // number in the star
  bool from_node; // is the face cut in two from the node?  Else between its neighbours.
};

// Value, gradient and Hessian in the (at most two) directions a node may move in.
struct Local_model
{
  double g[2] = { 0, 0 };
  double H[3] = { 0, 0, 0 }; // xx, xy, yy
};

// Gradient of the size along a face from its values at the corners (least squares on the
// diagonals); zero where it is constant.
inline Vec size_gradient(const Corners& p, const std::array<double, 4>& h)
{
  const Vec d1 = p[2] - p[0], d2 = p[3] - p[1];
  const double h1 = h[2] - h[0], h2 = h[3] - h[1];
  if(h1 == 0 && h2 == 0) return Vec(0, 0, 0);
  const double a = d1 * d1, b = d1 * d2, c = d2 * d2, det = a * c - b * b;
  if(!(det > 1e-6 * a * c)) return Vec(0, 0, 0);
  return ((c * h1 - b * h2) / det) * d1 + ((a * h2 - b * h1) / det) * d2;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_STAR_FACE_H
