// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_IO_WRITE_QUAD_MESH_H
#define CGAL_QUAD_MESH_ADAPTATION_IO_WRITE_QUAD_MESH_H

#include <CGAL/Quad_mesh_adaptation/IO/File_transaction.h>
#include <CGAL/Quad_mesh_adaptation/internal/file_calls.h>
#include <CGAL/Quad_mesh_adaptation/internal/file_names.h>
#include <CGAL/Quad_mesh_adaptation/internal/mesh_formats.h>
#include <CGAL/Quad_mesh_adaptation/internal/polygon_soup.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

namespace CGAL {
namespace Quad_mesh_adaptation {

/// Whether `write_quad_mesh()` knows the format that the extension of `file` names.
inline bool is_mesh_format_known(const std::string& file)
{
  const std::string extension = internal::extension_of(file);
  return extension == "off" || extension == "obj" || extension == "ply" || extension == "vtk" ||
         extension == "vtu";
}

/// Whether that format holds numbers at vertices and faces.
inline bool can_hold_fields(const std::string& file)
{
  const std::string extension = internal::extension_of(file);
  return extension == "ply" || extension == "vtk" || extension == "vtu";
}

/// The contents of the file that `write_quad_mesh()` would write; for a `File_transaction` of
/// several files.  Precondition: `is_mesh_format_known(file)` and fields of the right lengths.
template <class QuadMesh>
std::string quad_mesh_file_contents(const std::string& file, const QuadMesh& mesh,
                                    const Mesh_fields& fields = {})
{
  return internal::file_contents(internal::extension_of(file), internal::soup_of_mesh(mesh),
                                 fields);
}

/// Writes a mesh of quads (or any polygons) as OFF, OBJ, PLY, legacy VTK (`.vtk`) or XML VTK
/// (`.vtu`), all as text; the extension, in any case, tells the format.
///
/// Numbers are written so that reading gives the same doubles.  The file appears complete or not
/// at all: it is written beside its target and renamed, a file that had the name is replaced.
///
/// \tparam QuadMesh a model of `FaceListGraph` with an internal `vertex_point` map
/// \param file path of the file to write
/// \param mesh vertices and faces are written in its order of iteration
/// \param fields numbers per vertex and per face, in the same order, and marked edges.  OFF files
///        hold none of them, OBJ files patches (as groups) and marked edges (as polylines), PLY
///        files all but the names of patches, VTK files all numbers.  A field whose name an earlier
///        one has already, once it is written in letters, digits and underscores, or that is a
///        coordinate in PLY, gets a number at the end of its name: `heat_2`.
/// \return `unwritable_file` with the reason when the extension is not known, a field has not as
///         many values as the mesh vertices or faces, a marked edge names a vertex that is not
///         there, or the file cannot be written
template <class QuadMesh>
Write_result write_quad_mesh(const std::string& file, const QuadMesh& mesh,
                             const Mesh_fields& fields = {})
{
  if(!is_mesh_format_known(file))
    return { Refusal::unwritable_file,
             file + ": cannot be written: its name must end in .off, .obj, .ply, .vtk or .vtu" };
  const std::size_t number_of_vertices = vertices(mesh).size(); // linear for some meshes
  const std::string wrong =
      internal::field_of_wrong_length(fields, number_of_vertices, faces(mesh).size());
  if(!wrong.empty())
    return { Refusal::unwritable_file, file + ": cannot be written: the field \"" + wrong +
                                           "\" has not one value per entity" };
  for(const std::array<std::size_t, 2>& edge : fields.edges)
    if((std::max)(edge[0], edge[1]) >= number_of_vertices)
      return { Refusal::unwritable_file,
               file + ": cannot be written: a marked edge names a vertex that is not there" };
  File_transaction transaction;
  const Write_result result = transaction.stage(file, quad_mesh_file_contents(file, mesh, fields));
  return result.ok() ? transaction.commit() : result;
}

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_IO_WRITE_QUAD_MESH_H
