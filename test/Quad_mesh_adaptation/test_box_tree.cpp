// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Nearest triangles by boxes, the largest of many distances, and meshes that are kept, against what
// is simple and slow.

#include <CGAL/Quad_mesh_adaptation/internal/Box_tree.h>
#include <CGAL/Quad_mesh_adaptation/internal/Largest_distance.h>
#include <CGAL/Quad_mesh_adaptation/internal/Nearest_triangle.h>
#include <CGAL/Quad_mesh_adaptation/internal/Quad_complex.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace core = CGAL::Quad_mesh_adaptation::internal;
using core::Index;
using core::Vec;

namespace {

using Triangle = std::array<Vec, 3>;

class Random
{
public:
  double number() { return double(engine_()) / 4294967296.; }
  Vec point() { return Vec(number(), number(), number()); }

private:
  std::mt19937 engine_;
};

// Small triangles in a cube of that size, somewhere.
std::vector<Triangle> triangles(Random& random, std::size_t n, double size, const Vec& where)
{
  std::vector<Triangle> list;
  for(std::size_t i = 0; i < n; ++i) {
    const Vec p = random.point();
    list.push_back({ where + size * p, where + size * (p + 0.05 * random.point()),
                     where + size * (p + 0.05 * random.point()) });
  }
  return list;
}

double distance_to(const Triangle& t, const Vec& p)
{
  return core::distance(p, core::closest_on_triangle(p, t).point);
}

void expect_nearest(std::size_t n, double size, const Vec& where)
{
  Random random;
  const std::vector<Triangle> list = triangles(random, n, size, where);
  const auto corners = [&](Index t) { return list[t]; };
  const core::Box_tree tree(Index(n), corners);
  for(int i = 0; i < 200; ++i) {
    const Vec p = where + size * (1.6 * random.point() - Vec(0.3, 0.3, 0.3));
    const auto accept = [&](Index t) { return t % 3 != i % 4; };
    double least = 1e150;
    for(Index t = 0; t < Index(n); ++t)
      if(accept(t)) least = std::min(least, distance_to(list[t], p));
    const core::Box_tree::Nearest found = tree.nearest(p, corners, accept, 1e150);
    if(least == 1e150) {
      EXPECT_EQ(found.triangle, -1);
      continue;
    }
    ASSERT_GE(found.triangle, 0);
    EXPECT_TRUE(accept(found.triangle));
    EXPECT_EQ(distance_to(list[found.triangle], p), least);
    EXPECT_EQ(core::distance(found.point, p), least);
    EXPECT_EQ(tree.nearest(p, corners, accept, 0.999 * least).triangle, -1);
    EXPECT_GE(tree.nearest(p, corners, accept, 1.001 * least + 1e-70).triangle, 0);
  }
}

std::vector<core::Valued_triangle> valued(const std::vector<Triangle>& list)
{
  std::vector<core::Valued_triangle> result;
  for(const Triangle& t : list) result.push_back({ t, { double(result.size()), 0, 0 } });
  return result; // the first value is the number
}

// The same triangle as by Box_tree, also where several are as near, and as near as any.
void expect_nearest_for_values(const std::vector<Triangle>& list, const std::vector<Vec>& points)
{
  const auto corners = [&](Index t) { return list[t]; };
  const core::Box_tree tree(Index(list.size()), corners);
  const core::Nearest_triangle nearest(valued(list));
  for(const Vec& p : points) {
    double least = 1e300;
    for(const Triangle& t : list) least = std::min(least, distance_to(t, p));
    const auto found = nearest(p);
    ASSERT_GE(found.triangle, 0);
    EXPECT_EQ(core::distance(found.nearest, p), least);
    const auto expected = tree.nearest(
        p, corners, [](Index) { return true; }, 1e150);
    EXPECT_EQ(nearest[found.triangle].values[0], expected.triangle);
    EXPECT_EQ(found.nearest, expected.point);
  }
}

std::vector<Vec> points_about(Random& random, double size, const Vec& where, int n = 300)
{
  std::vector<Vec> points;
  for(int i = 0; i < n; ++i)
    points.push_back(where + size * (1.6 * random.point() - Vec(0.3, 0.3, 0.3)));
  return points;
}

// A bent sheet of two triangles a cell; its nodes are multiples of 1 / 8 in two coordinates.
std::vector<Triangle> sheet(int n, const Vec& across)
{
  std::vector<Triangle> list;
  const auto at = [&](int i, int j) {
    return Vec(0.125 * i, 0.125 * j, 0) + std::abs(0.125 * i - 0.0625 * n) * across;
  };
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j) {
      list.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
      list.push_back({ at(i, j), at(i + 1, j + 1), at(i, j + 1) });
    }
  return list;
}

} // namespace

