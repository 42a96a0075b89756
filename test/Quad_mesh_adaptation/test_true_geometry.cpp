// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What the nodes stay on: the smooth reconstruction, a user's projector, a separate reference with
// creases; and how far the mesh is from it.

#include "support/more_shapes.h"
#include "support/state_fixture.h"
#include "support/usual_calls.h"

#include <CGAL/Quad_mesh_adaptation/internal/Distance_measure.h>
#include <CGAL/Quad_mesh_adaptation/internal/Hermite_curve.h>
#include <CGAL/Quad_mesh_adaptation/internal/Local_fit.h>
#include <CGAL/Quad_mesh_adaptation/internal/core_calls.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace QMA = CGAL::Quad_mesh_adaptation;
namespace core = CGAL::Quad_mesh_adaptation::internal;
using more_shapes::Index;
using more_shapes::Quad;
using more_shapes::Shape;
using more_shapes::Vec;
using usual_mesh::Mesh;
using usual_mesh::Point;

template <typename Size, typename NP>
Shape adapt(const Shape& s, const Size& size, const NP& np, QMA::Adaptation_report& report)
{
  Mesh mesh = zoo_mesh::make<Mesh, Point>(s);
  const mesh_checks::Facts before = mesh_checks::facts_of(s.points, s.quads);
  report = QMA::adapt_quad_mesh(size, mesh, np);
  EXPECT_TRUE(report.has_valid_mesh()) << s.name << ": " << report.message;
  mesh.collect_garbage();
  zoo_mesh::expect_valid(mesh, before);
  return zoo_mesh::shape_of(mesh);
}

using Error = std::function<double(const Vec&)>; // distance to the exact surface

double largest(const Shape& s, const Error& error)
{
  double worst = 0;
  for(const Vec& p : s.points) worst = (std::max)(worst, error(p));
  return worst;
}

double of_sphere(const Vec& p) { return std::abs(core::norm(p) - 1); }
double of_torus(const Vec& p)
{
  return std::abs(std::hypot(std::hypot(p.x(), p.y()) - 2, p.z()) - 1);
}
double of_paraboloid(const Vec& p)
{
  const double r2 = p.x() * p.x() + p.y() * p.y();
  return std::abs(p.z() - 2 * r2) / std::sqrt(1 + 16 * r2);
}

} // namespace

// Refining a coarse mesh: the nodes' distance to the surface it was taken from.
TEST(Smooth_reference, TenTimesNearer)
{
  const struct
  {
    Shape shape;
    double size;
    Error error;
    double gain; // at least
  } cases[] = { { more_shapes::paraboloid(10), 0.06, of_paraboloid, 10 },
                { more_shapes::sphere(6), 0.07, of_sphere, 20 },
                { more_shapes::torus(24, 16), 0.12, of_torus, 10 } };
  for(const auto& c : cases) {
    QMA::Adaptation_report report;
    const double flat =
        largest(adapt(c.shape, c.size, QMA::smooth_reference(false), report), c.error);
    const Shape s = adapt(c.shape, c.size, QMA::smooth_reference(true), report);
    EXPECT_LT(largest(s, c.error), flat / c.gain) << c.shape.name << ", flat " << flat;
    EXPECT_LT(report.after.max_distance_to_reference, 0.05 * flat) << c.shape.name;
  }
}

// The error of the reconstruction itself falls at least with the third power of the edges.
TEST(Smooth_reference, Order)
{
  const auto error = [](Index n) {
    state_fixture::Options o;
    const Shape s = more_shapes::sphere(n);
    core::Adaptation_state state;
    state.size = core::Size_sampler([](const Vec&) { return 1.; }, 1);
    const core::Input_mesh in = state_fixture::input_of(s, o);
    core::Geometry_options geometry;
    geometry.smooth = true;
    core::build_state(in, core::Feature_options(), geometry, state);
    double worst = 0;
    for(Index t = 0; t < Index(state.surface.number_of_triangles()); ++t) {
      const auto c = state.surface.triangle(t);
      for(const auto& b : { Vec(1, 1, 1) / 3, Vec(.5, .5, 0), Vec(0, .5, .5), Vec(.5, 0, .5) }) {
        const Vec p = b.x() * c[0] + b.y() * c[1] + b.z() * c[2];
        const Vec q = state.surface.lifted(p, t);
        worst = (std::max)(worst, of_sphere(q));
        Index hint = t;
        EXPECT_LT(core::distance(state.surface.project(q, hint), q), 1e-3 / n)
            << "not a projection";
      }
    }
    return worst;
  };
  const double coarse = error(6), fine = error(12);
  EXPECT_LT(coarse, 2e-3);
  EXPECT_LT(fine, coarse / 8);
}

