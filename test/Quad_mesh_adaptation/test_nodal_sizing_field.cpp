// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quad_mesh_adaptation/IO/read_nodal_sizes.h>
#include <CGAL/Quad_mesh_adaptation/Nearest_face.h>
#include <CGAL/Quad_mesh_adaptation/Nodal_field.h>
#include <CGAL/Quad_mesh_adaptation/Nodal_sizing_field.h>
#include <CGAL/Quad_mesh_adaptation/limit_size_gradation.h>
#include <CGAL/adapt_quad_mesh.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <cmath>
#include <future>
#include <limits>
#include <memory>
#include <optional>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

namespace QMA = CGAL::Quad_mesh_adaptation;
using QMA::Nodal_field;
using QMA::Nodal_sizing_field;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Size_map = Mesh::Property_map<Vertex, double>;

// [0,n]^2 in unit squares, on the paraboloid z = bulge (x^2 + y^2).
struct Background
{
  explicit Background(int n, double bulge = 0)
  {
    for(int j = 0; j <= n; ++j)
      for(int i = 0; i <= n; ++i) mesh.add_vertex(Point(i, j, bulge * (i * i + j * j)));
    for(int j = 0; j < n; ++j)
      for(int i = 0; i < n; ++i) {
        const int v = j * (n + 1) + i;
        mesh.add_face(Vertex(v), Vertex(v + 1), Vertex(v + n + 2), Vertex(v + n + 1));
      }
    sizes = mesh.add_property_map<Vertex, double>("v:size", 1.).first;
  }
  template <class Function>
  void set(const Function& f)
  {
    for(Vertex v : mesh.vertices()) sizes[v] = f(mesh.point(v));
  }
  Mesh mesh;
  Size_map sizes;
};

} // namespace

TEST(Nodal_sizing_field, takes_the_nodal_values_at_the_nodes)
{
  Background b(6, 0.1);
  std::mt19937 random(1);
  b.set([&](const Point&) { return std::uniform_real_distribution<>(0.1, 9.)(random); });
  const Nodal_sizing_field field(b.mesh, b.sizes);
  for(Vertex v : b.mesh.vertices()) EXPECT_NEAR(field(b.mesh.point(v)), b.sizes[v], 1e-9);
}

TEST(Nodal_sizing_field, reproduces_an_exponential_exactly_between_the_nodes)
{
  Background b(5);
  const auto size = [](const Point& p) { return 0.2 * std::exp(0.3 * p.x() - 0.5 * p.y()); };
  b.set(size);
  const Nodal_sizing_field field(b.mesh, b.sizes);
  std::mt19937 random(2);
  std::uniform_real_distribution<> in(0., 5.);
  for(int i = 0; i < 1000; ++i) {
    const Point p(in(random), in(random), 0);
    EXPECT_NEAR(field(p) / size(p), 1., 1e-12);
  }
}

TEST(Nodal_sizing_field, a_point_outside_goes_to_the_nearest)
{
  Background b(4);
  b.set([](const Point& p) { return 1 + p.x() + 10 * p.y(); });
  const Nodal_sizing_field field(b.mesh, b.sizes);
  EXPECT_NEAR(field(Point(-3, -2, 0)), 1., 1e-12);
  EXPECT_NEAR(field(Point(9, 9, 0)), 45., 1e-9);
  EXPECT_NEAR(field(Point(-1, 2, 0)), 21., 1e-9);
  EXPECT_NEAR(field(Point(2, 2, 7)), 23., 1e-9); // above the plate
}

TEST(Nodal_sizing_field, outlives_its_mesh_and_is_shared_by_copies)
{
  auto b = std::make_unique<Background>(3);
  b->set([](const Point& p) { return 2 + p.x(); });
  const Nodal_sizing_field field(b->mesh, b->sizes);
  const Nodal_sizing_field copy = field;
  b.reset();
  EXPECT_NEAR(copy(Point(3, 1, 0)), 5., 1e-12);
  EXPECT_NEAR(field(Point(0, 1, 0)), 2., 1e-12);
}

