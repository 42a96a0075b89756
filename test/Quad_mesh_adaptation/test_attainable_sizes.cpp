// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "support/state_fixture.h"

#include <CGAL/Quad_mesh_adaptation/internal/Attainable_sizes.h>

#include <gtest/gtest.h>

#include <cmath>

namespace {

namespace core = CGAL::Quad_mesh_adaptation::internal;
using core::Adaptation_state;
using core::Index;
using core::Vec;
using shape_zoo::Shape;

constexpr double pi = 3.14159265358979323846;

// A ring whose tube is `radius` thick, of nearly square faces.
Shape ring(double radius)
{
  Shape s = shape_zoo::torus(int(std::lround(24 / radius)), 12);
  for(Vec& p : s.points) {
    const double r = std::hypot(p.x(), p.y()), scale = (2 + radius * (r - 2)) / r;
    p = Vec(scale * p.x(), scale * p.y(), radius * p.z());
  }
  return s;
}

Adaptation_state state_of(const Shape& shape, double size)
{
  state_fixture::Options o;
  o.size = [size](const Vec&) { return size; };
  return state_fixture::make_state(shape, o);
}

double forced_faces(const Shape& shape, double size)
{
  return core::Attainable_sizes(state_of(shape, size)).forced_faces();
}

} // namespace

TEST(Face_curvatures, OfATubeAndOfASphere)
{
  const Adaptation_state tube = state_of(ring(0.1), 1);
  for(Index f = 0; f < tube.mesh.face_end(); ++f) {
    const auto k = core::face_curvatures(tube, f);
    EXPECT_NEAR(k[0], 10, 0.5);
    EXPECT_LT(k[1], 0.55);
  }
  const Adaptation_state sphere = state_of(shape_zoo::sphere(12), 1);
  for(Index f = 0; f < sphere.mesh.face_end(); ++f)
    for(double k : core::face_curvatures(sphere, f)) EXPECT_NEAR(k, 1, 0.1);
}

// Three faces around, however thin.
TEST(Attainable_sizes, ATubeHasThreeFacesAround)
{
  for(double radius : { 0.05, 0.1, 0.2 }) {
    const double h = 0.6, along = 2 * pi * 2 / h;
    const double ideal = along * 2 * pi * radius / h;
    EXPECT_NEAR(ideal + forced_faces(ring(radius), h), 3 * along, 0.15 * along) << radius;
  }
  EXPECT_EQ(forced_faces(ring(0.2), 0.3), 0);
}

TEST(Attainable_sizes, ASphereAndAPlateAsAsked)
{
  EXPECT_EQ(forced_faces(shape_zoo::sphere(12), 1.5), 0);
  EXPECT_NEAR(forced_faces(shape_zoo::sphere(12), 1e3), 4 * pi * std::pow(3 / (2 * pi), 2), 0.2);
  EXPECT_EQ(forced_faces(shape_zoo::plate(20, 20), 5), 0);
}

// About a short curve on a plate sizes grow from its length.
TEST(Attainable_sizes, AShortCurve)
{
  const Shape plate = shape_zoo::plate(40, 40);
  const double size = 16;
  state_fixture::Options o;
  o.size = [size](const Vec&) { return size; };
  Index a = -1, b = -1;
  for(std::size_t v = 0; v < plate.points.size(); ++v) {
    if(core::distance(plate.points[v], Vec(20, 20, 0)) < 1e-9) a = Index(v);
    if(core::distance(plate.points[v], Vec(21, 20, 0)) < 1e-9) b = Index(v);
  }
  ASSERT_GE(a, 0);
  ASSERT_GE(b, 0);
  const auto forced = [&] {
    return core::Attainable_sizes(state_fixture::make_state(plate, o)).forced_faces();
  };
  EXPECT_EQ(forced(), 0);
  o.constrained.insert(std::minmax(a, b));
  const double at_once = forced();
  EXPECT_GT(at_once, 4);
  EXPECT_LT(at_once, 20);
}
