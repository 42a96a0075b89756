// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Combined fields, proximity and sizes from error indicators.

#include "support/usual_calls.h"

#include <CGAL/Quad_mesh_adaptation/Error_sizing_field.h>
#include <CGAL/Quad_mesh_adaptation/Graded_sizing_field.h>
#include <CGAL/Quad_mesh_adaptation/Proximity_sizing_field.h>
#include <CGAL/Quad_mesh_adaptation/combined_sizing_fields.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace QMA = CGAL::Quad_mesh_adaptation;

namespace {

using shape_zoo::Index;
using shape_zoo::Shape;
using shape_zoo::Vec;
using usual_mesh::Mesh;
using usual_mesh::mesh_of;
using usual_mesh::Point;
using usual_mesh::Size;

const double nan_value = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

// The cube [0,3]^3 of the zoo, each side cut into n x n faces, with another thickness.
Shape slab(double thickness, double at = 0)
{
  Shape s = shape_zoo::cube(6);
  double top = 0;
  for(const Vec& p : s.points) top = (std::max)(top, p.z());
  for(Vec& p : s.points) p = Vec(p.x(), p.y(), at + thickness * p.z() / top);
  return s;
}

// From one side wall of the slab to the other.
double between_side_walls(const Shape& s)
{
  double low = infinity, high = -infinity;
  for(const Vec& p : s.points) {
    low = (std::min)(low, p.x());
    high = (std::max)(high, p.x());
  }
  return high - low;
}

double smallest_xy(const Shape& s)
{
  double low = infinity;
  for(const Vec& p : s.points) low = (std::min)(low, p.x());
  return low;
}

} // namespace

TEST(Combined_sizing_fields, TakeTheSmallestTheLargestAndTheBounds)
{
  const auto x = [](const Point& p) { return p.x(); };
  const auto y = [](const Point& p) { return p.y(); };
  const QMA::Minimum_sizing_field low(x, 2, y);
  const QMA::Maximum_sizing_field high(x, y, 0.5);
  const QMA::Clamped_sizing_field bounded(high, { 1, 3 });
  EXPECT_EQ(low(Point(5, 3, 0)), 2);
  EXPECT_EQ(low(Point(5, 1, 0)), 1);
  EXPECT_EQ(high(Point(0.1, 0.2, 0)), 0.5);
  EXPECT_EQ(high(Point(5, 1, 0)), 5);
  EXPECT_EQ(bounded(Point(5, 1, 0)), 3);
  EXPECT_EQ(bounded(Point(0, 0, 0)), 1);
  EXPECT_EQ(bounded(Point(2, 1, 0)), 2);
}

TEST(Combined_sizing_fields, DoNotHideWhatIsNoSize)
{
  const auto bad = [](const Point&) { return nan_value; };
  EXPECT_TRUE(std::isnan(QMA::Clamped_sizing_field(bad, { 1, 3 })(Point(0, 0, 0))));
  Mesh mesh = mesh_of(shape_zoo::plate());
  const Mesh before = mesh;
  const auto report = QMA::adapt_quad_mesh(Size(QMA::Clamped_sizing_field(bad, { 1, 3 })), mesh);
  EXPECT_EQ(report.status, QMA::Adaptation_status::sizes_refused);
  EXPECT_TRUE(zoo_mesh::is_same(mesh, before));
  const Point p(0, 0, 0);
  EXPECT_TRUE(std::isnan(QMA::Minimum_sizing_field(bad, 1, 2)(p)));
  EXPECT_TRUE(std::isnan(QMA::Minimum_sizing_field(2, 1, bad)(p)));
  EXPECT_TRUE(std::isnan(QMA::Maximum_sizing_field(bad, 1, 2)(p)));
  EXPECT_TRUE(std::isnan(QMA::Maximum_sizing_field(1, bad, 2)(p)));
  EXPECT_THROW(QMA::Clamped_sizing_field(1., { 3, 1 }), std::invalid_argument);
  EXPECT_THROW(QMA::Clamped_sizing_field(1., { -1, 1 }), std::invalid_argument);
  EXPECT_THROW(QMA::Clamped_sizing_field(1., { nan_value, 1 }), std::invalid_argument);
}

