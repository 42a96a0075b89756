// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The planes in which an input is its own mirror image.

#include "support/symmetry_fixture.h"

#include <CGAL/Quad_mesh_adaptation/internal/mirror_planes.h>

#include <gtest/gtest.h>

#include <functional>
#include <set>

using namespace symmetry_fixture;

TEST(Mirror_planes, AreFound)
{
  EXPECT_EQ(planes_of(shape_zoo::plate(6, 4)), 2u);
  EXPECT_EQ(planes_of(shape_zoo::plate(6, 3)), 1u); // the other one cuts faces
  EXPECT_EQ(planes_of(shape_zoo::plate(5, 3)), 0u);
  EXPECT_EQ(planes_of(shape_zoo::cube(4)), 3u);
  EXPECT_EQ(planes_of(shape_zoo::cube(3)), 0u);
  EXPECT_EQ(planes_of(shape_zoo::torus(16, 10)), 3u);
  EXPECT_EQ(planes_of(shape_zoo::sphere(4)), 3u);
  EXPECT_EQ(planes_of(shape_zoo::annulus(16, 3)), 2u);
  EXPECT_EQ(planes_of(cap()), 2u);
  EXPECT_EQ(planes_of(shape_zoo::irregular()), 0u);
}

TEST(Mirror_planes, InAnyPosition)
{
  for(const Shape& s : { shape_zoo::plate(6, 4), shape_zoo::cube(4), shape_zoo::torus(16, 10),
                         shape_zoo::sphere(4), shape_zoo::annulus(16, 3), cap() })
    EXPECT_EQ(planes_of(moved(s, turned)), planes_of(s)) << s.name;
}

// The search takes no quadratic time where all vertices are equally far from the middle.
TEST(Mirror_planes, ManyVerticesEquallyFar)
{
  EXPECT_EQ(planes_of(moved(shape_zoo::sphere(40), turned)), 3u);
  EXPECT_EQ(planes_of(moved(shape_zoo::annulus(4000, 2), turned)), 2u);
}

TEST(Mirror_planes, MapEverything)
{
  const Shape shape = shape_zoo::cube(4);
  const auto s = state_fixture::make_state(shape);
  const auto planes = QMA::internal::mirror_planes(state_fixture::input_of(shape, {}), s);
  ASSERT_EQ(planes.size(), 3u);
  for(const auto& p : planes) {
    ASSERT_GE(p.axis, 0);
    EXPECT_EQ(p.offset, 2);
    EXPECT_EQ(std::count(p.side.begin(), p.side.end(), 1), std::ptrdiff_t(shape.quads.size() / 2));
    for(std::size_t v = 0; v < shape.points.size(); ++v)
      EXPECT_EQ(shape.points[p.vertex_partner[v]], p.reflect(shape.points[v]));
    for(std::size_t f = 0; f < shape.quads.size(); ++f) {
      std::set<QMA::internal::Index> image;
      const auto& partner = shape.quads[p.face_partner[f]];
      for(auto v : shape.quads[f]) image.insert(p.vertex_partner[v]);
      EXPECT_EQ(image, std::set<QMA::internal::Index>(partner.begin(), partner.end()));
      EXPECT_EQ(p.side[f], -p.side[p.face_partner[f]]);
    }
  }
}

TEST(Mirror_planes, ConstraintsAndSizesCount)
{
  const Shape shape = centred(shape_zoo::plate(6, 4));
  state_fixture::Options o;
  o.frozen_vertices = { 0 };
  EXPECT_EQ(planes_of(shape, o), 0u);
  o.frozen_vertices = { 0, 6 }; // both ends of the lower side
  EXPECT_EQ(planes_of(shape, o), 1u);
  o = {};
  o.constrained = { { 15, 16 } }; // beside the middle
  EXPECT_EQ(planes_of(shape, o), 1u);
  o.constrained = { { 16, 17 }, { 17, 18 } };
  EXPECT_EQ(planes_of(shape, o), 2u);
  o = {};
  o.size = [](const Vec& p) { return 1 + 0.1 * p.x() * p.x(); };
  EXPECT_EQ(planes_of(shape, o), 2u);
  o.size = [](const Vec& p) { return 1 + 0.1 * p.x(); };
  EXPECT_EQ(planes_of(shape, o), 1u);
  o.size = [](const Vec& p) { return 1 + 0.1 * p.x() + 0.01 * p.y(); };
  EXPECT_EQ(planes_of(shape, o), 0u);
}

TEST(Mirror_planes, SizesOfAClosedSurfaceCount)
{
  const Shape shape = centred(shape_zoo::cube(6));
  const auto planes_for = [&](const std::function<double(const Vec&)>& size) {
    state_fixture::Options o;
    o.size = size;
    return planes_of(shape, o);
  };
  EXPECT_EQ(planes_for([](const Vec& p) { return 1 + 0.01 * (p * p); }), 3u);
  EXPECT_EQ(planes_for([](const Vec& p) { return 1 + 0.1 * p.x(); }), 2u);
  EXPECT_EQ(planes_for([](const Vec& p) { return 2 + 0.1 * p.x() + 0.05 * p.y() * p.x(); }), 1u);
  EXPECT_EQ(planes_for([](const Vec& p) { return 2 + 0.1 * p.x() + 0.02 * p.y(); }), 1u);
  // a small change, in no plane and in one
  const auto changed_at = [](const Vec& where) {
    return [where](const Vec& p) {
      return (1 + 0.1 * p.x()) * ((p - where) * (p - where) < 0.7 ? 0.5 : 1.);
    };
  };
  EXPECT_EQ(planes_for(changed_at(Vec(1, 2, 3))), 0u);
  EXPECT_EQ(planes_for(changed_at(Vec(3, 0, 2))), 1u);
}
