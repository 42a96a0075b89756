// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Symmetric meshes with symmetric sizes stay symmetric; all others are adapted as ever.

#include "support/state_fixture.h"

#include <CGAL/adapt_quad_mesh.h>
#include <CGAL/Quad_mesh_adaptation/internal/mirror_planes.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace QMA = CGAL::Quad_mesh_adaptation;

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using shape_zoo::Shape;
using shape_zoo::Vec;
using Size = std::function<double(const Point&)>;

std::tuple<double, double, double> key(const Vec& p)
{
  return { p.x() + 0., p.y() + 0., p.z() + 0. }; // no negative zero
}

Shape moved(Shape s, const std::function<Vec(const Vec&)>& f)
{
  for(Vec& p : s.points) p = f(p);
  return s;
}

Shape centred(const Shape& s)
{
  Vec low = s.points[0], high = low;
  for(const Vec& p : s.points) {
    low = Vec((std::min)(low.x(), p.x()), (std::min)(low.y(), p.y()), (std::min)(low.z(), p.z()));
    high =
        Vec((std::max)(high.x(), p.x()), (std::max)(high.y(), p.y()), (std::max)(high.z(), p.z()));
  }
  return moved(s, [&](const Vec& p) { return p - 0.5 * (low + high); });
}

// A cap like a nosecone: the rim is a square, so that its planes cut no face.
Shape cap()
{
  return moved(centred(shape_zoo::plate(8, 8)), [](const Vec& p) {
    return Vec(p.x(), p.y(), 3 - 0.15 * (p.x() * p.x() + p.y() * p.y()));
  });
}

// Vertices without a partner to the last bit in the plane through the origin across an axis.
std::size_t unmatched(const Mesh& mesh, int axis)
{
  std::set<std::tuple<double, double, double>> all;
  const Shape s = zoo_mesh::shape_of(mesh);
  for(const Vec& p : s.points) all.insert(key(p));
  return std::size_t(std::count_if(s.points.begin(), s.points.end(), [&](const Vec& p) {
    double c[3] = { p.x(), p.y(), p.z() };
    c[axis] = -c[axis];
    return all.count(key(Vec(c[0], c[1], c[2]))) == 0;
  }));
}

// Faces without a partner of opposite orientation, with vertices matched to 1e-7.
std::size_t unmatched_faces(const Mesh& mesh, const Vec& normal)
{
  const Shape s = zoo_mesh::shape_of(mesh);
  const auto rounded = [](const Vec& p) {
    return std::make_tuple(std::llround(p.x() * 1e6), std::llround(p.y() * 1e6),
                           std::llround(p.z() * 1e6));
  };
  using Corner = decltype(rounded(Vec()));
  const auto from_lowest = [](std::vector<Corner> f) {
    std::rotate(f.begin(), std::min_element(f.begin(), f.end()), f.end());
    return f;
  };
  // rounding tells partners apart where they fall on different sides of a step: shift the grid
  const Vec shift(0.31e-6, 0.27e-6, 0.23e-6);
  std::set<std::vector<Corner>> all;
  for(const auto& q : s.quads) {
    std::vector<Corner> f;
    for(auto v : q) f.push_back(rounded(s.points[v] + shift));
    all.insert(from_lowest(f));
  }
  std::size_t missing = 0;
  for(const auto& q : s.quads) {
    std::vector<Corner> f;
    for(int k = 3; k >= 0; --k) {
      const Vec& p = s.points[q[k]];
      f.push_back(rounded(p - 2 * (p * normal) * normal + shift));
    }
    missing += all.count(from_lowest(f)) == 0;
  }
  return missing;
}

struct Outcome
{
  Mesh mesh;
  QMA::Adaptation_report report;
};

