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
    if(!are_known_) find();
    return get(position_, written_.face_of(f));
  }

private:
  void find()
  {
    position_ = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh_);
    std::size_t position = 0;
    for(auto f : faces(mesh_)) put(position_, f, position++);
    are_known_ = true;
  }

  const Export& written_;
  const QuadMesh& mesh_;
  typename boost::property_map<QuadMesh, CGAL::dynamic_face_property_t<std::size_t>>::const_type
      position_;
  bool are_known_ = false; // found only if asked for
};

// The poor faces with the numbers of the caller's mesh instead of the state's.
template <typename Export, typename QuadMesh>
std::vector<Poor_face> numbered(std::vector<Poor_face> poor, const Export& written,
                                const QuadMesh& mesh, Positions<Export, QuadMesh>& positions)
{
  for(Poor_face& p : poor) {
    p.face = positions.of_face(Index(p.face));
    if(p.limit == Shape_limit::feature_angle)
      p.vertex = std::size_t(position_of(written.vertex_of(Index(p.vertex)), mesh));
  }
  std::sort(poor.begin(), poor.end(),
            [](const Poor_face& a, const Poor_face& b) { return a.face < b.face; });
  return poor;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_POSITIONS_H