// A cylinder gets round, and its rims too; its ends stay flat, and the rims sharp.
TEST(Smooth_reference, CylinderWithRims)
{
  const Shape coarse = more_shapes::closed_cylinder(4);
  QMA::Adaptation_report report;
  const Shape s = adapt(coarse, 0.12, QMA::smooth_reference(true), report);
  EXPECT_EQ(report.patches, 3u);
  EXPECT_EQ(report.feature_curves, 2u);
  std::size_t rim = 0;
  for(const Vec& p : s.points) {
    const double r = std::hypot(p.x(), p.y());
    const bool on_end = std::abs(p.z()) < 1e-12 || std::abs(p.z() - 2) < 1e-12;
    EXPECT_TRUE(on_end || (p.z() > 0 && p.z() < 2));
    EXPECT_TRUE(on_end || std::abs(r - 1) < 1.8e-3) << r; // 1.9e-2 with facets
    rim += on_end && std::abs(r - 1) < 2e-4;
  }
  EXPECT_GT(rim, 80u); // about 2 * 2 pi / 0.12
}

// What is flat and straight stays so to the last bits.
TEST(Smooth_reference, FlatFacesStayFlat)
{
  QMA::Adaptation_report report;
  const Shape s = adapt(more_shapes::bracket(), 0.7, QMA::smooth_reference(true), report);
  for(const Vec& p : s.points) {
    double off = 1;
    for(double x : { p.x(), p.y(), p.z() }) off = (std::min)(off, std::abs(x - std::round(x)));
    EXPECT_LT(off, 1e-12);
  }
}

TEST(Hermite_curve, CircleAndStraight)
{
  for(bool closed : { true, false }) {
    std::vector<Vec> p;
    for(int i = 0; i <= 16; ++i) {
      const double a = (closed ? 2. : 0.8) * shape_zoo::pi * (i % (closed ? 16 : 17)) / 16;
      p.push_back(Vec(std::cos(a), std::sin(a), 0));
    }
    std::vector<std::size_t> where;
    const std::vector<Vec> fine = core::Hermite_curve(p, closed).polyline(24, where);
    ASSERT_EQ(where.size(), p.size());
    for(std::size_t i = 0; i < p.size(); ++i) EXPECT_EQ(fine[where[i]], p[i]);
    const double flat = 1 - std::cos((closed ? 1. : 0.4) * shape_zoo::pi / 16);
    for(const Vec& q : fine) EXPECT_LT(of_sphere(q), flat / 20);
  }
  std::vector<Vec> line;
  for(double x : { 0., 0.3, 1.7, 2., 5. }) line.push_back(Vec(x, 2 * x, -x));
  std::vector<std::size_t> where;
  EXPECT_EQ(core::Hermite_curve(line, false).polyline(24, where), line);
}

TEST(Local_fit, ExactForCubicsAndTheirCurvature)
{
  std::mt19937 random(zoo_mesh::seed());
  const auto real = [&](double a, double b) { return a + (b - a) * (random() / 4294967295.); };
  for(int round = 0; round < 20; ++round) {
    const double k1 = real(-1, 1), k2 = real(-1, 1), c = real(-.5, .5);
    const auto f = [&](double x, double y) {
      return 0.5 * (k1 * x * x + k2 * y * y) + c * x * x * y;
    };
    std::vector<Vec> p;
    for(int i = -2; i <= 2; ++i)
      for(int j = -2; j <= 2; ++j)
        if(i || j) p.push_back(Vec(.2 * i, .2 * j, f(.2 * i, .2 * j)));
    const core::Local_fit fit(Vec(0, 0, 0), Vec(0.02, -0.03, 1), p, 3);
    EXPECT_EQ(fit.degree(), 3);
    EXPECT_NEAR(fit.curvature(), std::abs(k1) + std::abs(k2), 2e-3);
    const core::Surface_point q = fit.lift(Vec(.1, .15, 0));
    EXPECT_NEAR(q.point.z(), f(q.point.x(), q.point.y()), 1e-4);
  }
}

