// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_T_JOIN_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_T_JOIN_H

#include <CGAL/Quad_mesh_adaptation/internal/t_join_graph.h>
#include <CGAL/Quad_mesh_adaptation/internal/t_join_matching.h>

#include <algorithm>
#include <array>
#include <cmath>
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
        m_terminal_of(n, -1), m_cell(n, -1)
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

    grow_cells();
    Alternating_cycles matching(m_terminals.size(), m_options.cycle_pairs, m_options.cycle_steps);
    match_along_forest(matching);
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
  struct Bridge // a graph edge from the cell of one terminal to that of another
  {
    double length; // of the path between the terminals through it
    Index edge;
    bool operator<(const Bridge& b) const
    {
      return length != b.length ? length < b.length : edge < b.edge;
    }
  };

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

  // Mostly each terminal has a partner near by.  So the cells grow no further than needed for each
  // tree over them to hold an even number of terminals, and the rest of the graph is not visited.
  void grow_cells()
  {
    double radius = 0;
    for(Index t : m_terminals) {
      double lightest = infinity();
      for(const auto& a : m_graph.arcs(t)) lightest = (std::min)(lightest, a.weight);
      if(std::isfinite(lightest)) radius = (std::max)(radius, lightest);
    }
    for(int attempt = 0; attempt < 5; ++attempt, radius *= 2) {
      make_cells(radius);
      span_terminals();
      if(are_trees_even()) return;
    }
    make_cells(infinity());
    span_terminals();
  }

  bool are_trees_even() const
  {
    std::vector<char> odd(m_terminals.size(), 1);
    for(auto it = m_order.rbegin(); it != m_order.rend(); ++it) {
      const Index up = m_up[*it];
      if(up >= 0)
        odd[up] ^= odd[*it];
      else if(odd[*it])
        return false;
    }
    return true;
  }

  // Nearest terminal of every vertex within the radius of one, and the path to it.
  void make_cells(double radius)
  {
    const std::size_t n = m_graph.number_of_vertices();
    m_cell.assign(n, -1);
    m_cell_edge.assign(n, -1);
    m_cell_parent.assign(n, -1);
    m_cell_distance.assign(n, 0);
    m_cell_order.clear();
    m_paths.run(m_terminals, radius, std::size_t(-1), [&](Index v) {
      const Index p = m_paths.parent(v);
      m_cell[v] = p < 0 ? m_terminal_of[v] : m_cell[p];
      m_cell_edge[v] = m_paths.parent_edge(v);
      m_cell_parent[v] = p;
      m_cell_distance[v] = m_paths.distance(v);
      m_cell_order.push_back(v);
      return true;
    });
  }

  // Shortest spanning forest of the terminals over the bridges (Kruskal), then rooted.
  void span_terminals()
  {
    std::vector<Bridge> bridges;
    for(std::size_t i = 0; i < m_edges.size(); ++i) {
      const T_join_edge& e = m_edges[i];
      if(!T_join_graph::is_usable(e, m_cell.size()) || m_cell[e.u] == m_cell[e.v]) continue;
      if(m_cell[e.u] < 0 || m_cell[e.v] < 0) continue;
      bridges.push_back({ m_cell_distance[e.u] + e.weight + m_cell_distance[e.v], Index(i) });
    }
    std::sort(bridges.begin(), bridges.end());
    Disjoint_sets sets(m_terminals.size());
    std::vector<std::vector<std::pair<Index, Bridge>>> tree(m_terminals.size());
    for(const Bridge& b : bridges) {
      const Index x = m_cell[m_edges[b.edge].u], y = m_cell[m_edges[b.edge].v];
      if(!sets.unite(x, y)) continue;
      tree[x].emplace_back(y, b);
      tree[y].emplace_back(x, b);
    }
    m_up.assign(m_terminals.size(), -1);
    m_up_bridge.assign(m_terminals.size(), Bridge{ 0, -1 });
    m_depth.assign(m_terminals.size(), -1);
    m_order.clear();
    for(std::size_t root = 0; root < m_terminals.size(); ++root) {
      if(m_depth[root] >= 0) continue;
      m_depth[root] = 0;
      std::size_t next = m_order.size();
      for(m_order.push_back(Index(root)); next < m_order.size(); ++next) {
        const Index x = m_order[next];
        for(const auto& [y, b] : tree[x])
          if(m_depth[y] < 0) {
            m_depth[y] = m_depth[x] + 1;
            m_up[y] = x;
            m_up_bridge[y] = b;
            m_order.push_back(y);
          }
      }
    }
  }

  // Pairs terminals from the leaves up.  Every forest edge that cuts an odd number of terminals is
  // on the path of exactly one pair, the others on none.
  void match_along_forest(Alternating_cycles& matching) const
  {
    std::vector<Index> waiting(m_terminals.size());
    std::vector<double> length(m_terminals.size(), 0); // of the way from it to here
    for(std::size_t t = 0; t < waiting.size(); ++t) waiting[t] = Index(t);
    for(auto it = m_order.rbegin(); it != m_order.rend(); ++it) {
      const Index t = *it, up = m_up[t];
      if(up < 0 || waiting[t] < 0) continue;
      const double way = length[t] + m_up_bridge[t].length;
      if(waiting[up] >= 0) {
        matching.match(waiting[t], waiting[up], way + length[up], true);
        waiting[up] = -1;
        length[up] = 0;
      } else {
        waiting[up] = waiting[t];
        length[up] = way;
      }
    }
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
        add_forest_path(Index(t), other, join, to_terminal);
      else
        add_shortest_path(Index(t), other, join);
    }
    for(auto it = m_cell_order.rbegin(); it != m_cell_order.rend(); ++it)
      if(to_terminal[*it] && m_cell_parent[*it] >= 0) {
        join[m_cell_edge[*it]] ^= 1;
        to_terminal[m_cell_parent[*it]] ^= 1;
      }
    return join;
  }

  void add_forest_path(Index a, Index b, std::vector<char>& join,
                       std::vector<char>& to_terminal) const
  {
    while(a != b) {
      if(m_depth[a] < m_depth[b]) std::swap(a, b);
      const Index e = m_up_bridge[a].edge;
      join[e] ^= 1;
      to_terminal[m_edges[e].u] ^= 1;
      to_terminal[m_edges[e].v] ^= 1;
      a = m_up[a];
    }
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
  // Cells: by vertex; `m_cell_order` by growing distance.
  std::vector<Index> m_cell, m_cell_edge, m_cell_parent, m_cell_order;
  std::vector<double> m_cell_distance;
  // Spanning forest: by terminal; `m_order` lists parents before children.
  std::vector<Index> m_up, m_depth, m_order;
  std::vector<Bridge> m_up_bridge;
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
