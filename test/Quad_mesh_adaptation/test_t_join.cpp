// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quad_mesh_adaptation/internal/t_join.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

using CGAL::Quad_mesh_adaptation::internal::Index;
using CGAL::Quad_mesh_adaptation::internal::minimum_weight_t_join;
using CGAL::Quad_mesh_adaptation::internal::T_join;
using CGAL::Quad_mesh_adaptation::internal::T_join_edge;
using CGAL::Quad_mesh_adaptation::internal::T_join_options;

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Problem
{
  std::size_t n = 0;
  std::vector<T_join_edge> edges;
  std::vector<char> odd;
};

std::vector<char> odd_vertices_of(const Problem& p, const std::vector<char>& join)
{
  std::vector<char> odd(p.n, 0);
  for(std::size_t i = 0; i < join.size(); ++i)
    if(join[i]) odd[p.edges[i].u] ^= 1, odd[p.edges[i].v] ^= 1;
  return odd;
}

void expect_join(const Problem& p, const T_join& j)
{
  ASSERT_TRUE(j.is_feasible);
  ASSERT_EQ(j.in_join.size(), p.edges.size());
  EXPECT_EQ(odd_vertices_of(p, j.in_join), p.odd);
  double weight = 0;
  for(std::size_t i = 0; i < p.edges.size(); ++i)
    if(j.in_join[i]) {
      EXPECT_NE(p.edges[i].u, p.edges[i].v) << "a loop is in the join";
      EXPECT_TRUE(std::isfinite(p.edges[i].weight)) << "a forbidden edge is in the join";
      weight += p.edges[i].weight;
    }
  EXPECT_DOUBLE_EQ(weight, j.weight);
}

// Weight of the best join over all subsets of edges, infinite when there is none.
double brute_force(const Problem& p)
{
  std::vector<T_join_edge> usable;
  for(const T_join_edge& e : p.edges)
    if(e.u != e.v && std::isfinite(e.weight)) usable.push_back(e);
  std::size_t wrong = 0; // vertices with the wrong parity
  std::vector<char> parity(p.odd);
  for(char c : parity) wrong += c;
  double best = wrong == 0 ? 0 : infinity;
  std::vector<char> in(usable.size(), 0);
  // Gray code: from one subset to the next one edge changes.
  for(std::size_t k = 1; k < (std::size_t(1) << usable.size()); ++k) {
    std::size_t bit = 0;
    while(!(k >> bit & 1)) ++bit;
    in[bit] ^= 1;
    for(Index v : { usable[bit].u, usable[bit].v }) parity[v] ^= 1, parity[v] ? ++wrong : --wrong;
    if(wrong != 0) continue;
    double weight = 0;
    for(std::size_t i = 0; i < in.size(); ++i)
      if(in[i]) weight += usable[i].weight;
    best = (std::min)(best, weight);
  }
  return best;
}

// Few distinct weights make many ties; loops, parallel, free and forbidden edges all occur.
Problem random_problem(std::mt19937& random, std::size_t max_edges)
{
  Problem p;
  p.n = 2 + random() % 9;
  const std::size_t m = 1 + random() % max_edges;
  const bool has_ties = random() % 2;
  for(std::size_t i = 0; i < m; ++i) {
    const double w = has_ties ? double(random() % 4) : 1e-3 * double(random() % 5000);
    p.edges.push_back(
        { Index(random() % p.n), Index(random() % p.n), random() % 16 ? w : infinity });
  }
  for(std::size_t v = 0; v < p.n; ++v) p.odd.push_back(random() % 2);
  return p;
}

Problem grid(std::size_t columns, std::size_t rows, double odd_share, std::mt19937& random)
{
  Problem p;
  p.n = columns * rows;
  std::uniform_real_distribution<double> weight(0, 1);
  for(std::size_t y = 0; y < rows; ++y)
    for(std::size_t x = 0; x < columns; ++x) {
      const Index v = Index(y * columns + x);
      if(x + 1 < columns) p.edges.push_back({ v, v + 1, weight(random) });
      if(y + 1 < rows) p.edges.push_back({ v, Index(v + columns), weight(random) });
    }
  std::size_t count = 0;
  for(std::size_t v = 0; v < p.n; ++v) {
    p.odd.push_back(weight(random) < odd_share);
    count += p.odd.back();
  }
  if(count % 2 == 1) p.odd[0] ^= 1;
  return p;
}

unsigned seed()
{
  const char* given = std::getenv("TEST_SEED");
  return given ? unsigned(std::stoul(given)) : 20090u;
}

} // namespace

TEST(T_join, Empty)
{
  EXPECT_TRUE(minimum_weight_t_join(0, {}, {}).is_feasible);
  const T_join j = minimum_weight_t_join(2, { { 0, 1, 1. } }, { 0, 0 });
  EXPECT_TRUE(j.is_feasible);
  EXPECT_EQ(j.in_join, std::vector<char>{ 0 });
}

TEST(T_join, ParallelEdgesTheLightestIsTaken)
{
  const Problem p{ 2, { { 0, 1, 3. }, { 0, 0, 0. }, { 1, 0, 1. }, { 0, 1, 1. } }, { 1, 1 } };
  const T_join j = minimum_weight_t_join(p.n, p.edges, p.odd);
  expect_join(p, j);
  EXPECT_EQ(j.in_join, (std::vector<char>{ 0, 0, 1, 0 }));
}

