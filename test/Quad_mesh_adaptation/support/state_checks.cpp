// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "state_checks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace state_checks {

std::string name(const char* kind, Index i) { return std::string(kind) + " " + std::to_string(i); }

std::string halfedge_problem(const Quad_complex& m)
{
  Index faces = 0;
  std::vector<int> corners(m.vertex_end(), 0), border(m.vertex_end(), 0);
  for(Index f = 0; f < m.face_end(); ++f) {
    const Quad q = m.quad(f);
    if(!m.is_face(f)) {
      if(q != Quad{ -1, -1, -1, -1 }) return name("half-deleted face", f);
      continue;
    }
    ++faces;
    for(Index h = 4 * f; h < 4 * f + 4; ++h) {
      const Index v = m.origin(h), o = m.opposite(h);
      if(v < 0 || v >= m.vertex_end() || !m.is_vertex(v)) return name("dead corner of face", f);
      ++corners[v];
      border[v] += o < 0;
      if(o < 0) continue;
      if(o >= 4 * m.face_end() || !m.is_face(m.face(o))) return name("dead opposite of", h);
      if(m.opposite(o) != h) return name("opposite of opposite of", h);
      if(m.origin(o) != m.target(h) || m.target(o) != v) return name("ends of opposite of", h);
      if(m.curve(o) != m.curve(h)) return name("two curves at", h);
    }
  }
  if(faces != m.number_of_faces()) return "face count";
  std::vector<Index> out;
  for(Index v = 0; v < m.vertex_end(); ++v) {
    if(!m.is_vertex(v)) {
      if(corners[v] != 0) return name("deleted but used vertex", v);
      continue;
    }
    const Index h = m.vertex(v).halfedge;
    if(h >= 4 * m.face_end() || m.origin(h) != v) return name("half-edge of vertex", v);
    if(border[v] > 1) return name("two borders at vertex", v);
    if((border[v] == 1) != m.is_border(h)) return name("half-edge not on the border, vertex", v);
    m.outgoing(v, out);
    if(int(out.size()) != corners[v]) return name("two fans at vertex", v);
    if(m.vertex(v).faces != corners[v]) return name("number of faces at vertex", v);
  }
  return "";
}

namespace {

std::vector<Component> components_of(const Quad_complex& m)
{
  mesh_checks::Sets part(std::size_t(m.vertex_end())), loop(std::size_t(m.vertex_end()));
  std::vector<char> on_border(m.vertex_end(), 0);
  for(Index h : m.halfedges()) {
    part.parent[part.find(m.origin(h))] = part.find(m.target(h));
    if(!m.is_border(h)) continue;
    on_border[m.origin(h)] = on_border[m.target(h)] = 1;
    loop.parent[loop.find(m.origin(h))] = loop.find(m.target(h));
  }
  std::map<Index, Component> by_root;
  for(Index v : m.vertices()) {
    Component& c = by_root[part.find(v)];
    ++c.euler;
    if(on_border[v] && loop.find(v) == v) ++c.loops;
  }
  for(Index h : m.halfedges()) {
    Component& c = by_root[part.find(m.origin(h))];
    if((h & 3) == 0) ++c.euler, ++c.faces;
    if(m.opposite(h) < h) --c.euler; // each edge at its higher half-edge, or its only one
  }
  std::vector<Component> list;
  for(const auto& c : by_root) list.push_back(c.second);
  std::sort(list.begin(), list.end());
  return list;
}

} // namespace

std::vector<Quad> quads_of(const Quad_complex& m, std::vector<Vec>& points)
{
  std::vector<Index> number(m.vertex_end(), -1);
  points.clear();
  for(Index v : m.vertices()) {
    number[v] = Index(points.size());
    points.push_back(m.point(v));
  }
  std::vector<Quad> quads;
  for(Index f : m.faces()) {
    const Quad q = m.quad(f);
    quads.push_back({ number[q[0]], number[q[1]], number[q[2]], number[q[3]] });
  }
  return quads;
}

