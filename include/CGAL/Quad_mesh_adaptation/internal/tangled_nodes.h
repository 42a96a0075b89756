// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TANGLED_NODES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TANGLED_NODES_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// A node that has slid over one of its neighbours turns faces over, and the edges about these look
// like creases.  Where no crease leads to the faces of a node, the node lies in the surface around
// them, and one of them is turned over, the detected creases at these faces are none.
//
// Surface: as of Stray_creases, and with `face` and `next` of half-edges, the `point` of a vertex
// and the `area_vector` of a face.
template <typename Surface>
class Tangled_nodes
{
public:
  // `detected`, per half-edge: found by its angle, whose cosine is given, and nobody asked for it.
  Tangled_nodes(Surface& s, const std::vector<char>& detected, double cosine)
      : s_(s), detected_(detected), cosine_(cosine)
  {
  }

  // Takes them back; returns the number of edges.
  std::size_t operator()()
  {
    std::size_t removed = 0;
    for(Index h = 0; h < s_.halfedge_end(); ++h) {
      if(!is_detected(h) || !gather(h) || !is_tangled(s_.point(s_.origin(h)))) continue;
      for(const std::vector<Index>* edges : { &spokes_, &rim_ })
        for(Index e : *edges)
          if(is_detected(e)) {
            s_.forget(e);
            ++removed;
          }
    }
    return removed;
  }

private:
  bool is_detected(Index h) const { return s_.is_feature(h) && detected_[h]; }
  bool is_given(Index h) const { return s_.is_feature(h) && !detected_[h]; }

  // The faces at the origin of h: their half-edges from it, and those around them, both
  // counter-clockwise.  Not where it lies on the border or on a feature that is given.
  bool gather(Index h)
  {
    const Index v = s_.origin(h);
    spokes_.clear();
    rim_.clear();
    Index spoke = h;
    do {
      if(spoke < 0 || is_given(spoke) || s_.is_held(v)) return false;
      spokes_.push_back(spoke);
      Index e = s_.next(spoke);
      for(; s_.target(e) != v; e = s_.next(e)) rim_.push_back(e);
      spoke = s_.opposite(e);
    } while(spoke != h);
    return true;
  }

  bool is_tangled(const Vec& p) const
  {
    std::vector<Vec> around; // normals of the surface
    Vec up(0, 0, 0);
    for(Index e : rim_) {
      if(s_.opposite(e) < 0 || is_given(e)) continue;
      around.push_back(normalized(s_.area_vector(s_.face(s_.opposite(e)))));
      up = up + around.back();
    }
    up = normalized(up);
    if(around.empty() || is_crossed_by_crease(around, up) || stands_out(p, up)) return false;
    return std::any_of(spokes_.begin(), spokes_.end(),
                       [&](Index spoke) { return s_.area_vector(s_.face(spoke)) * up < 0; });
  }

  // A crease would have to leave the faces somewhere.
  bool is_crossed_by_crease(const std::vector<Vec>& around, const Vec& up) const
  {
    for(std::size_t i = 0; i < around.size(); ++i)
      if(around[i] * up <= 0 || around[i] * around[(i + 1) % around.size()] < cosine_) return true;
    return false;
  }

  // As the tip of a spike does.
  bool stands_out(const Vec& p, const Vec& up) const
  {
    constexpr double clearly = 0.75; // of the edges around; less does not turn faces over
    Vec centre(0, 0, 0);
    double length = 0;
    for(Index e : rim_) {
      centre = centre + s_.point(s_.origin(e));
      length += s_.length(e);
    }
    return std::abs((p - centre / double(rim_.size())) * up) >
           clearly * length / double(rim_.size());
  }

  Surface& s_;
  const std::vector<char>& detected_;
  double cosine_;
  std::vector<Index> spokes_, rim_; // of the node that is looked at
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TANGLED_NODES_H
