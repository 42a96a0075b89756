// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quad_mesh_adaptation/internal/curve_order.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace {

using CGAL::Quad_mesh_adaptation::internal::distance;
using CGAL::Quad_mesh_adaptation::internal::Feature_curve;
using CGAL::Quad_mesh_adaptation::internal::Vec;

// Right, up, and up into space: lengths 3, 4 and 12.
Feature_curve open_curve()
{
  return Feature_curve({ Vec(0, 0, 0), Vec(3, 0, 0), Vec(3, 4, 0), Vec(3, 4, 12) }, false, true,
                       false);
}

Feature_curve square()
{
  return Feature_curve({ Vec(0, 0, 0), Vec(2, 0, 0), Vec(2, 2, 0), Vec(0, 2, 0), Vec(0, 0, 0) },
                       true, false, true);
}

} // namespace

TEST(Feature_curve, LengthAndKind)
{
  EXPECT_EQ(open_curve().length(), 19);
  EXPECT_EQ(square().length(), 8);
  EXPECT_TRUE(square().is_closed());
  EXPECT_TRUE(square().is_frozen());
  EXPECT_FALSE(square().is_border());
  EXPECT_FALSE(open_curve().is_closed());
  EXPECT_TRUE(open_curve().is_border());
  EXPECT_EQ(Feature_curve().length(), 0);
}

TEST(Feature_curve, Points)
{
  const Feature_curve c = open_curve();
  EXPECT_EQ(c.point(0), Vec(0, 0, 0));
  EXPECT_EQ(c.point(1.5), Vec(1.5, 0, 0));
  EXPECT_EQ(c.point(3), Vec(3, 0, 0));
  EXPECT_EQ(c.point(5), Vec(3, 2, 0));
  EXPECT_EQ(c.point(19), Vec(3, 4, 12));
  EXPECT_EQ(c.point(-1), Vec(0, 0, 0)) << "an open curve ends";
  EXPECT_EQ(c.point(20), Vec(3, 4, 12));
  const Feature_curve q = square();
  EXPECT_EQ(q.point(7), Vec(0, 1, 0));
  EXPECT_EQ(q.point(9), Vec(1, 0, 0)) << "a closed one goes on";
  EXPECT_EQ(q.point(-1), Vec(0, 1, 0));
  EXPECT_EQ(q.point(8), Vec(0, 0, 0));
  EXPECT_EQ(q.point(-16), Vec(0, 0, 0));
}

TEST(Feature_curve, WrappedStaysInside)
{
  const Feature_curve q = square();
  for(double s : { -1e-18, -8., 8., 16., 7.999999999999999, 1e9, -1e9, 0. }) {
    EXPECT_GE(q.wrapped(s), 0) << s;
    EXPECT_LE(q.wrapped(s), q.length()) << s;
    const Vec p = q.point(s); // and is a point of the curve
    EXPECT_LT(distance(p, q.point(q.nearest(p))), 1e-12) << s;
  }
}

TEST(Feature_curve, DifferenceIsTheShortWayRound)
{
  const Feature_curve q = square();
  EXPECT_EQ(q.difference(1, 3), 2);
  EXPECT_EQ(q.difference(3, 1), -2);
  EXPECT_EQ(q.difference(7, 1), 2);
  EXPECT_EQ(q.difference(1, 7), -2);
  EXPECT_EQ(open_curve().difference(1, 18), 17);
  EXPECT_EQ(open_curve().difference(18, 1), -17);
}

TEST(Feature_curve, Tangents)
{
  const Feature_curve c = open_curve();
  EXPECT_EQ(c.tangent(0), Vec(1, 0, 0));
  EXPECT_EQ(c.tangent(3), Vec(0, 1, 0)) << "at a bend, of what follows";
  EXPECT_EQ(c.tangent(19), Vec(0, 0, 1));
  EXPECT_EQ(square().tangent(7), Vec(0, -1, 0));
}

TEST(Feature_curve, NearestPoint)
{
  const Feature_curve c = open_curve();
  EXPECT_EQ(c.nearest(Vec(-5, 1, 2)), 0);
  EXPECT_EQ(c.nearest(Vec(2, -3, 0)), 2);
  EXPECT_EQ(c.nearest(Vec(4, 2, 1)), 5);
  EXPECT_EQ(c.nearest(Vec(9, 9, 90)), 19);
  // against a fine sampling
  std::mt19937 random(5);
  std::uniform_real_distribution<double> real(-2, 6);
  for(const Feature_curve& k : { open_curve(), square() })
    for(int i = 0; i < 200; ++i) {
      const Vec p(real(random), real(random), real(random));
      double best = 1e9;
      for(int j = 0; j <= 20000; ++j)
        best = (std::min)(best, distance(p, k.point(k.length() * j / 20000.)));
      const double d = distance(p, k.point(k.nearest(p)));
      EXPECT_LE(d, best + 1e-12);
      EXPECT_GE(d, best - 1e-3);
    }
}

// A repeated point makes a segment without length.
TEST(Feature_curve, RepeatedPoints)
{
  const Feature_curve c({ Vec(0, 0, 0), Vec(1, 0, 0), Vec(1, 0, 0), Vec(2, 0, 0) }, false, true,
                        false);
  for(double s : { 0., 0.5, 1., 1.5, 2. }) {
    EXPECT_EQ(c.point(s), Vec(s, 0, 0));
    EXPECT_EQ(c.nearest(Vec(s, 1, 0)), s);
    EXPECT_EQ(c.tangent(s), Vec(1, 0, 0));
  }
}

// A node may come near a corner, little by little, but not on it.
TEST(Feature_curve, NodesKeepClearOfTheEnds)
{
  using CGAL::Quad_mesh_adaptation::internal::is_clear_of_ends;
  const Feature_curve c = open_curve(); // of length 19
  EXPECT_TRUE(is_clear_of_ends(c, 5, 1));
  EXPECT_TRUE(is_clear_of_ends(c, 0.1, 0.05)) << "however near it is already";
  EXPECT_TRUE(is_clear_of_ends(c, 0.1, 18));
  EXPECT_FALSE(is_clear_of_ends(c, 5, 0));
  EXPECT_FALSE(is_clear_of_ends(c, 5, 19));
  EXPECT_FALSE(is_clear_of_ends(c, 5, 19 - 1e-9));
  EXPECT_TRUE(is_clear_of_ends(square(), 5, 0)) << "a closed curve has none";
}
