// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_OLD_HALFEDGES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_OLD_HALFEDGES_H

#include <CGAL/Quad_mesh_adaptation/internal/Input_mesh.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The caller's half-edges of changed faces of the input, by the vertices of the input where they
// start.
template <typename Halfedge>
class Old_halfedges
{
public:
  struct Entry
  {
    Index target;
    Halfedge halfedge;
  };

  // Room for those of the faces that are marked as changed, to be added then.
  void make_room(const Input_mesh& in, const std::vector<char>& is_changed)
  {
    first_.assign(in.points.size() + 1, 0);
    for(std::size_t f = 0; f < in.quads.size(); ++f)
      if(is_changed[f])
        for(Index u : in.quads[f]) ++first_[u + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    entries_.resize(first_.back());
    next_.assign(first_.begin(), first_.end() - 1);
  }
  void add(Index u, Index v, Halfedge h) { entries_[next_[u]++] = { v, h }; }

  // That from u to v; `none` if there is none.
  Halfedge find(Index u, Index v, Halfedge none) const
  {
    if(u + 1 >= Index(first_.size())) return none;
    for(Index i = first_[u]; i < first_[u + 1]; ++i)
      if(entries_[i].target == v) return entries_[i].halfedge;
    return none;
  }

  // Calls visit(number, u, entry) for all.
  template <typename Visit>
  void for_each(const Visit& visit) const
  {
    for(Index u = 0; u + 1 < Index(first_.size()); ++u)
      for(Index i = first_[u]; i < first_[u + 1]; ++i) visit(i, u, entries_[i]);
  }

  std::size_t size() const { return entries_.size(); }

private:
  std::vector<Index> first_, next_; // by vertex, among the next
  std::vector<Entry> entries_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_OLD_HALFEDGES_H