Outcome adapt(const Shape& shape, const Size& size, bool keep = true)
{
  Outcome o{ zoo_mesh::make<Mesh, Point>(shape), {} };
  o.report = QMA::adapt_quad_mesh(size, o.mesh, QMA::symmetry(keep));
  EXPECT_TRUE(o.report.has_valid_mesh()) << o.report.message;
  zoo_mesh::expect_valid(o.mesh, mesh_checks::facts_of(shape.points, shape.quads));
  const auto& t = o.report.after.strict_size_ratio;
  EXPECT_EQ(t.not_larger(), t.total()) << o.report.message;
  EXPECT_EQ(o.report.after.faces, o.mesh.number_of_faces());
  EXPECT_LT(o.report.after.max_distance_to_reference, 1e-9);
  EXPECT_TRUE(o.report.after.interior_valence.empty() ||
              o.report.after.interior_valence.begin()->first >= 3u);
  return o;
}

Size uniform(double h)
{
  return [h](const Point&) { return h; };
}

std::size_t planes_of(const Shape& shape, const state_fixture::Options& o = {})
{
  const auto s = state_fixture::make_state(shape, o);
  return QMA::internal::mirror_planes(state_fixture::input_of(shape, o), s).size();
}

Vec turned(const Vec& p)
{
  const double c = std::cos(0.4), s = std::sin(0.4);
  const Vec q(c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z());
  const double d = std::cos(1.1), t = std::sin(1.1);
  return Vec(q.x(), d * q.y() - t * q.z(), t * q.y() + d * q.z()) + Vec(2, -3, 0.7);
}

// Creases and corners of the input are still there.
void expect_features(const Shape& shape, const Mesh& mesh)
{
  const auto s = state_fixture::make_state(shape);
  const auto after = state_fixture::make_state(zoo_mesh::shape_of(mesh));
  const auto length = [](const QMA::internal::Adaptation_state& t) {
    double sum = 0;
    for(const auto& c : t.curves) sum += c.length();
    return sum;
  };
  EXPECT_NEAR(length(s), length(after), 1e-9 * length(s));
  const Shape out = zoo_mesh::shape_of(mesh);
  for(QMA::internal::Index v = 0; v < s.mesh.vertex_end(); ++v)
    if(s.mesh.vertex(v).carrier == QMA::internal::Carrier::corner) {
      EXPECT_EQ(std::count(out.points.begin(), out.points.end(), shape.points[v]), 1);
    }
}

} // namespace

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

TEST(Symmetry, CircularLoad)
{
  const Shape plate = centred(shape_zoo::plate(10, 10));
  for(double k : { 0.7, 0.35 }) {
    const Outcome o = adapt(plate, [k](const Point& p) {
      return k * (0.1 + std::abs(std::hypot(p.x(), p.y()) - 4.8));
    });
    EXPECT_EQ(unmatched(o.mesh, 0), 0u);
    EXPECT_EQ(unmatched(o.mesh, 1), 0u);
    EXPECT_EQ(unmatched_faces(o.mesh, Vec(1, 0, 0)), 0u);
    EXPECT_EQ(unmatched_faces(o.mesh, Vec(0, 1, 0)), 0u);
    EXPECT_GT(o.report.after.faces, 500u);
  }
}

TEST(Symmetry, Cap)
{
  const Shape shape = cap();
  const Outcome o = adapt(shape, [](const Point& p) { return 0.08 + 0.15 * (3 - p.z()); });
  EXPECT_EQ(unmatched(o.mesh, 0), 0u);
  EXPECT_EQ(unmatched(o.mesh, 1), 0u);
  EXPECT_EQ(unmatched_faces(o.mesh, Vec(1, 0, 0)), 0u);
}

TEST(Symmetry, BoxWithCreases)
{
  const Shape box = centred(shape_zoo::cube(6));
  const Outcome o =
      adapt(box, [](const Point& p) { return 0.22 * (1 + 0.1 * std::abs(p.x() * p.y())); });
  for(int axis = 0; axis < 3; ++axis) EXPECT_EQ(unmatched(o.mesh, axis), 0u);
  EXPECT_EQ(unmatched_faces(o.mesh, Vec(0, 0, 1)), 0u);
  expect_features(box, o.mesh);
}