TEST(NearestTriangle, IsThatOfTheOtherTree)
{
  Random random;
  for(std::size_t n : { 1, 2, 3, 4, 5, 8, 9, 16, 17, 31, 33, 65, 100, 1000, 3000 })
    expect_nearest_for_values(triangles(random, n, 1, Vec(0, 0, 0)),
                              points_about(random, 1, Vec(0, 0, 0)));
}

TEST(NearestTriangle, IsThatOfTheOtherTreeAtAnyScaleAndPlace)
{
  Random random;
  for(double size : { 1e-60, 1e-9, 1e40 })
    expect_nearest_for_values(triangles(random, 300, size, Vec(0, 0, 0)),
                              points_about(random, size, Vec(0, 0, 0)));
  const Vec far(1e6, -1e6, 1e7);
  expect_nearest_for_values(triangles(random, 300, 1, far), points_about(random, 1, far));
  expect_nearest_for_values(triangles(random, 300, 0, far), points_about(random, 1, far));
}

TEST(NearestTriangle, IsTheSameOfEquals)
{
  Random random;
  for(int n : { 2, 3, 7, 16, 23 })
    for(const Vec& across : { Vec(0, 0, 0), Vec(0, 0, 0.5), Vec(0.1, 0, 1) }) {
      std::vector<Triangle> list = sheet(n, across);
      const std::vector<Triangle> again(list.begin(), list.begin() + std::ptrdiff_t(n));
      list.insert(list.end(), again.begin(), again.end()); // some twice
      std::vector<Vec> points = points_about(random, 0.125 * n, Vec(0, 0, 0));
      for(const Triangle& t : list)
        for(int i = 0; i < 3; ++i) {
          points.push_back(t[i]);
          points.push_back(0.5 * (t[i] + t[(i + 1) % 3]));
          points.push_back(t[i] + Vec(0, 0, 0.25 * i));
        }
      expect_nearest_for_values(list, points);
    }
}

TEST(NearestTriangle, IsFoundAmongThinOnesAndFromFarAway)
{
  Random random;
  std::vector<Triangle> list = triangles(random, 500, 1, Vec(0, 0, 0));
  for(int i = 0; i < 50; ++i) {
    const Vec p = random.point(), q = random.point();
    list.push_back({ p, p, p });
    list.push_back({ p, q, 0.5 * (p + q) });
    list.push_back({ p, q, p + 1e-9 * random.point() });
  }
  for(int i = 0; i < 300; ++i) { // tiny ones: many in one cell
    const Vec p = Vec(0.3, 0.3, 0.3) + 1e-4 * random.point();
    list.push_back({ p, p + 1e-6 * random.point(), p + 1e-6 * random.point() });
  }
  std::vector<Vec> points = points_about(random, 1, Vec(0, 0, 0));
  for(const Vec& p : points_about(random, 1e-4, Vec(0.3, 0.3, 0.3))) points.push_back(p);
  for(double away : { 3., 1e3, 1e6, 1e9, 1e14, 1e16, 1e30 })
    for(int i = 0; i < 20; ++i) points.push_back(away * (random.point() - Vec(0.5, 0.5, 0.5)));
  expect_nearest_for_values(list, points);
}

