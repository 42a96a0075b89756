// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Where sizes change in a small place, the mesh changes there and nowhere else.

#include "support/more_shapes.h"
#include "support/usual_calls.h"
#include "support/usual_measures.h"

#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace {

namespace QMA = CGAL::Quad_mesh_adaptation;
using usual_mesh::Mesh;
using usual_mesh::Point;
using usual_mesh::Size;

double distance(const Point& a, const Point& b) { return std::sqrt(CGAL::squared_distance(a, b)); }

// Another size within a tenth of the plate's width of its centre, or of any other place.
struct Change
{
  Point where;
  double factor;
  double operator()(const Point& p) const
  {
    const double d = distance(p, where);
    return d < 0.5 ? factor : d < 1 ? factor + (1 - factor) * (2 * d - 1) : 1.;
  }
};

double graded(const Point& p) { return 0.12 + 0.01 * p.x(); }

Mesh adapted_plate()
{
  Mesh mesh = zoo_mesh::make<Mesh, Point>(shape_zoo::plate(10, 10));
  QMA::adapt_quad_mesh(Size(graded), mesh, QMA::symmetry(false));
  return mesh;
}

// The share of vertices at least so far away that are where they were.
double kept_far_away(const Mesh& before, const Mesh& after, const Point& where, double away)
{
  std::set<std::tuple<double, double, double>> places;
  for(auto v : before.vertices()) {
    const Point& p = before.point(v);
    places.insert({ p.x(), p.y(), p.z() });
  }
  std::size_t far = 0, kept = 0;
  for(auto v : after.vertices()) {
    const Point& p = after.point(v);
    if(distance(p, where) < away) continue;
    ++far;
    kept += places.count({ p.x(), p.y(), p.z() });
  }
  EXPECT_GT(far, 100u);
  return double(kept) / double(far);
}

double area_of(const Mesh& mesh)
{
  double sum = 0;
  for(auto f : mesh.faces()) {
    std::vector<Point> p;
    for(auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh)) p.push_back(mesh.point(v));
    sum += 0.5 * std::sqrt(CGAL::cross_product(p[2] - p[0], p[3] - p[1]).squared_length());
  }
  return sum;
}

// What is kept of faces left as they were gives what measuring all of the mesh gives.
void expect_measures(const QMA::Mesh_measures& wanted, const QMA::Mesh_measures& found)
{
  EXPECT_EQ(wanted.faces, found.faces);
  EXPECT_NEAR(wanted.ideal_number_of_faces, found.ideal_number_of_faces,
              1e-9 * wanted.ideal_number_of_faces);
  EXPECT_EQ(wanted.size_ratio.counts, found.size_ratio.counts);
  EXPECT_NEAR(wanted.size_ratio.mean, found.size_ratio.mean, 1e-12);
  EXPECT_NEAR(wanted.size_ratio.max, found.size_ratio.max, 1e-12);
  EXPECT_NEAR(wanted.strict_size_ratio.mean, found.strict_size_ratio.mean, 1e-12);
  EXPECT_NEAR(wanted.min_scaled_jacobian, found.min_scaled_jacobian, 1e-12);
  EXPECT_NEAR(wanted.p5_scaled_jacobian, found.p5_scaled_jacobian, 1e-12);
  EXPECT_NEAR(wanted.mean_scaled_jacobian, found.mean_scaled_jacobian, 1e-12);
  EXPECT_NEAR(wanted.min_angle, found.min_angle, 1e-9);
  EXPECT_NEAR(wanted.max_angle, found.max_angle, 1e-9);
  EXPECT_EQ(wanted.inverted_faces, found.inverted_faces);
  EXPECT_EQ(wanted.components, found.components);
  EXPECT_NEAR(wanted.max_warp, found.max_warp, 1e-12);
  EXPECT_EQ(wanted.interior_valence, found.interior_valence);
}

} // namespace