// The trigonometric functions of the shape leave its input symmetric to some 1e-16 only.
TEST(Symmetry, ClosedSurfaces)
{
  for(const Shape& s : { shape_zoo::torus(24, 12), shape_zoo::sphere(8) }) {
    const Outcome o = adapt(s, uniform(0.3 * zoo_mesh::mean_edge(s)));
    for(const Vec& n : { Vec(1, 0, 0), Vec(0, 1, 0), Vec(0, 0, 1) })
      EXPECT_EQ(unmatched_faces(o.mesh, n), 0u) << s.name;
  }
}

// Symmetry must not cost many faces; where few are asked for, it is given up before.
TEST(Symmetry, CostsFewFaces)
{
  for(const Shape& s : { centred(shape_zoo::cube(6)), shape_zoo::torus(24, 12),
                         shape_zoo::sphere(8), centred(shape_zoo::plate(8, 8)) })
    for(double factor : { 0.9, 1.6, 3.1 }) {
      const Size size = uniform(factor * zoo_mesh::mean_edge(s));
      const Outcome kept = adapt(s, size), free = adapt(s, size, false);
      EXPECT_LE(double(kept.report.after.faces), 1.1 * double(free.report.after.faces))
          << s.name << ", factor " << factor;
    }
}

TEST(Symmetry, InAnyPosition)
{
  const Shape plate = centred(shape_zoo::plate(8, 6));
  const Shape shape = moved(plate, [](const Vec& p) { return turned(p) - turned(Vec(0, 0, 0)); });
  const Vec x = shape.points[1] - shape.points[0], y = shape.points[9] - shape.points[0];
  const Outcome o = adapt(
      shape, [x](const Point& p) { return 0.1 + 0.03 * std::abs(Vec(p.x(), p.y(), p.z()) * x); });
  EXPECT_EQ(unmatched_faces(o.mesh, x), 0u);
  EXPECT_EQ(unmatched_faces(o.mesh, y), 0u);
}

TEST(Symmetry, OnePlaneOnly)
{
  const Shape shape = centred(shape_zoo::plate(8, 5));
  const Outcome o = adapt(shape, [](const Point& p) { return 0.15 + 0.02 * (p.y() + 3); });
  EXPECT_EQ(unmatched(o.mesh, 0), 0u);
  EXPECT_GT(unmatched(o.mesh, 1), 0u);
}

// What looks symmetric to the samples but is not: the result must not be.
TEST(Symmetry, SizeUnsymmetricBetweenTheSamples)
{
  const Shape shape = centred(shape_zoo::plate(4, 4));
  for(double side : { -1., 1. }) {
    const Size size = [side](const Point& p) {
      const double x = side * p.x() - 0.75, y = p.y() - 0.75;
      return x * x + y * y < 0.04 ? 0.05 : 0.5;
    };
    state_fixture::Options o;
    o.size = [&](const Vec& p) { return size(Point(p.x(), p.y(), p.z())); };
    ASSERT_EQ(planes_of(shape, o), 2u);
    const Shape before = zoo_mesh::shape_of(zoo_mesh::make<Mesh, Point>(shape));
    Mesh mesh = zoo_mesh::make<Mesh, Point>(shape);
    const QMA::Adaptation_report r = QMA::adapt_quad_mesh(size, mesh);
    ASSERT_TRUE(r.has_valid_mesh());
    zoo_mesh::expect_valid(mesh, mesh_checks::facts_of(before.points, before.quads));
    EXPECT_GT(unmatched(mesh, 0), 0u);
  }
}

TEST(Symmetry, CanBeSwitchedOff)
{
  const Shape plate = centred(shape_zoo::plate(10, 10));
  const Size size = [](const Point& p) { return 0.1 + std::abs(std::hypot(p.x(), p.y()) - 4.8); };
  EXPECT_GT(unmatched(adapt(plate, size, false).mesh, 0), 0u);
}

// A mesh without a plane is adapted to the last bit as if symmetry had not been asked for.
TEST(Symmetry, OthersAreNotTouched)
{
  const Shape shape = shape_zoo::irregular();
  const Outcome a = adapt(shape, uniform(0.3)), b = adapt(shape, uniform(0.3), false);
  EXPECT_TRUE(zoo_mesh::is_same(a.mesh, b.mesh));
}

