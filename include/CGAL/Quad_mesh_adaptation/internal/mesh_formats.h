// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MESH_FORMATS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MESH_FORMATS_H

#include <CGAL/Quad_mesh_adaptation/IO/Mesh_fields.h>
#include <CGAL/Quad_mesh_adaptation/internal/field_names.h>
#include <CGAL/Quad_mesh_adaptation/internal/number_text.h>
#include <CGAL/Quad_mesh_adaptation/internal/polygon_soup.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {

namespace internal {

inline void append(std::string& text, std::size_t value) { text += std::to_string(value); }
inline void append(std::string& text, Index value)
{
  char digits[16];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

inline void append_points(std::string& text, const Polygon_soup& soup, const char* before = "")
{
  for(const Vec& p : soup.points) {
    text += before;
    append(text, p.x());
    text += ' ';
    append(text, p.y());
    text += ' ';
    append(text, p.z());
    text += '\n';
  }
}

// A line per face: an optional number of vertices, then the vertices counted from `first`.
inline void append_face(std::string& text, const Polygon_soup::Face& face, bool with_degree,
                        Index first = 0)
{
  if(with_degree) append(text, face.size());
  for(std::size_t i = 0; i < face.size(); ++i) {
    if(with_degree || i > 0) text += ' ';
    append(text, face[i] + first);
  }
}

inline std::string counts(const Polygon_soup& soup)
{
  return std::to_string(soup.points.size()) + ' ' + std::to_string(soup.faces.size());
}

// Name of the first field that has not as many values as there are entities, or nothing.
inline std::string field_of_wrong_length(const Mesh_fields& fields, std::size_t vertices,
                                         std::size_t faces)
{
  for(const Scalar_field& field : fields.vertex)
    if(field.values.size() != vertices) return field_name(field);
  for(const Scalar_field& field : fields.face)
    if(field.values.size() != faces) return field_name(field);
  return {};
}

inline std::string to_off(const Polygon_soup& soup)
{
  std::string text = "OFF\n" + counts(soup) + " 0\n";
  append_points(text, soup);
  for(const Polygon_soup::Face& face : soup.faces) {
    append_face(text, face, true);
    text += '\n';
  }
  return text;
}

// What an OBJ file calls a patch: it has words for names, and no numbers.
inline std::string group_name(const Mesh_fields& fields, double patch)
{
  if(patch >= 0 && patch < double(fields.patch_names.size()) && patch == std::floor(patch)) {
    const std::string& name = fields.patch_names[std::size_t(patch)];
    return name.empty() ? "default" : name;
  }
  std::string text = patch_field + std::string("_");
  append(text, patch);
  return text;
}

inline std::string to_obj(const Polygon_soup& soup, const Mesh_fields& fields)
{
  const Scalar_field* patches = Mesh_fields::find(fields.face, patch_field);
  std::string text;
  append_points(text, soup, "v ");
  for(std::size_t f = 0; f < soup.faces.size(); ++f) {
    if(patches && (f == 0 || patches->values[f] != patches->values[f - 1]))
      text += "g " + group_name(fields, patches->values[f]) + '\n';
    text += "f ";
    append_face(text, soup.faces[f], false, 1);
    text += '\n';
  }
  for(const std::array<std::size_t, 2>& edge : fields.edges)
    text += "l " + std::to_string(edge[0] + 1) + ' ' + std::to_string(edge[1] + 1) + '\n';
  return text;
}

inline void append_ply_values(std::string& text, const std::vector<Scalar_field>& fields,
                              std::size_t i)
{
  for(const Scalar_field& field : fields) {
    text += ' ';
    append(text, field.values[i]);
  }
  text += '\n';
}

inline void append_ply_properties(std::string& text, const std::vector<std::string>& names)
{
  for(const std::string& name : names) text += "property double " + name + '\n';
}

// What holds the number of corners of any face.
inline const char* ply_length_type(const Polygon_soup& soup)
{
  const bool is_small = std::all_of(soup.faces.begin(), soup.faces.end(),
                                    [](const auto& face) { return face.size() <= 255; });
  return is_small ? "uchar" : "int";
}

inline std::string to_ply(const Polygon_soup& soup, const Mesh_fields& fields)
{
  std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(soup.points.size()) +
                     "\nproperty double x\nproperty double y\nproperty double z\n";
  append_ply_properties(text, field_names(fields.vertex, { "x", "y", "z" }));
  text += "element face " + std::to_string(soup.faces.size()) + "\nproperty list " +
          ply_length_type(soup) + " int vertex_indices\n";
  append_ply_properties(text, field_names(fields.face, { "vertex_indices", "vertex_index" }));
  if(!fields.edges.empty())
    text += "element edge " + std::to_string(fields.edges.size()) +
            "\nproperty int vertex1\nproperty int vertex2\n";
  text += "end_header\n";
  for(std::size_t v = 0; v < soup.points.size(); ++v) {
    const Vec& p = soup.points[v];
    append(text, p.x());
    text += ' ';
    append(text, p.y());
    text += ' ';
    append(text, p.z());
    append_ply_values(text, fields.vertex, v);
  }
  for(std::size_t f = 0; f < soup.faces.size(); ++f) {
    append_face(text, soup.faces[f], true);
    append_ply_values(text, fields.face, f);
  }
  for(const std::array<std::size_t, 2>& edge : fields.edges)
    text += std::to_string(edge[0]) + ' ' + std::to_string(edge[1]) + '\n';
  return text;
}

inline std::size_t number_of_corners(const Polygon_soup& soup)
{
  std::size_t n = 0;
  for(const Polygon_soup::Face& face : soup.faces) n += face.size();
  return n;
}

// VTK's number for a cell of that many vertices: triangle, quad, polygon.
inline Index vtk_cell_type(const Polygon_soup::Face& face)
{
  return face.size() == 3 ? 5 : face.size() == 4 ? 9 : 7;
}

inline void append_values(std::string& text, const std::vector<double>& values)
{
  for(const double value : values) {
    append(text, value);
    text += '\n';
  }
}

inline void append_legacy_fields(std::string& text, const std::vector<Scalar_field>& fields,
                                 const std::string& section)
{
  if(!fields.empty()) text += section;
  const std::vector<std::string> names = field_names(fields);
  for(std::size_t i = 0; i < fields.size(); ++i) {
    text += "SCALARS " + names[i] + " double 1\nLOOKUP_TABLE default\n";
    append_values(text, fields[i].values);
  }
}

inline std::string to_legacy_vtk(const Polygon_soup& soup, const Mesh_fields& fields)
{
  const std::string n_points = std::to_string(soup.points.size()),
                    n_faces = std::to_string(soup.faces.size());
  std::string text = "# vtk DataFile Version 3.0\nquad mesh\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                     "POINTS " +
                     n_points + " double\n";
  append_points(text, soup);
  text +=
      "CELLS " + n_faces + ' ' + std::to_string(number_of_corners(soup) + soup.faces.size()) + '\n';
  for(const Polygon_soup::Face& face : soup.faces) {
    append_face(text, face, true);
    text += '\n';
  }
  text += "CELL_TYPES " + n_faces + '\n';
  for(const Polygon_soup::Face& face : soup.faces) {
    append(text, vtk_cell_type(face));
    text += '\n';
  }
  append_legacy_fields(text, fields.face, "CELL_DATA " + n_faces + '\n');
  append_legacy_fields(text, fields.vertex, "POINT_DATA " + n_points + '\n');
  return text;
}

inline std::string vtu_array(const std::string& type, const std::string& name,
                             const std::string& more = "")
{
  return "<DataArray type=\"" + type + "\" Name=\"" + name + "\"" + more + " format=\"ascii\">\n";
}

inline void append_vtu_fields(std::string& text, const std::vector<Scalar_field>& fields)
{
  const std::vector<std::string> names = field_names(fields);
  for(std::size_t i = 0; i < fields.size(); ++i) {
    text += vtu_array("Float64", names[i]);
    append_values(text, fields[i].values);
    text += "</DataArray>\n";
  }
}

inline void append_vtu_cells(std::string& text, const Polygon_soup& soup)
{
  text += "<Cells>\n" + vtu_array("Int64", "connectivity");
  for(const Polygon_soup::Face& face : soup.faces) {
    append_face(text, face, false);
    text += '\n';
  }
  text += "</DataArray>\n" + vtu_array("Int64", "offsets");
  std::size_t offset = 0;
  for(const Polygon_soup::Face& face : soup.faces) {
    append(text, offset += face.size());
    text += '\n';
  }
  text += "</DataArray>\n" + vtu_array("UInt8", "types");
  for(const Polygon_soup::Face& face : soup.faces) {
    append(text, vtk_cell_type(face));
    text += '\n';
  }
  text += "</DataArray>\n</Cells>\n";
}

inline std::string to_vtu(const Polygon_soup& soup, const Mesh_fields& fields)
{
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
                     "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
                     std::to_string(soup.points.size()) + "\" NumberOfCells=\"" +
                     std::to_string(soup.faces.size()) + "\">\n<PointData>\n";
  append_vtu_fields(text, fields.vertex);
  text += "</PointData>\n<CellData>\n";
  append_vtu_fields(text, fields.face);
  text += "</CellData>\n<Points>\n" + vtu_array("Float64", "Points", " NumberOfComponents=\"3\"");
  append_points(text, soup);
  text += "</DataArray>\n</Points>\n";
  append_vtu_cells(text, soup);
  text += "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  return text;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MESH_FORMATS_H
