// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_IO_MESH_FIELDS_H
#define CGAL_QUAD_MESH_ADAPTATION_IO_MESH_FIELDS_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {

/// A number per vertex or per face, in the order of iteration over the mesh.
struct Scalar_field
{
  std::string name; ///< letters, digits and underscores; others are written as underscores, and
                    ///< equal names with numbers
  std::vector<double> values;
};

/// What goes with a mesh into a file, or comes with it out of one.
///
/// Which patch a face belongs to is a face field of the name `patch_field`.
struct Mesh_fields
{
  std::vector<Scalar_field> vertex, face;
  /// Names of the patches 0, 1, ...; those beyond the end have none.
  std::vector<std::string> patch_names;
  /// Marked edges, such as feature curves: each by the numbers of its two vertices.
  std::vector<std::array<std::size_t, 2>> edges;

  /// The field of that name, or null.
  static const Scalar_field* find(const std::vector<Scalar_field>& fields, const std::string& name)
  {
    const auto it = std::find_if(fields.begin(), fields.end(),
                                 [&](const Scalar_field& field) { return field.name == name; });
    return it == fields.end() ? nullptr : &*it;
  }
};

/// Name of the face field with the patches.
constexpr const char* patch_field = "patch";

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_IO_MESH_FIELDS_H
