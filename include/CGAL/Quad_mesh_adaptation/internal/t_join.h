// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_T_JOIN_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_T_JOIN_H

#include <CGAL/Quad_mesh_adaptation/internal/Disjoint_sets.h>
#include <CGAL/Quad_mesh_adaptation/internal/t_join_forest.h>
#include <CGAL/Quad_mesh_adaptation/internal/t_join_graph.h>
#include <CGAL/Quad_mesh_adaptation/internal/t_join_matching.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

/// How hard to look; with the defaults grids of some thousand vertices came out within 0.4 % of the
/// exact optimum.
struct T_join_options
{
  std::size_t exact_limit = 14; ///< components with at most so many odd vertices are solved exactly
  std::size_t neighbours = 10;  ///< elsewhere, nearest odd vertices that are allowed as partners
  double reach = 2;             ///< partners are looked for within so many ways to the first one
  std::size_t cycle_pairs = 30; ///< longest exchange of partners, in pairs
  std::size_t cycle_steps = 10000; ///< work allowed to one search for an exchange
};

struct T_join
{
  bool is_feasible = true;
  /// Per edge, 1 when it is in the join; all 0 when there is none.
  std::vector<char> in_join;
  double weight = 0;
  /// Where no join exists: for each connected component that holds an odd number of odd vertices
  /// (by its lowest vertex), those vertices, ascending.
  std::vector<std::vector<Index>> obstructions;
};

/// Turns the odd vertices of a graph into a lightest, or nearly lightest, set of edges in which
/// exactly those vertices have odd degree.  Source: Edmonds and Johnson's reduction to matching,
/// here with a near-linear heuristic instead of the exact matching.
class T_join_solver
{
public:
  T_join_solver(std::size_t n, const std::vector<T_join_edge>& edges, const std::vector<char>& odd,
                const T_join_options& options)
      : m_edges(edges), m_options(options), m_graph(n, edges), m_component(n), m_paths(m_graph),
        m_terminal_of(n, -1), m_forest(m_graph, edges, m_terminals, m_terminal_of, m_paths)
  {
    for(const T_join_edge& e : edges)
      if(T_join_graph::is_usable(e, n)) m_component.unite(e.u, e.v);
    for(std::size_t v = 0; v < (std::min)(n, odd.size()); ++v)
      if(odd[v]) {
        m_terminal_of[v] = Index(m_terminals.size());
        m_terminals.push_back(Index(v));
      }
  }

  T_join solve()
  {
    T_join result;
    result.in_join.assign(m_edges.size(), 0);
    const std::vector<std::vector<Index>> groups = terminals_by_component();
    for(const auto& group : groups)
      if(group.size() % 2 == 1) result.obstructions.push_back(vertices_of(group));
    result.is_feasible = result.obstructions.empty();
    if(!result.is_feasible || m_terminals.empty()) return result;

    m_forest.grow();
    Alternating_cycles matching(m_terminals.size(), m_options.cycle_pairs, m_options.cycle_steps);
    m_forest.match(matching);
    const std::vector<char> first = join_of(matching);
    for(const auto& group : groups)
      if(group.size() <= m_options.exact_limit)
        match_exactly(group, matching);
      else
        list_neighbours(group, matching);
    matching.prepare();
    matching.improve();
    result.in_join = join_of(matching);
    // The paths of the first matching may have shared edges that cancelled.
    if(weight_of(first) < weight_of(result.in_join)) result.in_join = first;
    result.weight = weight_of(result.in_join);
    return result;
  }

private:
  std::vector<std::vector<Index>> terminals_by_component()
  {
    std::vector<Index> group_of(m_graph.number_of_vertices(), -1);
    std::vector<std::vector<Index>> groups;
    for(std::size_t v = 0; v < m_terminal_of.size(); ++v) {
      if(m_terminal_of[v] < 0) continue;
      Index& g = group_of[m_component.find(Index(v))];
      if(g < 0) {
        g = Index(groups.size());
        groups.emplace_back();
      }
      groups[g].push_back(m_terminal_of[v]);
    }
    return groups;
  }

  std::vector<Index> vertices_of(const std::vector<Index>& terminals) const
  {
    std::vector<Index> vertices;
    for(Index t : terminals) vertices.push_back(m_terminals[t]);
    return vertices;
  }

