// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Projection to the reference surface: the walk from triangle to triangle against all triangles.

#include "support/state_fixture.h"

#include <CGAL/Quad_mesh_adaptation/internal/Input_mesh.h>
#include <CGAL/Quad_mesh_adaptation/internal/Reference_surface.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace {

namespace core = CGAL::Quad_mesh_adaptation::internal;
using core::Index;
using core::Reference_surface;
using core::Vec;
using shape_zoo::Shape;

struct Random
{
  explicit Random(unsigned seed) : engine(seed) {}
  double operator()(double a, double b)
  {
    return a + (b - a) * (engine() / double(std::mt19937::max()));
  }
  std::mt19937 engine;
};

Reference_surface surface_of(const Shape& s)
{
  core::Triangle_soup soup;
  soup.points = s.points;
  for(const auto& q : s.quads) core::append_quad(soup, q);
  return Reference_surface(soup.points, soup.triangles);
}

double brute_force_distance(const Reference_surface& r, const Vec& p)
{
  double best = 1e300;
  for(Index t = 0; t < Index(r.number_of_triangles()); ++t)
    best = (std::min)(best, core::distance(p, core::closest_on_triangle(p, r.triangle(t)).point));
  return best;
}

Vec point_in(const Reference_surface& r, Index t, Random& random)
{
  double a = random(0, 1), b = random(0, 1);
  if(a + b > 1) a = 1 - a, b = 1 - b;
  const auto c = r.triangle(t);
  return c[0] + a * (c[1] - c[0]) + b * (c[2] - c[0]);
}

} // namespace

TEST(Closest_on_triangle, AgainstSamplingAndItsOwnFeature)
{
  Random random(1);
  for(int i = 0; i < 500; ++i) {
    std::array<Vec, 3> c;
    for(Vec& v : c) v = Vec(random(-1, 1), random(-1, 1), random(-1, 1));
    const Vec p(random(-2, 2), random(-2, 2), random(-2, 2));
    const core::Closest_on_triangle found = core::closest_on_triangle(p, c);
    const double d = core::distance(p, found.point);
    for(int a = 0; a <= 20; ++a)
      for(int b = 0; a + b <= 20; ++b)
        EXPECT_LE(d, core::distance(p, c[0] + a / 20. * (c[1] - c[0]) + b / 20. * (c[2] - c[0])) +
                         1e-12);
    const Vec n = core::normalized(core::cross(c[1] - c[0], c[2] - c[0]));
    EXPECT_NEAR((found.point - c[0]) * n, 0, 1e-9);
    const Vec &u = c[found.index % 3], &v = c[(found.index + 1) % 3];
    if(found.feature == core::Triangle_feature::corner) {
      EXPECT_EQ(found.point, u);
    } else if(found.feature == core::Triangle_feature::edge) {
      EXPECT_NEAR(core::norm(core::cross(found.point - u, v - u)), 0, 1e-9);
      EXPECT_NEAR((p - found.point) * (v - u), 0, 1e-9);
    } else {
      EXPECT_NEAR(core::norm(core::cross(p - found.point, n)), 0, 1e-9);
    }
  }
}