TEST(NearestTriangle, IsNoneWhereACoordinateIsNone)
{
  Random random;
  const core::Nearest_triangle nearest(valued(triangles(random, 100, 1, Vec(0, 0, 0))));
  for(double x : { std::nan(""), HUGE_VAL, -HUGE_VAL }) {
    EXPECT_EQ(nearest(Vec(x, 0, 0)).triangle, -1);
    EXPECT_EQ(nearest(Vec(0.5, 0.5, x)).triangle, -1);
  }
}

TEST(BoxTree, FindsTheNearest)
{
  for(std::size_t n : { 1, 2, 4, 5, 9, 100, 1000 }) expect_nearest(n, 1, Vec(0, 0, 0));
}

TEST(BoxTree, FindsTheNearestAtAnyScaleAndPlace)
{
  for(double size : { 1e-60, 1e-9, 1e40 }) expect_nearest(300, size, Vec(0, 0, 0));
  expect_nearest(300, 1, Vec(1e6, -1e6, 1e7));
  expect_nearest(300, 0, Vec(3, 4, 5)); // all in one point
}

TEST(LargestDistance, WalksGoneWrongAreSettled)
{
  // two sheets, one on top of the other: walks that begin on the wrong one stay there
  std::vector<Vec> points;
  std::vector<std::array<Index, 3>> faces;
  for(double z : { 0., 1. }) {
    const Index k = Index(points.size());
    for(double y : { 0., 1. })
      for(double x : { 0., 1. }) points.push_back(Vec(x, y, z));
    faces.push_back({ k, k + 1, k + 3 });
    faces.push_back({ k, k + 3, k + 2 });
  }
  const core::Reference_surface surface(points, faces);
  core::Largest_distance largest;
  largest.note(0.01);
  for(int i = 0; i < 5; ++i) {
    const Vec p(0.5, 0.2, 1 + 0.1 * i);
    Index wrong = 0;
    const double d = surface.distance_from(p, largest.threshold(), wrong);
    EXPECT_NEAR(d, 1 + 0.1 * i, 1e-12);
    largest.doubt(d, p, -1, Vec(0, 0, 1));
  }
  EXPECT_TRUE(largest.settle(surface));
  EXPECT_NEAR(largest.value(), 0.4, 1e-12);
  for(int i = 0; i < 100; ++i) largest.doubt(2, Vec(0.5, 0.2, 1), -1, Vec(0, 0, 1));
  EXPECT_FALSE(largest.settle(surface)); // too many of them to know
}

TEST(QuadComplex, IsTheSameAfterItWasPacked)
{
  core::Quad_complex m;
  for(int j = 0; j < 4; ++j)
    for(int i = 0; i < 5; ++i) {
      core::Vertex_record r;
      r.p = Vec(i, j, 0);
      r.halfedge = 0;
      m.add_vertex(r);
    }
  m.protect_vertices_below(20);
  for(Index j = 0; j < 3; ++j)
    for(Index i = 0; i < 4; ++i) {
      const Index v = 5 * j + i;
      m.add_face({ v, v + 1, v + 6, v + 5 }, 0);
    }
  m.remove_face(0); // and its corner
  ASSERT_TRUE(m.link());
  ASSERT_FALSE(m.is_vertex(0));
  core::Quad_complex packed = m.packed(), copy;
  copy.add_vertex(core::Vertex_record());
  copy.become(std::move(packed), m.vertex_end());
  ASSERT_EQ(copy.vertex_end(), m.vertex_end());
  ASSERT_EQ(copy.face_end(), m.face_end());
  EXPECT_EQ(copy.number_of_faces(), m.number_of_faces());
  for(Index v = 0; v < m.vertex_end(); ++v) {
    ASSERT_EQ(copy.is_vertex(v), m.is_vertex(v));
    if(!m.is_vertex(v)) continue;
    EXPECT_EQ(copy.point(v), m.point(v));
    EXPECT_EQ(copy.vertex(v).halfedge, m.vertex(v).halfedge);
    EXPECT_EQ(copy.vertex(v).faces, m.vertex(v).faces);
  }
  for(Index h = 0; h < 4 * m.face_end(); ++h) EXPECT_EQ(copy.opposite(h), m.opposite(h));
}
