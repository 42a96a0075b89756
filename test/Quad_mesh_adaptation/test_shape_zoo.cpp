// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The shapes are what they claim to be, and the independent checker sees what is wrong.

#include "support/mesh_checks.h"
#include "support/shape_zoo.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace {

struct Expected
{
  long euler_characteristic;
  std::size_t components, boundary_loops;
};

const std::map<std::string, Expected> expected = { { "plate", { 1, 1, 1 } },
                                                   { "saddle", { 1, 1, 1 } },
                                                   { "annulus", { 0, 1, 2 } },
                                                   { "open cylinder", { 0, 1, 2 } },
                                                   { "torus", { 0, 1, 0 } },
                                                   { "L", { 1, 1, 1 } },
                                                   { "disk", { 1, 1, 1 } },
                                                   { "cube", { 2, 1, 0 } },
                                                   { "sphere", { 2, 1, 0 } },
                                                   { "slab of genus 2", { -2, 1, 0 } },
                                                   { "slab of genus 3", { -4, 1, 0 } },
                                                   { "irregular", { 1, 1, 1 } },
                                                   { "valences", { 1, 1, 1 } },
                                                   { "two components", { 3, 2, 1 } } };

mesh_checks::Facts facts_of(const shape_zoo::Shape& s)
{
  return mesh_checks::facts_of(s.points, s.quads);
}

void expect_problem(const shape_zoo::Shape& s, const std::string& words)
{
  const std::string problem = facts_of(s).problem;
  EXPECT_NE(problem.find(words), std::string::npos) << "'" << problem << "', not: " << words;
}

} // namespace

TEST(Shape_zoo, ShapesAreWhatTheyClaim)
{
  const auto shapes = shape_zoo::all();
  EXPECT_EQ(shapes.size(), expected.size());
  for(const auto& s : shapes) {
    SCOPED_TRACE(s.name);
    const auto f = facts_of(s);
    const Expected& e = expected.at(s.name);
    ASSERT_EQ(f.problem, "");
    EXPECT_EQ(f.euler_characteristic, e.euler_characteristic);
    EXPECT_EQ(f.components, e.components);
    EXPECT_EQ(f.boundary_loops, e.boundary_loops);
    EXPECT_EQ(f.doublets, 0u);
    EXPECT_EQ(4 * f.faces, 2 * f.edges - f.boundary_edges);
    EXPECT_GT(f.min_scaled_jacobian, 0.24);
  }
}

TEST(Shape_zoo, ClosedShapesAreOrientedOutwards)
{
  int closed = 0;
  for(const auto& s : shape_zoo::all()) {
    if(facts_of(s).boundary_edges != 0) continue;
    ++closed;
    double volume = 0; // of the tetrahedra over two triangles of each face
    for(const auto& q : s.quads)
      for(int k : { 1, 2 })
        volume += CGAL::cross_product(s.points[q[0]], s.points[q[k]]) * s.points[q[k + 1]] / 6;
    EXPECT_GT(volume, 0) << s.name;
  }
  EXPECT_GE(closed, 3);
}

TEST(Shape_zoo, FlatShapesLookUp)
{
  for(const auto& s : { shape_zoo::plate(), shape_zoo::annulus(), shape_zoo::l_shape(),
                        shape_zoo::disk(), shape_zoo::irregular(), shape_zoo::valences() })
    for(const auto& q : s.quads)
      EXPECT_GT(
          CGAL::cross_product(s.points[q[2]] - s.points[q[0]], s.points[q[3]] - s.points[q[1]]).z(),
          0)
          << s.name;
}

TEST(Shape_zoo, KnownAreasAndValences)
{
  EXPECT_DOUBLE_EQ(facts_of(shape_zoo::plate(6, 4)).area, 24);
  EXPECT_DOUBLE_EQ(facts_of(shape_zoo::cube(3)).area, 54);
  EXPECT_NEAR(facts_of(shape_zoo::irregular(5)).area, 25, 1e-12);
  EXPECT_NEAR(facts_of(shape_zoo::disk(40, 30)).area, shape_zoo::pi, 1e-3);
  const auto f = facts_of(shape_zoo::valences(true));
  for(std::size_t valence = 2; valence <= 8; ++valence) EXPECT_GE(f.valences.count(valence), 1u);
  EXPECT_EQ(f.doublets, 1u);
  EXPECT_EQ(facts_of(shape_zoo::disk()).valences.at(3), 4u);
}

TEST(Mesh_checks, SeeWhatIsWrong)
{
  using shape_zoo::Quad;
  const auto good = shape_zoo::plate(3, 3);
  auto s = good;
  s.quads[4] = Quad{ s.quads[4][3], s.quads[4][2], s.quads[4][1], s.quads[4][0] };
  expect_problem(s, "several faces"); // turned face
  s = good;
  s.quads[2][1] = s.quads[2][0];
  expect_problem(s, "repeats"); // repeated vertex
  s = good;
  s.quads[2][1] = 99;
  expect_problem(s, "no such"); // no such vertex
  s = good;
  s.quads.push_back(s.quads[0]);
  expect_problem(s, "several faces"); // double face
  s = good;
  s.quads.erase(s.quads.begin() + 1); // leaves two corners of the hole's sides
  EXPECT_EQ(facts_of(s).problem, "");
  s = good;
  s.quads = { good.quads[0], good.quads[4] };
  s.points.resize(11);
  expect_problem(s, "fans"); // two faces at a vertex only
  s = good;
  s.points.emplace_back(9, 9, 9);
  expect_problem(s, "has no face"); // vertex without face
  s = good;
  s.points[5] = shape_zoo::Vec(std::nan(""), 0, 0);
  expect_problem(s, "finite"); // not a number
  s = good;
  s.points[5] = shape_zoo::Vec(2.5, 2.5, 0);
  EXPECT_LT(facts_of(s).min_scaled_jacobian, 0) << "inverted face";
  // Two cubes that share a vertex: both fans are closed.
  s = shape_zoo::voxels(
      "", { 2, 2, 2 },
      [](shape_zoo::Index x, shape_zoo::Index y, shape_zoo::Index z) { return x == y && y == z; });
  expect_problem(s, "fans"); // cubes at a vertex
  // A cube on a corner of a plate: a closed fan beside an open one.
  s = shape_zoo::plate(1, 1);
  auto box = shape_zoo::cube(1);
  for(auto& p : box.points) p = p + shape_zoo::Vec(1, 1, 0);
  shape_zoo::append(s, box, true);
  expect_problem(s, "fans"); // a cube on the corner of a plate
}
