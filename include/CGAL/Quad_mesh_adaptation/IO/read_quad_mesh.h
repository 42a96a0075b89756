// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_IO_READ_QUAD_MESH_H
#define CGAL_QUAD_MESH_ADAPTATION_IO_READ_QUAD_MESH_H

#include <CGAL/Quad_mesh_adaptation/IO/Mesh_fields.h>
#include <CGAL/Quad_mesh_adaptation/IO/Read_result.h>
#include <CGAL/Quad_mesh_adaptation/internal/file_names.h>
#include <CGAL/Quad_mesh_adaptation/internal/polygon_soup.h>
#include <CGAL/Quad_mesh_adaptation/internal/read_obj.h>
#include <CGAL/Quad_mesh_adaptation/internal/read_off.h>
#include <CGAL/Quad_mesh_adaptation/internal/read_ply.h>
#include <CGAL/Quad_mesh_adaptation/internal/soup_check.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <fstream>
#include <limits>
#include <new>
#include <string>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

inline Read_result read_bytes(const std::string& file, std::string& bytes)
{
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if(!std::filesystem::exists(status))
    return refuse(Refusal::unreadable_file, "there is no such file");
  if(!std::filesystem::is_regular_file(status))
    return refuse(Refusal::unreadable_file, "it is not a regular file");
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if(!stream) return refuse(Refusal::unreadable_file, "the file cannot be opened for reading");
  const std::streamoff size = stream.tellg();
  if(size <= 0) return refuse(Refusal::unreadable_file, "the file is empty");
  bytes.resize(static_cast<std::size_t>(size));
  stream.seekg(0);
  if(!stream.read(&bytes[0], size))
    return refuse(Refusal::unreadable_file, "the file cannot be read to its end");
  return {};
}

// By extension.  Never throws but for lack of memory.
inline Read_result read_soup(const std::string& file, Polygon_soup& soup, Mesh_fields* fields)
{
  const std::string extension = extension_of(file);
  if(extension != "off" && extension != "obj" && extension != "ply")
    return refuse(Refusal::unreadable_file, "its name must end in .off, .obj or .ply");
  std::string bytes;
  const Read_result result = read_bytes(file, bytes);
  if(!result.ok()) return result;
  if(extension == "off") return read_off(bytes, soup);
  if(extension == "obj") return read_obj(bytes, soup, fields);
  return read_ply(bytes, soup, fields);
}

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

// Tells of vertices with the coordinates of others, where a surface may be open unexpectedly.
inline void note_coincident(const Polygon_soup& soup, std::vector<std::string>& notes)
{
  std::vector<Vec> points = soup.points;
  std::sort(points.begin(), points.end(), [](const Vec& p, const Vec& q) {
    return std::make_tuple(p.x(), p.y(), p.z()) < std::make_tuple(q.x(), q.y(), q.z());
  });
  std::size_t n = 0;
  for(std::size_t i = 1; i < points.size(); ++i) n += points[i] == points[i - 1];
  if(n == 0) return;
  notes.push_back(std::to_string(n) + (n == 1 ? " vertex has" : " vertices have") +
                  " the coordinates of others; they are not merged, and faces that do not share "
                  "vertices are not connected");
}

// After vertices have got other numbers, or -1 where they were left out.
inline void renumber_vertices(const std::vector<Index>& number, Mesh_fields& fields)
{
  for(Scalar_field& field : fields.vertex) {
    std::size_t kept = 0;
    for(std::size_t v = 0; v < number.size(); ++v)
      if(number[v] >= 0) field.values[kept++] = field.values[v];
    field.values.resize(kept);
  }
  const auto is_lost = [&](const std::array<std::size_t, 2>& edge) {
    return number[edge[0]] < 0 || number[edge[1]] < 0;
  };
  fields.edges.erase(std::remove_if(fields.edges.begin(), fields.edges.end(), is_lost),
                     fields.edges.end());
  for(std::array<std::size_t, 2>& edge : fields.edges)
    for(std::size_t& v : edge) v = std::size_t(number[v]);
}

// A file may hold a second list of vertices or of faces, whose properties differ.
inline void drop_incomplete(std::vector<Scalar_field>& fields, std::size_t entities)
{
  fields.erase(
      std::remove_if(fields.begin(), fields.end(),
                     [&](const Scalar_field& field) { return field.values.size() != entities; }),
      fields.end());
}

template <class Mesh>
Read_result read_mesh(const std::string& file, Mesh& mesh, bool quads_only,
                      Mesh_fields* fields = nullptr)
{
  Read_result result;
  try {
    Polygon_soup soup;
    Mesh_fields read;
    std::vector<Index> number;
    result = read_soup(file, soup, fields ? &read : nullptr);
    drop_incomplete(read.vertex, soup.points.size());
    drop_incomplete(read.face, soup.faces.size());
    std::vector<std::string> notes = std::move(result.notes);
    if(result.ok()) result = check_soup(soup, quads_only, number);
    result.notes.insert(result.notes.begin(), notes.begin(), notes.end());
    if(result.ok()) note_coincident(soup, result.notes);
    if(result.ok() && !fill_mesh(soup, mesh)) {
      CGAL::clear(mesh);
      result = refuse(Refusal::non_manifold, "the mesh type cannot hold this surface");
    }
    if(result.ok() && fields) {
      renumber_vertices(number, read);
      *fields = std::move(read);
    }
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
///   faces with the same of both, and polylines (`l`) as marked edges;
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