TEST(Proximity_sizing_field, AsksForElementsAcrossAThinPart)
{
  const Shape s = slab(0.2);
  const Mesh mesh = mesh_of(s);
  const QMA::Proximity_sizing_field size(mesh, 2);
  const double far = between_side_walls(s) / 2;
  for(const Vec& p : s.points) {
    const bool is_on_thin_part = p.z() < 1e-9 || p.z() > 0.2 - 1e-9;
    EXPECT_NEAR(size(Point(p.x(), p.y(), p.z())), is_on_thin_part ? 0.1 : far, 1e-6);
  }
  const QMA::Proximity_sizing_field bounded(mesh, 2, { 0.15, 1 });
  EXPECT_NEAR(bounded(Point(1, 1, 0)), 0.15, 1e-9);
}

TEST(Proximity_sizing_field, ASphereIsAsThickAsItsDiameter)
{
  const Shape s = shape_zoo::sphere(8);
  const QMA::Proximity_sizing_field size(mesh_of(s), 4);
  for(const Vec& p : s.points) EXPECT_NEAR(size(Point(p.x(), p.y(), p.z())), 0.5, 0.03);
}

TEST(Proximity_sizing_field, TellsAGapFromAPart)
{
  Shape two = slab(1);
  const double low = smallest_xy(two);
  const Shape other = slab(1, 1.1);
  const Index n = Index(two.points.size());
  for(const auto& q : other.quads) two.quads.push_back({ q[0] + n, q[1] + n, q[2] + n, q[3] + n });
  two.points.insert(two.points.end(), other.points.begin(), other.points.end());
  const Mesh mesh = mesh_of(two);
  const Point middle(low + 1.5, low + 1.5, 1), above(low + 1.5, low + 1.5, 1.1),
      below(low + 1.5, low + 1.5, 0);
  const QMA::Size_range range = { 0, 5 };
  const QMA::Proximity_sizing_field part(mesh, 1, range), //
      gap(mesh, 1, range, QMA::Proximity::gap), both(mesh, 1, range, QMA::Proximity::both);
  EXPECT_NEAR(part(middle), 1, 1e-6);
  EXPECT_NEAR(gap(middle), 0.1, 1e-6);
  EXPECT_NEAR(gap(above), 0.1, 1e-6);
  EXPECT_NEAR(gap(below), 5, 1e-6);
  EXPECT_NEAR(both(middle), 0.1, 1e-6);
  EXPECT_NEAR(both(below), 1, 1e-6);
}

TEST(Proximity_sizing_field, RefusesWhatMakesNoSense)
{
  const Mesh mesh = mesh_of(shape_zoo::cube());
  for(const double bad : { 0., -1., nan_value, infinity })
    EXPECT_THROW(QMA::Proximity_sizing_field(mesh, bad), std::invalid_argument);
  EXPECT_THROW(QMA::Proximity_sizing_field(mesh, 1, { 2, 1 }), std::invalid_argument);
  EXPECT_THROW(QMA::Proximity_sizing_field(Mesh(), 1), std::invalid_argument);
}

namespace {

// A plate of unit faces with an indicator at each of them.
struct Estimated
{
  explicit Estimated(int n) : mesh(mesh_of(shape_zoo::plate(n, n)))
  {
    errors = mesh.add_property_map<Mesh::Face_index, double>("f:error", 1.).first;
  }
  double total() const
  {
    double sum = 0;
    for(auto f : mesh.faces()) sum += errors[f] * errors[f];
    return std::sqrt(sum);
  }
  Mesh mesh;
  Mesh::Property_map<Mesh::Face_index, double> errors;
};

} // namespace

TEST(Error_sizing_field, EvenErrorsGiveAnEvenSize)
{
  // 36 faces of error 1: 6 in all; with h^p it takes h = (target / 6)^(1 / p)
  const Estimated e(6);
  for(const double order : { 1., 2., 3. }) {
    QMA::Error_sizing_options options;
    options.order = order;
    const QMA::Error_sizing_field size(e.mesh, e.errors, QMA::Error_target::error(2), options);
    EXPECT_NEAR(size(Point(2.3, 1.1, 0)), std::pow(2. / 6, 1 / order), 1e-6) << order;
    const QMA::Error_sizing_field same(e.mesh, e.errors, QMA::Error_target::reduction(1. / 3),
                                       options);
    EXPECT_NEAR(same(Point(2.3, 1.1, 0)), std::pow(2. / 6, 1 / order), 1e-6) << order;
  }
}

