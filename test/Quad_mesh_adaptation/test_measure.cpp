// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures of meshes whose figures can be computed by hand.

#include <CGAL/Quad_mesh_adaptation/measure_quad_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <vector>

namespace QMA = CGAL::Quad_mesh_adaptation;
using QMA::Mesh_measures;
using QMA::internal::Index;
using QMA::internal::measure;
using QMA::internal::Quad;
using QMA::internal::Size_function;
using QMA::internal::Triangle;
using QMA::internal::Vec;

namespace {

using Counts = std::array<std::size_t, 8>;
using Valences = std::map<std::size_t, std::size_t>;

Size_function constant(double h)
{
  return [h](const Vec&) { return h; };
}

// n x m unit squares; `wrap` glues the last column to the first (an annulus of quads).
std::vector<Quad> grid_quads(Index n, Index m, bool wrap_columns = false, bool wrap_rows = false)
{
  const Index columns = wrap_columns ? n : n + 1, rows = wrap_rows ? m : m + 1;
  std::vector<Quad> quads;
  for(Index j = 0; j < m; ++j)
    for(Index i = 0; i < n; ++i) {
      const Index i1 = (i + 1) % columns, j1 = (j + 1) % rows;
      quads.push_back({ j * columns + i, j * columns + i1, j1 * columns + i1, j1 * columns + i });
    }
  return quads;
}

std::vector<Vec> grid_points(Index n, Index m)
{
  std::vector<Vec> points;
  for(Index j = 0; j <= m; ++j)
    for(Index i = 0; i <= n; ++i) points.emplace_back(i, j, 0);
  return points;
}

std::vector<Vec> torus_points(Index n, Index m)
{
  const double pi = std::acos(-1.);
  std::vector<Vec> points;
  for(Index j = 0; j < m; ++j)
    for(Index i = 0; i < n; ++i) {
      const double u = 2 * pi * i / n, v = 2 * pi * j / m, r = 3 + std::cos(v);
      points.emplace_back(r * std::cos(u), r * std::sin(u), std::sin(v));
    }
  return points;
}

const std::vector<Vec> cube_points = { Vec(0, 0, 0), Vec(1, 0, 0), Vec(0, 1, 0), Vec(1, 1, 0),
                                       Vec(0, 0, 1), Vec(1, 0, 1), Vec(0, 1, 1), Vec(1, 1, 1) };
const std::vector<Quad> cube_quads = { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 },
                                       { 2, 6, 7, 3 }, { 0, 4, 6, 2 }, { 1, 3, 7, 5 } };

} // namespace

TEST(Measure_topology, square_grid)
{
  const Mesh_measures m = measure(grid_points(5, 3), grid_quads(5, 3), constant(1));
  EXPECT_EQ(m.vertices, 24u);
  EXPECT_EQ(m.edges, 38u);
  EXPECT_EQ(m.faces, 15u);
  EXPECT_EQ(m.euler_characteristic, 1);
  EXPECT_EQ(m.components, 1u);
  EXPECT_EQ(m.boundary_edges, 16u);
  EXPECT_EQ(m.boundary_loops, 1u);
  EXPECT_EQ(m.interior_vertices, 8u);
  EXPECT_EQ(m.interior_valence, (Valences{ { 4, 8 } }));
  EXPECT_EQ(m.irregular_interior_vertices, 0u);
  EXPECT_EQ(m.max_valence, 4u);
}

TEST(Measure_topology, cube_has_eight_irregular_vertices_and_no_boundary)
{
  const Mesh_measures m = measure(cube_points, cube_quads, constant(1));
  EXPECT_EQ(m.edges, 12u);
  EXPECT_EQ(m.euler_characteristic, 2);
  EXPECT_EQ(m.boundary_loops, 0u);
  EXPECT_EQ(m.interior_valence, (Valences{ { 3, 8 } }));
  EXPECT_EQ(m.irregular_interior_vertices, 8u);
}

