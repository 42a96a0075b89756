// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Calls that are refused, cancelled or end by an exception leave the mesh as it was.

#include "support/usual_calls.h"

#include <CGAL/Quad_mesh_adaptation/expected_number_of_faces.h>
#include <CGAL/Quad_mesh_adaptation/smooth.h>

#include <CGAL/Polyhedron_3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace QMA = CGAL::Quad_mesh_adaptation;

namespace {

using usual_mesh::Mesh;
using usual_mesh::Point;
using usual_mesh::Size;
using Polyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>;
using QMA::Adaptation_report;
using QMA::Adaptation_status;
using QMA::Refusal;

Mesh plate() { return zoo_mesh::make<Mesh, Point>(shape_zoo::plate()); }

void expect_refused(Mesh mesh, Refusal reason, long entity)
{
  for(QMA::Schedule schedule : { QMA::Schedule::progressive, QMA::Schedule::paper }) {
    const Mesh before = mesh;
    const Adaptation_report r = QMA::adapt_quad_mesh(0.7, mesh, QMA::schedule(schedule));
    EXPECT_EQ(r.status, Adaptation_status::input_refused);
    EXPECT_EQ(int(r.reason), int(reason)) << r.message;
    EXPECT_EQ(r.entity, entity) << r.message;
    EXPECT_FALSE(r.message.empty());
    EXPECT_FALSE(r.has_valid_mesh());
    if(entity >= 0) {
      EXPECT_NE(r.message.find(std::to_string(entity)), std::string::npos) << r.message;
    }
    // NaN is never equal to itself: compare what is finite
    EXPECT_EQ(zoo_mesh::shape_of(mesh).quads, zoo_mesh::shape_of(before).quads);
    for(auto v : before.vertices())
      for(int k = 0; k < 3; ++k)
        if(std::isfinite(before.point(v)[k])) {
          EXPECT_EQ(mesh.point(v)[k], before.point(v)[k]);
        }
    EXPECT_EQ(mesh.number_of_faces(), before.number_of_faces());
    EXPECT_EQ(mesh.number_of_vertices(), before.number_of_vertices());
  }
}

} // namespace

TEST(Refusals, EmptyMesh)
{
  expect_refused(Mesh(), Refusal::empty_mesh, -1);
  Mesh isolated;
  isolated.add_vertex(Point(0, 0, 0));
  expect_refused(isolated, Refusal::empty_mesh, -1);
  Mesh mesh = plate();
  const Adaptation_report r = QMA::adapt_quad_mesh(std::vector<Mesh::Face_index>(), 1., mesh);
  EXPECT_EQ(r.status, Adaptation_status::input_refused);
  EXPECT_EQ(r.reason, Refusal::empty_mesh);
}

TEST(Refusals, NotAllQuads)
{
  Mesh triangle = plate();
  CGAL::Euler::split_face(triangle.halfedge(Mesh::Face_index(5)),
                          triangle.next(triangle.next(triangle.halfedge(Mesh::Face_index(5)))),
                          triangle);
  expect_refused(triangle, Refusal::not_all_quads, 5);
  Mesh pentagon = plate();
  CGAL::Euler::join_face(pentagon.next(pentagon.next(pentagon.halfedge(Mesh::Face_index(2)))),
                         pentagon);
  pentagon.collect_garbage();
  const Adaptation_report r = QMA::adapt_quad_mesh(1., pentagon);
  EXPECT_EQ(r.reason, Refusal::not_all_quads);
}

TEST(Refusals, CoordinatesThatAreNotFinite)
{
  for(double bad :
      { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity() })
    for(int k = 0; k < 3; ++k) {
      Mesh mesh = plate();
      double c[3] = { 3, 2, 0 };
      c[k] = bad;
      mesh.point(Mesh::Vertex_index(17)) = Point(c[0], c[1], c[2]);
      expect_refused(mesh, Refusal::non_finite_coordinate, 17);
    }
}

