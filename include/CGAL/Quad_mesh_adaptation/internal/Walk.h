// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_WALK_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_WALK_H

#include <CGAL/Quad_mesh_adaptation/internal/Quad_complex.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Ways to choose among equals: 0 leaves a list as it is, 1 turns it round, others mix it, each in
// its own way, which is the same with every compiler.
template <typename T>
void put_in_order(std::vector<T>& list, int order)
{
  if(order == 1) std::reverse(list.begin(), list.end());
  if(order <= 1) return;
  std::mt19937 random{ std::uint32_t(order) };
  for(std::size_t i = list.size(); i > 1; --i) std::swap(list[i - 1], list[random() % i]);
}

// A walk over marked nodes at several places at once, a step at each in turn.  A step takes one
// node at each place, or a run of some that follow each other.  The nodes of different runs of one
// step are far from each other, but for a few, so that threads can work on them side by side; the
// order depends on the marks and on the choice of one alone.
class Walk
{
public:
  // A new place for every `stretch` nodes, up to `most` places; one place for few nodes.
  Walk(const Quad_complex& m, const std::vector<char>& marks, std::size_t stretch, std::size_t most,
       int order, std::size_t run = 1)
      : run_(run)
  {
    list_nodes(m, marks);
    put_in_order(nodes_, order);
    std::size_t places = nodes_.size() < few ? 1 : nodes_.size() / stretch;
    places = (std::min)((std::max)(places, std::size_t(1)), most);
    steps_ = (nodes_.size() + places * run_ - 1) / (places * run_);
  }

  std::size_t steps() const { return steps_; }

  // The nodes of a step, in order; all runs but the last have their full length.
  const std::vector<Index>& step(std::size_t number)
  {
    batch_.clear();
    for(std::size_t i = number * run_; i < nodes_.size(); i += steps_ * run_)
      batch_.insert(batch_.end(), nodes_.begin() + std::ptrdiff_t(i),
                    nodes_.begin() + std::ptrdiff_t((std::min)(i + run_, nodes_.size())));
    return batch_;
  }

private:
  // Often few are marked in a large mesh: eight that are not are passed over at once.
  void list_nodes(const Quad_complex& m, const std::vector<char>& marks)
  {
    for(Index v = 0, end = m.vertex_end(); v < end;) {
      std::uint64_t eight = 1;
      if(!marks[v] && v + 8 <= end) std::memcpy(&eight, marks.data() + v, 8);
      if(marks[v] && m.is_vertex(v)) nodes_.push_back(v);
      v += eight == 0 ? 8 : 1;
    }
  }

  static constexpr std::size_t few = 2000; // threads would not pay

  std::vector<Index> nodes_, batch_;
  std::size_t run_, steps_ = 0;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_WALK_H