TEST(Measure_topology, annulus_and_torus)
{
  const Mesh_measures a = measure(grid_points(7, 2), grid_quads(8, 2, true), constant(1));
  EXPECT_EQ(a.euler_characteristic, 0);
  EXPECT_EQ(a.boundary_loops, 2u);
  EXPECT_EQ(a.boundary_edges, 16u);
  const Mesh_measures t = measure(torus_points(12, 6), grid_quads(12, 6, true, true), constant(1));
  EXPECT_EQ(t.euler_characteristic, 0);
  EXPECT_EQ(t.boundary_loops, 0u);
  EXPECT_EQ(t.interior_valence, (Valences{ { 4, 72 } }));
}

TEST(Measure_topology, unused_points_do_not_count_and_parts_do)
{
  std::vector<Vec> points = { Vec(9, 9, 9) };
  std::vector<Quad> quads;
  for(Index part = 0; part < 2; ++part) {
    const Index first = Index(points.size());
    for(const Vec& p : grid_points(1, 1)) points.push_back(p + Vec(0, 0, 5. * part));
    quads.push_back({ first, first + 1, first + 3, first + 2 });
    points.push_back(Vec(-9, -9, -9));
  }
  const Mesh_measures m = measure(points, quads, constant(1));
  EXPECT_EQ(m.vertices, 8u);
  EXPECT_EQ(m.components, 2u);
  EXPECT_EQ(m.boundary_loops, 2u);
  EXPECT_EQ(m.euler_characteristic, 2);
  EXPECT_EQ(m.interior_vertices, 0u);
}

TEST(Measure_topology, no_faces_gives_zeros)
{
  const Mesh_measures m = measure({ Vec(0, 0, 0) }, {}, constant(1));
  EXPECT_EQ(m.vertices + m.edges + m.faces + m.components, 0u);
  EXPECT_EQ(m.efficiency, 0.);
}

TEST(Measure_quality, rectangle_and_rhombus)
{
  const std::vector<Quad> one = { { 0, 1, 2, 3 } };
  const Mesh_measures r =
      measure({ Vec(0, 0, 0), Vec(7, 0, 0), Vec(7, 2, 0), Vec(0, 2, 0) }, one, constant(1));
  EXPECT_NEAR(r.min_scaled_jacobian, 1., 1e-15);
  EXPECT_NEAR(r.min_angle, 90., 1e-12);
  EXPECT_NEAR(r.max_angle, 90., 1e-12);
  const double c = 0.5, s = std::sqrt(3.) / 2; // a rhombus with 60 and 120 degrees
  const Mesh_measures k =
      measure({ Vec(0, 0, 0), Vec(1, 0, 0), Vec(1 + c, s, 0), Vec(c, s, 0) }, one, constant(1));
  EXPECT_NEAR(k.mean_scaled_jacobian, s, 1e-12);
  EXPECT_NEAR(k.min_angle, 60., 1e-9);
  EXPECT_NEAR(k.max_angle, 120., 1e-9);
  EXPECT_EQ(k.inverted_faces, 0u);
  EXPECT_EQ(k.max_warp, 0.);
}

TEST(Measure_quality, warp_of_a_folded_square)
{
  const std::vector<Quad> one = { { 0, 1, 2, 3 } };
  const double half = std::acos(-1.) / 6, d = std::sqrt(0.5), c = d * std::cos(half),
               s = d * std::sin(half); // by 60 degrees
  const Mesh_measures m =
      measure({ Vec(-d, 0, 0), Vec(0, -c, s), Vec(d, 0, 0), Vec(0, c, s) }, one, constant(1));
  EXPECT_NEAR(m.max_warp, 2 * s, 1e-12);
}

