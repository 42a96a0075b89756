// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_BOUNDARY_COARSENING_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_BOUNDARY_COARSENING_H

#include <CGAL/Quad_mesh_adaptation/internal/Phase_scope.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/chord_collapse.h>
#include <CGAL/Quad_mesh_adaptation/internal/smoothing.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Boundary edge ratio, eq. 2 of the paper: actual over desired length.
inline double edge_ratio(const Adaptation_state& s, Index h)
{
  const Vec &a = s.mesh.point(s.mesh.origin(h)), &b = s.mesh.point(s.mesh.target(h));
  return distance(a, b) / s.size.at(0.5 * (a + b));
}

// Edges with a ratio below it are too short.
constexpr double short_edge = 0.75;

// A node on a curve of the border, with those before and after it.
struct Border_node
{
  Index node, before, after;
};

// That at the end of border half-edge h, if it moves along the curve of h.
inline void append_border_node(const Adaptation_state& s, Index h, std::vector<Border_node>& nodes)
{
  const Quad_complex& m = s.mesh;
  const Vertex_record& r = m.vertex(m.target(h));
  if(r.carrier == Carrier::curve && !r.frozen)
    nodes.push_back({ m.target(h), m.origin(h), m.target(r.halfedge) });
}

// The border half-edge that ends where border half-edge h starts.
inline Index border_before(const Quad_complex& m, Index h)
{
  while(m.turn_left(h) >= 0) h = m.turn_left(h);
  return m.prev(h);
}

// Nodes of curve c around v, up to `reach` edges away.
inline std::vector<Border_node> border_nodes_near(const Adaptation_state& s, Index c, Index v,
                                                  int reach)
{
  const Quad_complex& m = s.mesh;
  std::vector<Border_node> nodes;
  const Index from = m.vertex(v).halfedge;
  Index h = from;
  int edges = 0; // back first
  for(; edges < reach && m.curve(border_before(m, h)) == c; ++edges) {
    h = border_before(m, h);
    if(h == from) break; // the curve is closed
  }
  for(edges += reach; edges > 0 && m.curve(h) == c; --edges) {
    append_border_node(s, h, nodes);
    h = m.vertex(m.target(h)).halfedge;
    if(!nodes.empty() && m.target(h) == nodes.front().node) break;
  }
  return nodes;
}

// Nodes of all curves, by curve.
inline std::vector<std::vector<Border_node>> border_nodes(const Adaptation_state& s)
{
  const Quad_complex& m = s.mesh;
  std::vector<std::vector<Border_node>> nodes(s.curves.size());
  for(Index h : m.halfedges())
    if(m.is_border(h)) append_border_node(s, h, nodes[m.curve(h)]);
  return nodes;
}

// Evens out the spacing of nodes of curve c, in proportion to the size.
inline void smooth_curve(Adaptation_state& s, Index c, const std::vector<Border_node>& nodes,
                         int sweeps)
{
  const Quad_complex& m = s.mesh;
  const Feature_curve& curve = s.curves[c];
  for(int sweep = 0; sweep < sweeps; ++sweep)
    for(const Border_node& n : nodes) {
      Vertex_record& r = s.mesh.vertex(n.node);
      const auto arc_to = [&](Index u) {
        const Vertex_record& o = m.vertex(u);
        return o.carrier == Carrier::curve ? curve.difference(r.param, o.param)
                                           : curve.difference(r.param, curve.nearest(o.p));
      };
      const double a = arc_to(n.before), b = arc_to(n.after);
      if(!(a * b < 0)) continue; // ambiguous on a very short curve
      const double wa = 1 / s.size.at(r.p + 0.5 * (m.point(n.before) - r.p));
      const double wb = 1 / s.size.at(r.p + 0.5 * (m.point(n.after) - r.p));
      r.param += 0.5 * (wa * a + wb * b) / (std::max)(wa, wb);
      s.place(r);
    }
  for(const Border_node& n : nodes) s.node_moved(n.node);
}

// A chord whose end edges are too short, and stay short enough when their neighbours take over
// half of each; the worst of the two ratios, or 2 where it is not to be removed.
inline double removal_rank(const Adaptation_state& s, const Chord& c)
{
  if(c.is_closed) return 2;
  const Quad_complex& m = s.mesh;
  double worst = 0;
  for(Index h : { c.rungs.front(), c.rungs.back() }) {
    const double r = edge_ratio(s, h);
    const Index after = m.vertex(m.target(h)).halfedge;
    worst = (std::max)(worst, r);
    if(m.is_border(after) && edge_ratio(s, after) + 0.5 * r > 1) return 2;
  }
  return worst < short_edge ? worst : 2;
}

// The border half-edges too short for their size, the shortest first.
inline std::vector<Index> short_border_edges(const Adaptation_state& s)
{
  std::vector<std::pair<double, Index>> ranked;
  for(Index h : s.mesh.halfedges()) {
    if(!s.mesh.is_border(h)) continue;
    const double ratio = edge_ratio(s, h);
    if(ratio < short_edge) ranked.push_back({ ratio, h });
  }
  std::sort(ranked.begin(), ranked.end());
  std::vector<Index> list;
  for(const auto& r : ranked) list.push_back(r.second);
  return list;
}

// Removes the chord through border half-edge h, if that is to be, and evens out the nodes that are
// left about its ends.  Notes the curves of these.
inline bool remove_chord(Adaptation_state& s, Index h, Cavity& cavity, std::vector<char>& touched)
{
  constexpr int reach = 32; // edges; what lies farther off hardly moves
  const Quad_complex& m = s.mesh;
  const Chord c = chord_through(m, h);
  if(removal_rank(s, c) >= 1 || !is_chord_collapse_allowed(s, c)) return false;
  const std::array<Index, 2> rungs = { c.rungs.front(), c.rungs.back() };
  std::array<std::array<Index, 3>, 2> ends; // curve and nodes of each
  for(int i = 0; i < 2; ++i)
    ends[i] = { m.curve(rungs[i]), m.origin(rungs[i]), m.target(rungs[i]) };
  describe_chord_collapse(s, c, cavity);
  if(!cavity.close() || cavity.worst_after() < (std::min)(0.2, cavity.worst_before())) return false;
  cavity.commit();
  s.count("chord collapse");
  for(const auto& [curve, origin, target] : ends) {
    touched[curve] = 1;
    const Index left = m.is_vertex(origin) ? origin : target;
    smooth_curve(s, curve, border_nodes_near(s, curve, left, reach), 3);
  }
  return true;
}

// Boundary coarsening, step 2 of section 3.3: dual chords that end in boundary edges too short
// for their size are removed, the shortest first, then each coarsened curve is smoothed.
// Returns the number of chords removed.
inline std::size_t coarsen_boundary(Adaptation_state& s)
{
  Phase_scope phase(s, "boundary coarsening");
  Cavity cavity(s);
  std::size_t removed = 0;
  std::vector<char> touched(s.curves.size(), 0);
  for(bool again = true; again;) {
    again = false;
    s.check_cancelled();
    for(Index h : short_border_edges(s)) {
      if(!s.mesh.is_face(s.mesh.face(h)) || !s.mesh.is_border(h)) continue;
      if(!remove_chord(s, h, cavity, touched)) continue;
      ++removed;
      again = true;
    }
  }
  if(removed == 0) return 0;
  const auto nodes = border_nodes(s);
  for(std::size_t k = 0; k < touched.size(); ++k)
    if(touched[k]) smooth_curve(s, Index(k), nodes[k], 10);
  smooth(s, 5);
  return removed;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_BOUNDARY_COARSENING_H