TEST(Reference_surface, WalkAgainstBruteForce)
{
  Random random(zoo_mesh::seed());
  for(const Shape& shape :
      { shape_zoo::sphere(8), shape_zoo::torus(24, 16), shape_zoo::saddle(12) }) {
    const Reference_surface surface = surface_of(shape);
    ASSERT_FALSE(surface.is_planar());
    const double edge = zoo_mesh::mean_edge(shape);
    // beside a hollow edge both triangles may hold a nearest point of their own, and the walk may
    // stay with the second best; the sphere has none as seen from outside
    const bool is_convex = shape.name == "sphere";
    int second_best = 0;
    for(int i = 0; i < 600; ++i) {
      // a node on some triangle makes a move of up to one and a half edges, and a little off
      const Index start = Index(random.engine() % surface.number_of_triangles());
      const Vec from = point_in(surface, start, random);
      Vec d(random(-1, 1), random(-1, 1), random(-1, 1));
      d = d - (d * surface.normal(start)) * surface.normal(start);
      const Vec p = from + random(0, 1.5) * edge * core::normalized(d) +
                    random(is_convex ? 0 : -0.1, 0.1) * edge * surface.normal(start);
      Index hint = start;
      const Vec found = surface.project(p, hint);
      const double best = brute_force_distance(surface, p);
      const double behind = core::distance(p, found) - best;
      EXPECT_GE(behind, -1e-9 * edge) << shape.name << " " << i;
      EXPECT_LE(behind, (is_convex ? 1e-9 : 0.1) * edge) << shape.name << " " << i;
      second_best += behind > 1e-9 * edge;
      ASSERT_TRUE(hint >= 0 && hint < Index(surface.number_of_triangles()));
      EXPECT_LT(
          core::distance(found, core::closest_on_triangle(found, surface.triangle(hint)).point),
          1e-12)
          << "the hint is not the triangle found";
      Index none = -1;
      EXPECT_NEAR(core::distance(p, surface.project(p, none)), best, 1e-9 * edge) << "by the tree";
      EXPECT_NEAR(surface.distance_to(p), best, 1e-9 * edge);
    }
    EXPECT_LE(second_best, 600 / 20) << shape.name;
  }
}

TEST(Reference_surface, ProjectionOfItsOwnPointsIsThePoint)
{
  Random random(4);
  for(const Shape& shape : { shape_zoo::sphere(), shape_zoo::torus(), shape_zoo::cube() }) {
    const Reference_surface surface = surface_of(shape);
    for(Index t = 0; t < Index(surface.number_of_triangles()); ++t) {
      const Vec p = point_in(surface, t, random);
      Index hint = t;
      EXPECT_LT(core::distance(surface.project(p, hint), p), 1e-12);
    }
  }
}

// Two sheets a thousandth apart, back to back, as two components and joined by a fold: a node of
// one never turns up on the other, wherever it is pulled to.
TEST(Reference_surface, ThinSheets)
{
  const double gap = 1e-3;
  Shape apart = shape_zoo::plate(8, 8);
  Shape below = apart;
  for(Vec& p : below.points) p = Vec(p.x(), p.y(), -gap);
  for(auto& q : below.quads) std::swap(q[1], q[3]);
  shape_zoo::append(apart, below, false);
  // the same, joined along x = 0
  Shape folded = shape_zoo::grid("fold", 17, 8, [=](Index i, Index j) {
    return i <= 8 ? Vec(8 - i, j, 0) : Vec(i - 9, j, -gap);
  });
  for(auto& q : folded.quads) std::swap(q[1], q[3]);
  Random random(zoo_mesh::seed());
  for(const Shape& shape : { apart, folded }) {
    const Reference_surface surface = surface_of(shape);
    ASSERT_FALSE(surface.is_planar());
    for(int i = 0; i < 1000; ++i) {
      const Index start = Index(random.engine() % surface.number_of_triangles());
      const Vec from = point_in(surface, start, random);
      if(from.x() < 2.5) continue; // near the fold it may go round, on the surface
      Vec p = from + Vec(random(-1.5, 1.5), random(-1.5, 1.5), 0);
      p = Vec(p.x(), p.y(), random(-20, 20) * gap);
      Index hint = start;
      const Vec found = surface.project(p, hint);
      EXPECT_NEAR(found.z(), from.z(), 1e-12) << shape.name << " " << i;
      EXPECT_GT(surface.normal(hint) * surface.normal(start), 0.99);
      Index none = -1; // the tree does jump: the test is a test
      if(p.z() * (from.z() + gap / 2) < 0 && std::abs(p.z() + gap / 2) > gap && p.x() > 0.5) {
        EXPECT_NE(surface.project(p, none).z(), from.z());
      }
    }
  }
}