TEST(Refusals, DegenerateFaces)
{
  Mesh edge = plate(); // an edge of length zero, between vertices 8 and 9
  edge.point(Mesh::Vertex_index(9)) = edge.point(Mesh::Vertex_index(8));
  const Adaptation_report r = QMA::adapt_quad_mesh(1., edge);
  EXPECT_EQ(r.status, Adaptation_status::input_refused);
  EXPECT_EQ(r.reason, Refusal::degenerate_face);
  EXPECT_TRUE(r.entity == 1 || r.entity == 7) << r.entity;

  Mesh flat; // all four corners on a line
  const auto a = flat.add_vertex(Point(0, 0, 0)), b = flat.add_vertex(Point(1, 0, 0)),
             c = flat.add_vertex(Point(3, 0, 0)), d = flat.add_vertex(Point(2, 0, 0));
  flat.add_face(a, b, c, d);
  expect_refused(flat, Refusal::degenerate_face, 0);
}

// Two plates that share a vertex; the numbers of the message are those of the iteration, though
// the vertex is not the first that faces use.
TEST(Refusals, NonManifoldVertex)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for(const Point& p : { Point(9, 9, 9), Point(2, 2, 0), Point(1, 1, 0), Point(2, 1, 0),
                         Point(1, 2, 0), Point(0, 1, 0), Point(0, 0, 0), Point(1, 0, 0) })
    v.push_back(mesh.add_vertex(p));
  ASSERT_NE(mesh.add_face(v[6], v[7], v[2], v[5]), Mesh::null_face());
  ASSERT_NE(mesh.add_face(v[2], v[3], v[1], v[4]), Mesh::null_face());
  expect_refused(mesh, Refusal::non_manifold, 2);
}

TEST(Refusals, BadParameters)
{
  const double infinite = std::numeric_limits<double>::infinity();
  const std::vector<std::pair<double, std::string>> angles = { { 0., "0" },
                                                               { -3., "-3" },
                                                               { 180.5, "180.5" },
                                                               { 180.00000000000003,
                                                                 "180.00000000000003" },
                                                               { 200., "200" },
                                                               { infinite, "inf" },
                                                               { std::nan(""), "nan" } };
  for(const auto& [angle, text] : angles) {
    Mesh mesh = plate();
    const Mesh before = mesh;
    const Adaptation_report r = QMA::adapt_quad_mesh(0.5, mesh, QMA::feature_angle(angle));
    EXPECT_EQ(r.status, Adaptation_status::input_refused);
    EXPECT_EQ(r.reason, Refusal::invalid_parameter);
    EXPECT_NE(r.message.find("feature_angle(" + text + ")"), std::string::npos) << r.message;
    EXPECT_TRUE(zoo_mesh::is_same(mesh, before));
  }
}

TEST(Refusals, BadDistances)
{
  for(double distance : { 0., -3., std::numeric_limits<double>::quiet_NaN() }) {
    Mesh mesh = plate();
    const Mesh before = mesh;
    const Adaptation_report r = QMA::adapt_quad_mesh(0.5, mesh, QMA::max_distance(distance));
    EXPECT_EQ(r.status, Adaptation_status::input_refused);
    EXPECT_EQ(r.reason, Refusal::invalid_parameter);
    EXPECT_NE(r.message.find("max_distance("), std::string::npos) << r.message;
    EXPECT_TRUE(zoo_mesh::is_same(mesh, before));
  }
}

TEST(Refusals, NegativeNumbersOfIterations)
{
  Mesh mesh = plate();
  const Mesh before = mesh;
  const auto np = CGAL::parameters::number_of_iterations(-1);
  for(const Adaptation_report& r :
      { QMA::adapt_quad_mesh(0.5, mesh, np), QMA::smooth(0.5, mesh, np) }) {
    EXPECT_EQ(r.status, Adaptation_status::input_refused);
    EXPECT_EQ(r.reason, Refusal::invalid_parameter);
    EXPECT_NE(r.message.find("number_of_iterations(-1)"), std::string::npos) << r.message;
    EXPECT_TRUE(zoo_mesh::is_same(mesh, before));
  }
  EXPECT_THROW(QMA::expected_number_of_faces(0.5, mesh, np), std::invalid_argument);
}

// --- sizes

TEST(Refused_sizes, AreToldToTheLastDigit)
{
  Mesh mesh = plate();
  const double bad = -0.12345678901234566;
  const Adaptation_report r = QMA::adapt_quad_mesh(Size([&](const Point&) { return bad; }), mesh);
  EXPECT_EQ(r.status, Adaptation_status::sizes_refused);
  EXPECT_NE(r.message.find(" is -0.12345678901234566,"), std::string::npos) << r.message;
}

