// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_ADAPT_MESH_SETS_H
#define QUAD_ADAPT_MESH_SETS_H

#include "Sizes.h"

#include <CGAL/Quad_mesh_adaptation/IO/Mesh_fields.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

/// Patches, marked edges and fixed vertices of a mesh: taken from what its file says, kept by the
/// adaptation, and written with the result.
class Mesh_sets
{
public:
  using Patch_map = Mesh::Property_map<Mesh::Face_index, double>;
  using Edge_map = Mesh::Property_map<Mesh::Edge_index, bool>;
  using Vertex_map = Mesh::Property_map<Mesh::Vertex_index, bool>;
  /// Name of the vertex field that is not zero where vertices are fixed.
  static constexpr const char* fixed_field = "fixed";

  /// The mesh has no sets until take() has found some.
  explicit Mesh_sets(Mesh& mesh)
      : mesh_(mesh), patch_(mesh.add_property_map<Mesh::Face_index, double>("f:patch", 0.).first),
        is_marked_(mesh.add_property_map<Mesh::Edge_index, bool>("e:is_marked", false).first),
        is_fixed_(mesh.add_property_map<Mesh::Vertex_index, bool>("v:is_fixed", false).first)
  {
  }

  /// Refused where a patch is no number.  `notes`: what is found, and what is left out.
  QMA::Read_result take(const QMA::Mesh_fields& fields, std::vector<std::string>& notes)
  {
    patch_names_ = fields.patch_names;
    if(const auto* patches = QMA::Mesh_fields::find(fields.face, QMA::patch_field)) {
      has_patches_ = true;
      for(const Mesh::Face_index f : mesh_.faces()) {
        put(patch_, f, patches->values[f]);
        if(!std::isfinite(patches->values[f]))
          return { QMA::Refusal::invalid_parameter,
                   "the patch of face " + std::to_string(f) + " is not a finite number",
                   long(f),
                   {} };
      }
    }
    if(const auto* fixed = QMA::Mesh_fields::find(fields.vertex, fixed_field)) {
      has_fixed_ = true;
      for(const Mesh::Vertex_index v : mesh_.vertices()) put(is_fixed_, v, fixed->values[v] != 0);
    }
    mark(fields.edges, notes);
    const std::string kept = summary();
    if(!kept.empty()) notes.push_back(kept + "; --ignore-sets leaves them out");
    return {};
  }

  Patch_map patches() const { return patch_; }
  Edge_map marked_edges() const { return is_marked_; }
  Vertex_map fixed_vertices() const { return is_fixed_; }

  /// Is that edge marked, or does it part patches?
  bool is_kept(Mesh::Edge_index e) const
  {
    if(get(is_marked_, e)) return true;
    const Mesh::Halfedge_index h = mesh_.halfedge(e);
    return !mesh_.is_border(e) &&
           get(patch_, mesh_.face(h)) != get(patch_, mesh_.face(mesh_.opposite(h)));
  }

  /// Those of the mesh as it is now, to be written with it.
  void add_to(QMA::Mesh_fields& fields) const
  {
    fields.patch_names = patch_names_;
    if(has_patches_) {
      fields.face.push_back({ QMA::patch_field, {} });
      for(const Mesh::Face_index f : mesh_.faces())
        fields.face.back().values.push_back(get(patch_, f));
    }
    if(has_fixed_) {
      fields.vertex.push_back({ fixed_field, {} });
      for(const Mesh::Vertex_index v : mesh_.vertices())
        fields.vertex.back().values.push_back(get(is_fixed_, v));
    }
    std::map<Mesh::Vertex_index, std::size_t> number;
    if(has_marked_)
      for(const Mesh::Vertex_index v : mesh_.vertices()) number.emplace(v, number.size());
    for(const Mesh::Edge_index e : mesh_.edges())
      if(has_marked_ && get(is_marked_, e))
        fields.edges.push_back({ number.at(mesh_.vertex(e, 0)), number.at(mesh_.vertex(e, 1)) });
  }

private:
  std::string summary() const
  {
    std::set<double> patches;
    for(const Mesh::Face_index f : mesh_.faces()) patches.insert(get(patch_, f));
    std::string text;
    const auto add = [&](std::size_t number, const char* one, const char* many) {
      if(number > 0)
        text +=
            (text.empty() ? "kept: " : ", ") + std::to_string(number) + (number == 1 ? one : many);
    };
    add(has_patches_ ? patches.size() : 0, " patch", " patches");
    add(number_in(mesh_.edges(), is_marked_), " marked edge", " marked edges");
    add(number_in(mesh_.vertices(), is_fixed_), " fixed vertex", " fixed vertices");
    return text;
  }

  template <class Range, class Map>
  static std::size_t number_in(const Range& entities, const Map& set)
  {
    return std::size_t(std::count_if(entities.begin(), entities.end(),
                                     [&](auto entity) { return get(set, entity); }));
  }

  void mark(const std::vector<std::array<std::size_t, 2>>& edges, std::vector<std::string>& notes)
  {
    std::size_t lost = 0;
    for(const auto& edge : edges) {
      const Mesh::Halfedge_index h = mesh_.halfedge(Mesh::Vertex_index(Mesh::size_type(edge[0])),
                                                    Mesh::Vertex_index(Mesh::size_type(edge[1])));
      if(h == Mesh::null_halfedge())
        ++lost;
      else
        put(is_marked_, mesh_.edge(h), true);
    }
    has_marked_ = lost < edges.size();
    if(lost > 0)
      notes.push_back(std::to_string(lost) + " of the " + std::to_string(edges.size()) +
                      " marked edges are no edges of faces and are left out");
  }

  Mesh& mesh_;
  Patch_map patch_;
  Edge_map is_marked_;
  Vertex_map is_fixed_;
  std::vector<std::string> patch_names_;
  bool has_patches_ = false, has_marked_ = false, has_fixed_ = false;
};

#endif // QUAD_ADAPT_MESH_SETS_H