TEST(Error_sizing_field, MeetsTheClosedFormWhereNothingIsLimited)
{
  // bilinear elements: h_new = h target / sqrt(e_i sum of e_k)
  std::mt19937 random(3);
  std::uniform_real_distribution<> real(0.5, 2);
  std::vector<double> errors;
  double sum = 0;
  for(int i = 0; i < 50; ++i) sum += (errors.push_back(real(random)), errors.back());
  QMA::internal::Optimal_sizes optimal(errors, 1, 1000);
  optimal.set_error(0.7);
  for(std::size_t i = 0; i < errors.size(); ++i)
    EXPECT_NEAR(optimal.ratio(i), 0.7 / std::sqrt(errors[i] * sum), 1e-9);
  EXPECT_NEAR(optimal.error(), 0.7, 1e-9);
  optimal.set_number_of_faces(333);
  EXPECT_NEAR(optimal.number_of_faces(), 333, 1e-6);
}

TEST(Error_sizing_field, LimitsAreMadeUpForByOtherFaces)
{
  QMA::internal::Optimal_sizes optimal({ 100, 1, 1, 1 }, 1, 2);
  optimal.set_number_of_faces(9);
  EXPECT_NEAR(optimal.ratio(0), 0.5, 1e-12);
  EXPECT_NEAR(optimal.number_of_faces(), 9, 1e-6);
}

TEST(Error_sizing_field, FacesComeOutAsManyAsAsked)
{
  Estimated e(12);
  for(auto f : e.mesh.faces()) {
    const Vec c(e.mesh.point(target(e.mesh.halfedge(f), e.mesh)) - Point(2, 3, 0));
    e.errors[f] = 1 / (1 + c.squared_length());
  }
  Mesh mesh = e.mesh;
  const auto report = QMA::adapt_quad_mesh(
      Size(QMA::Error_sizing_field(e.mesh, e.errors, QMA::Error_target::number_of_faces(600))),
      mesh);
  EXPECT_TRUE(report.has_valid_mesh());
  EXPECT_NEAR(double(report.after.faces), 600, 90);
}

TEST(Error_sizing_field, TakesIndicatorsAtVertices)
{
  Estimated e(6);
  auto at_vertices = e.mesh.add_property_map<Mesh::Vertex_index, double>("v:error", 0.).first;
  const Point where(3, 3, 0);
  for(auto v : e.mesh.vertices())
    at_vertices[v] = 0.1 + (CGAL::squared_distance(e.mesh.point(v), where) < 0.1 ? 1 : 0);
  const QMA::Error_sizing_field size(e.mesh, at_vertices, QMA::Error_target::reduction(0.5));
  EXPECT_LT(size(where), 0.6 * size(Point(0.5, 0.5, 0)));
}

TEST(Error_sizing_field, RefusesWhatMakesNoSense)
{
  Estimated e(2);
  using Target = QMA::Error_target;
  const auto make = [&](const Target& t, const QMA::Error_sizing_options& o = {}) {
    return QMA::Error_sizing_field(e.mesh, e.errors, t, o);
  };
  for(const double bad : { 0., -1., nan_value, infinity }) {
    EXPECT_THROW(make(Target::error(bad)), std::invalid_argument);
    QMA::Error_sizing_options o;
    o.order = bad;
    EXPECT_THROW(make(Target::error(1), o), std::invalid_argument);
    o = {};
    o.largest_change = bad;
    EXPECT_THROW(make(Target::error(1), o), std::invalid_argument);
  }
  for(const double bad : { -1., nan_value, infinity }) {
    e.errors[*e.mesh.faces().begin()] = bad;
    EXPECT_THROW(make(Target::error(1)), std::invalid_argument);
  }
  for(auto f : e.mesh.faces()) e.errors[f] = 0;
  EXPECT_THROW(make(Target::error(1)), std::invalid_argument);
}
