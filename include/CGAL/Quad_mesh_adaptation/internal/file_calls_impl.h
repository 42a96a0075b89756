// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FILE_CALLS_IMPL_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FILE_CALLS_IMPL_H

#include <CGAL/Quad_mesh_adaptation/internal/file_calls.h>
#include <CGAL/Quad_mesh_adaptation/internal/file_names.h>
#include <CGAL/Quad_mesh_adaptation/internal/mesh_formats.h>
#include <CGAL/Quad_mesh_adaptation/internal/read_obj.h>
#include <CGAL/Quad_mesh_adaptation/internal/read_off.h>
#include <CGAL/Quad_mesh_adaptation/internal/read_ply.h>
#include <CGAL/Quad_mesh_adaptation/internal/soup_check.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL std::string
file_contents(const std::string& extension, const Polygon_soup& soup, const Mesh_fields& fields)
{
  if(extension == "off") return to_off(soup);
  if(extension == "obj") return to_obj(soup, fields);
  if(extension == "ply") return to_ply(soup, fields);
  if(extension == "vtk") return to_legacy_vtk(soup, fields);
  return to_vtu(soup, fields);
}

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

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL Read_result read_soup(const std::string& file,
                                                          Polygon_soup& soup, Mesh_fields* fields)
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

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL Read_result read_checked_soup(const std::string& file,
                                                                  bool quads_only,
                                                                  Polygon_soup& soup,
                                                                  Mesh_fields* fields)
{
  Mesh_fields read;
  std::vector<Index> number;
  Read_result result = read_soup(file, soup, fields ? &read : nullptr);
  drop_incomplete(read.vertex, soup.points.size());
  drop_incomplete(read.face, soup.faces.size());
  std::vector<std::string> notes = std::move(result.notes);
  if(result.ok()) result = check_soup(soup, quads_only, number);
  result.notes.insert(result.notes.begin(), notes.begin(), notes.end());
  if(!result.ok()) return result;
  note_coincident(soup, result.notes);
  if(fields) {
    renumber_vertices(number, read);
    *fields = std::move(read);
  }
  return result;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FILE_CALLS_IMPL_H
