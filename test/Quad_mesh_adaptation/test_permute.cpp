// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Lists in another order.

#include <CGAL/Quad_mesh_adaptation/internal/permute.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <vector>

namespace core = CGAL::Quad_mesh_adaptation::internal;
using core::Index;

TEST(Permute, TakesRunsInOrder)
{
  std::vector<Index> list = { 0, 1, 10, 11, 20, 21, 30, 31 };
  core::take_in_order(list, { 3, 0, 2 }, 2, 5, [](Index i) { return i + 100; });
  EXPECT_EQ(list, (std::vector<Index>{ 130, 131, 100, 101, 120, 121 }));
  EXPECT_GE(list.capacity(), 16u);
}

TEST(Permute, MovesToPlaces)
{
  std::mt19937 random(7);
  for(int n = 0; n < 60; ++n) {
    // a third goes
    std::vector<Index> list, place(std::size_t(n), -1), order;
    for(Index i = 0; i < n; ++i) {
      list.push_back(100 + i);
      order.push_back(i);
    }
    std::shuffle(order.begin(), order.end(), random);
    const std::size_t left = order.size() - order.size() / 3;
    std::vector<Index> wanted(left);
    for(std::size_t k = 0; k < left; ++k) {
      place[order[k]] = Index(k);
      wanted[k] = 100 + order[k];
    }
    core::move_to_places(list, place, left);
    EXPECT_EQ(list, wanted) << n;
  }
}
