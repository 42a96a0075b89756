// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_IO_READ_QUAD_MESH_H
#define CGAL_QUAD_MESH_ADAPTATION_IO_READ_QUAD_MESH_H

#include <CGAL/Quad_mesh_adaptation/IO/Mesh_fields.h>
#include <CGAL/Quad_mesh_adaptation/IO/Read_result.h>
#include <CGAL/Quad_mesh_adaptation/internal/file_calls.h>
#include <CGAL/Quad_mesh_adaptation/internal/polygon_soup.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstddef>
#include <exception>
#include <new>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Precondition: `check_soup()` accepted the soup.  `false` when the mesh type could not take it.
template <class Mesh>
bool fill_mesh(const Polygon_soup& soup, Mesh& mesh)
{
  const auto point_map = get(CGAL::vertex_point, mesh);
  using Point = typename boost::property_traits<std::decay_t<decltype(point_map)>>::value_type;
  using Traits = boost::graph_traits<Mesh>;
  CGAL::clear(mesh);
  reserve(mesh, static_cast<typename Traits::vertices_size_type>(soup.points.size()),
          static_cast<typename Traits::edges_size_type>(2 * soup.faces.size()),
          static_cast<typename Traits::faces_size_type>(soup.faces.size()));
  std::vector<typename Traits::vertex_descriptor> vertices;
  vertices.reserve(soup.points.size());
  for(const Vec& p : soup.points) {
    vertices.push_back(add_vertex(mesh));
    put(point_map, vertices.back(), Point(p.x(), p.y(), p.z()));
  }
  std::vector<typename Traits::vertex_descriptor> corners;
  for(const Polygon_soup::Face& face : soup.faces) {
    corners.clear();
    for(const Index v : face) corners.push_back(vertices[v]);
    if(CGAL::Euler::add_face(corners, mesh) == Traits::null_face()) return false;
  }
  return true;
}

template <class Mesh>
Read_result read_mesh(const std::string& file, Mesh& mesh, bool quads_only,
                      Mesh_fields* fields = nullptr)
{
  Read_result result;
  try {
    Polygon_soup soup;
    Mesh_fields read;
    result = read_checked_soup(file, quads_only, soup, fields ? &read : nullptr);
    if(result.ok() && !fill_mesh(soup, mesh)) {
      CGAL::clear(mesh);
      result = refuse(Refusal::non_manifold, "the mesh type cannot hold this surface");
    }
    if(result.ok() && fields) *fields = std::move(read);
  } catch(const std::bad_alloc&) {
    CGAL::clear(mesh);
    result = refuse(Refusal::unreadable_file, "there is not enough memory for it");
  } catch(const std::exception& error) {
    result = refuse(Refusal::unreadable_file, error.what());
  }
  if(!result.ok()) result.message = file + ": " + result.message;
  return result;
}

} // namespace internal

/// Reads a quad mesh from an OFF (text), OBJ or PLY (text or binary) file; the format is told by
/// the extension, in any case.  Colours, normals and texture coordinates are ignored.
///
/// The surface must be an orientable 2-manifold, with or without boundary, of quads that have an
/// area; it may have several components.  Faces of different orientation are turned (the majority
/// of each component stays), isolated vertices are left out, both is told in
/// `Read_result::notes`.  Coincident vertices are *not* merged, which is told there, too.  Vertices
/// and faces keep the order of the file.
///
/// \tparam QuadMesh a model of `MutableFaceGraph` with an internal `vertex_point` map whose points
///         can be made of three doubles
/// \param file path of the file
/// \param mesh is cleared and filled; untouched when the file is refused, cleared where the mesh
///        type cannot hold the surface or there is not memory enough for it
/// \return what was refused and where: `unreadable_file` (missing, truncated, damaged, vertex
///         number out of range), `empty_mesh`, `non_finite_coordinate`, `not_all_quads`,
///         `degenerate_face` (zero edge, zero area, vertex twice), `non_manifold` (edge of three
///         faces, two fans at a vertex, face twice) or `non_orientable`.  Vertices and faces are
///         counted from 0, as in OFF files.  Throws nothing.
template <class QuadMesh>
Read_result read_quad_mesh(const std::string& file, QuadMesh& mesh)
{
  return internal::read_mesh(file, mesh, true);
}

/// The same, and what the file says beside the shape:
/// - PLY: every property of vertices and faces that is a single number, as a field, and the element
///   `edge` with its `vertex1` and `vertex2` as marked edges;
/// - OBJ: groups (`g`) and materials (`usemtl`) as the face field `patch_field`, a patch being the
///   faces with the same of both, named by both, and polylines (`l`) as marked edges;
/// - OFF: nothing.
///
/// \param fields is replaced; vertices and faces are counted in the order of iteration over `mesh`.
///        Marked edges need not be edges of faces.  Untouched when the file is refused.
template <class QuadMesh>
Read_result read_quad_mesh(const std::string& file, QuadMesh& mesh, Mesh_fields& fields)
{
  return internal::read_mesh(file, mesh, true, &fields);
}

/// Reads a surface of any polygons, as `read_quad_mesh()` does with quads; meant for reference
/// surfaces.
template <class SurfaceMesh>
Read_result read_surface(const std::string& file, SurfaceMesh& mesh)
{
  return internal::read_mesh(file, mesh, false);
}

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_IO_READ_QUAD_MESH_H
