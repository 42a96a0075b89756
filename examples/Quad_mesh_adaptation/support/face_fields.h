// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_EXAMPLES_FACE_FIELDS_H
#define QUAD_MESH_ADAPTATION_EXAMPLES_FACE_FIELDS_H

#include <CGAL/Quad_mesh_adaptation/IO/write_quad_mesh.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>

/// Size ratio (mean edge length by the size at the centre, eq. 3 of Anderson, Benzley and Owen)
/// and scaled Jacobian (Verdict: the smallest corner's) of every face, and the size asked at every
/// vertex, to be written with a mesh of quads.
template <class QuadMesh, class SizingFunction>
CGAL::Quad_mesh_adaptation::Mesh_fields size_and_quality_fields(const QuadMesh& mesh,
                                                                const SizingFunction& size)
{
  const auto points = get(CGAL::vertex_point, mesh);
  using Point = typename boost::property_traits<std::decay_t<decltype(points)>>::value_type;
  using Vector = typename CGAL::Kernel_traits<Point>::Kernel::Vector_3;
  CGAL::Quad_mesh_adaptation::Mesh_fields fields;
  fields.face = { { "size_ratio", {} }, { "scaled_jacobian", {} } };
  fields.vertex = { { "size", {} } };
  for(const auto v : vertices(mesh)) fields.vertex[0].values.push_back(size(get(points, v)));

  for(const auto f : faces(mesh)) {
    std::array<Point, 4> corner;
    std::size_t n = 0;
    for(const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      corner[n++ % 4] = get(points, v);
    std::array<Vector, 4> edge;
    std::array<double, 4> length;
    for(std::size_t i = 0; i < 4; ++i) {
      edge[i] = corner[(i + 1) % 4] - corner[i];
      length[i] = std::sqrt(CGAL::to_double(edge[i].squared_length()));
    }
    const Point centre = CGAL::centroid(corner[0], corner[1], corner[2], corner[3]);
    fields.face[0].values.push_back((length[0] + length[1] + length[2] + length[3]) / 4 /
                                    size(centre));
    // the normal at the centre, that of the bilinear patch
    const Vector normal = CGAL::cross_product(edge[0] - edge[2], edge[1] - edge[3]);
    const double norm = std::sqrt(CGAL::to_double(normal.squared_length()));
    double jacobian = norm > 0 ? 1 : 0;
    for(std::size_t i = 0; i < 4 && norm > 0; ++i) {
      const std::size_t before = (i + 3) % 4;
      const double volume = CGAL::to_double(CGAL::cross_product(edge[before], edge[i]) * normal);
      jacobian = (std::min)(jacobian, volume / norm / (length[before] * length[i]));
    }
    fields.face[1].values.push_back(jacobian);
  }
  return fields;
}

#endif // QUAD_MESH_ADAPTATION_EXAMPLES_FACE_FIELDS_H