// Smoothing on a thin box: every node stays on its side.
TEST(Reference_surface, SmoothingOnAThinBox)
{
  Shape box = shape_zoo::voxels("box", { 8, 8, 1 }, [](Index, Index, Index) { return true; });
  for(Vec& p : box.points) p = Vec(p.x(), p.y(), 1e-3 * p.z());
  state_fixture::Options o;
  o.size = [](const Vec& p) { return 0.5 + 0.2 * p.x(); };
  o.feature_angle = 180;
  core::Adaptation_state s = state_fixture::make_state(box, o);
  std::vector<Index> top;
  for(Index v = 0; v < s.mesh.vertex_end(); ++v) {
    const Vec& p = s.mesh.point(v);
    if(p.z() > 5e-4 && p.x() > 1 && p.x() < 7 && p.y() > 1 && p.y() < 7) top.push_back(v);
  }
  ASSERT_EQ(top.size(), 25u);
  Random random(9);
  for(int round = 0; round < 200; ++round)
    for(Index v : top) {
      core::Vertex_record r = s.mesh.vertex(v);
      r.p = r.p + Vec(random(-0.4, 0.4), random(-0.4, 0.4), random(-5e-3, 5e-3));
      s.place(r);
      EXPECT_NEAR(r.p.z(), 1e-3, 1e-12);
    }
}

TEST(Reference_surface, Planes)
{
  Random random(2);
  const Reference_surface flat = surface_of(shape_zoo::l_shape());
  ASSERT_TRUE(flat.is_planar());
  Shape tilted = shape_zoo::plate();
  for(Vec& p : tilted.points) p = Vec(p.x(), p.y(), 0.3 * p.x() - 0.7 * p.y() + 2);
  const Reference_surface plane = surface_of(tilted);
  ASSERT_TRUE(plane.is_planar());
  const Vec n = core::normalized(Vec(-0.3, 0.7, 1));
  EXPECT_NEAR(core::distance(plane.normal(0), n), 0, 1e-12);
  for(int i = 0; i < 50; ++i) {
    const Vec on(random(0, 6), random(0, 4), 0);
    const Vec p(on.x(), on.y(), 0.3 * on.x() - 0.7 * on.y() + 2);
    Index hint = -1;
    EXPECT_NEAR(core::distance(plane.project(p + random(-3, 3) * n, hint), p), 0, 1e-12);
    EXPECT_NEAR(plane.distance_to(p + 0.25 * n), 0.25, 1e-12);
  }
  // a bend of a millionth is no plane
  Shape bent = shape_zoo::plate();
  bent.points[8] = bent.points[8] + Vec(0, 0, 1e-6);
  EXPECT_FALSE(surface_of(bent).is_planar());
  EXPECT_FALSE(surface_of(shape_zoo::two_components()).is_planar());
}

// A quad that is not flat is cut along the diagonal that folds least.
// A walk ends somewhere, and in a plane, too, what it has not reached is found then.
TEST(Reference_surface, LongWaysInAPlane)
{
  const Reference_surface strip = surface_of(shape_zoo::plate(1000, 1));
  ASSERT_TRUE(strip.is_planar());
  Random random(4);
  for(int i = 0; i < 50; ++i) {
    Index t = Index(random(0, 2000)), there = Index(random(0, 2000));
    const Vec p = point_in(strip, there, random);
    EXPECT_NEAR(core::distance(strip.nearest_on(p, t), p), 0, 1e-9);
    ASSERT_TRUE(t >= 0 && t < 2000);
    EXPECT_NEAR(core::distance(core::closest_on_triangle(p, strip.triangle(t)).point, p), 0, 1e-9);
  }
}

TEST(Append_quad, FlatterDiagonal)
{
  core::Triangle_soup soup;
  soup.points = { Vec(0, 0, 0), Vec(1, 0, 0), Vec(1, 1, 0), Vec(0, 1, 0) };
  for(int raised = 0; raised < 4; ++raised) {
    core::Triangle_soup s = soup;
    s.points[raised] = s.points[raised] + Vec(0, 0, 0.5);
    core::append_quad(s, { 0, 1, 2, 3 });
    ASSERT_EQ(s.triangles.size(), 2u);
    double area = 0;
    for(const auto& t : s.triangles) {
      const Vec n = core::cross(s.points[t[1]] - s.points[t[0]], s.points[t[2]] - s.points[t[0]]);
      EXPECT_GT(n.z(), 0) << "orientation";
      area += 0.5 * n.z();
    }
    EXPECT_NEAR(area, 1, 1e-12);
  }
}
