// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MIRROR_PART_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MIRROR_PART_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/Input_mesh.h>
#include <CGAL/Quad_mesh_adaptation/internal/Mirror_plane.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The part of a symmetric input that all the rest is an image of: the faces on the positive side
// of every plane.  Vertices keep their numbers; those of other parts have no face.  The edges along
// the planes are its border now, and its state is built as that of any input.
struct Mirror_part
{
  Input_mesh in;
  std::vector<Index> face; // of each quad of `in`, the quad of the whole

  // `whole` is the state of the whole input, not adapted yet.
  Mirror_part(const Input_mesh& all, const Adaptation_state& whole,
              const std::vector<Mirror_plane>& planes)
  {
    in.points = all.points;
    in.is_frozen_vertex = all.is_frozen_vertex;
    in.is_frozen_vertex.resize(all.points.size(), 0);
    for(std::size_t f = 0; f < all.quads.size(); ++f) {
      bool inside = true;
      for(const Mirror_plane& p : planes) inside = inside && p.side[f] > 0;
      if(!inside) continue;
      face.push_back(Index(f));
      in.quads.push_back(all.quads[f]);
      if(!all.patch.empty()) in.patch.push_back(all.patch[f]);
      for(std::size_t h = 4 * f; h < 4 * f + 4; ++h) {
        in.is_constrained.push_back(all.has_constrained(Index(h)));
        in.is_frozen.push_back(all.has_frozen(Index(h)));
      }
    }
    hold_corners(whole, planes);
  }

  // How the cut runs on the state built from this part.
  struct Cut
  {
    std::vector<int> plane;       // per curve: the one it is cut along, -1: it is no cut
    std::vector<char> is_feature; // per curve: it is a feature curve of the whole, too
    bool is_known = true;         // false: a curve is cut and border at once
  };

  Cut cut_of(const Adaptation_state& part, const Adaptation_state& whole,
             const std::vector<Mirror_plane>& planes) const
  {
    constexpr int unknown = -2;
    Cut cut;
    cut.plane.assign(part.curves.size(), unknown);
    cut.is_feature.assign(part.curves.size(), 1);
    for(Index h = 0; h < Index(4 * in.quads.size()); ++h) {
      const Index c = part.mesh.curve(h), g = 4 * face[Quad_complex::face(h)] + (h & 3);
      if(c < 0) continue;
      int plane = -1;
      if(part.mesh.is_border(h) && !whole.mesh.is_border(g))
        for(std::size_t i = 0; i < planes.size(); ++i)
          if(planes[i].has_vertex(part.mesh.origin(h)) && planes[i].has_vertex(part.mesh.target(h)))
            plane = int(i);
      const char feature = whole.mesh.curve(g) >= 0;
      if(cut.plane[c] != unknown && (cut.plane[c] != plane || cut.is_feature[c] != feature))
        cut.is_known = false;
      cut.plane[c] = plane;
      cut.is_feature[c] = feature;
    }
    return cut;
  }

private:
  // What is a corner of the whole, or a point where the cut meets the border or another plane,
  // stays where it is.
  void hold_corners(const Adaptation_state& whole, const std::vector<Mirror_plane>& planes)
  {
    for(const Quad& q : in.quads)
      for(Index v : q) {
        int on = 0;
        for(const Mirror_plane& p : planes) on += p.has_vertex(v);
        if(on > 1 || (on == 1 && (whole.mesh.is_border_vertex(v) ||
                                  whole.mesh.vertex(v).carrier == Carrier::corner)))
          in.is_frozen_vertex[v] = 1;
      }
  }
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MIRROR_PART_H
