// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_SIZES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_SIZES_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The corners next to the Gauss points, in their order.
constexpr std::array<std::size_t, 4> gauss_corners = { 2, 1, 3, 0 };

// The 2 x 2 Gauss points of the bilinear face.
inline std::array<Vec, 4> gauss_points(const Corners& p)
{
  const double g = 0.5 / std::sqrt(3.);
  const Vec c = face_centre(p);
  const Vec u = 0.5 * g * (p[1] + p[2] - p[0] - p[3]); // half steps along the two directions
  const Vec v = 0.5 * g * (p[2] + p[3] - p[0] - p[1]);
  const Vec w = g * g * (p[0] - p[1] + p[2] - p[3]);
  return { c + u + v + w, c + u - v - w, c - u + v - w, c - u - v + w };
}

// The sizes that a face is judged by.
struct Face_sizes
{
  double at_centre;
  std::array<double, 4> at_gauss; // in the order of the points

  // The size it must meet wherever its centre lies, where all are `scale` times larger: the smaller
  // of the one at the centre and the inverse root mean square of the others.
  double strict(double scale = 1) const
  {
    double sum = 0;
    for(double h : at_gauss) sum += 1 / ((scale * h) * (scale * h));
    return (std::min)(scale * at_centre, 2 / std::sqrt(sum));
  }
};

template <typename Size>
Face_sizes sizes_of_face(const Corners& p, const Size& size)
{
  Face_sizes x;
  x.at_centre = size(face_centre(p));
  const std::array<Vec, 4> points = gauss_points(p);
  for(std::size_t k = 0; k < points.size(); ++k) x.at_gauss[k] = size(points[k]);
  return x;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_SIZES_H