TEST(Nodal_sizing_field, concave_quads_triangles_and_pentagons_cover_their_area_once)
{
  // a dart with the reflex corner third: the other diagonal would leave the face
  Mesh dart;
  const Vertex v[] = { dart.add_vertex(Point(0, 0, 0)), dart.add_vertex(Point(4, 0, 0)),
                       dart.add_vertex(Point(1, 1, 0)), dart.add_vertex(Point(0, 4, 0)) };
  dart.add_face(v[0], v[1], v[2], v[3]);
  auto sizes = dart.add_property_map<Vertex, double>("v:size", 1.).first;
  sizes[v[2]] = 4;
  const Nodal_sizing_field on_dart(dart, sizes);
  EXPECT_NEAR(on_dart(Point(0.5, 0.5, 0)), 2., 1e-12);
  EXPECT_NEAR(on_dart(Point(2.5, 0.5, 0)), 2., 1e-12); // on the edge to the reflex corner
  // in the notch: nearest is a fifth of the way from the reflex corner to a tip
  EXPECT_NEAR(on_dart(Point(2, 2, 0)), std::pow(4., 0.8), 1e-12);

  Mesh mixed;
  std::vector<Vertex> pentagon;
  for(int i = 0; i < 5; ++i)
    pentagon.push_back(
        mixed.add_vertex(Point(std::cos(i * 1.2566370614), std::sin(i * 1.2566370614), 0)));
  mixed.add_face(pentagon);
  mixed.add_face(pentagon[1], pentagon[0], mixed.add_vertex(Point(2, 2, 0)));
  auto constant = mixed.add_property_map<Vertex, double>("v:size", 3.).first;
  const Nodal_sizing_field on_mixed(mixed, constant);
  EXPECT_NEAR(on_mixed(Point(0, 0, 0)), 3., 1e-12);
  EXPECT_NEAR(on_mixed(Point(1.5, 1.5, 0)), 3., 1e-12);
}

TEST(Nodal_sizing_field, answers_the_same_from_several_threads)
{
  Background b(20, 0.02);
  b.set([](const Point& p) { return 0.5 + std::hypot(p.x() - 7, p.y() - 9); });
  const Nodal_sizing_field field(b.mesh, b.sizes);
  const auto checksum = [&field](double shift) {
    double sum = 0;
    for(int i = 0; i < 4000; ++i) sum += field(Point(i % 61 / 3., i % 59 / 3. + shift, 1));
    return sum;
  };
  auto other = std::async(std::launch::async, checksum, 0.);
  const double here = checksum(0.);
  EXPECT_EQ(other.get(), here);
}

TEST(Nodal_sizing_field, refuses_bad_sizes_and_empty_meshes)
{
  for(double bad : { 0., -1., std::nan(""), std::numeric_limits<double>::infinity() }) {
    Background b(2);
    b.sizes[Vertex(4)] = bad;
    EXPECT_THROW(Nodal_sizing_field(b.mesh, b.sizes), std::invalid_argument);
  }
  Mesh empty;
  auto sizes = empty.add_property_map<Vertex, double>("v:size", 1.).first;
  EXPECT_THROW(Nodal_sizing_field(empty, sizes), std::invalid_argument);
}

TEST(Nodal_field, carries_a_linear_field_over_to_an_adapted_mesh)
{
  Background b(9);
  const auto linear = [](const Point& p) { return 5 - 3 * p.x() + 0.5 * p.y(); };
  b.set(linear);
  const Nodal_field field(b.mesh, b.sizes);
  ASSERT_TRUE(QMA::adapt_quad_mesh([](const Point& p) { return 0.5 + 0.2 * p.x(); }, b.mesh)
                  .has_valid_mesh());
  ASSERT_GT(b.mesh.number_of_faces(), 50u);
  for(Vertex v : b.mesh.vertices())
    EXPECT_NEAR(field(b.mesh.point(v)), linear(b.mesh.point(v)), 1e-12);
}

Point centre_of(Mesh::Face_index f, const Mesh& mesh)
{
  CGAL::Vector_3<Kernel> sum(0, 0, 0);
  for(Vertex v : vertices_around_face(mesh.halfedge(f), mesh))
    sum = sum + 0.25 * (mesh.point(v) - CGAL::ORIGIN);
  return CGAL::ORIGIN + sum;
}