TEST(SmallChange, StaysLocal)
{
  const Mesh before = adapted_plate();
  for(double factor : { 0.5, 2. }) {
    double wanted = 0, made = 0;
    for(const Point& where : { Point(4, 5, 0), Point(6, 3, 0), Point(7, 6, 0) }) {
      SCOPED_TRACE("factor " + std::to_string(factor) + " at x = " + std::to_string(where.x()));
      Mesh mesh = before;
      const Change change{ where, factor };
      const Size size = [&](const Point& p) { return graded(p) * change(p); };
      const auto r = QMA::adapt_quad_mesh(size, mesh, QMA::symmetry(false));
      EXPECT_EQ(r.after.strict_size_ratio.percent_not_larger(), 100.) << r.message;
      EXPECT_GE(r.after.efficiency, 0.85);
      EXPECT_LE(r.after.max_valence, 5u);
      // it reaches some twenty edges beyond what has changed
      const double edge = graded(where);
      EXPECT_GT(kept_far_away(before, mesh, where, 1 + 20 * edge), 0.99);
      EXPECT_EQ(kept_far_away(before, mesh, where, 1 + 25 * edge), 1.);
      expect_measures(QMA::measure_quad_mesh(mesh, size), r.after);
      wanted += QMA::measure_quad_mesh(mesh, size).ideal_number_of_faces -
                QMA::measure_quad_mesh(before, Size(graded)).ideal_number_of_faces;
      made += r.after.efficiency * (double(mesh.number_of_faces()) - before.number_of_faces());
    }
    // it is made at all, within a third of what it asks for at this efficiency: few faces are in
    // question
    EXPECT_NEAR(made / wanted, 1, 0.35) << "factor " << factor;
  }
}

// The part of a large mesh that is taken out for the time of the work comes back whole, also at the
// border, at corners and where two places change.
TEST(SmallChange, InALargeMesh)
{
  const Size fine = [](const Point& p) { return 0.065 + 0.001 * p.x(); };
  Mesh before = zoo_mesh::make<Mesh, Point>(shape_zoo::plate(140, 140));
  for(auto v : before.vertices()) {
    const Point& p = before.point(v);
    before.point(v) = Point(p.x() / 14, p.y() / 14, p.z());
  }
  QMA::adapt_quad_mesh(fine, before, QMA::symmetry(false));
  ASSERT_GT(before.number_of_faces(), 10000u);
  for(double factor : { 0.5, 2. })
    for(const Point& where : { Point(4, 5, 0), Point(10, 4, 0), Point(0, 10, 0) }) {
      SCOPED_TRACE("factor " + std::to_string(factor) + " at x = " + std::to_string(where.x()));
      Mesh mesh = before;
      const Change change{ where, factor }, other{ Point(7, 7, 0), 0.7 };
      const Size size = [&](const Point& p) { return fine(p) * change(p) * other(p); };
      const auto r = QMA::adapt_quad_mesh(size, mesh, QMA::symmetry(false));
      EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
      EXPECT_EQ(r.after.strict_size_ratio.percent_not_larger(), 100.) << r.message;
      EXPECT_GE(r.after.efficiency, 0.85);
      EXPECT_GE(r.after.min_scaled_jacobian, 0.4);
      EXPECT_LE(r.after.max_valence, 5u);
      EXPECT_EQ(r.after.euler_characteristic, 1);
      EXPECT_EQ(r.after.boundary_loops, 1u);
      EXPECT_LT(r.after.max_distance_to_reference, 1e-12);
      expect_measures(QMA::measure_quad_mesh(mesh, size), r.after);
      std::size_t moved = 0;
      for(auto v : before.vertices()) {
        const Point& p = before.point(v);
        if(distance(p, where) > 3 && distance(p, Point(7, 7, 0)) > 3)
          moved += mesh.is_removed(v) || mesh.point(v) != p;
      }
      EXPECT_EQ(moved, 0u);
    }
}

