// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Time and weight of the T-join on the dual of a square grid of quads whose border may be split.
// Usage: bench_t_join [faces per side ...]

#include <CGAL/Quad_mesh_adaptation/internal/t_join.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

using namespace CGAL::Quad_mesh_adaptation::internal;

void run(int side, double odd_share, std::mt19937& random)
{
  std::uniform_real_distribution<double> uniform(0, 1);
  const Index outside = side * side;
  std::vector<T_join_edge> edges;
  std::vector<char> odd(outside + 1, 0);
  std::size_t count = 0;
  for(int y = 0; y < side; ++y)
    for(int x = 0; x < side; ++x) {
      const Index v = y * side + x;
      edges.push_back({ v, x + 1 < side ? v + 1 : outside, uniform(random) });
      edges.push_back({ v, y + 1 < side ? v + side : outside, uniform(random) });
      if(x == 0) edges.push_back({ v, outside, uniform(random) });
      if(y == 0) edges.push_back({ v, outside, uniform(random) });
      odd[v] = uniform(random) < odd_share;
      count += odd[v];
    }
  odd[outside] = count % 2;
  T_join_options forest_only;
  forest_only.exact_limit = forest_only.neighbours = 0;
  const double forest = minimum_weight_t_join(odd.size(), edges, odd, forest_only).weight;
  const auto start = std::chrono::steady_clock::now();
  const double weight = minimum_weight_t_join(odd.size(), edges, odd).weight;
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  std::printf("%9d %9zu %12.2f %12.2f %8.3f\n", side * side, count, forest, weight, time.count());
}

int main(int argc, char** argv)
{
  std::vector<int> sides = { 100, 320, 1000 };
  if(argc > 1) sides.clear();
  for(int i = 1; i < argc; ++i) sides.push_back(std::atoi(argv[i]));
  std::puts("    faces       odd  forest only       T-join  seconds");
  for(int side : sides)
    for(double share : { 1e-4, 1e-3, 1e-2, 0.1, 0.5 }) {
      std::mt19937 random(1);
      if(side > 0 && side <= 10000) run(side, share, random);
    }
}
