// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shape_zoo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace shape_zoo {

Shape grid(std::string name, Index n, Index m, const std::function<Vec(Index, Index)>& at,
           bool closed_i, bool closed_j)
{
  Shape s{ std::move(name), {}, {} };
  const Index columns = closed_i ? n : n + 1, rows = closed_j ? m : m + 1;
  for(Index j = 0; j < rows; ++j)
    for(Index i = 0; i < columns; ++i) s.points.push_back(at(i, j));
  const auto id = [&](Index i, Index j) { return (j % rows) * columns + i % columns; };
  for(Index j = 0; j < m; ++j)
    for(Index i = 0; i < n; ++i)
      s.quads.push_back({ id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1) });
  return s;
}

Shape plate(Index n, Index m)
{
  return grid("plate", n, m, [](Index i, Index j) { return Vec(i, j, 0); });
}

Shape saddle(Index n)
{
  return grid("saddle", n, n, [n](Index i, Index j) {
    const double x = 2. * i / n - 1, y = 2. * j / n - 1;
    return Vec(x, y, x * x - y * y);
  });
}

Shape annulus(Index around, Index across)
{
  return grid(
      "annulus", across, around,
      [=](Index i, Index j) {
        const double r = 1 + double(i) / across, a = 2 * pi * j / around;
        return Vec(r * std::cos(a), r * std::sin(a), 0);
      },
      false, true);
}

Shape open_cylinder(Index around, Index along)
{
  return grid(
      "open cylinder", around, along,
      [=](Index i, Index j) {
        const double a = 2 * pi * i / around;
        return Vec(std::cos(a), std::sin(a), 2. * j / along);
      },
      true);
}

Shape torus(Index around, Index tube)
{
  return grid(
      "torus", around, tube,
      [=](Index i, Index j) {
        const double a = 2 * pi * i / around, b = 2 * pi * j / tube, r = 2 + std::cos(b);
        return Vec(r * std::cos(a), r * std::sin(a), std::sin(b));
      },
      true, true);
}

void append(Shape& a, const Shape& b, bool glue)
{
  std::map<std::array<long long, 3>, Index> known;
  const auto key = [](const Vec& p) {
    return std::array<long long, 3>{ std::llround(p.x() * 1e9), std::llround(p.y() * 1e9),
                                     std::llround(p.z() * 1e9) };
  };
  if(glue)
    for(std::size_t v = 0; v < a.points.size(); ++v) known.emplace(key(a.points[v]), Index(v));
  std::vector<Index> id;
  for(const Vec& p : b.points) {
    Index v = Index(a.points.size());
    if(glue) v = known.emplace(key(p), v).first->second;
    if(std::size_t(v) == a.points.size()) a.points.push_back(p);
    id.push_back(v);
  }
  for(const Quad& q : b.quads) a.quads.push_back({ id[q[0]], id[q[1]], id[q[2]], id[q[3]] });
}

Shape l_shape(Index n)
{
  const auto block = [n](Index x, Index y) {
    return grid("", n, n, [=](Index i, Index j) { return Vec(x + i, y + j, 0); });
  };
  Shape s{ "L", {}, {} };
  append(s, block(-n, -n), true);
  append(s, block(0, -n), true);
  append(s, block(-n, 0), true);
  return s;
}

Shape disk(Index n, Index rings)
{
  const double half = 0.5;
  Shape s = grid("disk", n, n, [=](Index i, Index j) {
    return Vec(half * (2. * i / n - 1), half * (2. * j / n - 1), 0);
  });
  for(int side = 0; side < 4; ++side)
    append(s,
           grid("", n, rings,
                [=](Index i, Index j) {
                  const double t = 2. * i / n - 1, a = t * pi / 4, k = double(j) / rings;
                  // The right-hand side, then turned; i runs clockwise so that the faces look up.
                  const double x = (1 - k) * half + k * std::cos(a),
                               y = -((1 - k) * half * t + k * std::sin(a));
                  const int turn[4][2] = { { 1, 0 }, { 0, 1 }, { -1, 0 }, { 0, -1 } };
                  const int c = turn[side][0], d = turn[side][1];
                  return Vec(c * x - d * y, d * x + c * y, 0);
                }),
           true);
  return s;
}

Shape voxels(std::string name, std::array<Index, 3> size,
             const std::function<bool(Index, Index, Index)>& is_inside)
{
  Shape s{ std::move(name), {}, {} };
  std::map<std::array<Index, 3>, Index> known;
  const auto vertex = [&](const std::array<Index, 3>& p) {
    const auto [it, is_new] = known.emplace(p, Index(s.points.size()));
    if(is_new) s.points.emplace_back(p[0], p[1], p[2]);
    return it->second;
  };
  const auto inside = [&](const std::array<Index, 3>& c) {
    for(int k = 0; k < 3; ++k)
      if(c[k] < 0 || c[k] >= size[k]) return false;
    return is_inside(c[0], c[1], c[2]);
  };
  std::array<Index, 3> c;
  for(c[2] = 0; c[2] < size[2]; ++c[2])
    for(c[1] = 0; c[1] < size[1]; ++c[1])
      for(c[0] = 0; c[0] < size[0]; ++c[0])
        for(int side = 0; side < 6 && inside(c); ++side) {
          const int axis = side / 2, up = side % 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
          std::array<Index, 3> next = c;
          next[axis] += up ? 1 : -1;
          if(inside(next)) continue;
          std::array<Index, 3> p = c;
          p[axis] += up;
          Quad q;
          q[0] = vertex(p);
          ++p[u];
          q[1] = vertex(p);
          ++p[v];
          q[2] = vertex(p);
          --p[u];
          q[3] = vertex(p);
          if(!up) std::swap(q[1], q[3]);
          s.quads.push_back(q);
        }
  return s;
}