TEST(Projector, SphereWithAndWithoutNormal)
{
  const Shape s = more_shapes::sphere(3);
  const auto bare = [](const Point& p) {
    return CGAL::ORIGIN + core::normalized(p - CGAL::ORIGIN);
  };
  const auto full = [&](const Point& p) { // the normal points inwards and is not of length one
    return std::make_pair(bare(p), -3 * (p - CGAL::ORIGIN));
  };
  QMA::Adaptation_report report;
  EXPECT_LT(largest(adapt(s, 0.15, QMA::projector(bare), report), of_sphere), 1e-14);
  EXPECT_LT(largest(adapt(s, 0.15, QMA::projector(full), report), of_sphere), 1e-14);
  EXPECT_GT(largest(adapt(s, 0.15, QMA::schedule(QMA::Schedule::progressive), report), of_sphere),
            1e-2);
}

// A flat disk blown up to a cap, and its polygonal rim to the circle.
TEST(Projector, CurvesAndFlatInput)
{
  const auto cap = [](const Point& p) {
    return Point(p.x(), p.y(), 0.3 * (1 - p.x() * p.x() - p.y() * p.y()));
  };
  const auto rim = [](const Point& p) {
    const double r = std::hypot(p.x(), p.y());
    return Point(p.x() / r, p.y() / r, 0);
  };
  QMA::Adaptation_report report;
  const Shape s =
      adapt(more_shapes::disk(4, 2), 0.1, QMA::projector(cap, QMA::curve_projector(rim)), report);
  std::size_t on_rim = 0;
  for(const Vec& p : s.points) {
    const double r2 = p.x() * p.x() + p.y() * p.y();
    on_rim += std::abs(r2 - 1) < 1e-12 && p.z() == 0;
    EXPECT_NEAR(p.z(), 0.3 * (1 - r2), 1e-12);
  }
  EXPECT_GE(on_rim, 60u);
}

TEST(Projector, Refusals)
{
  const Shape s = more_shapes::sphere(3);
  const Mesh before = zoo_mesh::make<Mesh, Point>(s);
  Mesh mesh = before;
  const auto throws = [](const Point& p) -> Point {
    if(p.z() < -0.9) throw std::runtime_error("no such point");
    return p;
  };
  EXPECT_THROW(QMA::adapt_quad_mesh(0.2, mesh, QMA::projector(throws)), std::runtime_error);
  EXPECT_TRUE(zoo_mesh::is_same(mesh, before));
  const auto expect_refused = [&](const QMA::Adaptation_report& r) {
    EXPECT_EQ(r.status, QMA::Adaptation_status::input_refused);
    EXPECT_EQ(r.reason, QMA::Refusal::invalid_parameter);
    EXPECT_NE(r.message, "");
    EXPECT_TRUE(zoo_mesh::is_same(mesh, before));
  };
  const auto nan_below = [](const Point& p) {
    return p.z() < -0.9 ? Point(0, std::nan(""), 0) : p;
  };
  const QMA::Adaptation_report below = QMA::adapt_quad_mesh(0.2, mesh, QMA::projector(nan_below));
  expect_refused(below);
  ASSERT_TRUE(below.place);
  EXPECT_LT((*below.place)[2], -0.9);
  const auto same = [](const Point& p) { return p; };
  expect_refused(
      QMA::adapt_quad_mesh(0.2, mesh, QMA::projector(same, QMA::smooth_reference(true))));
  expect_refused(QMA::adapt_quad_mesh(0.2, mesh, QMA::max_distance(0)));
  expect_refused(QMA::adapt_quad_mesh(0.2, mesh, QMA::max_distance(std::nan(""))));
}