  void match_exactly(const std::vector<Index>& group, Alternating_cycles& matching)
  {
    double bound = 0; // no pair of an optimal matching is longer than all of the one known
    for(Index t : group) bound += matching.mate_length[t] / 2;
    bound *= 1 + 1e-9;
    std::vector<std::vector<double>> cost(group.size(),
                                          std::vector<double>(group.size(), infinity()));
    for(std::size_t i = 0; i < group.size(); ++i) {
      std::size_t missing = group.size();
      m_paths.run(std::array<Index, 1>{ m_terminals[group[i]] }, bound, std::size_t(-1),
                  [&](Index v) { return m_terminal_of[v] < 0 || --missing > 0; });
      for(std::size_t j = i + 1; j < group.size(); ++j)
        if(m_paths.is_reached(m_terminals[group[j]]))
          cost[i][j] = cost[j][i] = m_paths.distance(m_terminals[group[j]]);
    }
    const std::vector<Index> mate = exact_matching(cost);
    for(std::size_t i = 0; i < group.size(); ++i)
      if(mate[i] > Index(i)) matching.match(group[i], group[mate[i]], cost[i][mate[i]], false);
  }

  void list_neighbours(const std::vector<Index>& group, Alternating_cycles& matching)
  {
    // On average a search sees `neighbours` times the arcs of a cell; the budget stops those that
    // would see most of the graph, for instance through the vertex that stands for the outside.
    const std::size_t budget =
        64 + 8 * m_options.neighbours * (m_graph.number_of_arcs() / m_terminals.size() + 1);
    for(Index t : group) {
      const double radius = m_options.reach * matching.mate_length[t];
      m_paths.run(std::array<Index, 1>{ m_terminals[t] }, radius, budget, [&](Index v) {
        const Index other = m_terminal_of[v];
        if(other >= 0 && other != t) matching.near[t].push_back({ other, m_paths.distance(v) });
        return matching.near[t].size() < m_options.neighbours;
      });
    }
  }

  std::vector<char> join_of(const Alternating_cycles& matching)
  {
    std::vector<char> join(m_edges.size(), 0);
    std::vector<char> to_terminal(m_graph.number_of_vertices(), 0); // use the path out of the cell
    for(std::size_t t = 0; t < m_terminals.size(); ++t) {
      const Index other = matching.mate[t];
      if(other < Index(t)) continue;
      if(matching.from_forest[t])
        m_forest.add_path(Index(t), other, join, to_terminal);
      else
        add_shortest_path(Index(t), other, join);
    }
    m_forest.add_ways_to_terminals(join, to_terminal);
    return join;
  }

  void add_shortest_path(Index a, Index b, std::vector<char>& join)
  {
    const Index target = m_terminals[b];
    m_paths.run(std::array<Index, 1>{ m_terminals[a] }, infinity(), std::size_t(-1),
                [&](Index v) { return v != target; });
    for(Index v = target; m_paths.parent(v) >= 0; v = m_paths.parent(v))
      join[m_paths.parent_edge(v)] ^= 1;
  }

  double weight_of(const std::vector<char>& join) const
  {
    double w = 0;
    for(std::size_t i = 0; i < join.size(); ++i)
      if(join[i]) w += m_edges[i].weight;
    return w;
  }
  static double infinity() { return std::numeric_limits<double>::infinity(); }

  const std::vector<T_join_edge>& m_edges;
  T_join_options m_options;
  T_join_graph m_graph;
  Disjoint_sets m_component;
  Shortest_paths m_paths;
  std::vector<Index> m_terminals, m_terminal_of; // the odd vertices and their numbers
  Terminal_forest m_forest;
};

/// A set of edges in which exactly the vertices with `odd[v] != 0` have odd degree, of least weight
/// in connected components with few odd vertices (`options.exact_limit`) and of nearly least weight
/// in the others.  Loops, and edges whose weight is not a finite number >= 0, are never used;
/// multiple edges are welcome.  Where no such set exists nothing is forced: the answer says so.
/// Deterministic.  Time about O(m log n), `m` the number of edges and `n` that of vertices.
inline T_join minimum_weight_t_join(std::size_t n, const std::vector<T_join_edge>& edges,
                                    const std::vector<char>& odd,
                                    const T_join_options& options = T_join_options())
{
  return T_join_solver(n, edges, odd, options).solve();
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_T_JOIN_H
