// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "support/state_fixture.h"

#include <CGAL/Quad_mesh_adaptation/internal/No_constraints.h>
#include <CGAL/Quad_mesh_adaptation/internal/advise_on_stray_creases.h>
#include <CGAL/Quad_mesh_adaptation/internal/core_calls.h>
#include <CGAL/Quad_mesh_adaptation/internal/feature_edges.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace state_fixture;

constexpr Index n = 12;

// A roof over a rectangle, whose middle row of edges runs along x = 6, and which fades out between
// y = 16 and y = 32: height(steps from the ridge) up to there, flat beyond.
template <typename Height>
Shape roof(const Height& height)
{
  return shape_zoo::grid("roof", n, n, [&](Index i, Index j) {
    const double fade = std::clamp((8. - j) / 4, 0., 1.);
    return Vec(i, 4 * j, fade * height(std::abs(i - 6)));
  });
}

// Two planes that meet: a crease that ends on the surface.
Shape sharp_roof()
{
  return roof([](Index d) { return -0.45 * d; });
}

// Round, in few faces: the rows of edges turn by 45, 35, 22, 25 and 10 degrees.
Shape round_roof()
{
  const double heights[] = { 0, -0.41, -1.98, -2.68, -2.86, -2.86, -2.86 };
  return roof([&](Index d) { return heights[d]; });
}

// Down a steep wall one face high, whose lower crease fades into a slope; the upper one does not.
Shape step()
{
  return shape_zoo::grid("step", n, n, [](Index i, Index j) {
    const double fade = std::clamp((j - 5.) / 4, 0., 1.), down = std::max(i - 6, 0);
    if(i < 6) return Vec(i, 2 * j, 0);
    return Vec(5.2 + down * (1 - 0.8 * fade), 2 * j, -2 - 2 * fade * down);
  });
}

Options at(double degrees)
{
  Options o;
  o.feature_angle = degrees;
  return o;
}

std::size_t inner_feature_edges(const Adaptation_state& s)
{
  std::size_t count = 0;
  for(Index h = 0; h < 4 * s.mesh.face_end(); ++h)
    if(s.mesh.curve(h) >= 0 && s.mesh.opposite(h) > h) ++count;
  return count;
}

std::size_t edges_turning(const Adaptation_state& s, double degrees)
{
  std::size_t count = 0;
  const auto area = [&](Index h) { return core::area_vector(s.corners(s.mesh.face(h))); };
  for(Index h = 0; h < 4 * s.mesh.face_end(); ++h) {
    const Index o = s.mesh.opposite(h);
    if(o > h && core::angle_between(area(h), area(o)) * 180 / std::acos(-1.) > degrees) ++count;
  }
  return count;
}

Adaptation_state with_reference(const Shape& shape, const Shape& surface)
{
  core::Triangle_soup soup;
  soup.points = surface.points;
  for(const core::Quad& q : surface.quads) core::append_quad(soup, q);
  core::Geometry_options geometry;
  geometry.reference = &soup;
  Adaptation_state s;
  s.size = core::Size_sampler([](const Vec&) { return 1.; }, 1);
  core::build_state(input_of(shape, Options()), core::Feature_options(), geometry, s);
  return s;
}

using Edges = std::set<std::pair<Index, Index>>; // by their ends, lower one first

Edges features_of_state(const Adaptation_state& s)
{
  Edges edges;
  for(Index h = 0; h < 4 * s.mesh.face_end(); ++h)
    if(s.mesh.curve(h) >= 0) edges.insert(std::minmax(s.mesh.origin(h), s.mesh.target(h)));
  return edges;
}

Edges features_of_fields(const Shape& shape, double degrees)
{
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  const Mesh mesh = zoo_mesh::make<Mesh, Mesh::Point>(shape);
  const core::Face_arrays a = core::face_arrays(mesh, get(CGAL::vertex_point, mesh),
                                                core::No_constraints<Mesh::Edge_index>(), "test");
  const std::vector<char> is_feature =
      core::feature_edges(a, std::cos(degrees * std::acos(-1.) / 180));
  Edges edges;
  for(Index h = 0; h < a.number_of_halfedges(); ++h)
    if(is_feature[h]) edges.insert(std::minmax(a.origin[h], a.origin[a.next(h)]));
  return edges;
}

} // namespace

TEST(Stray_creases, ASharpOneThatEndsOnTheSurfaceStays)
{
  const Adaptation_state s = make_state(sharp_roof(), at(40));
  EXPECT_GE(inner_feature_edges(s), 4u);
  EXPECT_EQ(inner_feature_edges(s), edges_turning(s, 40));
}

TEST(Stray_creases, ACoarseRoundIsNone)
{
  const Adaptation_state s = make_state(round_roof(), at(40));
  ASSERT_GE(edges_turning(s, 40), 3u) << "else this shows nothing";
  EXPECT_EQ(inner_feature_edges(s), 0u);
}