Shape cube(Index n)
{
  Shape s = voxels("cube", { n, n, n }, [](Index, Index, Index) { return true; });
  return s;
}

Shape sphere(Index n)
{
  Shape s = cube(n);
  s.name = "sphere";
  for(Vec& p : s.points) {
    const auto angle = [n](double x) { return std::tan((2 * x / n - 1) * pi / 4); };
    p = CGAL::Quad_mesh_adaptation::internal::normalized(
        Vec(angle(p.x()), angle(p.y()), angle(p.z())));
  }
  return s;
}

Shape slab_with_tunnels(Index genus, Index wall)
{
  const Index period = wall + 1;
  return voxels("slab of genus " + std::to_string(genus),
                { genus * period + wall, 2 * wall + 1, wall },
                [=](Index x, Index y, Index) { return x % period != wall || y != wall; });
}

namespace {

/// Splits each triangle in three quads, at its centre and the middles of its edges.
Shape split_triangles(std::string name, const std::vector<Vec>& points,
                      const std::vector<std::array<Index, 3>>& triangles)
{
  Shape s{ std::move(name), points, {} };
  std::map<std::pair<Index, Index>, Index> middles;
  const auto middle = [&](Index a, Index b) {
    const auto [it, is_new] = middles.emplace(std::minmax(a, b), Index(s.points.size()));
    if(is_new) s.points.push_back((points[a] + points[b]) / 2);
    return it->second;
  };
  for(const auto& t : triangles) {
    const Index m[3] = { middle(t[0], t[1]), middle(t[1], t[2]), middle(t[2], t[0]) };
    const Index centre = Index(s.points.size());
    s.points.push_back((points[t[0]] + points[t[1]] + points[t[2]]) / 3);
    for(int k = 0; k < 3; ++k) s.quads.push_back({ t[k], m[k], centre, m[(k + 2) % 3] });
  }
  return s;
}

} // namespace

Shape irregular(Index n, unsigned seed)
{
  std::mt19937 random(seed);
  const auto shake = [&] { return 0.25 * (random() / double(std::mt19937::max()) - 0.5) * 2; };
  const Shape g = grid("", n, n, [&](Index i, Index j) {
    const bool on_side = i == 0 || j == 0 || i == n || j == n;
    const double dx = shake(), dy = shake();
    return on_side ? Vec(i, j, 0) : Vec(i + dx, j + dy, 0);
  });
  std::vector<std::array<Index, 3>> triangles;
  for(const Quad& q : g.quads) {
    const int k = random() % 2;
    triangles.push_back({ q[k], q[k + 1], q[k + 2] });
    triangles.push_back({ q[k], q[k + 2], q[(k + 3) % 4] });
  }
  return split_triangles("irregular", g.points, triangles);
}

namespace {

/// Cuts a quad in two along its first diagonal by a vertex of valence 2: a doublet.
void insert_doublet(Shape& s, std::size_t face)
{
  const Quad q = s.quads[face];
  const Index v = Index(s.points.size());
  s.points.push_back((s.points[q[0]] + s.points[q[1]] + s.points[q[2]] + s.points[q[3]]) / 4);
  s.quads[face] = { q[0], q[1], q[2], v };
  s.quads.push_back({ q[0], v, q[2], q[3] });
}

} // namespace

Shape valences(bool with_doublet)
{
  // Squares in a row with a hub each; the hub of square k sees 4 + k points of its outline.
  std::vector<Vec> points;
  std::vector<std::array<Index, 3>> triangles;
  for(Index k = 0; k <= 5; ++k) {
    points.emplace_back(k, 0, 0);
    points.emplace_back(k, 1, 0);
  }
  for(Index k = 0; k < 5; ++k) {
    std::vector<Index> outline = { 2 * k };
    for(Index i = 1; i <= k; ++i) {
      outline.push_back(Index(points.size()));
      points.emplace_back(k + double(i) / (k + 1), 0, 0);
    }
    outline.insert(outline.end(), { 2 * k + 2, 2 * k + 3, 2 * k + 1 });
    const Index hub = Index(points.size());
    points.emplace_back(k + 0.5, 0.5, 0);
    for(std::size_t i = 0; i < outline.size(); ++i)
      triangles.push_back({ hub, outline[i], outline[(i + 1) % outline.size()] });
  }
  Shape s = split_triangles("valences", points, triangles);
  if(with_doublet) {
    s.name = "valences with doublet";
    insert_doublet(s, 0);
  }
  return s;
}

Shape two_components()
{
  Shape s = plate(4, 4);
  s.name = "two components";
  Shape box = cube(2);
  for(Vec& p : box.points) p = p + Vec(1, 1, 3);
  append(s, box, false);
  return s;
}

std::vector<Shape> all()
{
  return { plate(),
           saddle(),
           annulus(),
           open_cylinder(),
           torus(),
           l_shape(),
           disk(),
           cube(),
           sphere(),
           slab_with_tunnels(2),
           slab_with_tunnels(3, 2),
           irregular(),
           valences(),
           two_components() };
}

} // namespace shape_zoo
