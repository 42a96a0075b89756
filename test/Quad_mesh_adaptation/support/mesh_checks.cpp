// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_checks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace mesh_checks {

double scaled_jacobian(const Vec& a, const Vec& b, const Vec& c, const Vec& d)
{
  const Vec p[4] = { a, b, c, d };
  const Vec normal = CGAL::cross_product((b - a) + (c - d), (c - b) + (d - a));
  double worst = std::numeric_limits<double>::infinity();
  for(int k = 0; k < 4; ++k) {
    const Vec u = p[(k + 1) % 4] - p[k], v = p[(k + 3) % 4] - p[k];
    const double scale = std::sqrt((u * u) * (v * v) * (normal * normal));
    worst = (std::min)(worst, scale > 0 ? CGAL::cross_product(u, v) * normal / scale : 0.);
  }
  return worst;
}

double area(const Vec& a, const Vec& b, const Vec& c, const Vec& d)
{
  return std::sqrt(CGAL::cross_product(c - a, d - b).squared_length()) / 2;
}

namespace {

// Each side of an edge at most once, in either direction: at most two faces, of equal orientation.
std::string collect_edges(std::size_t n, const std::vector<Quad>& quads, Directed_edges& edges)
{
  for(std::size_t f = 0; f < quads.size(); ++f)
    for(int k = 0; k < 4; ++k) {
      const Index a = quads[f][k], b = quads[f][(k + 1) % 4];
      const std::string name = "face " + std::to_string(f);
      if(a < 0 || std::size_t(a) >= n) return name + " has no such vertex: " + std::to_string(a);
      if(a == b || a == quads[f][(k + 2) % 4]) return name + " repeats vertex " + std::to_string(a);
      if(!edges.emplace(std::make_pair(a, b), f).second)
        return "edge " + std::to_string(a) + "-" + std::to_string(b) +
               " has several faces on one side, one is " + name;
    }
  return "";
}

// The faces of a vertex must be one fan: a path of faces at a boundary vertex, else a cycle.
std::string count_fans(const std::vector<Quad>& quads, const Directed_edges& edges, std::size_t n,
                       Facts& facts)
{
  std::vector<std::size_t> faces_of(n, 0), exits(n, 0);
  std::vector<Index> next_of_corner(4 * quads.size()); // one turn counter-clockwise, or -1
  for(std::size_t f = 0; f < quads.size(); ++f)
    for(int k = 0; k < 4; ++k) {
      const Index v = quads[f][k], before = quads[f][(k + 3) % 4];
      ++faces_of[v];
      const auto it = edges.find({ v, before });
      next_of_corner[4 * f + k] = -1;
      if(it == edges.end())
        ++exits[v];
      else
        for(int l = 0; l < 4; ++l)
          if(quads[it->second][l] == v) next_of_corner[4 * f + k] = Index(4 * it->second + l);
    }
  std::vector<char> seen(n, 0);
  for(std::size_t corner = 0; corner < next_of_corner.size(); ++corner) {
    const Index v = quads[corner / 4][corner % 4];
    if(exits[v] > 1) return "vertex " + std::to_string(v) + " joins several fans of faces";
    if(exits[v] == 1 || seen[v]) continue;
    seen[v] = 1;
    std::size_t length = 1;
    for(Index c = next_of_corner[corner]; c != Index(corner); c = next_of_corner[c]) ++length;
    if(length != faces_of[v]) return "vertex " + std::to_string(v) + " joins several fans of faces";
    ++facts.valences[length];
    if(length == 2) ++facts.doublets;
  }
  // A closed fan beside an open one.
  for(std::size_t corner = 0; corner < next_of_corner.size(); ++corner) {
    const Index v = quads[corner / 4][corner % 4];
    if(exits[v] != 1) continue;
    Index c = Index(corner);
    for(std::size_t k = 0; k < faces_of[v] && c >= 0; ++k) c = next_of_corner[c];
    if(c >= 0) return "vertex " + std::to_string(v) + " joins several fans of faces";
  }
  for(std::size_t v = 0; v < n; ++v)
    if(faces_of[v] == 0) return "vertex " + std::to_string(v) + " has no face";
  return "";
}

} // namespace

Facts facts_of(const std::vector<Vec>& points, const std::vector<Quad>& quads)
{
  Facts facts;
  facts.vertices = points.size();
  facts.faces = quads.size();
  for(std::size_t v = 0; v < points.size(); ++v)
    if(!std::isfinite(points[v].x()) || !std::isfinite(points[v].y()) ||
       !std::isfinite(points[v].z()))
      facts.problem = "vertex " + std::to_string(v) + " has no finite position";
  Directed_edges edges;
  if(facts.problem.empty()) facts.problem = collect_edges(points.size(), quads, edges);
  if(facts.problem.empty()) facts.problem = count_fans(quads, edges, points.size(), facts);
  if(!facts.problem.empty()) return facts;

  Sets all(points.size()), boundary(points.size());
  std::vector<char> is_vertex(points.size(), 1), is_boundary(points.size(), 0);
  for(const auto& [e, f] : edges) {
    const bool is_border = edges.count({ e.second, e.first }) == 0;
    facts.edges += is_border || e.first < e.second;
    all.parent[all.find(e.first)] = all.find(e.second);
    if(!is_border) continue;
    ++facts.boundary_edges;
    is_boundary[e.first] = is_boundary[e.second] = 1;
    boundary.parent[boundary.find(e.first)] = boundary.find(e.second);
  }
  facts.components = all.count(is_vertex);
  facts.boundary_loops = boundary.count(is_boundary);
  facts.euler_characteristic = long(facts.vertices) - long(facts.edges) + long(facts.faces);
  facts.min_scaled_jacobian = std::numeric_limits<double>::infinity();
  for(const Quad& q : quads) {
    const Vec &a = points[q[0]], &b = points[q[1]], &c = points[q[2]], &d = points[q[3]];
    facts.min_scaled_jacobian = (std::min)(facts.min_scaled_jacobian, scaled_jacobian(a, b, c, d));
    facts.area += area(a, b, c, d);
  }
  return facts;
}

bool same_topology(const Facts& a, const Facts& b)
{
  return a.problem.empty() && b.problem.empty() && a.components == b.components &&
         a.boundary_loops == b.boundary_loops && a.euler_characteristic == b.euler_characteristic;
}

} // namespace mesh_checks