TEST(Measure_quality, concave_folded_and_collapsed_faces_are_inverted)
{
  const std::vector<Quad> one = { { 0, 1, 2, 3 } };
  const Mesh_measures dart =
      measure({ Vec(0, 0, 0), Vec(2, 0, 0), Vec(0.5, 0.5, 0), Vec(0, 2, 0) }, one, constant(1));
  EXPECT_EQ(dart.inverted_faces, 1u);
  EXPECT_LT(dart.min_scaled_jacobian, 0.);
  // at (0.5,0.5): the directions (1.5,-0.5) and (-0.5,1.5), with cosine -1.5/2.5
  EXPECT_NEAR(dart.max_angle, 360. - std::acos(-0.6) * 180. / std::acos(-1.), 1e-9);
  const Mesh_measures bow =
      measure({ Vec(0, 0, 0), Vec(1, 0, 0), Vec(0, 1, 0), Vec(1, 1, 0) }, one, constant(1));
  EXPECT_EQ(bow.inverted_faces, 1u);
  const Mesh_measures flat =
      measure({ Vec(0, 0, 0), Vec(1, 0, 0), Vec(2, 0, 0), Vec(3, 0, 0) }, one, constant(1));
  EXPECT_EQ(flat.inverted_faces, 1u);
  EXPECT_EQ(flat.min_scaled_jacobian, 0.);
}

TEST(Measure_quality, percentile_interpolates_between_ranks)
{
  std::vector<double> sample = { 3, 1, 2, 5, 4 }; // ranks 0..4: 5 % is rank 0.2
  EXPECT_NEAR(QMA::internal::percentile(sample, 5.), 1.2, 1e-15);
  EXPECT_NEAR(QMA::internal::percentile(sample, 100.), 5., 1e-15);
  EXPECT_NEAR(QMA::internal::percentile(sample, 50.), 3., 1e-15);
}

TEST(Measure_sizes, every_bin_has_its_edges)
{
  using QMA::internal::size_ratio_bin;
  const std::map<double, std::size_t> expected = {
    { 0.49999, 0 },   { 0.5, 1 },      { 0.79999, 1 }, { 0.8, 2 }, { 0.9, 3 }, { 1., 3 },
    { 1 + 9e-10, 3 }, { 1 + 2e-9, 4 }, { 1.1, 4 },     { 1.2, 5 }, { 1.5, 6 }, { 1.50001, 7 }
  };
  for(const auto& [ratio, bin] : expected) EXPECT_EQ(size_ratio_bin(ratio), bin) << ratio;
}

TEST(Measure_sizes, constant_size)
{
  const Mesh_measures m = measure(grid_points(10, 4), grid_quads(10, 4), constant(2));
  EXPECT_EQ(m.size_ratio.counts, (Counts{ 0, 40, 0, 0, 0, 0, 0, 0 }));
  EXPECT_EQ(m.strict_size_ratio.counts, m.size_ratio.counts);
  EXPECT_NEAR(m.size_ratio.min, 0.5, 1e-15);
  EXPECT_NEAR(m.size_ratio.max, 0.5, 1e-15);
  EXPECT_NEAR(m.size_ratio.mean, 0.5, 1e-15);
  EXPECT_NEAR(m.ideal_number_of_faces, 10., 1e-9);
  EXPECT_NEAR(m.efficiency, 0.25, 1e-12);
  EXPECT_EQ(m.size_ratio.percent_not_larger(), 100.);
}

TEST(Measure_sizes, the_strict_size_sees_what_the_centre_misses)
{
  // the size is 1 at the centre of the square of side 2 and 1/2 at its four Gauss points
  const Size_function dip = [](const Vec& p) {
    return std::hypot(p.x() - 1, p.y() - 1) < 0.1 ? 1. : 0.5;
  };
  const std::vector<Vec> square = { Vec(0, 0, 0), Vec(2, 0, 0), Vec(2, 2, 0), Vec(0, 2, 0) };
  const Mesh_measures m = measure(square, { { 0, 1, 2, 3 } }, dip);
  EXPECT_NEAR(m.size_ratio.max, 2., 1e-14);
  EXPECT_NEAR(m.strict_size_ratio.max, 4., 1e-14);
}

