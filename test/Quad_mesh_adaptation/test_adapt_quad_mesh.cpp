// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// adapt_quad_mesh() on whole meshes: shapes, types of mesh, kernels, both schedules.

#include "support/state_fixture.h"
#include "support/usual_calls.h"
#include "support/usual_measures.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace QMA = CGAL::Quad_mesh_adaptation;

namespace {

using Cartesian = CGAL::Simple_cartesian<double>;
using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Cartesian::Point_3>;
using QMA::Adaptation_report;
using QMA::Mesh_measures;
using QMA::Schedule;
using shape_zoo::Shape;
using shape_zoo::Vec;

std::vector<Shape> shapes()
{
  return { shape_zoo::plate(),         shape_zoo::l_shape(),
           shape_zoo::annulus(),       shape_zoo::cube(),
           shape_zoo::torus(),         shape_zoo::open_cylinder(),
           shape_zoo::sphere(),        shape_zoo::slab_with_tunnels(2),
           shape_zoo::two_components() };
}

// Corners of the input that must be there to the last bit.
template <typename M>
void expect_corners(const M& mesh, const Shape& input)
{
  const QMA::internal::Adaptation_state s = state_fixture::make_state(input);
  const Shape after = zoo_mesh::shape_of(mesh);
  for(QMA::internal::Index v = 0; v < s.mesh.vertex_end(); ++v) {
    if(s.mesh.vertex(v).carrier != QMA::internal::Carrier::corner) continue;
    EXPECT_EQ(std::count(after.points.begin(), after.points.end(), input.points[v]), 1)
        << "corner " << v;
  }
}

// A fresh measurement of the mesh says what the report says.
template <typename M, typename Size>
void expect_measures(const M& mesh, const Size& size, const Mesh_measures& told)
{
  const Mesh_measures m = QMA::measure_quad_mesh(mesh, size);
  EXPECT_EQ(m.vertices, told.vertices);
  EXPECT_EQ(m.edges, told.edges);
  EXPECT_EQ(m.faces, told.faces);
  EXPECT_EQ(m.components, told.components);
  EXPECT_EQ(m.boundary_edges, told.boundary_edges);
  EXPECT_EQ(m.boundary_loops, told.boundary_loops);
  EXPECT_EQ(m.euler_characteristic, told.euler_characteristic);
  EXPECT_EQ(m.size_ratio.counts, told.size_ratio.counts);
  EXPECT_EQ(m.strict_size_ratio.counts, told.strict_size_ratio.counts);
  EXPECT_NEAR(m.efficiency, told.efficiency, 1e-3 * m.efficiency);
  EXPECT_NEAR(m.min_scaled_jacobian, told.min_scaled_jacobian, 1e-9);
  EXPECT_EQ(m.interior_valence, told.interior_valence);
}

template <typename M, typename Point>
Adaptation_report adapt(const Shape& shape, double size, Schedule schedule)
{
  SCOPED_TRACE(shape.name + ", size " + std::to_string(size) +
               (schedule == Schedule::paper ? ", paper" : ""));
  M mesh = zoo_mesh::make<M, Point>(shape);
  const mesh_checks::Facts before = mesh_checks::facts_of(shape.points, shape.quads);
  const Mesh_measures first = QMA::measure_quad_mesh(mesh, size);
  const Adaptation_report report = QMA::adapt_quad_mesh(size, mesh, QMA::schedule(schedule));
  EXPECT_TRUE(report.has_valid_mesh()) << report.message;
  EXPECT_EQ(report.before.faces, first.faces);
  EXPECT_EQ(report.before.size_ratio.counts, first.size_ratio.counts);
  zoo_mesh::expect_valid(mesh, before);
  expect_corners(mesh, shape);
  expect_measures(mesh, size, report.after);
  return report;
}

template <typename M, typename Point>
void adapt_all(Schedule schedule)
{
  for(const Shape& shape : shapes()) {
    const double edge = zoo_mesh::mean_edge(shape);
    const Adaptation_report fine = adapt<M, Point>(shape, 0.45 * edge, schedule);
    EXPECT_GT(fine.after.faces, 2 * shape.quads.size()) << shape.name;
    const Adaptation_report coarse = adapt<M, Point>(shape, 2.1 * edge, schedule);
    if(schedule == Schedule::progressive) {
      EXPECT_LE(coarse.after.faces, shape.quads.size()) << shape.name;
      EXPECT_EQ(fine.status, QMA::Adaptation_status::sizes_met) << shape.name << fine.message;
      EXPECT_EQ(fine.after.strict_size_ratio.not_larger(), fine.after.faces) << shape.name;
    }
  }
}

// Area of a plane shape and its box, which no adaptation may change.
double area_of(const Shape& s) { return mesh_checks::facts_of(s.points, s.quads).area; }

} // namespace

