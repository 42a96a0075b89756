// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_POSITIONS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_POSITIONS_H

#include <CGAL/Quad_mesh_adaptation/Poor_face.h>
#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

template <typename Vertex, typename QuadMesh>
long position_of(const Vertex& wanted, const QuadMesh& mesh)
{
  long position = 0;
  for(const auto& v : vertices(mesh)) {
    if(v == wanted) return position;
    ++position;
  }
  return -1;
}

// Where the faces and vertices of the state stand in the iteration over the caller's mesh.
template <typename Export, typename QuadMesh>
class Positions
{
public:
  Positions(const Export& written, const QuadMesh& mesh) : written_(written), mesh_(mesh) {}

  std::vector<std::size_t> of_faces(const std::vector<Index>& faces_of_state)
  {
    std::vector<std::size_t> list;
    for(Index f : faces_of_state) list.push_back(of_face(f));
    std::sort(list.begin(), list.end());
    return list;
  }

  std::size_t of_face(Index f)
  {
    if(!are_faces_known_) find_faces();
    return get(of_face_, written_.face_of(f));
  }

  std::size_t of_vertex(Index v)
  {
    if(!are_vertices_known_) find_vertices();
    return get(of_vertex_, written_.vertex_of(v));
  }

private:
  void find_faces()
  {
    of_face_ = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh_);
    std::size_t position = 0;
    for(auto f : faces(mesh_)) put(of_face_, f, position++);
    are_faces_known_ = true;
  }

  void find_vertices()
  {
    of_vertex_ = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh_);
    std::size_t position = 0;
    for(auto v : vertices(mesh_)) put(of_vertex_, v, position++);
    are_vertices_known_ = true;
  }

  const Export& written_;
  const QuadMesh& mesh_;
  typename boost::property_map<QuadMesh, CGAL::dynamic_face_property_t<std::size_t>>::const_type
      of_face_;
  typename boost::property_map<QuadMesh, CGAL::dynamic_vertex_property_t<std::size_t>>::const_type
      of_vertex_;
  bool are_faces_known_ = false, are_vertices_known_ = false; // found only if asked for
};

// The poor faces with the numbers of the caller's mesh instead of the state's.
template <typename Export, typename QuadMesh>
std::vector<Poor_face> numbered(std::vector<Poor_face> poor, Positions<Export, QuadMesh>& positions)
{
  for(Poor_face& p : poor) {
    p.face = positions.of_face(Index(p.face));
    if(p.limit == Shape_limit::feature_angle) p.vertex = positions.of_vertex(Index(p.vertex));
  }
  std::sort(poor.begin(), poor.end(),
            [](const Poor_face& a, const Poor_face& b) { return a.face < b.face; });
  return poor;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_POSITIONS_H
