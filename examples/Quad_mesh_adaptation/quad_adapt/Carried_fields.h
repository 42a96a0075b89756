// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_ADAPT_CARRIED_FIELDS_H
#define QUAD_ADAPT_CARRIED_FIELDS_H

#include "Mesh_sets.h"
#include "Sizes.h"

#include <CGAL/Quad_mesh_adaptation/IO/Mesh_fields.h>
#include <CGAL/Quad_mesh_adaptation/Nearest_face.h>
#include <CGAL/Quad_mesh_adaptation/Nodal_field.h>

#include <CGAL/centroid.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

/// The numbers that a file has at its vertices and faces: at those of the adapted mesh they are
/// interpolated, or those of the nearest face of the initial one.
class Carried_fields
{
public:
  /// `mesh` is as it was read.  `notes`: what cannot be carried over.
  void take(const Mesh& mesh, const QMA::Mesh_fields& fields, std::vector<std::string>& notes)
  {
    std::set<std::string> left_out;
    const std::set<std::string> of_vertices = looks(fields.vertex, left_out),
                                of_faces = looks(fields.face, left_out);
    if(!left_out.empty()) notes.push_back(note_on(left_out));
    for(const QMA::Scalar_field& field : fields.vertex) {
      if(field.name == Mesh_sets::fixed_field || is_own(field.name)) continue;
      if(of_vertices.count(field.name) > 0) continue;
      if(!std::all_of(field.values.begin(), field.values.end(),
                      [](double value) { return std::isfinite(value); })) {
        notes.push_back("the property \"" + field.name +
                        "\" has values that are not finite and "
                        "is left out");
        continue;
      }
      const auto value = [&field](std::size_t v) { return field.values[v]; };
      at_vertices_.emplace_back(
          field.name,
          QMA::Nodal_field(mesh, boost::make_function_property_map<Mesh::Vertex_index>(value)));
    }
    for(const QMA::Scalar_field& field : fields.face)
      if(field.name != QMA::patch_field && !is_own(field.name) && of_faces.count(field.name) == 0)
        at_faces_.push_back(field);
    if(!at_faces_.empty()) nearest_.emplace(mesh);
  }

  /// At the vertices and faces of the mesh as it is now.
  void add_to(const Mesh& mesh, QMA::Mesh_fields& fields) const
  {
    for(const auto& [name, field] : at_vertices_) {
      fields.vertex.push_back({ name, {} });
      for(const Mesh::Vertex_index v : mesh.vertices())
        fields.vertex.back().values.push_back(field(mesh.point(v)));
    }
    if(at_faces_.empty()) return;
    std::vector<std::size_t> origin;
    for(const Mesh::Face_index f : mesh.faces()) origin.push_back(origin_of(f, mesh));
    for(const QMA::Scalar_field& field : at_faces_) {
      fields.face.push_back({ field.name, {} });
      for(const std::size_t f : origin) fields.face.back().values.push_back(field.values[f]);
    }
  }

private:
  // The program writes these itself.
  static bool is_own(const std::string& name)
  {
    return name == "size" || name == "size_ratio" || name == "scaled_jacobian";
  }

  // Names of those that are normals, colours or texture coordinates, and not numbers to
  // interpolate; only where all of a kind are there.  `u` and `v` are displacements more often.
  static std::set<std::string> looks(const std::vector<QMA::Scalar_field>& fields,
                                     std::set<std::string>& all)
  {
    static const std::vector<std::vector<std::string>> kinds = { { "nx", "ny", "nz" },
                                                                 { "red", "green", "blue" },
                                                                 { "red", "green", "blue",
                                                                   "alpha" },
                                                                 { "s", "t" },
                                                                 { "texture_u", "texture_v" } };
    std::set<std::string> names;
    for(const std::vector<std::string>& kind : kinds)
      if(std::all_of(kind.begin(), kind.end(), [&](const std::string& name) {
           return QMA::Mesh_fields::find(fields, name) != nullptr;
         }))
        names.insert(kind.begin(), kind.end());
    all.insert(names.begin(), names.end());
    return names;
  }

  static std::string note_on(const std::set<std::string>& names)
  {
    std::string list;
    for(const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    return "normals, colours and texture coordinates are left out: " + list;
  }

  std::size_t origin_of(Mesh::Face_index f, const Mesh& mesh) const
  {
    std::vector<Mesh::Point> p;
    for(const Mesh::Vertex_index v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      p.push_back(mesh.point(v));
    return (*nearest_)(CGAL::centroid(p.begin(), p.end(), CGAL::Dimension_tag<0>()),
                       CGAL::cross_product(p[2] - p[0], p[3] - p[1]));
  }

  std::vector<std::pair<std::string, QMA::Nodal_field>> at_vertices_;
  std::vector<QMA::Scalar_field> at_faces_; // of the initial mesh
  std::optional<QMA::Nearest_face> nearest_;
};

#endif // QUAD_ADAPT_CARRIED_FIELDS_H
