// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FILE_CALLS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FILE_CALLS_H

#include <CGAL/Quad_mesh_adaptation/IO/Mesh_fields.h>
#include <CGAL/Quad_mesh_adaptation/IO/Read_result.h>
#include <CGAL/Quad_mesh_adaptation/internal/compiled_core.h>
#include <CGAL/Quad_mesh_adaptation/internal/polygon_soup.h>

#include <string>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// What reading and writing of files does that knows no type of mesh, see compiled_core.h.

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL std::string
file_contents(const std::string& extension, const Polygon_soup& soup, const Mesh_fields& fields);

// By extension.  Never throws but for lack of memory.
CGAL_QUAD_MESH_ADAPTATION_CORE_CALL Read_result read_soup(const std::string& file,
                                                          Polygon_soup& soup, Mesh_fields* fields);

// Reads and checks; `fields` are those of the file but for entities that were left out.
CGAL_QUAD_MESH_ADAPTATION_CORE_CALL Read_result read_checked_soup(const std::string& file,
                                                                  bool quads_only,
                                                                  Polygon_soup& soup,
                                                                  Mesh_fields* fields);

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#ifndef QUAD_MESH_ADAPTATION_COMPILED_CORE
#include <CGAL/Quad_mesh_adaptation/internal/file_calls_impl.h>
#endif

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FILE_CALLS_H