// Descriptors of what did not change survive on both sides alike, and so do points.
TEST(Symmetry, DescriptorsSurvive)
{
  const Shape shape = centred(shape_zoo::plate(24, 12));
  const Mesh before = zoo_mesh::make<Mesh, Point>(shape);
  Mesh mesh = before;
  const auto size = [](const Point& p) { return std::abs(p.x()) > 9 ? 0.25 : 1.02; };
  ASSERT_TRUE(QMA::adapt_quad_mesh(size, mesh).has_valid_mesh());
  std::size_t left = 0, right = 0;
  for(auto f : before.faces()) {
    if(mesh.is_removed(f)) continue;
    const auto u = CGAL::vertices_around_face(before.halfedge(f), before);
    const auto w = CGAL::vertices_around_face(mesh.halfedge(f), mesh);
    if(!std::equal(u.begin(), u.end(), w.begin(), w.end())) continue;
    ++(before.point(*u.begin()).x() + before.point(*std::next(u.begin(), 2)).x() > 0 ? right
                                                                                     : left);
  }
  EXPECT_EQ(left, right);
  EXPECT_GT(left + right, before.number_of_faces() / 4);
  EXPECT_EQ(unmatched(mesh, 0), 0u);
  EXPECT_EQ(unmatched(mesh, 1), 0u);
}

// A second call with the same sizes changes nothing.
TEST(Symmetry, IsRepeatable)
{
  Outcome o = adapt(centred(shape_zoo::cube(4)), uniform(0.31));
  o.mesh.collect_garbage();
  const Mesh first = o.mesh;
  QMA::adapt_quad_mesh(uniform(0.31), o.mesh);
  EXPECT_TRUE(zoo_mesh::is_same(first, o.mesh));
}

// Constrained edges along a plane stay marked, those across it as well.
TEST(Symmetry, ConstrainedEdges)
{
  const Shape shape = centred(shape_zoo::plate(8, 8));
  Mesh mesh = zoo_mesh::make<Mesh, Point>(shape);
  auto marks = mesh.add_property_map<Mesh::Edge_index, bool>("e:marked", false).first;
  const auto on_cross = [&](Mesh::Edge_index e) {
    const Point p = mesh.point(mesh.vertex(e, 0)), q = mesh.point(mesh.vertex(e, 1));
    const auto flat = [](double a, double b, double c) {
      return std::abs(a - c) < 1e-9 && std::abs(b - c) < 1e-9;
    };
    return flat(p.x(), q.x(), 0) || flat(p.y(), q.y(), 2) || flat(p.y(), q.y(), -2);
  };
  for(auto e : mesh.edges()) marks[e] = on_cross(e);
  const double before = 8 * 3;
  const auto size = [](const Point& p) { return 0.12 + 0.04 * std::abs(p.x()); };
  const auto report =
      QMA::adapt_quad_mesh(size, mesh, CGAL::parameters::edge_is_constrained_map(marks));
  ASSERT_TRUE(report.has_valid_mesh());
  double length = 0;
  for(auto e : mesh.edges()) {
    EXPECT_EQ(marks[e], on_cross(e));
    if(marks[e])
      length += std::sqrt(
          CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  }
  EXPECT_NEAR(length, before, 1e-9);
  EXPECT_EQ(unmatched(mesh, 0), 0u);
  EXPECT_EQ(unmatched(mesh, 1), 0u);
}

// Without corners in the plane of the border, too.
TEST(Symmetry, NoFeatureAngle)
{
  const Shape shape = centred(shape_zoo::cube(6));
  Mesh mesh = zoo_mesh::make<Mesh, Point>(shape);
  const auto report = QMA::adapt_quad_mesh(0.3, mesh, QMA::feature_angle(180));
  ASSERT_TRUE(report.has_valid_mesh());
  zoo_mesh::expect_valid(mesh, mesh_checks::facts_of(shape.points, shape.quads));
  for(int axis = 0; axis < 3; ++axis) EXPECT_EQ(unmatched(mesh, axis), 0u);
}

TEST(Symmetry, Region)
{
  const Shape shape = centred(shape_zoo::plate(16, 16));
  Mesh mesh = zoo_mesh::make<Mesh, Point>(shape);
  std::vector<Mesh::Face_index> region;
  for(auto f : mesh.faces()) {
    double x = 0;
    for(auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh)) x += mesh.point(v).x() / 4;
    if(std::abs(x) < 4) region.push_back(f);
  }
  const auto report = QMA::adapt_quad_mesh(region, 0.3, mesh);
  ASSERT_TRUE(report.has_valid_mesh()) << report.message;
  zoo_mesh::expect_valid(mesh, mesh_checks::facts_of(shape.points, shape.quads));
  EXPECT_EQ(unmatched(mesh, 0), 0u);
  EXPECT_EQ(unmatched(mesh, 1), 0u);
}