TEST(Refused_sizes, Numbers)
{
  for(double bad : { 0., -1., -0., std::numeric_limits<double>::quiet_NaN(),
                     std::numeric_limits<double>::infinity(), 1e-7, 1e-200 }) {
    Mesh mesh = plate();
    const Mesh before = mesh;
    const Adaptation_report r = QMA::adapt_quad_mesh(bad, mesh);
    EXPECT_EQ(r.status, Adaptation_status::sizes_refused) << bad;
    EXPECT_EQ(r.reason, Refusal::invalid_size) << bad;
    EXPECT_FALSE(r.message.empty());
    EXPECT_EQ(r.message.find(" at "), std::string::npos) << r.message;
    EXPECT_FALSE(r.place) << bad << " is wrong everywhere";
    EXPECT_TRUE(zoo_mesh::is_same(mesh, before)) << bad;
  }
}

// Bad from the start, and bad only after the mesh was refined into the place.
TEST(Refused_sizes, Functions)
{
  for(double bad : { 0., -1., std::numeric_limits<double>::quiet_NaN(),
                     std::numeric_limits<double>::infinity() })
    for(double radius : { 10., 0.3, 0.02 }) {
      Mesh mesh = plate();
      const Mesh before = mesh;
      const Size size = [=](const Point& p) {
        const double d = std::hypot(p.x() - 3.1, p.y() - 1.9);
        return d < radius ? bad : 0.02 + 0.1 * d;
      };
      const Adaptation_report r = QMA::adapt_quad_mesh(size, mesh);
      EXPECT_EQ(r.status, Adaptation_status::sizes_refused) << bad << ", radius " << radius;
      EXPECT_EQ(r.reason, Refusal::invalid_size);
      EXPECT_NE(r.message.find("size at ("), std::string::npos) << r.message;
      ASSERT_TRUE(r.place);
      const auto [x, y, z] = *r.place;
      EXPECT_LT(std::hypot(x - 3.1, y - 1.9), radius) << "the size is not bad there";
      EXPECT_EQ(z, 0);
      EXPECT_TRUE(zoo_mesh::is_same(mesh, before)) << bad;
    }
}

namespace {

struct My_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

template <typename M>
long calls_of_size(double h)
{
  long calls = 0;
  M mesh = zoo_mesh::make<M, Point>(shape_zoo::plate());
  QMA::adapt_quad_mesh(Size([&](const Point&) { return ++calls, h; }), mesh);
  return calls;
}

// The size throws at its n-th call, for n from the first to the very last.
template <typename M>
void expect_exception_passes()
{
  const double h = 0.6;
  const long all = calls_of_size<M>(h);
  ASSERT_GT(all, 100);
  for(long n : { 1L, 2L, 50L, all / 3, all / 2, all - 500, all - 5, all - 1, all }) {
    M mesh = zoo_mesh::make<M, Point>(shape_zoo::plate());
    const M before = mesh;
    long calls = 0;
    const Size size = [&](const Point&) {
      if(++calls == n) throw My_error("no size here");
      return h;
    };
    EXPECT_THROW(QMA::adapt_quad_mesh(size, mesh), My_error) << "call " << n << " of " << all;
    EXPECT_TRUE(zoo_mesh::is_same(mesh, before)) << "call " << n << " of " << all;
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  }
}

} // namespace

TEST(Exceptions, OfTheSizePassThrough)
{
  expect_exception_passes<Mesh>();
  expect_exception_passes<Polyhedron>();
}

// --- cancelling

TEST(Cancelled, ByTheCallback)
{
  long all = 0;
  double last = 0;
  Mesh whole = plate();
  const Adaptation_report r = QMA::adapt_quad_mesh(
      0.3, whole, CGAL::parameters::callback(std::function<bool(double)>([&](double p) {
        EXPECT_GE(p, last) << "progress goes back";
        EXPECT_LE(p, 1);
        last = p;
        ++all;
        return true;
      })));
  EXPECT_TRUE(r.has_valid_mesh());
  EXPECT_EQ(last, 1);
  ASSERT_GT(all, 5);
  for(long n : { 1L, 2L, all / 3, all / 2, all - 1, all }) {
    Mesh mesh = plate();
    const Mesh before = mesh;
    long calls = 0;
    const Adaptation_report c =
        QMA::adapt_quad_mesh(0.3, mesh,
                             CGAL::parameters::callback(
                                 std::function<bool(double)>([&](double) { return ++calls < n; })));
    EXPECT_EQ(c.status, Adaptation_status::cancelled) << "call " << n << " of " << all;
    EXPECT_FALSE(c.message.empty());
    EXPECT_EQ(calls, n) << "asked again after it was cancelled";
    EXPECT_TRUE(zoo_mesh::is_same(mesh, before)) << "call " << n << " of " << all;
  }
}

