// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_STRAY_CREASES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_STRAY_CREASES_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Detected creases that are none.
struct Creases_taken_back
{
  std::size_t creases = 0, edges = 0;
  double turn = 0;          // of the sharpest edge, in radians
  Vec where = Vec(0, 0, 0); // its middle
};

// Where a smooth surface is meshed coarsely it turns by much at single edges, and those look like
// creases that end somewhere on the surface.  A detected crease with such a free end is one only if
// it turns much more than the rows of edges beside it; else it is taken back.  Creases beside it
// that have no free end are none of that: two of them may run close to each other along a step.
//
// Surface: a mesh with the `point` of a vertex, whose half-edges have `origin`, `target`,
// `opposite` (negative on the border), `across` (the one on the other side of the face, negative
// where there is no such), `turn` of the surface across them in radians, and `length`; `is_feature`
// says which are features and `forget` makes an edge none; the vertices that `is_held` says are
// kept whatever meets there.
template <typename Surface>
class Stray_creases
{
public:
  static constexpr double stands_out = 2; // times the turn of the edges beside it, on average

  // `detected`, per half-edge: found by its angle, and nobody asked for it.
  Stray_creases(Surface& s, const std::vector<char>& detected)
      : s_(s), detected_(detected), edges_at_(s.vertex_end())
  {
    for(Index h = 0; h < s.halfedge_end(); ++h)
      if(s.is_feature(h) && (s.opposite(h) < 0 || h < s.opposite(h))) {
        edges_at_[s.origin(h)].push_back(h);
        edges_at_[s.target(h)].push_back(h);
      }
  }

  // Takes stray creases back, branch by branch.
  Creases_taken_back operator()()
  {
    std::vector<Index> ends;
    for(Index v = 0; v < Index(edges_at_.size()); ++v)
      if(is_free_end(v)) ends.push_back(v);
    is_suspect_.assign(std::size_t(s_.halfedge_end()), 0);
    for(Index v : ends) suspect(branch_from(v));
    Creases_taken_back removed;
    while(!ends.empty()) {
      const Index v = ends.back();
      ends.pop_back();
      if(!is_free_end(v)) continue;
      const std::vector<Index> branch = branch_from(v);
      if(stands_out_from_sides(branch)) continue;
      ++removed.creases;
      for(const Index h : branch) {
        note(h, removed);
        remove(h);
        // where branches met there may be a free end now
        for(const Index u : { s_.origin(h), s_.target(h) })
          if(is_free_end(u)) {
            ends.push_back(u);
            suspect(branch_from(u));
          }
      }
    }
    return removed;
  }

private:
  bool is_free_end(Index v) const
  {
    return edges_at_[v].size() == 1 && detected_[edges_at_[v][0]] && !s_.is_held(v);
  }

  // The detected edges from a free end to the next node that is not simply passed.
  std::vector<Index> branch_from(Index v) const
  {
    std::vector<Index> branch = { edges_at_[v][0] };
    for(;;) {
      const Index h = branch.back();
      v = s_.origin(h) == v ? s_.target(h) : s_.origin(h);
      const std::vector<Index>& e = edges_at_[v];
      if(e.size() != 2 || s_.is_held(v)) return branch;
      const Index next = e[0] == h ? e[1] : e[0];
      if(!detected_[next]) return branch;
      branch.push_back(next);
    }
  }

  void suspect(const std::vector<Index>& branch)
  {
    for(const Index h : branch) is_suspect_[h] = is_suspect_[s_.opposite(h)] = 1;
  }

  // Of an edge beside a crease: 0 where there is none or it is a crease beyond doubt.
  double turn_beside(Index h) const
  {
    return h < 0 || (s_.is_feature(h) && !is_suspect_[h]) ? 0. : s_.turn(h);
  }

  // By the means over its length of its own turn and of the larger one of both sides.
  bool stands_out_from_sides(const std::vector<Index>& branch) const
  {
    double own = 0, beside = 0;
    for(const Index h : branch) {
      const double l = s_.length(h);
      own += l * s_.turn(h);
      beside += l * (std::max)(turn_beside(s_.across(h)), turn_beside(s_.across(s_.opposite(h))));
    }
    return own >= stands_out * beside;
  }

  void note(Index h, Creases_taken_back& removed) const
  {
    ++removed.edges;
    const double turn = s_.turn(h);
    if(!(turn > removed.turn)) return;
    removed.turn = turn;
    removed.where = 0.5 * (s_.point(s_.origin(h)) + s_.point(s_.target(h)));
  }

  void remove(Index h)
  {
    for(const Index v : { s_.origin(h), s_.target(h) }) {
      std::vector<Index>& e = edges_at_[v];
      e.erase(std::find(e.begin(), e.end(), h));
    }
    s_.forget(h);
  }

  Surface& s_;
  const std::vector<char>& detected_;
  std::vector<std::vector<Index>> edges_at_; // feature edges, one half-edge of each
  std::vector<char> is_suspect_;             // half-edges of creases with a free end
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_STRAY_CREASES_H
