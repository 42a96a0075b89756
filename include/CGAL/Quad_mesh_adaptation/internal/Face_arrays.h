// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_ARRAYS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_ARRAYS_H

#include <CGAL/Quad_mesh_adaptation/internal/mesh_arrays.h>
#include <CGAL/Quad_mesh_adaptation/internal/No_constraints.h>
#include <CGAL/Quad_mesh_adaptation/internal/boxes.h>
#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// A polygon mesh as arrays.  Half-edges are numbered face by face; half-edge h starts at
// origin[h], those of face f are first[f] to first[f + 1] - 1.  Vertices and faces are numbered in
// the order of the mesh.
struct Face_arrays
{
  std::vector<Vec> points;
  std::vector<Index> first, origin, face, opposite; // opposite is -1 at the border
  std::vector<char> is_constrained;                 // per half-edge

  Index number_of_faces() const { return Index(first.size()) - 1; }
  Index number_of_halfedges() const { return Index(origin.size()); }
  Index next(Index h) const { return h + 1 < first[face[h] + 1] ? h + 1 : first[face[h]]; }
  Index prev(Index h) const { return h > first[face[h]] ? h - 1 : first[face[h] + 1] - 1; }
  const Vec& source(Index h) const { return points[origin[h]]; }
  const Vec& target(Index h) const { return points[origin[next(h)]]; }

  // Half the sum of cross products about the centre: normal times area of a flat face.
  Vec area_vector(Index f) const
  {
    const Vec c = centre(f);
    Vec sum(0, 0, 0);
    for(Index h = first[f]; h < first[f + 1]; ++h)
      sum = sum + 0.5 * cross(source(h) - c, target(h) - c);
    return sum;
  }
  Vec centre(Index f) const
  {
    Vec sum(0, 0, 0);
    for(Index h = first[f]; h < first[f + 1]; ++h) sum = sum + source(h);
    return sum / double(first[f + 1] - first[f]);
  }
  double area() const
  {
    double sum = 0;
    for(Index f = 0; f < number_of_faces(); ++f) sum += norm(area_vector(f));
    return sum;
  }
  // Of the box around all points.
  double diagonal() const { return norm(Box(points).extent()); }
};

// Throws std::invalid_argument, in the name of `who`, for a mesh without faces or a coordinate that
// is not finite.
template <class PolygonMesh, class VertexPointMap, class EdgeConstrainedMap>
Face_arrays face_arrays(const PolygonMesh& mesh, const VertexPointMap& point_map,
                        const EdgeConstrainedMap& constrained, const std::string& who)
{
  using Traits = boost::graph_traits<PolygonMesh>;
  Face_arrays a;
  auto vertex_number = get(CGAL::dynamic_vertex_property_t<Index>(), mesh);
  auto halfedge_number = get(CGAL::dynamic_halfedge_property_t<Index>(), mesh);
  for(typename Traits::vertex_descriptor v : vertices(mesh)) {
    put(vertex_number, v, Index(a.points.size()));
    a.points.push_back(to_vec(get(point_map, v)));
    if(!is_finite(a.points.back()))
      throw std::invalid_argument(who + ": a coordinate is not finite");
  }
  for(typename Traits::halfedge_descriptor h : halfedges(mesh)) put(halfedge_number, h, -1);
  a.first.push_back(0);
  for(typename Traits::face_descriptor f : faces(mesh)) {
    for(typename Traits::halfedge_descriptor h : halfedges_around_face(halfedge(f, mesh), mesh)) {
      put(halfedge_number, h, a.number_of_halfedges());
      a.origin.push_back(get(vertex_number, source(h, mesh)));
      a.face.push_back(Index(a.first.size()) - 1);
      a.is_constrained.push_back(get(constrained, edge(h, mesh)));
    }
    a.first.push_back(a.number_of_halfedges());
  }
  if(a.number_of_faces() == 0) throw std::invalid_argument(who + ": the mesh has no faces");
  for(typename Traits::face_descriptor f : faces(mesh))
    for(typename Traits::halfedge_descriptor h : halfedges_around_face(halfedge(f, mesh), mesh))
      a.opposite.push_back(get(halfedge_number, opposite(h, mesh)));
  return a;
}

// The same by the parameters `vertex_point_map` and `edge_is_constrained_map`.
template <class PolygonMesh, class NP>
Face_arrays face_arrays(const PolygonMesh& mesh, const NP& np, const std::string& who)
{
  using Edge = typename boost::graph_traits<PolygonMesh>::edge_descriptor;
  return face_arrays(
      mesh, vertex_points(mesh, np),
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::edge_is_constrained),
                                   No_constraints<Edge>()),
      who);
}

// The half-edges that leave the origin of h, from feature edge to feature edge or all around.
inline std::vector<Index> fan_of(const Face_arrays& mesh, const std::vector<char>& is_feature,
                                 Index h)
{
  std::vector<Index> list = { h };
  for(Index g = h; !is_feature[mesh.prev(g)];) {
    g = mesh.opposite[mesh.prev(g)];
    if(g == h) return list;
    list.push_back(g);
  }
  for(Index g = h; !is_feature[g];) {
    g = mesh.next(mesh.opposite[g]);
    list.push_back(g);
  }
  return list;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_ARRAYS_H