TEST(Adapt_quad_mesh, SurfaceMeshCartesian)
{
  adapt_all<Mesh, Cartesian::Point_3>(Schedule::progressive);
}

TEST(Adapt_quad_mesh, SurfaceMeshEpick)
{
  using M = CGAL::Surface_mesh<Epick::Point_3>;
  for(const Shape& shape : { shape_zoo::l_shape(), shape_zoo::torus() })
    for(double factor : { 0.5, 2. })
      adapt<M, Epick::Point_3>(shape, factor * zoo_mesh::mean_edge(shape), Schedule::progressive);
}

TEST(Adapt_quad_mesh, Polyhedron)
{
  adapt_all<CGAL::Polyhedron_3<Cartesian>, Cartesian::Point_3>(Schedule::progressive);
}

TEST(Adapt_quad_mesh, PaperSchedule) { adapt_all<Mesh, Cartesian::Point_3>(Schedule::paper); }

// The type of mesh and the kernel do not matter for the result.
TEST(Adapt_quad_mesh, AllTypesAgree)
{
  using Epick_mesh = CGAL::Surface_mesh<Epick::Point_3>;
  using Polyhedron = CGAL::Polyhedron_3<Cartesian>;
  for(const Shape& shape : { shape_zoo::plate(), shape_zoo::sphere() }) {
    const double h = 0.6 * zoo_mesh::mean_edge(shape);
    Mesh a = zoo_mesh::make<Mesh, Cartesian::Point_3>(shape);
    Epick_mesh b = zoo_mesh::make<Epick_mesh, Epick::Point_3>(shape);
    Polyhedron c = zoo_mesh::make<Polyhedron, Cartesian::Point_3>(shape);
    QMA::adapt_quad_mesh(h, a);
    QMA::adapt_quad_mesh(h, b);
    QMA::adapt_quad_mesh(h, c);
    std::vector<Vec> p = zoo_mesh::shape_of(a).points, q = zoo_mesh::shape_of(b).points,
                     r = zoo_mesh::shape_of(c).points;
    const auto less = [](const Vec& u, const Vec& v) {
      return std::make_tuple(u.x(), u.y(), u.z()) < std::make_tuple(v.x(), v.y(), v.z());
    };
    for(std::vector<Vec>* list : { &p, &q, &r }) std::sort(list->begin(), list->end(), less);
    EXPECT_EQ(p, q) << shape.name;
    EXPECT_EQ(p, r) << shape.name;
  }
}

// As near as possible: about as many faces as the sizes ask for, ratios on both sides of one.
TEST(Adapt_quad_mesh, AsNearAsPossible)
{
  double sum = 0;
  std::size_t runs = 0, faces = 0, faces_within = 0;
  for(const Shape& shape : { shape_zoo::plate(), shape_zoo::torus(), shape_zoo::annulus() })
    for(double factor : { 0.36, 0.4, 0.45 }) {
      SCOPED_TRACE(shape.name + " x " + std::to_string(factor));
      const double h = factor * zoo_mesh::mean_edge(shape);
      Mesh mesh = zoo_mesh::make<Mesh, Cartesian::Point_3>(shape), strict = mesh;
      const Adaptation_report near = QMA::adapt_quad_mesh(h, mesh, QMA::aim(QMA::Aim::nearest));
      const Adaptation_report within = QMA::adapt_quad_mesh(h, strict);
      EXPECT_EQ(near.status, QMA::Adaptation_status::sizes_met) << near.message;
      EXPECT_NEAR(near.after.efficiency, 1, 0.15); // whole numbers of faces along the sides
      EXPECT_LE(near.after.faces, within.after.faces);
      EXPECT_NEAR(near.after.size_ratio.mean, 1, 0.06);
      EXPECT_LT(near.after.strict_size_ratio.max, std::sqrt(2.));
      faces += near.after.faces;
      faces_within += within.after.faces;
      sum += near.after.efficiency;
      ++runs;
    }
  EXPECT_NEAR(sum / runs, 1, 0.05);
  EXPECT_LT(faces, 0.95 * faces_within);
}