namespace {

// Folded over: some corner turns the wrong way seen along the face's own normal, or the face shows
// its back to the reference surface.  Where the normals at its corners point all ways, as on a face
// round half a tube, or stand across it, there is no telling back from front.
bool is_inverted(const Adaptation_state& s, Index f)
{
  const core::Corners p = s.corners(f);
  if(!(mesh_checks::scaled_jacobian(p[0], p[1], p[2], p[3]) > 0)) return true;
  double weight = 0;
  for(Index v : s.mesh.quad(f)) weight += core::norm(s.mesh.vertex(v).normal);
  const Vec n = core::area_vector(p), r = s.reference_normal(f).sum;
  return core::norm(r) > 0.5 * weight && weight > 0 && n * r < -0.5 * core::norm(n) * core::norm(r);
}

} // namespace

std::size_t number_of_inverted(const Adaptation_state& s)
{
  std::size_t n = 0;
  for(Index f = 0; f < s.mesh.face_end(); ++f) n += s.mesh.is_face(f) && is_inverted(s, f);
  return n;
}

namespace {

bool is_interior_doublet(const Quad_complex& m, Index v)
{
  return m.is_vertex(v) && !m.is_border_vertex(v) && m.vertex(v).faces <= 2;
}

std::set<Edge> frozen_edges_of(const Adaptation_state& s)
{
  std::set<Edge> edges;
  for(Index h : s.mesh.halfedges())
    if(s.mesh.curve(h) >= 0 && s.curves[s.mesh.curve(h)].is_frozen())
      edges.insert(std::minmax(s.mesh.origin(h), s.mesh.target(h)));
  return edges;
}

} // namespace

Snapshot snapshot(const Adaptation_state& s)
{
  const Quad_complex& m = s.mesh;
  Snapshot b;
  b.components = components_of(m);
  for(Index v : m.vertices()) {
    const core::Vertex_record& r = m.vertex(v);
    if(r.carrier == Carrier::corner || r.frozen) b.fixed.emplace_back(v, r.p);
    if(is_interior_doublet(m, v)) b.doublets.insert(v);
  }
  b.frozen_edges = frozen_edges_of(s);
  b.curves = s.curves.size();
  b.inverted = number_of_inverted(s);
  return b;
}

