// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_T_JOIN_MATCHING_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_T_JOIN_MATCHING_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

/// Partner of each of 2k items in the perfect matching of least total `cost[i][j]` (symmetric,
/// infinite = not allowed; some perfect matching must be allowed).  Exact, by dynamic programming
/// over the subsets: time 2k * 4^k, so for about 2k <= 16.
inline std::vector<Index> exact_matching(const std::vector<std::vector<double>>& cost)
{
  const std::size_t n = cost.size(), full = (std::size_t(1) << n) - 1;
  std::vector<double> best(full + 1, std::numeric_limits<double>::infinity());
  std::vector<signed char> partner(full + 1, -1); // of the lowest item of the subset
  best[0] = 0;
  for(std::size_t set = 1; set <= full; ++set) {
    std::size_t i = 0;
    while(!(set >> i & 1)) ++i;
    for(std::size_t j = i + 1; j < n; ++j) {
      if(!(set >> j & 1)) continue;
      const double c = best[set ^ (std::size_t(1) << i) ^ (std::size_t(1) << j)] + cost[i][j];
      if(c < best[set]) best[set] = c, partner[set] = static_cast<signed char>(j);
    }
  }
  std::vector<Index> mate(n, -1);
  for(std::size_t set = full, i = 0; set != 0; ++i) {
    if(!(set >> i & 1)) continue;
    const Index j = partner[set];
    if(j < 0) break; // no perfect matching is allowed
    mate[i] = j;
    mate[j] = Index(i);
    set ^= (std::size_t(1) << i) | (std::size_t(1) << j);
  }
  return mate;
}

/// A perfect matching of terminals, improved by alternating cycles over a sparse list of allowed
/// pairs: exchanges of partners among up to `max_pairs` pairs that make the matching shorter.  Two
/// rules keep a search short.  A cycle that shortens has a start from which every partial gain is
/// positive (as in Lin and Kernighan's heuristic), so only those are followed; and a terminal is
/// left again only with a larger gain than before.  `max_steps` bounds the work of one search.
class Alternating_cycles
{
public:
  struct Neighbour
  {
    Index terminal;
    double length;
  };
  std::vector<std::vector<Neighbour>> near; ///< allowed pairs, symmetric, by growing length
  std::vector<Index> mate;                  ///< -1: no partner, does not take part
  std::vector<double> mate_length;
  std::vector<char> from_forest; ///< the pair still is the initial one, with its initial path

  Alternating_cycles(std::size_t n, std::size_t max_pairs, std::size_t max_steps)
      : near(n), mate(n, -1), mate_length(n, 0), from_forest(n, 0), m_max_pairs(max_pairs),
        m_max_steps(max_steps), m_used(n, 0), m_reached(n, 0), m_best_gain(n, 0)
  {
  }

  void match(Index a, Index b, double length, bool is_from_forest)
  {
    mate[a] = b;
    mate[b] = a;
    mate_length[a] = mate_length[b] = length;
    from_forest[a] = from_forest[b] = is_from_forest;
  }

  /// Makes `near` symmetric and sorted.
  void prepare()
  {
    std::vector<std::size_t> given(near.size());
    for(std::size_t a = 0; a < near.size(); ++a) given[a] = near[a].size();
    for(std::size_t a = 0; a < near.size(); ++a)
      for(std::size_t i = 0; i < given[a]; ++i) {
        const Neighbour x = near[a][i];
        near[x.terminal].push_back({ Index(a), x.length });
      }
    for(auto& list : near) {
      std::sort(list.begin(), list.end(), [](const Neighbour& x, const Neighbour& y) {
        return x.terminal != y.terminal ? x.terminal < y.terminal : x.length < y.length;
      });
      list.erase(std::unique(list.begin(), list.end(),
                             [](const Neighbour& x, const Neighbour& y) {
                               return x.terminal == y.terminal;
                             }),
                 list.end());
      std::sort(list.begin(), list.end(), [](const Neighbour& x, const Neighbour& y) {
        return x.length != y.length ? x.length < y.length : x.terminal < y.terminal;
      });
    }
    for(std::size_t a = 0; a < near.size(); ++a)
      if(mate[a] >= 0 && length_of_pair(Index(a), mate[a]) <= mate_length[a])
        match(Index(a), mate[a], length_of_pair(Index(a), mate[a]), false);
  }

  void improve()
  {
    std::vector<Index> queue;
    std::vector<char> queued(mate.size(), 0);
    for(std::size_t a = mate.size(); a-- > 0;)
      if(mate[a] >= 0) queue.push_back(Index(a)), queued[a] = 1;
    while(!queue.empty()) {
      const Index a = queue.back();
      queue.pop_back();
      queued[a] = 0;
      if(!find_cycle(a)) continue;
      for(const auto& [b, c] : m_added)
        for(Index x : { b, c })
          if(!queued[x]) queue.push_back(x), queued[x] = 1;
      if(!queued[a]) queue.push_back(a), queued[a] = 1;
    }
  }

private:
  double length_of_pair(Index a, Index b) const
  {
    const auto& list = near[a].size() < near[b].size() ? near[a] : near[b];
    const Index other = &list == &near[a] ? b : a;
    for(const Neighbour& x : list)
      if(x.terminal == other) return x.length;
    return std::numeric_limits<double>::infinity();
  }

  bool find_cycle(Index start)
  {
    m_start = start;
    m_steps = 0;
    ++m_search;
    m_added.clear();
    m_used[start] = m_used[mate[start]] = 1;
    // A gain below the rounding of the sums is none: the loop over cycles must end.
    m_least_gain = 1e-12 * mate_length[start];
    const bool found = mate_length[start] > 0 && extend(mate[start], mate_length[start], 1);
    m_used[start] = m_used[mate[start]] = 0;
    if(!found) return false;
    for(const auto& [a, b] : m_added) match(a, b, length_of_pair(a, b), false);
    return true;
  }

  // `end` has lost its partner, `gain` is what the cycle has won so far.
  bool extend(Index end, double gain, std::size_t pairs)
  {
    for(const Neighbour& x : near[end]) {
      if(x.length >= gain || ++m_steps > m_max_steps) return false;
      const Index c = x.terminal;
      if(m_used[c] || mate[c] < 0) continue;
      const Index d = mate[c];
      const double open_gain = gain - x.length + mate_length[c];
      if(m_reached[d] == m_search && open_gain <= m_best_gain[d]) continue;
      m_reached[d] = m_search;
      m_best_gain[d] = open_gain;
      m_added.emplace_back(end, c);
      if(open_gain - length_of_pair(d, m_start) > m_least_gain + 1e-12 * open_gain) {
        m_added.emplace_back(d, m_start);
        return true;
      }
      if(pairs + 1 < m_max_pairs) {
        m_used[c] = m_used[d] = 1;
        const bool found = extend(d, open_gain, pairs + 1);
        m_used[c] = m_used[d] = 0;
        if(found) return true;
      }
      m_added.pop_back();
    }
    return false;
  }

  std::size_t m_max_pairs, m_max_steps, m_steps = 0;
  std::vector<char> m_used;
  std::size_t m_search = 0;
  std::vector<std::size_t> m_reached; // last search in which the terminal was the open end,
  std::vector<double> m_best_gain;    // and its best gain then
  Index m_start = -1;
  double m_least_gain = 0;
  std::vector<std::pair<Index, Index>> m_added;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_T_JOIN_MATCHING_H