TEST(Adapt_quad_mesh, StraightBordersStayStraight)
{
  for(const Shape& shape : { shape_zoo::plate(), shape_zoo::l_shape(), shape_zoo::irregular() })
    for(double factor : { 0.4, 1.3, 2.5 })
      for(Schedule schedule : { Schedule::progressive, Schedule::paper }) {
        Mesh mesh = zoo_mesh::make<Mesh, Cartesian::Point_3>(shape);
        QMA::adapt_quad_mesh(factor * zoo_mesh::mean_edge(shape), mesh, QMA::schedule(schedule));
        EXPECT_NEAR(area_of(zoo_mesh::shape_of(mesh)), area_of(shape), 1e-9 * area_of(shape))
            << shape.name << ", factor " << factor;
      }
}

TEST(Adapt_quad_mesh, NodesStayOnTheSurface)
{
  for(const Shape& shape : { shape_zoo::sphere(), shape_zoo::torus(), shape_zoo::saddle() }) {
    Mesh mesh = zoo_mesh::make<Mesh, Cartesian::Point_3>(shape);
    const Adaptation_report report = QMA::adapt_quad_mesh(0.4 * zoo_mesh::mean_edge(shape), mesh);
    EXPECT_LT(report.after.max_distance_to_reference, 1e-9) << shape.name;
    const QMA::internal::Adaptation_state s = state_fixture::make_state(shape);
    for(const Vec& p : zoo_mesh::shape_of(mesh).points)
      EXPECT_LT(s.surface.distance_to(p), 1e-9) << shape.name;
  }
}

// A mesh of the right size already stays as it is, descriptors included.
TEST(Adapt_quad_mesh, FittingSizeChangesNothing)
{
  for(const Shape& shape : { shape_zoo::plate(), shape_zoo::l_shape(), shape_zoo::cube() }) {
    const Mesh before = zoo_mesh::make<Mesh, Cartesian::Point_3>(shape);
    Mesh mesh = before;
    const Adaptation_report report = QMA::adapt_quad_mesh(1.02, mesh);
    EXPECT_EQ(report.status, QMA::Adaptation_status::sizes_met);
    EXPECT_TRUE(zoo_mesh::is_same(mesh, before)) << shape.name;
    EXPECT_EQ(mesh.number_of_removed_faces(), 0u) << shape.name;
    EXPECT_EQ(mesh.number_of_removed_vertices(), 0u) << shape.name;
  }
}

// Where a graded size asks for nothing, faces keep descriptors.
TEST(Adapt_quad_mesh, FacesFarFromTheChangeKeepTheirDescriptors)
{
  const Shape shape = shape_zoo::plate(24, 12);
  const Mesh before = zoo_mesh::make<Mesh, Cartesian::Point_3>(shape);
  Mesh mesh = before;
  const usual_mesh::Size size = [](const Cartesian::Point_3& p) { return p.x() < 3 ? 0.4 : 1.02; };
  const Adaptation_report report = QMA::adapt_quad_mesh(size, mesh);
  ASSERT_TRUE(report.has_valid_mesh());
  std::size_t kept = 0;
  for(auto f : before.faces()) {
    if(mesh.is_removed(f)) continue;
    const auto u = CGAL::vertices_around_face(before.halfedge(f), before);
    const auto w = CGAL::vertices_around_face(mesh.halfedge(f), mesh);
    kept += std::equal(u.begin(), u.end(), w.begin(), w.end());
  }
  EXPECT_GT(kept, before.number_of_faces() / 2);
}

TEST(Adapt_quad_mesh, FeatureAngle)
{
  // with creases from 40 degrees the edges of the cube stay, with none they are smoothed away
  const Shape cube = shape_zoo::cube(4);
  Mesh sharp = zoo_mesh::make<Mesh, Cartesian::Point_3>(cube), smooth = sharp;
  QMA::adapt_quad_mesh(0.6, sharp, QMA::feature_angle(40));
  const QMA::Adaptation_report report = QMA::adapt_quad_mesh(0.6, smooth, QMA::feature_angle(180));
  ASSERT_TRUE(report.has_valid_mesh());
  double off = 0;
  for(auto e : sharp.edges()) { // no edge crosses an edge of the cube
    const auto p = sharp.point(sharp.vertex(e, 0)), q = sharp.point(sharp.vertex(e, 1));
    const auto m = CGAL::midpoint(p, q);
    double least = 4;
    for(int k = 0; k < 3; ++k) least = (std::min)({ least, m[k], 4 - m[k] });
    off = (std::max)(off, std::abs(least));
  }
  EXPECT_LT(off, 1e-9);
  zoo_mesh::expect_valid(smooth, mesh_checks::facts_of(cube.points, cube.quads));
}
