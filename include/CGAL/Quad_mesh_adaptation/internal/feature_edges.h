// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FEATURE_EDGES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FEATURE_EDGES_H

#include <CGAL/Quad_mesh_adaptation/internal/Face_arrays.h>
#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>
#include <CGAL/Quad_mesh_adaptation/internal/stray_creases.h>
#include <CGAL/Quad_mesh_adaptation/internal/tangled_nodes.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// A polygon mesh for `Stray_creases`.  Only quads have an edge across.
class Arrays_with_creases
{
public:
  Arrays_with_creases(const Face_arrays& mesh, std::vector<char>& is_feature)
      : mesh_(mesh), is_feature_(is_feature)
  {
    areas_.reserve(std::size_t(mesh.number_of_faces()));
    for(Index f = 0; f < mesh.number_of_faces(); ++f) areas_.push_back(mesh.area_vector(f));
  }

  Index vertex_end() const { return Index(mesh_.points.size()); }
  Index halfedge_end() const { return mesh_.number_of_halfedges(); }
  Index face(Index h) const { return mesh_.face[h]; }
  Index next(Index h) const { return mesh_.next(h); }
  Index origin(Index h) const { return mesh_.origin[h]; }
  Index target(Index h) const { return mesh_.origin[mesh_.next(h)]; }
  Index opposite(Index h) const { return mesh_.opposite[h]; }
  Index across(Index h) const
  {
    const Index f = mesh_.face[h];
    return mesh_.first[f + 1] - mesh_.first[f] == 4 ? mesh_.next(mesh_.next(h)) : -1;
  }
  double turn(Index h) const
  {
    const Index o = mesh_.opposite[h];
    return o < 0 ? 0. : angle_between(areas_[mesh_.face[h]], areas_[mesh_.face[o]]);
  }
  const Vec& point(Index v) const { return mesh_.points[v]; }
  const Vec& area_vector(Index f) const { return areas_[f]; }
  double length(Index h) const { return distance(mesh_.source(h), mesh_.target(h)); }
  bool is_feature(Index h) const { return is_feature_[h]; }
  void forget(Index h) { is_feature_[h] = is_feature_[mesh_.opposite[h]] = 0; }
  bool is_held(Index) const { return false; }

private:
  const Face_arrays& mesh_;
  std::vector<char>& is_feature_; // by half-edge
  std::vector<Vec> areas_;        // by face
};

// By half-edge: the border, constrained edges, and those that turn by the angle with cosine
// `cos_feature` at least, but for what adaptation does not take for creases either.  A field that
// stops at these while adaptation goes across asks for nothing where faces lie over a sharp fold.
inline std::vector<char> feature_edges(const Face_arrays& mesh, double cos_feature)
{
  std::vector<char> is_feature(std::size_t(mesh.number_of_halfedges()), 0), detected = is_feature;
  Arrays_with_creases surface(mesh, is_feature);
  const double angle = cos_feature < -1 ? 4. : std::acos(cos_feature);
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h) {
    const Index o = mesh.opposite[h];
    if(o < 0 || mesh.is_constrained[h])
      is_feature[h] = 1;
    else if(o > h && surface.turn(h) > angle)
      is_feature[h] = is_feature[o] = detected[h] = detected[o] = 1;
  }
  Tangled_nodes<Arrays_with_creases>(surface, detected, cos_feature)();
  Stray_creases<Arrays_with_creases>(surface, detected)();
  return is_feature;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FEATURE_EDGES_H
