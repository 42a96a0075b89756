// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHANGED_NODES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHANGED_NODES_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// About which nodes a search for operations may come to another result than before some were
// committed.  What a search reads lies within three rings of faces of its node; the check that a
// closed curve keeps four edges follows the curve further.
class Changed_nodes
{
public:
  explicit Changed_nodes(const Adaptation_state& s) : s_(s) {}

  bool has(Index v) const { return v < Index(marked_.size()) && marked_[v]; }

  // The nodes of an operation that are left after it.
  void add(const std::vector<Index>& nodes)
  {
    int rings = 4;
    front_.clear();
    ++time_;
    reached_at_.resize(s_.mesh.vertex_end(), 0);
    marked_.resize(s_.mesh.vertex_end(), 0);
    for(Index v : nodes) {
      const Vertex_record& r = s_.mesh.vertex(v);
      if(r.carrier == Carrier::curve && s_.curves[r.curve].is_closed()) rings = 12;
      reach(v);
    }
    for(std::size_t k = 0, end = front_.size(); rings > 0; --rings, end = front_.size())
      for(; k < end; ++k) reach_around(front_[k]);
  }

  void clear()
  {
    for(Index v : all_) marked_[v] = 0;
    all_.clear();
  }

private:
  void reach(Index v)
  {
    if(reached_at_[v] == time_) return;
    reached_at_[v] = time_;
    front_.push_back(v);
    if(marked_[v]) return;
    marked_[v] = 1;
    all_.push_back(v);
  }

  void reach_around(Index v)
  {
    for(Index h : s_.mesh.outgoing(v))
      for(Index u : s_.mesh.quad(s_.mesh.face(h))) reach(u);
  }

  const Adaptation_state& s_;
  std::vector<char> marked_;
  std::vector<Index> all_;           // that are marked
  std::vector<Index> front_;         // reached from the operation in hand, in order
  std::vector<unsigned> reached_at_; // when a node was last reached
  unsigned time_ = 0;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHANGED_NODES_H