// Faces of all images are of the patch they descend from.
TEST(Symmetry, Patches)
{
  const Shape shape = centred(shape_zoo::plate(8, 8));
  Mesh mesh = zoo_mesh::make<Mesh, Point>(shape);
  auto patch = mesh.add_property_map<Mesh::Face_index, int>("f:number", 0).first;
  const auto wanted = [&](Mesh::Face_index f) {
    double y = 0;
    for(auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh)) y += mesh.point(v).y() / 4;
    return std::abs(y) < 2 ? 7 : 3;
  };
  for(auto f : mesh.faces()) patch[f] = wanted(f);
  const auto size = [](const Point& p) { return 0.12 + 0.04 * std::abs(p.x()); };
  ASSERT_TRUE(
      QMA::adapt_quad_mesh(size, mesh, CGAL::parameters::face_patch_map(patch)).has_valid_mesh());
  for(auto f : mesh.faces()) EXPECT_EQ(patch[f], wanted(f));
  EXPECT_EQ(unmatched(mesh, 0), 0u);
  EXPECT_EQ(unmatched(mesh, 1), 0u);
}

// A reference that is the input's own plane, in triangles of its own, does not stand in the way;
// one with another border does.
TEST(Symmetry, FlatReference)
{
  const Shape shape = centred(shape_zoo::plate(10, 10));
  const Size size = [](const Point& p) {
    return 0.7 * (0.1 + std::abs(std::hypot(p.x(), p.y()) - 4.8));
  };
  Mesh square;
  std::vector<Mesh::Vertex_index> c;
  for(const Point& p : { Point(-5, -5, 0), Point(5, -5, 0), Point(5, 5, 0), Point(-5, 5, 0) })
    c.push_back(square.add_vertex(p));
  square.add_face(c[0], c[1], c[2]);
  square.add_face(c[0], c[2], c[3]);
  Mesh mesh = zoo_mesh::make<Mesh, Point>(shape);
  ASSERT_TRUE(QMA::adapt_quad_mesh(size, mesh, QMA::reference_surface(square)).has_valid_mesh());
  EXPECT_EQ(unmatched(mesh, 0), 0u);
  EXPECT_EQ(unmatched(mesh, 1), 0u);

  square.point(c[2]) = Point(5.1, 5.1, 0);
  Mesh bent = zoo_mesh::make<Mesh, Point>(shape);
  ASSERT_TRUE(QMA::adapt_quad_mesh(size, bent, QMA::reference_surface(square)).has_valid_mesh());
  EXPECT_GT(unmatched(bent, 0), 0u);
  const Shape out = zoo_mesh::shape_of(bent);
  EXPECT_TRUE(
      std::any_of(out.points.begin(), out.points.end(), [](const Vec& p) { return p.x() > 5.05; }));
}

// Exceptions of the caller leave the mesh as it was.
TEST(Symmetry, ExceptionsPass)
{
  const Shape shape = centred(shape_zoo::plate(8, 8));
  Mesh mesh = zoo_mesh::make<Mesh, Point>(shape);
  const Mesh before = mesh;
  int calls = 0;
  const auto size = [&](const Point&) {
    if(++calls > 20000) throw 7;
    return 0.2;
  };
  EXPECT_THROW(QMA::adapt_quad_mesh(size, mesh), int);
  EXPECT_TRUE(zoo_mesh::is_same(mesh, before));
}
