// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_T_JOIN_FOREST_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_T_JOIN_FOREST_H

#include <CGAL/Quad_mesh_adaptation/internal/Disjoint_sets.h>
#include <CGAL/Quad_mesh_adaptation/internal/t_join_graph.h>
#include <CGAL/Quad_mesh_adaptation/internal/t_join_matching.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

/// Odd vertices of a graph, its terminals, the cells of the vertices that are nearest to each, and
/// a shortest forest of paths between terminals through neighbouring cells.
class Terminal_forest
{
public:
  /// `terminal_of`: by vertex, the number of the terminal that it is, or -1.
  Terminal_forest(const T_join_graph& graph, const std::vector<T_join_edge>& edges,
                  const std::vector<Index>& terminals, const std::vector<Index>& terminal_of,
                  Shortest_paths& paths)
      : m_graph(graph), m_edges(edges), m_terminals(terminals), m_terminal_of(terminal_of),
        m_paths(paths)
  {
  }

  // Mostly each terminal has a partner near by.  So the cells grow no further than needed for each
  // tree over them to hold an even number of terminals, and the rest of the graph is not visited.
  void grow()
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

  // Pairs terminals from the leaves up.  Every forest edge that cuts an odd number of terminals is
  // on the path of exactly one pair, the others on none.
  void match(Alternating_cycles& matching) const
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

  // Adds the path to one join, where it cancels what is there.  `to_terminal` collects the vertices
  // whose way to their terminal is still missing.
  void add_path(Index a, Index b, std::vector<char>& join, std::vector<char>& to_terminal) const
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

  // Adds these ways.
  void add_ways_to_terminals(std::vector<char>& join, std::vector<char>& to_terminal) const
  {
    for(auto it = m_cell_order.rbegin(); it != m_cell_order.rend(); ++it)
      if(to_terminal[*it] && m_cell_parent[*it] >= 0) {
        join[m_cell_edge[*it]] ^= 1;
        to_terminal[m_cell_parent[*it]] ^= 1;
      }
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

  using Tree = std::vector<std::vector<std::pair<Index, Bridge>>>; // neighbours by terminal

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
    Disjoint_sets sets(m_terminals.size());
    Tree tree(m_terminals.size());
    for(const Bridge& b : bridges()) {
      const Index x = m_cell[m_edges[b.edge].u], y = m_cell[m_edges[b.edge].v];
      if(!sets.unite(x, y)) continue;
      tree[x].emplace_back(y, b);
      tree[y].emplace_back(x, b);
    }
    root_trees(tree);
  }

  std::vector<Bridge> bridges() const
  {
    std::vector<Bridge> list;
    for(std::size_t i = 0; i < m_edges.size(); ++i) {
      const T_join_edge& e = m_edges[i];
      if(!T_join_graph::is_usable(e, m_cell.size()) || m_cell[e.u] == m_cell[e.v]) continue;
      if(m_cell[e.u] < 0 || m_cell[e.v] < 0) continue;
      list.push_back({ m_cell_distance[e.u] + e.weight + m_cell_distance[e.v], Index(i) });
    }
    std::sort(list.begin(), list.end());
    return list;
  }

  void root_trees(const Tree& tree)
  {
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

  static double infinity() { return std::numeric_limits<double>::infinity(); }

  const T_join_graph& m_graph;
  const std::vector<T_join_edge>& m_edges;
  const std::vector<Index>& m_terminals;
  const std::vector<Index>& m_terminal_of;
  Shortest_paths& m_paths;
  // Cells: by vertex; `m_cell_order` by growing distance.
  std::vector<Index> m_cell, m_cell_edge, m_cell_parent, m_cell_order;
  std::vector<double> m_cell_distance;
  // Spanning forest: by terminal; `m_order` lists parents before children.
  std::vector<Index> m_up, m_depth, m_order;
  std::vector<Bridge> m_up_bridge;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_T_JOIN_FOREST_H
