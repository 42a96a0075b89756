// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MERGED_NODES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MERGED_NODES_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/merged_position.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/merge_nodes.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The nodes as they are to be when chosen rows of faces are gone: the ends of each rung are one.
// The mesh stays as it is meanwhile.
class Merged_nodes
{
public:
  explicit Merged_nodes(const Adaptation_state& s) : s_(s) {}

  // The ends of all rungs that a set of rows has chosen.
  template <typename Row_set>
  void merge(const Row_set& rows)
  {
    const Quad_complex& m = s_.mesh;
    image_.resize(m.vertex_end());
    for(Index v = 0; v < m.vertex_end(); ++v) image_[v] = v;
    merged_.clear();
    rows.for_each_chosen_rung([&](Index h) {
      const Index a = root(m.origin(h)), b = root(m.target(h));
      if(a == b) return;
      const bool a_wins = carrier_rank(m.vertex(a)) >= carrier_rank(m.vertex(b));
      image_[a_wins ? b : a] = a_wins ? a : b;
    });
    for(Index v = 0; v < m.vertex_end(); ++v)
      if(image_[v] != v) {
        image_[v] = root(v);
        merged_.push_back({ image_[v], v });
      }
    std::stable_sort(merged_.begin(), merged_.end());
    place_merged();
  }

  // The node that v becomes one with, itself where that is none.
  Index image(Index v) const { return image_[v]; }

  // Does v stand for others as well?
  bool is_merged(Index v) const { return node_of_[v] >= 0; }

  // What becomes of v.
  const Vertex_record& node(Index v) const
  {
    const Index n = node_of_[image_[v]];
    return n >= 0 ? nodes_[n] : s_.mesh.vertex(v);
  }

private:
  Index root(Index v) const
  {
    while(image_[v] != v) v = image_[v];
    return v;
  }

  void place_merged()
  {
    const Quad_complex& m = s_.mesh;
    nodes_.clear();
    node_of_.assign(m.vertex_end(), -1);
    for(std::size_t i = 0, end = 0; i < merged_.size(); i = end) {
      const Index v = merged_[i].first;
      members_.assign(1, v);
      for(end = i; end < merged_.size() && merged_[end].first == v; ++end)
        if(carrier_rank(m.vertex(merged_[end].second)) == carrier_rank(m.vertex(v)))
          members_.push_back(merged_[end].second);
      node_of_[v] = Index(nodes_.size());
      nodes_.push_back(merged_node());
    }
  }

  // One for those of the nodes that are as little free to move as the one that stays.
  Vertex_record merged_node() const
  {
    Vertex_record w = s_.mesh.vertex(members_[0]);
    if(members_.size() == 1 || carrier_rank(w) > 1) return w;
    if(w.carrier == Carrier::curve) {
      const Feature_curve& c = s_.curves[w.curve];
      double arcs = 0;
      for(Index v : members_) arcs += c.difference(w.param, s_.mesh.vertex(v).param);
      w.param += arcs / double(members_.size());
    } else {
      w.p = merged_position(s_, members_);
    }
    s_.place(w);
    return w;
  }

  const Adaptation_state& s_;
  std::vector<Index> image_;
  std::vector<std::pair<Index, Index>> merged_; // the one that stays, one that goes
  std::vector<Index> members_;                  // of what becomes one node
  std::vector<Vertex_record> nodes_;            // as they will be
  std::vector<Index> node_of_;                  // by vertex, -1 where none is merged
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MERGED_NODES_H