namespace {

struct Counting_visitor : QMA::Adaptation_visitor
{
  long asked = 0, give_up_at = std::numeric_limits<long>::max();
  std::vector<std::string> open;
  std::vector<std::string> seen;
  std::size_t faces = 0;
  std::vector<double> foretold;

  void foretell(double f)
  {
    EXPECT_TRUE(seen.empty()) << "foretold after the work has begun";
    foretold.push_back(f);
  }
  void start_phase(const char* name, std::size_t)
  {
    open.push_back(name);
    seen.push_back(name);
  }
  void end_phase(const char* name, std::size_t f)
  {
    ASSERT_FALSE(open.empty());
    EXPECT_EQ(open.back(), name);
    open.pop_back();
    faces = f;
  }
  bool go_further() { return ++asked < give_up_at; }
};

struct Throwing_visitor : QMA::Adaptation_visitor
{
  bool at_start = false;
  int left = 0;
  void start_phase(const char*, std::size_t)
  {
    if(at_start && left-- == 0) throw My_error("start");
  }
  void end_phase(const char*, std::size_t)
  {
    if(!at_start && left-- == 0) throw My_error("end");
  }
};

} // namespace

TEST(Cancelled, ByTheVisitor)
{
  for(QMA::Schedule schedule : { QMA::Schedule::progressive, QMA::Schedule::paper }) {
    Mesh whole = plate();
    Counting_visitor v;
    const auto np = CGAL::parameters::visitor(std::ref(v));
    const Adaptation_report r = QMA::adapt_quad_mesh(0.3, whole, QMA::schedule(schedule, np));
    EXPECT_TRUE(r.has_valid_mesh());
    EXPECT_TRUE(v.open.empty()) << "a phase never ended";
    EXPECT_EQ(std::count(v.seen.begin(), v.seen.end(), "refinement") > 0, true);
    const long all = v.asked;
    ASSERT_GT(all, 5);
    for(long n : { 1L, 2L, all / 3, all / 2, all - 1, all }) {
      Mesh mesh = plate();
      const Mesh before = mesh;
      Counting_visitor w;
      w.give_up_at = n;
      const Adaptation_report c = QMA::adapt_quad_mesh(
          0.3, mesh, QMA::schedule(schedule, CGAL::parameters::visitor(std::ref(w))));
      EXPECT_EQ(c.status, Adaptation_status::cancelled) << n;
      EXPECT_EQ(w.asked, n);
      EXPECT_TRUE(zoo_mesh::is_same(mesh, before)) << n;
    }
  }
}

TEST(Foretold, ToTheVisitorBeforeTheWork)
{
  for(QMA::Schedule schedule : { QMA::Schedule::progressive, QMA::Schedule::paper }) {
    Mesh mesh = plate();
    Counting_visitor v;
    const Adaptation_report r = QMA::adapt_quad_mesh(
        0.3, mesh, QMA::schedule(schedule, CGAL::parameters::visitor(std::ref(v))));
    if(schedule == QMA::Schedule::paper) {
      EXPECT_TRUE(v.foretold.empty());
    } else {
      EXPECT_EQ(v.foretold, std::vector<double>{ r.expected_number_of_faces });
      EXPECT_GT(r.expected_number_of_faces, 0);
    }
  }
}

TEST(Exceptions, OfTheVisitorPassThrough)
{
  for(bool at_start : { true, false })
    for(int left : { 0, 1, 3 }) {
      Mesh mesh = plate();
      const Mesh before = mesh;
      Throwing_visitor v;
      v.at_start = at_start;
      v.left = left;
      EXPECT_THROW(QMA::adapt_quad_mesh(0.3, mesh, CGAL::parameters::visitor(std::ref(v))),
                   My_error);
      EXPECT_TRUE(zoo_mesh::is_same(mesh, before));
    }
}
