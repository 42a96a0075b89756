// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LOWER_VALUES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LOWER_VALUES_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Dijkstra's algorithm for values that bound those beside them: from the least on, `spread(value,
// i, lower)` calls `lower(j, bound)` for each of them that is to be lowered.
template <typename Spread>
void lower_values(std::vector<double>& values, const Spread& spread)
{
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  for(Index i = 0; i < Index(values.size()); ++i) queue.emplace(values[i], i);
  const auto lower = [&](Index j, double bound) { queue.emplace(values[j] = bound, j); };
  while(!queue.empty()) {
    const auto [value, i] = queue.top();
    queue.pop();
    if(!(value > values[i])) spread(value, i, lower);
  }
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LOWER_VALUES_H
