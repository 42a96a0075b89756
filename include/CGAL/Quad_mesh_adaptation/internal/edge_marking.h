// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_EDGE_MARKING_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_EDGE_MARKING_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/t_join.h>

#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

struct Marking_options
{
  double threshold = 1.05; // rho_0: edges longer than sqrt(2) rho_0 times their size want a split
  double bend = 0.25;      // cost of a 3-quad template, which makes a node of valence 3
  double force_above = 0;  // if > 0: edges of faces above this ratio must be split
};

// Splits by edge, all even on every face, nearest to what `wish` asks for: a minimum-weight
// T-join on the dual graph.  Each face is two graph vertices, one per pair of opposite edges,
// joined by an edge that stands for a bend (two adjacent split edges); free border edges lead to
// one outer vertex.  `wish`, per half-edge of each edge's lower half: negative asks for a split,
// its magnitude is the cost of doing otherwise; infinite fixes the edge.
// Returns, per half-edge, whether its edge is split; faces without solution in `infeasible`.
inline std::vector<char> even_marks(const Quad_complex& m, const std::vector<double>& wish,
                                    double bend, std::vector<Index>* infeasible = nullptr)
{
  const std::size_t n = 2 * std::size_t(m.face_end());
  std::vector<char> split(4 * std::size_t(m.face_end()), 0), odd(n + 1, 0);
  std::vector<T_join_edge> edges;
  std::vector<Index> halfedge_of;
  const auto port = [](Index h) { return 2 * (h >> 2) + (h & 1); };
  for(Index h = 0; h < 4 * m.face_end(); ++h) {
    if(!m.is_face(m.face(h))) continue;
    const Index o = m.opposite(h);
    if(o >= 0 && o < h) continue;
    const Index a = port(h), b = o >= 0 ? port(o) : Index(n);
    if(wish[h] < 0) {
      split[h] = 1;
      odd[a] ^= 1;
      if(o >= 0) {
        split[o] = 1;
        odd[b] ^= 1;
      }
    }
    if(!std::isfinite(wish[h])) continue;
    edges.push_back({ a, b, std::abs(wish[h]) });
    halfedge_of.push_back(h);
  }
  std::vector<char> taken(m.face_end(), 0); // faces that any edge may be split of
  for(Index h : halfedge_of) {
    taken[m.face(h)] = 1;
    if(m.opposite(h) >= 0) taken[m.face(m.opposite(h))] = 1;
  }
  for(Index f = 0; f < m.face_end(); ++f)
    if(taken[f]) {
      edges.push_back({ 2 * f, 2 * f + 1, bend });
      halfedge_of.push_back(-1);
    }
  std::size_t terminals = 0;
  for(std::size_t i = 0; i < n; ++i) terminals += std::size_t(odd[i]);
  odd[n] = terminals % 2 == 1; // the border takes up an odd one
  const T_join join = minimum_weight_t_join(n + 1, edges, odd);
  if(!join.is_feasible) {
    if(infeasible)
      for(const auto& component : join.obstructions)
        for(Index v : component)
          if(v < Index(n)) infeasible->push_back(v / 2); // the outer vertex is no face
    return {};
  }
  for(std::size_t i = 0; i < edges.size(); ++i) {
    if(!join.in_join[i] || halfedge_of[i] < 0) continue;
    const Index h = halfedge_of[i], o = m.opposite(h);
    split[h] ^= 1;
    if(o >= 0) split[o] ^= 1;
  }
  return split;
}
// What splitting edge h costs: negative where it is too long, infinite where it must not be split.
// With rho = length / size at the middle, splitting changes (log rho)^2 by
// ln 2 (ln 2 - 2 ln(rho / rho_0)).
inline double split_wish(const Adaptation_state& s, const Marking_options& o, Index h)
{
  const Quad_complex& m = s.mesh;
  const Index c = m.curve(h);
  if(c >= 0 && s.curves[c].is_frozen()) return std::numeric_limits<double>::infinity();
  const double ln2 = std::log(2.);
  const Vec &a = m.point(m.origin(h)), &b = m.point(m.target(h));
  const double rho = distance(a, b) / s.size.at(0.5 * (a + b));
  return ln2 * (ln2 - 2 * std::log(rho / o.threshold));
}

// The same of all edges, by the lower of their half-edges.
inline std::vector<double> split_wishes(const Adaptation_state& s, const Marking_options& o)
{
  const Quad_complex& m = s.mesh;
  std::vector<double> wish(4 * std::size_t(m.face_end()), 0.);
  for(Index h = 0; h < 4 * m.face_end(); ++h)
    if(m.is_face(m.face(h)) && !(m.opposite(h) >= 0 && m.opposite(h) < h))
      wish[h] = split_wish(s, o, h);
  return wish;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_EDGE_MARKING_H
