// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_IO_READ_NODAL_SIZES_H
#define CGAL_QUAD_MESH_ADAPTATION_IO_READ_NODAL_SIZES_H

#include <CGAL/Quad_mesh_adaptation/IO/Read_result.h>
#include <CGAL/Quad_mesh_adaptation/Nodal_sizing_field.h>
#include <CGAL/Quad_mesh_adaptation/internal/file_calls.h>
#include <CGAL/Quad_mesh_adaptation/internal/file_names.h>

#include <cmath>
#include <exception>
#include <new>
#include <optional>
#include <string>

namespace CGAL {
namespace Quad_mesh_adaptation {

namespace internal {

inline Read_result read_nodal_sizes(const std::string& file, const std::string& property,
                                    std::optional<Nodal_sizing_field>& field)
{
  if(extension_of(file) != "ply")
    return refuse(Refusal::unreadable_file, "its name must end in .ply");
  Polygon_soup soup;
  Mesh_fields fields;
  const Read_result result = read_soup(file, soup, &fields);
  if(!result.ok()) return result;
  const Scalar_field* sizes = Mesh_fields::find(fields.vertex, property);
  if(!sizes)
    return refuse(Refusal::unreadable_file, "its vertices have no property \"" + property + "\"");
  for(std::size_t v = 0; v < sizes->values.size(); ++v)
    if(!(sizes->values[v] > 0 && std::isfinite(sizes->values[v])))
      return refuse(Refusal::invalid_size,
                    "the size at vertex " + std::to_string(v) + " is not positive and finite",
                    long(v));
  field.emplace(soup.points, soup.faces, sizes->values);
  return result;
}

} // namespace internal

/// Reads a background mesh with sizes at its vertices: a PLY file (text or binary) of polygons
/// whose vertices have a property `property`, a single number of any type.  The mesh need not be
/// manifold.
///
/// \param field is set when the file was read, otherwise left as it is.
/// \return what was refused and where, as for `read_quad_mesh()`; `invalid_size` for a size that
///         is not positive and finite.  Throws nothing.
inline Read_result read_nodal_sizes(const std::string& file,
                                    std::optional<Nodal_sizing_field>& field,
                                    const std::string& property = "size")
{
  Read_result result;
  try {
    result = internal::read_nodal_sizes(file, property, field);
  } catch(const std::bad_alloc&) {
    result = internal::refuse(Refusal::unreadable_file, "there is not enough memory for it");
  } catch(const std::exception& error) {
    result = internal::refuse(Refusal::unreadable_file, error.what());
  }
  if(!result.ok()) result.message = file + ": " + result.message;
  return result;
}

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_IO_READ_NODAL_SIZES_H