// Columns of faces, from x = n to n + 1, are of material n.
TEST(Nearest_face, carries_materials_over_to_an_adapted_mesh)
{
  for(double size : { 0.37, 1., 2.5 }) {
    Background b(9);
    std::vector<int> material;
    for(Mesh::Face_index f : b.mesh.faces()) material.push_back(int(centre_of(f, b.mesh).x()));
    const QMA::Nearest_face nearest(b.mesh);
    ASSERT_TRUE(QMA::adapt_quad_mesh(size, b.mesh).has_valid_mesh());
    for(Mesh::Face_index f : b.mesh.faces()) {
      const Point c = centre_of(f, b.mesh);
      const int found = material.at(nearest(c));
      EXPECT_TRUE(found <= c.x() + 1e-12 && c.x() - 1e-12 <= found + 1) << c;
    }
  }
}

// Two sheets that face away from each other; a point nearer to the other one.
TEST(Nearest_face, tells_sheets_apart_by_the_normal)
{
  Mesh sheets;
  for(double z : { 0., 0.1 }) {
    std::vector<Vertex> v;
    for(const auto& [x, y] : { std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1) })
      v.push_back(sheets.add_vertex(Point(x, y, z)));
    if(z > 0)
      sheets.add_face(v[0], v[1], v[2], v[3]);
    else
      sheets.add_face(v[3], v[2], v[1], v[0]);
  }
  const QMA::Nearest_face nearest(sheets);
  const Point p(0.3, 0.4, 0.02);
  const CGAL::Vector_3<Kernel> up(0, 0, 1), aside(1, 0, 0);
  EXPECT_EQ(nearest(p), 0u);
  EXPECT_EQ(nearest(p, up), 1u);
  EXPECT_EQ(nearest(p, -3 * up), 0u);
  EXPECT_EQ(nearest(p, aside), 0u);
  sheets.remove_face(Mesh::Face_index(0)); // does not change what was there
  EXPECT_EQ(nearest(p), 0u);
}

TEST(Nearest_face, refuses_what_is_not_finite_and_what_has_no_area)
{
  Background b(2);
  EXPECT_THROW(QMA::Nearest_face(b.mesh)(Point(0, std::nan(""), 0)), std::invalid_argument);
  b.mesh.point(Vertex(4)) = Point(0, 0, std::numeric_limits<double>::infinity());
  EXPECT_THROW(QMA::Nearest_face(b.mesh).operator()(Point(0, 0, 0)), std::invalid_argument);
  EXPECT_THROW(QMA::Nearest_face{ Mesh() }, std::invalid_argument);
}

TEST(Nodal_field, refuses_what_is_not_finite_and_what_has_no_area)
{
  for(double bad : { std::nan(""), -std::numeric_limits<double>::infinity() }) {
    Background b(2);
    b.sizes[Vertex(4)] = bad;
    EXPECT_THROW(Nodal_field(b.mesh, b.sizes), std::invalid_argument);
  }
  const std::vector<Point> points = { Point(0, 0, 0), Point(1, 0, 0), Point(2, 0, 0) };
  const std::vector<std::vector<int>> line = { { 0, 1, 2 } }, none = { { 0, 1, 3 } };
  const std::vector<double> values = { -1, 0, 1 };
  EXPECT_THROW(Nodal_field(points, line, values), std::invalid_argument);
  EXPECT_THROW(Nodal_field(points, none, values), std::invalid_argument);
  EXPECT_THROW(Nodal_field(points, line, std::vector<double>(2)), std::invalid_argument);
}

TEST(Limit_size_gradation, a_single_small_size_spreads_as_a_cone)
{
  Background b(8);
  b.set([](const Point& p) { return p == Point(0, 0, 0) ? 0.1 : 100.; });
  QMA::limit_size_gradation(b.mesh, b.sizes, 0.3);
  for(Vertex v : b.mesh.vertices()) {
    const double x = b.mesh.point(v).x(), y = b.mesh.point(v).y();
    // shortest way over edges and diagonals of unit squares
    const double way = std::abs(x - y) + std::sqrt(2.) * (std::min)(x, y);
    EXPECT_NEAR(b.sizes[v], 0.1 + 0.3 * way, 1e-12);
  }
}

