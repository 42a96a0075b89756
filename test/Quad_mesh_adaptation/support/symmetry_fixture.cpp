// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "symmetry_fixture.h"

#include <CGAL/Quad_mesh_adaptation/internal/mirror_planes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <set>
#include <tuple>
#include <vector>

namespace symmetry_fixture {

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
  const CGAL::Quad_mesh_adaptation::internal::Box box(s.points);
  return moved(s, [&](const Vec& p) { return p - 0.5 * (box.low + box.high); });
}

Shape cap()
{
  return moved(centred(shape_zoo::plate(8, 8)), [](const Vec& p) {
    return Vec(p.x(), p.y(), 3 - 0.15 * (p.x() * p.x() + p.y() * p.y()));
  });
}

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

Outcome adapt(const Shape& shape, const Size& size, bool keep)
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

std::size_t planes_of(const Shape& shape, const state_fixture::Options& o)
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

} // namespace symmetry_fixture