// The same on curved surfaces, open and closed, with creases, corners and several components: what
// the parts know of the surface and its features is what the whole would.
TEST(SmallChange, InLargeMeshesOfManyShapes)
{
  for(const shape_zoo::Shape& shape :
      { shape_zoo::sphere(8), shape_zoo::torus(24, 12), shape_zoo::cube(6), more_shapes::dome(4),
        shape_zoo::open_cylinder(16, 6), more_shapes::two_spheres(8, 0.5) }) {
    SCOPED_TRACE(shape.name);
    Mesh before = zoo_mesh::make<Mesh, Point>(shape);
    const double area = area_of(before);
    const double length = std::sqrt(area / 12000), reach = 0.06 * std::sqrt(area);
    QMA::adapt_quad_mesh(length, before, QMA::symmetry(false));
    before.collect_garbage();
    ASSERT_GT(before.number_of_faces(), 10000u);
    const auto given = QMA::measure_quad_mesh(before, length);
    const std::size_t n = before.number_of_vertices();
    for(const double factor : { 0.5, 2. })
      for(const std::size_t place : { std::size_t(0), n / 3, n - 1 }) {
        SCOPED_TRACE("factor " + std::to_string(factor) + " at " + std::to_string(place));
        const Point where = before.point(*(before.vertices_begin() + long(place)));
        const Size size = [&](const Point& p) {
          return length * (distance(p, where) < reach ? factor : 1.);
        };
        Mesh mesh = before;
        const auto r = QMA::adapt_quad_mesh(size, mesh, QMA::symmetry(false));
        EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
        EXPECT_EQ(r.after.strict_size_ratio.percent_not_larger(), 100.) << r.message;
        EXPECT_TRUE(r.poor_faces.empty());
        EXPECT_LE(r.after.max_valence, (std::max)(given.max_valence, std::size_t(5)));
        EXPECT_EQ(r.after.euler_characteristic, given.euler_characteristic);
        EXPECT_EQ(r.after.components, given.components);
        EXPECT_EQ(r.after.boundary_loops, given.boundary_loops);
        EXPECT_LE(r.after.max_distance_to_reference, 1e-9 * std::sqrt(area));
        EXPECT_LE(r.after.reference_to_mesh, 0.2 * (std::max)(factor, 1.) * length);
        expect_measures(QMA::measure_quad_mesh(mesh, size), r.after);
        // on the dome there is something left to do at another place
        const double kept = shape.name == "dome" ? 0.94 : 1;
        EXPECT_GE(kept_far_away(before, mesh, where, reach + 25 * length), kept);
        Mesh again = mesh;
        const auto second = QMA::adapt_quad_mesh(size, again, QMA::symmetry(false));
        EXPECT_EQ(second.patches, r.patches);
        EXPECT_EQ(second.feature_curves, r.feature_curves);
        EXPECT_EQ(second.corners, r.corners);
        EXPECT_NEAR(double(again.number_of_faces()), double(mesh.number_of_faces()),
                    0.01 * double(mesh.number_of_faces()));
      }
  }
}

// Nothing changed, nothing done, but for few faces.
TEST(SmallChange, None)
{
  const Mesh before = adapted_plate();
  Mesh mesh = before;
  QMA::adapt_quad_mesh(Size(graded), mesh, QMA::symmetry(false));
  EXPECT_GT(kept_far_away(before, mesh, Point(-9, 0, 0), 3), 0.9);
}

// Also where a bound on the distance takes faces of its own.
TEST(SmallChange, WithABoundOnTheDistance)
{
  const Mesh round = zoo_mesh::make<Mesh, Point>(shape_zoo::sphere(48));
  const auto np = QMA::symmetry(false, QMA::reference_surface(round));
  Mesh mesh = zoo_mesh::make<Mesh, Point>(shape_zoo::sphere(12));
  QMA::adapt_quad_mesh(0.15, mesh, np);
  const Point pole(0, 0, 1);
  const Size size = [&](const Point& p) { return distance(p, pole) < 0.2 ? 0.07 : 0.15; };
  const double bound = 0.004;
  const auto r = QMA::adapt_quad_mesh(size, mesh, QMA::max_distance(bound, np));
  EXPECT_EQ(r.after.strict_size_ratio.percent_not_larger(), 100.) << r.message;
  EXPECT_LE(r.after.mesh_to_reference, bound);
  EXPECT_GE(r.after.min_scaled_jacobian, 0.45);
  EXPECT_GE(r.after.efficiency, 0.48); // seen 0.49 and 0.5: the splits decide
}

// A bad face does not keep a mesh that is a little too fine everywhere from being coarsened.
TEST(SmallChange, OneBadFaceInAFineMesh)
{
  Mesh mesh = zoo_mesh::make<Mesh, Point>(shape_zoo::plate(40, 40));
  const Point where(20, 20, 0);
  const Size size = [&](const Point& p) { return distance(p, where) < 1 ? 0.8 : 1.45; };
  const auto r = QMA::adapt_quad_mesh(size, mesh, QMA::symmetry(false));
  EXPECT_EQ(r.after.strict_size_ratio.percent_not_larger(), 100.) << r.message;
  EXPECT_GE(r.after.efficiency, 0.8);
}