TEST(Limit_size_gradation, only_lowers_and_keeps_what_is_gentle_enough)
{
  Background b(6, 0.05);
  b.set([](const Point& p) { return 1 + 0.1 * p.x(); });
  QMA::limit_size_gradation(b.mesh, b.sizes, 0.2);
  for(Vertex v : b.mesh.vertices()) EXPECT_EQ(b.sizes[v], 1 + 0.1 * b.mesh.point(v).x());
  QMA::limit_size_gradation(b.mesh, b.sizes, 0.);
  for(Vertex v : b.mesh.vertices()) EXPECT_EQ(b.sizes[v], 1.);
  EXPECT_THROW(QMA::limit_size_gradation(b.mesh, b.sizes, -1.), std::invalid_argument);
  EXPECT_THROW(QMA::limit_size_gradation(b.mesh, b.sizes, std::nan("")), std::invalid_argument);
  for(const double bad : { 0., -1., std::nan("") }) {
    put(b.sizes, *vertices(b.mesh).begin(), bad);
    EXPECT_THROW(QMA::limit_size_gradation(b.mesh, b.sizes, 0.2), std::invalid_argument) << bad;
  }
}

TEST(Nodal_sizing_field, takes_arrays_that_are_no_manifold)
{
  // three squares on one edge, of different orientation
  const std::vector<Point> points = { Point(0, 0, 0),  Point(1, 0, 0),  Point(1, 1, 0),
                                      Point(0, 1, 0),  Point(1, 0, -1), Point(0, 0, -1),
                                      Point(1, -1, 0), Point(0, -1, 0) };
  const std::vector<std::vector<int>> polygons = { { 0, 1, 2, 3 }, { 0, 1, 4, 5 }, { 0, 1, 6, 7 } };
  const std::vector<double> sizes = { 1, 1, 2, 2, 4, 4, 8, 8 };
  const Nodal_sizing_field field(points, polygons, sizes);
  for(std::size_t v = 0; v < points.size(); ++v) EXPECT_NEAR(field(points[v]), sizes[v], 1e-9);
  EXPECT_NEAR(field(Point(0.5, -0.5, 0)), std::sqrt(8.), 1e-9);
  EXPECT_THROW(Nodal_sizing_field(points, polygons, { 1 }), std::invalid_argument);
  using Polygons = std::vector<std::vector<int>>;
  EXPECT_THROW(Nodal_sizing_field(points, Polygons{ { 0, 1, 8 } }, sizes), std::invalid_argument);
  EXPECT_THROW(Nodal_sizing_field(points, Polygons{ { 0, 1, -1 } }, sizes), std::invalid_argument);
  EXPECT_THROW(Nodal_sizing_field(points, Polygons{ { 0, 1 } }, sizes), std::invalid_argument);
  EXPECT_THROW(Nodal_sizing_field(points, Polygons{}, sizes), std::invalid_argument);
}

TEST(Nodal_sizing_field, is_read_from_a_file)
{
  std::optional<Nodal_sizing_field> field;
  const QMA::Read_result read =
      QMA::read_nodal_sizes(QUAD_MESH_DATA_DIR "/meshes/background_sizes.ply", field);
  ASSERT_TRUE(read.ok()) << read.message;
  EXPECT_NEAR((*field)(Point(8, 0, 0)), 0.2, 1e-9);
  EXPECT_NEAR((*field)(Point(0, 0, 0)), 0.2 + 0.12 * 8, 1e-9);
  std::optional<Nodal_sizing_field> none;
  EXPECT_FALSE(QMA::read_nodal_sizes("missing.ply", none).ok());
  EXPECT_FALSE(
      QMA::read_nodal_sizes(QUAD_MESH_DATA_DIR "/meshes/background_sizes.ply", none, "weight")
          .ok());
  EXPECT_FALSE(none);
}
