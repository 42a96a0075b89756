// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_WALK_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_WALK_H

#include <CGAL/Quad_mesh_adaptation/internal/Quad_complex.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// A walk over marked nodes at several places at once, a step at each in turn.  The nodes of one
// step are far from each other, but for a few, so that threads can work on them side by side; the
// order depends on the marks alone.
class Walk
{
public:
  // A new place for every `stretch` nodes, up to `most` places; one place for few nodes.
  Walk(const Quad_complex& m, const std::vector<char>& marks, std::size_t stretch, std::size_t most,
       bool backwards)
  {
    for(Index v = 0; v < m.vertex_end(); ++v)
      if(marks[v] && m.is_vertex(v)) nodes_.push_back(v);
    if(backwards) std::reverse(nodes_.begin(), nodes_.end());
    std::size_t places = nodes_.size() < few ? 1 : nodes_.size() / stretch;
    places = (std::min)((std::max)(places, std::size_t(1)), most);
    steps_ = (nodes_.size() + places - 1) / places;
  }

  std::size_t steps() const { return steps_; }

  // The nodes of a step, in order.
  const std::vector<Index>& step(std::size_t number)
  {
    batch_.clear();
    for(std::size_t i = number; i < nodes_.size(); i += steps_) batch_.push_back(nodes_[i]);
    return batch_;
  }

private:
  static constexpr std::size_t few = 2000; // threads would not pay

  std::vector<Index> nodes_, batch_;
  std::size_t steps_ = 0;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_WALK_H
