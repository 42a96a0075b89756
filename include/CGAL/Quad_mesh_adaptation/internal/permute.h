// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PERMUTE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PERMUTE_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Lists of a mesh take most of its memory: they are put in another order one after the other, and
// the longest in place.

// Of runs of `length` values those of `order`, changed by `value`, with room for some more runs.
template <typename Value>
void take_in_order(std::vector<Index>& list, const std::vector<Index>& order, std::size_t length,
                   std::size_t spare, const Value& value)
{
  std::vector<Index> result;
  result.reserve(length * (order.size() + spare));
  for(Index i : order)
    for(std::size_t k = 0; k < length; ++k) result.push_back(value(list[length * i + k]));
  list = std::move(result);
}

// Moves value i to place[i]; those with negative places go, and `n` are left.  Gives memory back
// where much is not needed any more.  Uses `place` up.
template <typename T>
void move_to_places(std::vector<T>& list, std::vector<Index>& place, std::size_t n)
{
  for(std::size_t i = 0; i < list.size(); ++i)
    while(place[i] >= 0 && place[i] != Index(i)) {
      const std::size_t to = std::size_t(place[i]);
      std::swap(list[i], list[to]);
      std::swap(place[i], place[to]);
    }
  list.resize(n);
  if(list.capacity() <= 3 * n) return;
  std::vector<T> result;
  result.reserve(n + n / 16);
  result.assign(list.begin(), list.end());
  list = std::move(result);
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PERMUTE_H