namespace {

using Neighbours = std::map<Index, std::vector<Index>>; // along a curve

// Each node of curve c has two neighbours but for the ends, and lies on the curve.
std::string chain_node_problem(const Adaptation_state& s, Index c, const Neighbours& neighbours)
{
  const core::Feature_curve& curve = s.curves[c];
  const bool loop = curve.is_closed() || curve.first_corner == curve.last_corner;
  for(const auto& n : neighbours) {
    const bool end = n.first == curve.first_corner || n.first == curve.last_corner;
    if(n.second.size() != (end && !loop ? 1u : 2u)) return name("branch at vertex", n.first);
    if(end) continue;
    const core::Vertex_record& r = s.mesh.vertex(n.first);
    if(r.carrier != Carrier::curve || r.curve != c) return name("strange node", n.first);
    const double off = std::sqrt((r.p - curve.point(r.param)).squared_length());
    if(off > 1e-9 * curve.length()) return name("off its curve: vertex", n.first);
  }
  return "";
}

// The edges of curve c form one chain from its first to its last corner, or one cycle, through
// its own nodes in the order of their arc lengths.
std::string chain_problem(const Adaptation_state& s, Index c, const std::vector<Edge>& edges)
{
  const core::Feature_curve& curve = s.curves[c];
  const Quad_complex& m = s.mesh;
  Neighbours neighbours;
  for(const Edge& e : edges) {
    neighbours[e.first].push_back(e.second);
    neighbours[e.second].push_back(e.first);
  }
  const bool loop = curve.is_closed() || curve.first_corner == curve.last_corner;
  const std::string problem = chain_node_problem(s, c, neighbours);
  if(!problem.empty()) return problem;
  if(edges.empty()) return "no edges";
  const Index start = curve.is_closed() ? edges[0].first : curve.first_corner;
  if(neighbours.count(start) == 0) return "first corner lost";
  // walk, adding up the arc length passed
  Index before = -1, v = start;
  double passed = 0;
  std::size_t steps = 0;
  const auto arc = [&](Index u, bool at_end) {
    if(m.vertex(u).carrier == Carrier::curve) return m.vertex(u).param;
    return at_end ? curve.length() : 0.;
  };
  std::vector<Index> ahead = neighbours[start];
  if(!curve.is_closed() && loop && arc(ahead[0], true) > arc(ahead[1], true))
    std::swap(ahead[0], ahead[1]); // start along the curve
  Index w = ahead[0];
  const double sign =
      curve.is_closed() && curve.difference(arc(v, false), arc(w, false)) < 0 ? -1 : 1;
  for(; steps < edges.size(); ++steps) {
    const bool last = !curve.is_closed() && w == curve.last_corner;
    const double d = curve.is_closed() ? curve.difference(arc(v, false), arc(w, false))
                                       : arc(w, last) - arc(v, false);
    if(!(sign * d > 0)) return name("not in order at vertex", w);
    passed += d;
    before = v;
    v = w;
    if(v == start || last) {
      ++steps;
      break;
    }
    const auto& n = neighbours[v];
    w = n[0] == before ? n[1] : n[0];
  }
  if(steps != edges.size()) return "more than one chain";
  if(v != (curve.is_closed() ? start : curve.last_corner)) return "last corner lost";
  return std::abs(std::abs(passed) - curve.length()) > 1e-9 * curve.length() ? "arc length" : "";
}

std::string curve_problem(const Adaptation_state& s)
{
  const Quad_complex& m = s.mesh;
  std::vector<std::vector<Edge>> edges(s.curves.size());
  for(Index h : m.halfedges()) {
    const Index c = m.curve(h);
    if(m.is_border(h) != (c >= 0 && s.curves[c].is_border())) return name("border and curve at", h);
    if(c < 0 || m.opposite(h) > h) continue;
    edges[c].push_back(std::minmax(m.origin(h), m.target(h)));
  }
  for(std::size_t c = 0; c < edges.size(); ++c) {
    const std::string problem = chain_problem(s, Index(c), edges[c]);
    if(!problem.empty()) return name("curve", Index(c)) + ": " + problem;
  }
  for(Index v : m.vertices()) {
    const core::Vertex_record& r = m.vertex(v);
    if(r.carrier == Carrier::surface && m.is_border_vertex(v))
      return name("loose border vertex", v);
    if(r.carrier == Carrier::curve && (r.curve < 0 || r.curve >= Index(s.curves.size())))
      return name("no curve under vertex", v);
  }
  return "";
}

} // namespace

std::string cache_problem(const Adaptation_state& s)
{
  for(Index f : s.mesh.faces()) {
    const core::Corners p = s.corners(f);
    // a cavity may have begun with another corner
    if(s.sizes.is_known(f) && std::abs(s.sizes[f] / s.size.at_face(p) - 1) > 1e-12)
      return name("stale size of face", f);
    if(!s.energies.is_known(f)) continue;
    const double e = s.face_energy(p, s.reference_normal(f), s.face_floor(f));
    if(std::abs(e - s.energies[f]) > 1e-5 * (1 + std::abs(e)))
      return name("stale energy of face", f);
  }
  return "";
}

std::string problem_of(const Adaptation_state& s, const Snapshot& before, bool check_shape)
{
  const Quad_complex& m = s.mesh;
  std::string problem = halfedge_problem(m);
  if(!problem.empty()) return "half-edges: " + problem;
  std::vector<Vec> points;
  const std::vector<Quad> quads = quads_of(m, points);
  const mesh_checks::Facts facts = mesh_checks::facts_of(points, quads);
  if(!facts.problem.empty()) return "as polygons: " + facts.problem;
  if(components_of(m) != before.components) return "Euler characteristic or loops of a component";
  if(s.curves.size() != before.curves) return "number of curves";
  problem = curve_problem(s);
  if(!problem.empty()) return problem;
  for(const auto& f : before.fixed) {
    if(!m.is_vertex(f.first)) return name("removed corner or frozen vertex", f.first);
    if(m.point(f.first) != f.second) return name("moved corner or frozen vertex", f.first);
  }
  if(frozen_edges_of(s) != before.frozen_edges) return "frozen edges";
  for(Index v = 0; v < m.vertex_end(); ++v)
    if(is_interior_doublet(m, v) && before.doublets.count(v) == 0) return name("doublet", v);
  if(check_shape && number_of_inverted(s) > before.inverted) return "inverted face";
  return cache_problem(s);
}

} // namespace state_checks
