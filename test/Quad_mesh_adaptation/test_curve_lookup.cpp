// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Nearest points of curves by boxes against Feature_curve::nearest(), which looks at every segment.

#include "support/zoo_mesh.h"

#include <CGAL/Quad_mesh_adaptation/internal/Curve_lookup.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace {

namespace core = CGAL::Quad_mesh_adaptation::internal;
using core::Curve_lookup;
using core::Feature_curve;
using core::Vec;

class Random
{
public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double number(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  double power_of_ten(double low, double high) { return std::pow(10., number(low, high)); }
  std::size_t below(std::size_t n)
  {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(engine_);
  }
  Vec in_cube(double size)
  {
    const double x = number(-size, size), y = number(-size, size);
    return Vec(x, y, number(-size, size));
  }

private:
  std::mt19937 engine_;
};

// A closed curve repeats its first point at the end.
Feature_curve curve(std::vector<Vec> points, bool is_closed)
{
  if(is_closed) points.push_back(points.front());
  return Feature_curve(std::move(points), is_closed, true, false);
}

std::vector<Vec> walk(Random& random, std::size_t n)
{
  std::vector<Vec> points = { random.in_cube(1) };
  while(points.size() <= n) points.push_back(points.back() + random.in_cube(0.3));
  return points;
}

// Lengths differ by up to ten powers of ten.
std::vector<Vec> unequal(Random& random, std::size_t n)
{
  std::vector<Vec> points = { random.in_cube(1) };
  while(points.size() <= n)
    points.push_back(points.back() + random.power_of_ten(-9, 1) * random.in_cube(1));
  return points;
}

// Long legs side by side, so that the boxes of all overlap.
std::vector<Vec> zigzag(Random& random, std::size_t n)
{
  const double step = random.power_of_ten(-6, -1);
  std::vector<Vec> points;
  for(std::size_t i = 0; i <= n; ++i)
    points.push_back(Vec(step * double(i), i % 2 == 0 ? -1 : 1, random.number(-step, step)));
  return points;
}

// There and back again, nearly on the same line.
std::vector<Vec> near_touching(Random& random, std::size_t n)
{
  std::vector<Vec> points = walk(random, n / 2);
  const double gap = random.power_of_ten(-12, -3);
  for(std::size_t i = points.size(); i-- > 0;) points.push_back(points[i] + random.in_cube(gap));
  return points;
}

// Points that are met again and segments without length.
std::vector<Vec> grid_walk(Random& random, std::size_t n)
{
  std::vector<Vec> points = { Vec(0, 0, 0) };
  while(points.size() <= n) {
    Vec step(0, 0, 0);
    if(random.below(8) > 0) {
      const double length = random.below(2) == 0 ? 2 : -2;
      const std::size_t axis = random.below(3);
      step = Vec(axis == 0 ? length : 0, axis == 1 ? length : 0, axis == 2 ? length : 0);
    }
    points.push_back(points.back() + step);
  }
  return points;
}

// On the curve, beside it, about it and far away.
Vec question(Random& random, const Feature_curve& c)
{
  const Vec on_curve = c.point(random.number(0, c.length()));
  switch(random.below(5)) {
  case 0:
    return c.points()[random.below(c.points().size())];
  case 1:
    return on_curve;
  case 2:
    return on_curve + random.in_cube(random.power_of_ten(-12, 0));
  case 3:
    return c.points().front() + random.in_cube(4);
  default:
    return random.in_cube(1e5);
  }
}

using Polyline = std::vector<Vec> (*)(Random&, std::size_t);

void expect_same(const char* kind, Polyline polyline)
{
  SCOPED_TRACE(kind + (", QUAD_MESH_SEED=" + std::to_string(zoo_mesh::seed())));
  Random random(zoo_mesh::seed());
  std::size_t differing = 0;
  for(int i = 0; i < 60; ++i) {
    const std::size_t n = 2 + random.below(i % 3 == 0 ? 20 : 200);
    const Feature_curve c = curve(polyline(random, n), i % 2 == 0);
    const Curve_lookup lookup(c);
    for(int k = 0; k < 50; ++k) {
      const Vec p = question(random, c);
      if(lookup.nearest(p) != c.nearest(p)) ++differing;
    }
  }
  EXPECT_EQ(differing, 0u) << "of 3000";
}

} // namespace

TEST(Curve_lookup, AsByAllSegments)
{
  expect_same("walk", walk);
  expect_same("unequal segments", unequal);
  expect_same("zig-zag", zigzag);
  expect_same("near-touching", near_touching);
}

// On a grid distances are exact: where several segments are as near the first of them counts.
TEST(Curve_lookup, TheFirstOfEquals)
{
  Random random(zoo_mesh::seed());
  std::size_t ties = 0;
  for(int i = 0; i < 60; ++i) {
    const Feature_curve c = curve(grid_walk(random, 2 + random.below(100)), false);
    const Curve_lookup lookup(c);
    for(int k = 0; k < 50; ++k) {
      const auto whole = [&] { return double(random.below(13)) - 6; };
      const double x = whole(), y = whole();
      const Vec p(x, y, whole());
      ASSERT_EQ(lookup.nearest(p), c.nearest(p)) << "QUAD_MESH_SEED=" << zoo_mesh::seed();
      std::size_t nearest = 0;
      double arc = 0;
      const double d = core::distance(p, c.point(c.nearest(p)));
      for(std::size_t j = 0; j + 1 < c.points().size(); ++j)
        if(c.squared_distance_to_segment(j, p, arc) == d * d) ++nearest;
      if(nearest > 1) ++ties;
    }
  }
  EXPECT_GT(ties, 300u) << "else this tests little";
}

TEST(Curve_lookup, DistanceAndBox)
{
  const Feature_curve c = curve({ Vec(0, 0, 0), Vec(3, 0, 0), Vec(3, 4, 0), Vec(3, 4, 12) }, false);
  const Curve_lookup lookup(c);
  EXPECT_EQ(&lookup.curve(), &c);
  EXPECT_EQ(lookup.box().low, Vec(0, 0, 0));
  EXPECT_EQ(lookup.box().high, Vec(3, 4, 12));
  EXPECT_EQ(lookup.distance_to(Vec(3, 2, 0)), 0);
  EXPECT_EQ(lookup.distance_to(Vec(2, -3, 0)), 3);
  EXPECT_EQ(lookup.distance_to(Vec(3, 4, 20)), 8);
}

// A curve of one segment, and one of none.
TEST(Curve_lookup, FewSegments)
{
  const Feature_curve one = curve({ Vec(0, 0, 0), Vec(2, 0, 0) }, false), none;
  EXPECT_EQ(Curve_lookup(one).nearest(Vec(1.5, 7, 0)), 1.5);
  EXPECT_EQ(Curve_lookup(one).nearest(Vec(-1, 7, 0)), 0);
  EXPECT_EQ(Curve_lookup(none).nearest(Vec(1, 2, 3)), 0);
  EXPECT_TRUE(Curve_lookup(none).box().is_empty());
}