// Creases of a finer reference take the place of those of the input: rims without corner ...
TEST(Separate_reference, Rims)
{
  const Mesh reference = zoo_mesh::make<Mesh, Point>(more_shapes::closed_cylinder(16));
  QMA::Adaptation_report report;
  const Shape s =
      adapt(more_shapes::closed_cylinder(4), 0.12, QMA::reference_surface(reference), report);
  EXPECT_EQ(report.feature_curves, 2u);
  const double sagitta = 1 - std::cos(shape_zoo::pi / 64);
  std::size_t rim = 0;
  for(const Vec& p : s.points) {
    const bool on_end = std::abs(p.z()) < 1e-12 || std::abs(p.z() - 2) < 1e-12;
    const bool on_cylinder = std::abs(std::hypot(p.x(), p.y()) - 1) <= sagitta + 1e-12;
    EXPECT_TRUE(on_end || on_cylinder);
    rim += on_end && on_cylinder;
  }
  EXPECT_GT(rim, 80u);
}

// ... and a ridge that ends on the border.
TEST(Separate_reference, Ridge)
{
  const Mesh reference = zoo_mesh::make<Mesh, Point>(more_shapes::ridge(16));
  QMA::Adaptation_report report;
  for(double size : { 0.2, 0.9 }) {
    const Shape s = adapt(more_shapes::ridge(2), size, QMA::reference_surface(reference), report);
    EXPECT_EQ(report.patches, 2u);
    std::size_t on_ridge = 0;
    for(const Vec& p : s.points) {
      if(p.z() < 2 - 0.002) continue;
      ++on_ridge;
      EXPECT_NEAR(p.y(), more_shapes::ridge_at(p.x()), 1e-3); // 1.2e-2 on the input's polyline
      EXPECT_NEAR(p.z(), 2, 1e-12);
    }
    EXPECT_GE(on_ridge, std::size_t(5 / size));
  }
}

namespace {

// The largest distance from dense samples of the faces to the unit sphere.
double off_sphere(const Shape& s)
{
  double worst = 0;
  for(const Quad& q : s.quads)
    for(int i = 0; i <= 8; ++i)
      for(int j = 0; j <= 8; ++j) {
        const double u = i / 8., v = j / 8.;
        const Vec p = (1 - v) * ((1 - u) * s.points[q[0]] + u * s.points[q[1]]) +
                      v * (u * s.points[q[2]] + (1 - u) * s.points[q[3]]);
        worst = (std::max)(worst, of_sphere(p));
      }
  return worst;
}

} // namespace

TEST(Distance, ReportAgreesWithDenseSampling)
{
  const Mesh reference = zoo_mesh::make<Mesh, Point>(more_shapes::sphere(60));
  QMA::Adaptation_report report;
  const Shape s = adapt(more_shapes::sphere(4), 0.4, QMA::reference_surface(reference), report);
  const double off = off_sphere(s);
  EXPECT_NEAR(report.after.mesh_to_reference, off, 0.05 * off);
  EXPECT_NEAR(report.after.reference_to_mesh, off, 0.05 * off);
  EXPECT_GT(report.before.mesh_to_reference, 0);
}

// Somebody who mixes millimetres and metres is told.
TEST(Distance, ReferencesElsewhereAreTold)
{
  const auto is_told = [](double scale) {
    Shape sphere = more_shapes::sphere(20);
    for(Vec& p : sphere.points) p = scale * p;
    const Mesh reference = zoo_mesh::make<Mesh, Point>(sphere);
    Mesh mesh = zoo_mesh::make<Mesh, Point>(more_shapes::sphere(4));
    const QMA::Adaptation_report report =
        QMA::adapt_quad_mesh(0.4 * scale, mesh, QMA::reference_surface(reference));
    EXPECT_TRUE(report.has_valid_mesh()) << report.message;
    return std::any_of(report.advice.begin(), report.advice.end(), [](const std::string& text) {
      return text.find("away from the reference surface") != std::string::npos;
    });
  };
  EXPECT_FALSE(is_told(1));
  EXPECT_FALSE(is_told(1.1));
  EXPECT_TRUE(is_told(10));
}