TEST(T_join, InfeasibleComponentsAreNamed)
{
  // 0-1-2 holds three odd vertices, 3-4 two, 5 is alone; 6-7 are parted by a forbidden edge.
  const Problem p{ 8,
                   { { 0, 1, 1. }, { 1, 2, 1. }, { 3, 4, 1. }, { 6, 7, infinity } },
                   { 1, 1, 1, 1, 1, 1, 1, 1 } };
  const T_join j = minimum_weight_t_join(p.n, p.edges, p.odd);
  EXPECT_FALSE(j.is_feasible);
  EXPECT_EQ(j.obstructions, (std::vector<std::vector<Index>>{ { 0, 1, 2 }, { 5 }, { 6 }, { 7 } }));
  EXPECT_EQ(j.in_join, std::vector<char>(4, 0));
}

TEST(T_join, AgreesWithBruteForce)
{
  std::mt19937 random(seed());
  std::size_t feasible = 0;
  for(int round = 0; round < 4000; ++round) {
    SCOPED_TRACE("seed " + std::to_string(seed()) + ", round " + std::to_string(round));
    const Problem p = random_problem(random, 16);
    const double best = brute_force(p);
    const T_join j = minimum_weight_t_join(p.n, p.edges, p.odd);
    ASSERT_EQ(j.is_feasible, std::isfinite(best));
    if(!j.is_feasible) continue;
    ++feasible;
    expect_join(p, j);
    EXPECT_NEAR(j.weight, best, 1e-9);
  }
  EXPECT_GT(feasible, 200u);
}

TEST(T_join, HeuristicIsCloseToBruteForce)
{
  std::mt19937 random(seed() + 1);
  T_join_options options;
  options.exact_limit = 0;
  options.neighbours = 3;
  options.cycle_pairs = 2;
  double sum = 0, sum_of_best = 0;
  for(int round = 0; round < 4000; ++round) {
    SCOPED_TRACE("seed " + std::to_string(seed() + 1) + ", round " + std::to_string(round));
    const Problem p = random_problem(random, 16);
    const double best = brute_force(p);
    const T_join j = minimum_weight_t_join(p.n, p.edges, p.odd, options);
    ASSERT_EQ(j.is_feasible, std::isfinite(best));
    if(!j.is_feasible) continue;
    expect_join(p, j);
    EXPECT_LE(j.weight, 2 * best + 1e-9);
    sum += j.weight;
    sum_of_best += best;
  }
  EXPECT_LE(sum, 1.02 * sum_of_best);
}

// With 16 odd vertices the exact solver and the heuristic can be compared on larger graphs.
TEST(T_join, HeuristicIsCloseToExactOnGrids)
{
  std::mt19937 random(seed() + 2);
  double sum = 0, sum_of_best = 0;
  for(int round = 0; round < 60; ++round) {
    SCOPED_TRACE("seed " + std::to_string(seed() + 2) + ", round " + std::to_string(round));
    Problem p = grid(12, 12, 0, random);
    for(std::size_t count = 0; count < 16;) {
      char& odd = p.odd[random() % p.n];
      count += !odd;
      odd = 1;
    }
    T_join_options exact, heuristic;
    exact.exact_limit = 16;
    heuristic.exact_limit = 0;
    const T_join a = minimum_weight_t_join(p.n, p.edges, p.odd, exact);
    const T_join b = minimum_weight_t_join(p.n, p.edges, p.odd, heuristic);
    expect_join(p, a);
    expect_join(p, b);
    EXPECT_GE(b.weight, a.weight - 1e-9);
    sum += b.weight;
    sum_of_best += a.weight;
  }
  EXPECT_LE(sum, 1.002 * sum_of_best);
}

TEST(T_join, LargeGrids)
{
  for(double share : { 0.0003, 0.01, 0.5 }) {
    std::mt19937 random(seed() + 3);
    const std::size_t side = share > 0.1 ? 160 : 320;
    const Problem p = grid(side, side, share, random);
    const T_join j = minimum_weight_t_join(p.n, p.edges, p.odd);
    expect_join(p, j);
    // The spanning forest alone, without exchange of partners, is about 10 % heavier.
    T_join_options forest;
    forest.exact_limit = forest.neighbours = 0;
    const T_join first = minimum_weight_t_join(p.n, p.edges, p.odd, forest);
    expect_join(p, first);
    EXPECT_LE(j.weight, (share < 0.01 ? 1 : 0.95) * first.weight);
    EXPECT_EQ(minimum_weight_t_join(p.n, p.edges, p.odd).in_join, j.in_join);
  }
}

// The dual of a mesh with an open boundary: one vertex next to all boundary faces, equal weights.
TEST(T_join, OuterVertexAndTies)
{
  std::mt19937 random(seed() + 4);
  Problem p = grid(100, 100, 0.2, random);
  for(T_join_edge& e : p.edges) e.weight = 1;
  for(std::size_t i = 0; i < 100; ++i)
    for(std::size_t v : { i, 9900 + i, 100 * i, 100 * i + 99 })
      p.edges.push_back({ Index(v), Index(p.n), 1. });
  ++p.n;
  p.odd.push_back(1);
  p.odd[4950] ^= 1;
  expect_join(p, minimum_weight_t_join(p.n, p.edges, p.odd));
}
