// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "feature_checks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace feature_checks {

double norm(const Vec& v) { return std::sqrt(v.squared_length()); }

namespace {

std::map<Edge, std::vector<Index>> faces_by_edge(const Shape& s)
{
  std::map<Edge, std::vector<Index>> faces;
  for(Index f = 0; f < Index(s.quads.size()); ++f)
    for(int i = 0; i < 4; ++i)
      faces[std::minmax(s.quads[f][i], s.quads[f][(i + 1) % 4])].push_back(f);
  return faces;
}

} // namespace

std::vector<int> patches(const Shape& s, double angle)
{
  std::vector<Vec> normals;
  for(const Quad& q : s.quads) {
    const Vec n =
        CGAL::cross_product(s.points[q[2]] - s.points[q[0]], s.points[q[3]] - s.points[q[1]]);
    normals.push_back(n / norm(n));
  }
  std::vector<std::vector<Index>> beside(s.quads.size());
  for(const auto& [e, f] : faces_by_edge(s))
    if(f.size() == 2 && normals[f[0]] * normals[f[1]] > std::cos(angle * shape_zoo::pi / 180)) {
      beside[f[0]].push_back(f[1]);
      beside[f[1]].push_back(f[0]);
    }
  std::vector<int> patch(s.quads.size(), -1);
  int n = 0;
  for(std::size_t first = 0; first < patch.size(); ++first) {
    if(patch[first] >= 0) continue;
    std::vector<Index> queue(1, Index(first));
    patch[first] = n;
    for(std::size_t i = 0; i < queue.size(); ++i)
      for(Index g : beside[queue[i]])
        if(patch[g] < 0) {
          patch[g] = n;
          queue.push_back(g);
        }
    ++n;
  }
  return patch;
}

Features features(const Shape& s, const std::vector<int>& patch)
{
  Features result;
  std::vector<int> degree(s.points.size(), 0);
  for(const auto& [e, f] : faces_by_edge(s)) {
    const int a = patch[f[0]], b = f.size() == 2 ? patch[f[1]] : -1;
    if(a == b) continue;
    result.edges.push_back(e);
    result.neighbours.insert(std::minmax(a, b));
    const double length = norm(s.points[e.second] - s.points[e.first]);
    result.length += length;
    Seam& seam = result.seams[std::minmax(a, b)];
    ++seam.edges;
    seam.length += length;
    ++degree[e.first];
    ++degree[e.second];
  }
  for(Index v = 0; v < Index(degree.size()); ++v)
    if(degree[v] != 0 && degree[v] != 2) result.corners.push_back(v);
  return result;
}

double nodes_off_curves(const Shape& s, const Features& f, const Shape& of, const Features& curves)
{
  std::set<Index> nodes;
  for(const Edge& e : f.edges) nodes.insert({ e.first, e.second });
  double largest = 0;
  for(Index v : nodes) {
    double least = 1e300;
    for(const Edge& e : curves.edges) {
      const Vec a = of.points[e.first], d = of.points[e.second] - a;
      const double t = std::clamp((s.points[v] - a) * d / d.squared_length(), 0., 1.);
      least = (std::min)(least, norm(s.points[v] - a - t * d));
    }
    largest = (std::max)(largest, least);
  }
  return largest;
}

double distance_to_triangle(const Vec& p, const Vec& a, const Vec& b, const Vec& c)
{
  const Vec n = CGAL::cross_product(b - a, c - a);
  const auto inside = [&](const Vec& u, const Vec& v) {
    return CGAL::cross_product(v - u, p - u) * n >= 0;
  };
  if(n.squared_length() > 0 && inside(a, b) && inside(b, c) && inside(c, a))
    return std::abs((p - a) * n) / norm(n);
  const auto to_edge = [&](const Vec& u, const Vec& v) {
    const double l = (v - u).squared_length();
    const double t = l > 0 ? std::clamp((p - u) * (v - u) / l, 0., 1.) : 0.;
    return norm(p - u - t * (v - u));
  };
  return (std::min)({ to_edge(a, b), to_edge(b, c), to_edge(c, a) });
}

Quad_distances::Quad_distances(const Shape& s) : s(s)
{
  for(const Quad& q : s.quads) {
    const Vec c = (s.points[q[0]] + s.points[q[1]] + s.points[q[2]] + s.points[q[3]]) / 4;
    double r = 0;
    for(Index v : q) r = (std::max)(r, norm(s.points[v] - c));
    balls.emplace_back(c, r);
  }
}

double Quad_distances::lesser(double least, const Vec& p, Index f) const
{
  if(norm(p - balls[f].first) > least + balls[f].second) return least;
  const Quad& q = s.quads[f];
  for(int i = 0; i < 4 && least > 0; ++i)
    least = (std::min)(least, distance_to_triangle(p, s.points[q[i]], s.points[q[(i + 1) % 4]],
                                                   s.points[q[(i + 2) % 4]]));
  return least;
}

double nodes_off_patches(const Shape& s, const std::vector<int>& patch, const Shape& of,
                         const std::vector<int>& of_patch)
{
  std::map<int, std::vector<Index>> faces; // of the other mesh, by patch
  for(Index f = 0; f < Index(of.quads.size()); ++f) faces[of_patch[f]].push_back(f);
  const Quad_distances distances(of);
  std::set<std::pair<Index, int>> seen;
  double largest = 0;
  for(Index f = 0; f < Index(s.quads.size()); ++f)
    for(Index v : s.quads[f]) {
      if(!seen.insert({ v, patch[f] }).second) continue;
      double least = 1e300;
      for(Index g : faces[patch[f]]) least = distances.lesser(least, s.points[v], g);
      largest = (std::max)(largest, least);
    }
  return largest;
}

double size_of(const Shape& s)
{
  double largest = 0;
  for(const Vec& p : s.points) largest = (std::max)(largest, norm(p - s.points[0]));
  return largest;
}

} // namespace feature_checks