// What is far from the mesh is seen from the reference only: a mesh that closes over a dent.
TEST(Distance, BothWays)
{
  core::Adaptation_state s;
  s.size = core::Size_sampler([](const Vec&) { return 1.; }, 1);
  const Shape flat = more_shapes::plate(4, 4);
  const Shape dented = more_shapes::grid("", 16, 16, [](Index i, Index j) {
    return Vec(i / 4., j / 4., i == 9 && j == 7 ? -0.5 : 0.);
  });
  core::Triangle_soup soup;
  soup.points = dented.points;
  for(const Quad& q : dented.quads) core::append_quad(soup, q);
  core::Geometry_options geometry;
  geometry.reference = &soup;
  const core::Input_mesh in = state_fixture::input_of(flat, state_fixture::Options());
  core::Feature_options features;
  features.feature_angle = 180;
  core::build_state(in, features, geometry, s);
  const core::Distance_measure d(s);
  EXPECT_NEAR(d.from_reference(), 0.5, 1e-9);
  EXPECT_LT(d.to_reference(), 0.4);
}

// Walks that end early and faces that are passed over do not change the largest distance.
TEST(Distance, LargestIsThatOfAllPointsOneByOne)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> shift(-0.02, 0.02);
  Shape warped = more_shapes::sphere(12);
  for(Vec& p : warped.points) p = p + Vec(shift(random), shift(random), shift(random));
  core::Adaptation_state s = state_fixture::make_state(warped);
  for(int i = 0; i < 2; ++i) {
    const double found = core::Distance_measure(s).to_reference();
    EXPECT_GT(found, 0);
    EXPECT_NEAR(found, core::Distance_measure(s, 0).to_reference(), 1e-12);
    core::Vertex_record& r = s.mesh.vertex(17); // the faces about it are others now
    r.p = r.p + Vec(0.03, 0.02, -0.01);
    s.place(r);
  }
}

// Where edges are shorter than those of the border there is a node at each bend of it, which costs
// no faces, however small the bound.
TEST(Distance, BendsOfABorderAskForNoFaces)
{
  const auto shape = shape_zoo::disk(2, 2);
  const double h = 0.5 * zoo_mesh::mean_edge(shape);
  auto free = zoo_mesh::make<Mesh, Point>(shape), bound = free;
  const auto without = QMA::adapt_quad_mesh(h, free),
             with = QMA::adapt_quad_mesh(h, bound, QMA::max_distance(1e-4 * h));
  ASSERT_EQ(with.status, QMA::Adaptation_status::sizes_met) << with.message;
  EXPECT_LE(with.after.mesh_to_reference, 1e-4 * h);
  EXPECT_LE(with.after.reference_to_mesh, 1e-4 * h);
  EXPECT_LE(double(with.after.faces), 2 * double(without.after.faces));
}

TEST(Distance, BoundIsMetOrTheFacesAreNamed)
{
  const Mesh reference = zoo_mesh::make<Mesh, Point>(more_shapes::sphere(60));
  for(double bound : { 0.02, 0.004 }) {
    QMA::Adaptation_report report;
    const Shape s = adapt(more_shapes::sphere(4), 1.,
                          QMA::max_distance(bound, QMA::reference_surface(reference)), report);
    const double off = off_sphere(s);
    EXPECT_LT(off, 1.1 * bound + 4e-4); // the reference's own facets
    EXPECT_GT(off, 0.5 * bound) << "finer than asked";
    EXPECT_EQ(report.faces_too_far.empty(),
              (std::max)(report.after.mesh_to_reference, report.after.reference_to_mesh) <= bound);
    EXPECT_EQ(report.status == QMA::Adaptation_status::sizes_met,
              report.faces_too_far.empty() && report.faces_too_large.empty());
  }
  // a flat sheet asks for nothing inside, its round border does
  QMA::Adaptation_report report;
  const Shape disk = adapt(more_shapes::disk(8, 6), 1., QMA::max_distance(0.01), report);
  // a face's size is the mean of its edges, so that the one on the border may be longer
  EXPECT_LT(report.after.reference_to_mesh, 0.0125);
  EXPECT_LT(report.after.faces, 200u);
}
