// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_T_JOIN_GRAPH_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_T_JOIN_GRAPH_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

/// An undirected edge between the vertices `u` and `v`; its weight is the price of using it.
struct T_join_edge
{
  Index u, v;
  double weight;
};

/// The usable edges of a graph, by vertex.  Left out are loops, edges to no vertex, and edges whose
/// weight is not a finite number >= 0.
class T_join_graph
{
public:
  struct Arc
  {
    Index target, edge;
    double weight;
  };
  struct Arc_range
  {
    const Arc *first, *last;
    const Arc* begin() const { return first; }
    const Arc* end() const { return last; }
    std::size_t size() const { return last - first; }
  };

  T_join_graph(std::size_t n, const std::vector<T_join_edge>& edges) : m_first(n + 1, 0)
  {
    for(const T_join_edge& e : edges)
      if(is_usable(e, n)) ++m_first[e.u + 1], ++m_first[e.v + 1];
    std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
    m_arcs.resize(m_first[n]);
    std::vector<std::size_t> next(m_first.begin(), m_first.end() - 1);
    for(std::size_t i = 0; i < edges.size(); ++i) {
      const T_join_edge& e = edges[i];
      if(!is_usable(e, n)) continue;
      m_arcs[next[e.u]++] = Arc{ e.v, Index(i), e.weight };
      m_arcs[next[e.v]++] = Arc{ e.u, Index(i), e.weight };
    }
  }

  static bool is_usable(const T_join_edge& e, std::size_t n)
  {
    return e.u != e.v && e.u >= 0 && e.v >= 0 && std::size_t(e.u) < n && std::size_t(e.v) < n &&
           std::isfinite(e.weight) && e.weight >= 0;
  }
  std::size_t number_of_vertices() const { return m_first.size() - 1; }
  std::size_t number_of_arcs() const { return m_arcs.size(); }
  Arc_range arcs(Index v) const
  {
    return { m_arcs.data() + m_first[v], m_arcs.data() + m_first[v + 1] };
  }

private:
  std::vector<std::size_t> m_first; // arcs of v: m_first[v] .. m_first[v + 1]
  std::vector<Arc> m_arcs;
};

/// Shortest paths from one or more sources (Dijkstra).  A search costs what it visits, not the size
/// of the graph, so that many short searches can share one object.
class Shortest_paths
{
public:
  explicit Shortest_paths(const T_join_graph& graph)
      : m_graph(graph), m_stamp(graph.number_of_vertices(), 0),
        m_distance(graph.number_of_vertices()), m_parent_edge(graph.number_of_vertices()),
        m_parent(graph.number_of_vertices())
  {
  }

  /// Visits vertices by growing (distance, number) up to `radius`, calling `settle(v)` for each;
  /// ends when that returns false or after `budget` arcs were looked at.
  template <class Sources, class Settle>
  void run(const Sources& sources, double radius, std::size_t budget, Settle settle)
  {
    ++m_time;
    m_heap.clear();
    for(Index s : sources) reach(s, 0, -1, -1);
    std::size_t looked_at = 0;
    while(!m_heap.empty() && looked_at <= budget) {
      std::pop_heap(m_heap.begin(), m_heap.end(), std::greater<>());
      const auto [d, v] = m_heap.back();
      m_heap.pop_back();
      if(d > m_distance[v]) continue; // reached on a shorter way since
      if(!settle(v)) return;
      const auto arcs = m_graph.arcs(v);
      looked_at += arcs.size();
      for(const auto& a : arcs) {
        const double there = d + a.weight;
        if(there <= radius && (m_stamp[a.target] != m_time || there < m_distance[a.target]))
          reach(a.target, there, a.edge, v);
      }
    }
  }

  bool is_reached(Index v) const { return m_stamp[v] == m_time; }
  double distance(Index v) const { return m_distance[v]; }
  /// Last edge of the path to `v` and the vertex before it; -1 at a source.
  Index parent_edge(Index v) const { return m_parent_edge[v]; }
  Index parent(Index v) const { return m_parent[v]; }

private:
  void reach(Index v, double d, Index edge, Index from)
  {
    m_stamp[v] = m_time;
    m_distance[v] = d;
    m_parent_edge[v] = edge;
    m_parent[v] = from;
    m_heap.emplace_back(d, v);
    std::push_heap(m_heap.begin(), m_heap.end(), std::greater<>());
  }

  const T_join_graph& m_graph;
  std::size_t m_time = 0;
  std::vector<std::size_t> m_stamp; // the search that reached the vertex last
  std::vector<double> m_distance;
  std::vector<Index> m_parent_edge, m_parent;
  std::vector<std::pair<double, Index>> m_heap;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_T_JOIN_GRAPH_H
