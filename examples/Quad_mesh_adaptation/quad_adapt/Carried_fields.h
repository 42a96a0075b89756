// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_ADAPT_CARRIED_FIELDS_H
#define QUAD_ADAPT_CARRIED_FIELDS_H

#include "Mesh_sets.h"
#include "Sizes.h"

#include <CGAL/Quad_mesh_adaptation/IO/Mesh_fields.h>
#include <CGAL/Quad_mesh_adaptation/Nodal_field.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

/// The numbers that a file has at its vertices, interpolated at those of the adapted mesh.
class Carried_fields
{
public:
  /// `mesh` is as it was read.  `notes`: what cannot be carried over.
  void take(const Mesh& mesh, const QMA::Mesh_fields& fields, std::vector<std::string>& notes)
  {
    for(const QMA::Scalar_field& field : fields.vertex) {
      if(field.name == Mesh_sets::fixed_field || field.name == own_field) continue;
      if(!std::all_of(field.values.begin(), field.values.end(),
                      [](double value) { return std::isfinite(value); })) {
        notes.push_back("the property \"" + field.name +
                        "\" has values that are not finite and "
                        "is left out");
        continue;
      }
      const auto value = [&field](std::size_t v) { return field.values[v]; };
      fields_.emplace_back(
          field.name,
          QMA::Nodal_field(mesh, boost::make_function_property_map<Mesh::Vertex_index>(value)));
    }
  }

  /// At the vertices of the mesh as it is now.
  void add_to(const Mesh& mesh, QMA::Mesh_fields& fields) const
  {
    for(const auto& [name, field] : fields_) {
      fields.vertex.push_back({ name, {} });
      for(const Mesh::Vertex_index v : mesh.vertices())
        fields.vertex.back().values.push_back(field(mesh.point(v)));
    }
  }

private:
  static constexpr const char* own_field = "size"; // the program writes one of that name itself

  std::vector<std::pair<std::string, QMA::Nodal_field>> fields_;
};

#endif // QUAD_ADAPT_CARRIED_FIELDS_H
