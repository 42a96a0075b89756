// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_STRAY_CREASES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_STRAY_CREASES_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The turn of the surface across the edge of h, in radians; none on the border.
inline double turn_across(const Adaptation_state& s, Index h)
{
  const Index o = s.mesh.opposite(h);
  if(o < 0) return 0;
  const Vec a = area_vector(s.corners(s.mesh.face(h))), b = area_vector(s.corners(s.mesh.face(o)));
  return std::atan2(norm(cross(a, b)), a * b);
}

// Where a smooth surface is meshed coarsely it turns by much at single edges, and those look like
// creases that end somewhere on the surface.  A detected crease with such a free end is one only if
// it turns much more than the rows of edges beside it; else it is taken back.  Creases beside it
// that have no free end are none of that: two of them may run close to each other along a step.
class Stray_creases
{
public:
  static constexpr double stands_out = 2; // times the turn of the edges beside it, on average

  // `detected`, per half-edge: found by its angle, and nobody asked for it.  Feature edges are
  // those with a curve number.
  Stray_creases(Adaptation_state& s, const std::vector<char>& detected)
      : s_(s), detected_(detected), edges_at_(s.mesh.vertex_end())
  {
    for(Index h = 0; h < 4 * s.mesh.face_end(); ++h)
      if(s.mesh.curve(h) >= 0 && (s.mesh.opposite(h) < 0 || h < s.mesh.opposite(h))) {
        edges_at_[s.mesh.origin(h)].push_back(h);
        edges_at_[s.mesh.target(h)].push_back(h);
      }
  }

  // Takes stray creases back, branch by branch; returns the number of edges.
  std::size_t operator()()
  {
    std::vector<Index> ends;
    for(Index v = 0; v < s_.mesh.vertex_end(); ++v)
      if(is_free_end(v)) ends.push_back(v);
    is_suspect_.assign(4 * std::size_t(s_.mesh.face_end()), 0);
    for(Index v : ends) suspect(branch_from(v));
    std::size_t removed = 0;
    while(!ends.empty()) {
      const Index v = ends.back();
      ends.pop_back();
      if(!is_free_end(v)) continue;
      const std::vector<Index> branch = branch_from(v);
      if(stands_out_from_sides(branch)) continue;
      for(const Index h : branch) {
        remove(h);
        // where branches met there may be a free end now
        for(const Index u : { s_.mesh.origin(h), s_.mesh.target(h) })
          if(is_free_end(u)) {
            ends.push_back(u);
            suspect(branch_from(u));
          }
      }
      removed += branch.size();
    }
    return removed;
  }

private:
  bool is_free_end(Index v) const
  {
    return edges_at_[v].size() == 1 && detected_[edges_at_[v][0]] && !s_.mesh.vertex(v).frozen;
  }

  // The detected edges from a free end to the next node that is not simply passed.
  std::vector<Index> branch_from(Index v) const
  {
    const Quad_complex& m = s_.mesh;
    std::vector<Index> branch = { edges_at_[v][0] };
    for(;;) {
      const Index h = branch.back();
      v = m.origin(h) == v ? m.target(h) : m.origin(h);
      const std::vector<Index>& e = edges_at_[v];
      if(e.size() != 2 || m.vertex(v).frozen) return branch;
      const Index next = e[0] == h ? e[1] : e[0];
      if(!detected_[next]) return branch;
      branch.push_back(next);
    }
  }

  void suspect(const std::vector<Index>& branch)
  {
    for(const Index h : branch) is_suspect_[h] = is_suspect_[s_.mesh.opposite(h)] = 1;
  }

  // Of an edge beside a crease: 0 where it is a crease beyond doubt.
  double turn_beside(Index h) const
  {
    return s_.mesh.curve(h) >= 0 && !is_suspect_[h] ? 0. : turn_across(s_, h);
  }

  // By the means over its length of its own turn and of the larger one of both sides.
  bool stands_out_from_sides(const std::vector<Index>& branch) const
  {
    const auto across = [](Index h) { return Quad_complex::next(Quad_complex::next(h)); };
    double own = 0, beside = 0;
    for(const Index h : branch) {
      const double l = distance(s_.mesh.point(s_.mesh.origin(h)), s_.mesh.point(s_.mesh.target(h)));
      own += l * turn_across(s_, h);
      beside += l * (std::max)(turn_beside(across(h)), turn_beside(across(s_.mesh.opposite(h))));
    }
    return own >= stands_out * beside;
  }

  void remove(Index h)
  {
    for(const Index v : { s_.mesh.origin(h), s_.mesh.target(h) }) {
      std::vector<Index>& e = edges_at_[v];
      e.erase(std::find(e.begin(), e.end(), h));
    }
    s_.mesh.set_curve(h, -1);
  }

  Adaptation_state& s_;
  const std::vector<char>& detected_;
  std::vector<std::vector<Index>> edges_at_; // feature edges, one half-edge of each
  std::vector<char> is_suspect_;             // half-edges of creases with a free end
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_STRAY_CREASES_H
