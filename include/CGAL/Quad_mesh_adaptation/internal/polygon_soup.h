// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_POLYGON_SOUP_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_POLYGON_SOUP_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>
#include <CGAL/Quad_mesh_adaptation/internal/mesh_arrays.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Points and faces without adjacency: what a file holds, and what is written or drawn.
struct Polygon_soup
{
  using Face = std::vector<Index>;

  std::vector<Vec> points;
  std::vector<Face> faces;
};

// The vertices and faces of a mesh in its order of iteration.
template <class Mesh>
Polygon_soup soup_of_mesh(const Mesh& mesh)
{
  Polygon_soup soup;
  soup.points = points_and_faces(mesh, get(CGAL::vertex_point, mesh),
                                 [&](const auto& face) { soup.faces.push_back(face); });
  return soup;
}

inline Vec centre_of_face(const Polygon_soup& soup, const Polygon_soup::Face& face)
{
  Vec sum(0, 0, 0);
  for(const Index v : face) sum = sum + soup.points[v];
  return sum / double(face.size());
}

// Sum of the cross products of a polygon's corners about its first one: twice the area that it
// encloses, along its mean normal (Newell); exact also for warped polygons.
inline Vec twice_vector_area(const Polygon_soup& soup, const Polygon_soup::Face& face)
{
  Vec sum(0, 0, 0);
  const Vec origin = soup.points[face[0]];
  for(std::size_t i = 1; i + 1 < face.size(); ++i)
    sum = sum + cross(soup.points[face[i]] - origin, soup.points[face[i + 1]] - origin);
  return sum;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_POLYGON_SOUP_H