// Those taken back are counted, and the sharpest is told where it is.
TEST(Stray_creases, ThoseTakenBackAreTold)
{
  CGAL::Quad_mesh_adaptation::Adaptation_report report;
  core::advise_on_stray_creases(make_state(sharp_roof(), at(40)), report);
  EXPECT_TRUE(report.advice.empty()) << report.advice[0];
  const Adaptation_state s = make_state(round_roof(), at(40));
  const core::Creases_taken_back& taken = s.creases_taken_back;
  EXPECT_EQ(taken.edges, edges_turning(s, 40));
  EXPECT_GE(taken.creases, 1u);
  EXPECT_NEAR(taken.turn, 44.6 * core::pi / 180, 0.01); // twice atan(0.41)
  EXPECT_EQ(taken.where.x(), 6);
  EXPECT_LT(taken.where.y(), 17);
  core::advise_on_stray_creases(s, report);
  ASSERT_EQ(report.advice.size(), 1u);
  EXPECT_NE(report.advice[0].find("turns by 45 degrees at (6, "), std::string::npos)
      << report.advice[0];
}

// The upper crease makes the lower one no less of a crease.
TEST(Stray_creases, BothOfAStepStay)
{
  const Adaptation_state s = make_state(step(), at(50));
  EXPECT_GE(inner_feature_edges(s), std::size_t(n) + 5);
  EXPECT_EQ(inner_feature_edges(s), edges_turning(s, 50));
}

TEST(Stray_creases, MarkedOnesStay)
{
  const Shape shape = round_roof();
  Options o = at(40);
  const Index k = n + 1;
  for(Index j : { 1, 2, 3 }) o.constrained.insert({ 6 + j * k, 6 + (j + 1) * k });
  const Adaptation_state s = make_state(shape, o);
  EXPECT_GE(inner_feature_edges(s), 3u);
  for(Index j : { 1, 2, 3 })
    EXPECT_GE(s.mesh.curve(s.mesh.find_halfedge(6 + j * k, 6 + (j + 1) * k)), 0);
}

// Nothing ends on the surface of a hexagonal prism or a box, however few the faces.
TEST(Stray_creases, ClosedNetworksStay)
{
  const Shape tube = shape_zoo::grid(
      "tube", 6, 2,
      [](Index i, Index j) {
        const double t = std::acos(-1.) / 3 * i;
        return Vec(std::cos(t), std::sin(t), j);
      },
      true);
  EXPECT_EQ(inner_feature_edges(make_state(tube, at(50))), 12u);
  const Shape cube{ "cube",
                    { Vec(0, 0, 0), Vec(1, 0, 0), Vec(1, 1, 0), Vec(0, 1, 0), Vec(0, 0, 1),
                      Vec(1, 0, 1), Vec(1, 1, 1), Vec(0, 1, 1) },
                    { { 0, 3, 2, 1 },
                      { 4, 5, 6, 7 },
                      { 0, 1, 5, 4 },
                      { 1, 2, 6, 5 },
                      { 2, 3, 7, 6 },
                      { 3, 0, 4, 7 } } };
  EXPECT_EQ(inner_feature_edges(make_state(cube, at(50))), 12u);
}

// A few faces about a sphere turn by more than the feature angle everywhere; where the sphere
// itself is given it is known better.
TEST(Stray_creases, NoneWhereTheReferenceHasNone)
{
  const Shape coarse = shape_zoo::sphere(1);
  ASSERT_EQ(inner_feature_edges(make_state(coarse, at(50))), 12u);
  const Adaptation_state s = with_reference(coarse, shape_zoo::sphere(8));
  EXPECT_EQ(inner_feature_edges(s), 0u);
  EXPECT_TRUE(s.curves.empty());
  for(Index v = 0; v < s.mesh.vertex_end(); ++v)
    EXPECT_EQ(s.mesh.vertex(v).carrier, Carrier::surface);
}

TEST(Stray_creases, ThoseOfTheReferenceStay)
{
  const Shape coarse = shape_zoo::cube(1), fine = shape_zoo::cube(4);
  Shape unit = fine;
  for(Vec& p : unit.points) p = p / 4;
  const Adaptation_state s = with_reference(coarse, unit);
  EXPECT_EQ(inner_feature_edges(s), 12u);
  EXPECT_EQ(s.curves.size(), 12u);
}

// What curvature fields stop at is what adaptation stops at.
TEST(Stray_creases, FieldsHaveTheSameFeatures)
{
  for(const Shape& shape : { sharp_roof(), round_roof(), step(), shape_zoo::cube(3) })
    for(double degrees : { 20., 40., 50. })
      EXPECT_EQ(features_of_fields(shape, degrees),
                features_of_state(make_state(shape, at(degrees))))
          << shape.name << ", " << degrees;
}