TEST(Measure_sizes, ideal_count_of_a_graded_size_and_of_a_kink)
{
  const std::vector<Vec> square = { Vec(0, 0, 0), Vec(1, 0, 0), Vec(1, 1, 0), Vec(0, 1, 0) };
  const std::vector<Quad> one = { { 0, 1, 2, 3 } };
  // h = 0.01 + x: the integral of 1/h^2 over the unit square is 1/0.01 - 1/1.01
  const Mesh_measures g = measure(square, one, [](const Vec& p) { return 0.01 + p.x(); });
  EXPECT_NEAR(g.ideal_number_of_faces / (1 / 0.01 - 1 / 1.01), 1., 1e-3);
  // h = 0.01 + |x - 0.3|: twice the fine side, with a kink no cut of the square runs along
  const Mesh_measures k =
      measure(square, one, [](const Vec& p) { return 0.01 + std::abs(p.x() - 0.3); });
  EXPECT_NEAR(k.ideal_number_of_faces / (2 / 0.01 - 1 / 0.31 - 1 / 0.71), 1., 1e-3);
}

TEST(Measure_sizes, ideal_count_is_taken_on_the_reference)
{
  const std::vector<Triangle> reference = { { Vec(0, 0, 0), Vec(4, 0, 0), Vec(0, 3, 0) } };
  const Mesh_measures m = measure(grid_points(2, 2), grid_quads(2, 2), constant(0.5), &reference);
  EXPECT_NEAR(m.ideal_number_of_faces, 24., 1e-9);
  EXPECT_NEAR(m.efficiency, 6., 1e-9);
}

TEST(Measure_quad_mesh, two_mesh_types_and_a_point_map)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Point = Kernel::Point_3;
  CGAL::Surface_mesh<Point> mesh;
  CGAL::make_hexahedron(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0),
                        Point(0, 1, 1), Point(0, 0, 1), Point(1, 0, 1), Point(1, 1, 1), mesh);
  mesh.add_vertex(Point(7, 7, 7));
  const auto ask_two = [](const Point&) { return 2.; };
  const Mesh_measures m = QMA::measure_quad_mesh(mesh, ask_two);
  EXPECT_EQ(m.vertices, 8u);
  EXPECT_EQ(m.size_ratio.counts[1], 6u);
  EXPECT_NEAR(m.efficiency, 0.25, 1e-12);

  CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>> polyhedron;
  using P = CGAL::Simple_cartesian<double>::Point_3;
  CGAL::make_hexahedron(P(0, 0, 0), P(1, 0, 0), P(1, 1, 0), P(0, 1, 0), P(0, 1, 1), P(0, 0, 1),
                        P(1, 0, 1), P(1, 1, 1), polyhedron);
  EXPECT_NEAR(QMA::measure_quad_mesh(polyhedron, 1).efficiency, 1., 1e-12);

  auto doubled =
      mesh.add_property_map<CGAL::Surface_mesh<Point>::Vertex_index, Point>("v:big").first;
  for(auto v : mesh.vertices())
    doubled[v] = Point(2 * mesh.point(v).x(), 2 * mesh.point(v).y(), 2 * mesh.point(v).z());
  EXPECT_NEAR(
      QMA::measure_quad_mesh(mesh, 2., CGAL::parameters::vertex_point_map(doubled)).size_ratio.max,
      1., 1e-12);
}

TEST(Measure_quad_mesh, refuses_triangles_and_bad_sizes)
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  CGAL::Surface_mesh<Point> triangle, square;
  CGAL::make_triangle(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), triangle);
  CGAL::make_quad(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), square);
  EXPECT_THROW(QMA::measure_quad_mesh(triangle, 1.), std::invalid_argument);
  auto bad = square;
  bad.point(*bad.vertices().begin()) = Point(0, std::nan(""), 0);
  EXPECT_THROW(QMA::measure_quad_mesh(bad, 1.), std::invalid_argument);
  EXPECT_THROW(QMA::measure_quad_mesh(square, 0.), std::domain_error);
  EXPECT_THROW(QMA::measure_quad_mesh(square, std::nan("")), std::domain_error);
  EXPECT_THROW(QMA::measure_quad_mesh(square, std::numeric_limits<double>::infinity()),
               std::domain_error);
}
