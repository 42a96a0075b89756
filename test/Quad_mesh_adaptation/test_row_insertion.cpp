// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Regular meshes refined by less than halving get whole rows and stay regular.

#include "support/state_checks.h"
#include "support/usual_calls.h"

#include <CGAL/Quad_mesh_adaptation/internal/row_insertion.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

namespace QMA = CGAL::Quad_mesh_adaptation;
using namespace state_fixture;
using usual_mesh::Mesh;
using usual_mesh::Point;

Shape tube()
{
  return shape_zoo::grid(
      "tube", 32, 24,
      [](Index i, Index j) {
        const double t = std::acos(-1.) / 16 * i;
        return Vec(std::cos(t), std::sin(t), 0.19 * j);
      },
      true);
}

Options of_size(double size)
{
  Options o;
  o.size = [size](const Vec&) { return size; };
  return o;
}

} // namespace

// A plate of 20 rows needs n of them; it gets few more.
TEST(Row_insertion, AsManyRowsAsNeeded)
{
  for(double factor : { 1.02, 1.05, 1.1, 1.2, 1.3, 1.4 }) {
    Adaptation_state s = make_state(shape_zoo::plate(20, 20), of_size(1 / factor));
    EXPECT_GT(core::insert_rows(s), 0u) << factor;
    EXPECT_EQ(state_checks::halfedge_problem(s.mesh), "");
    EXPECT_EQ(irregular_nodes(s), 0u) << factor;
    const double rows = std::ceil(20 * factor);
    EXPECT_GE(s.mesh.number_of_faces(), 400 * factor * factor) << factor;
    EXPECT_LE(s.mesh.number_of_faces(), 1.1 * rows * rows) << factor;
  }
}

// What is taken back has not been done: no operation of it is told of.
TEST(Row_insertion, RowsTakenBackAreNotCounted)
{
  Options o = of_size(1 / 1.03);
  Adaptation_state s = make_state(shape_zoo::plate(2, 2), o);
  s.energy.face = 1000; // no row is worth its faces
  s.forget_energies();
  EXPECT_EQ(core::insert_rows(s), 0u);
  EXPECT_EQ(s.mesh.number_of_faces(), 4);
  for(const auto& [operation, count] : s.operation_counts()) EXPECT_EQ(count, 0u) << operation;
}

TEST(Row_insertion, OnlyInTheDirectionThatIsTooWide)
{
  // faces of 1 by 0.5 where edges of 0.75 on average are allowed, and a little less
  const Shape plate =
      shape_zoo::grid("oblong", 12, 12, [](Index i, Index j) { return Vec(i, 0.5 * j, 0); });
  Adaptation_state s = make_state(plate, of_size(0.7));
  const std::size_t added = core::insert_rows(s);
  EXPECT_GT(added, 0u);
  EXPECT_EQ(added % 12, 0u) << "columns of twelve faces each";
  EXPECT_EQ(irregular_nodes(s), 0u);
}

TEST(Row_insertion, NothingWhereSizesAreMetOrVaryAlongTheRows)
{
  Adaptation_state met = make_state(shape_zoo::plate(8, 8), of_size(1));
  EXPECT_EQ(core::insert_rows(met), 0u);
  Options varying;
  varying.size = [](const Vec& p) { return 0.5 + 0.2 * std::abs(p.x() - p.y()); };
  Adaptation_state s = make_state(shape_zoo::plate(12, 12), varying);
  EXPECT_EQ(core::insert_rows(s), 0u);
}

// A size is met if it is exceeded by no more than rounding.
TEST(Row_insertion, NothingWhereSizesAreMetUpToRounding)
{
  Adaptation_state s = make_state(shape_zoo::plate(8, 8), of_size(1 - 1e-12));
  EXPECT_EQ(core::insert_rows(s), 0u);
  for(const Shape& shape : { shape_zoo::cube(8), shape_zoo::plate(20, 20) })
    for(double rounding : { -1e-12, 0., 1e-12 }) {
      Mesh mesh = zoo_mesh::make<Mesh, Point>(shape);
      const double size = (0.5 + rounding) * zoo_mesh::mean_edge(shape);
      const QMA::Adaptation_report r = QMA::adapt_quad_mesh(size, mesh);
      EXPECT_EQ(r.after.faces, 4 * shape.quads.size()) << shape.name << rounding;
    }
}

TEST(Row_insertion, FrozenBordersAreNotSplit)
{
  const Shape plate = shape_zoo::plate(8, 8);
  Options o = of_size(0.8);
  const Adaptation_state free = make_state(plate);
  for(Index h = 0; h < 4 * free.mesh.face_end(); ++h)
    if(free.mesh.is_border(h))
      o.frozen.insert(std::minmax(free.mesh.origin(h), free.mesh.target(h)));
  Adaptation_state s = make_state(plate, o), unfrozen = make_state(plate, of_size(0.8));
  EXPECT_EQ(core::insert_rows(s), 0u);
  EXPECT_GT(core::insert_rows(unfrozen), 0u);
}

// The same through the whole schedule.
TEST(Row_insertion, RegularMeshesStayRegular)
{
  for(const Shape& shape : { shape_zoo::plate(20, 20), tube() })
    for(double factor : { 1.05, 1.15, 1.3, 1.5 }) {
      Mesh mesh = zoo_mesh::make<Mesh, Point>(shape);
      const double size = zoo_mesh::mean_edge(shape) / factor;
      const QMA::Adaptation_report r = QMA::adapt_quad_mesh(size, mesh);
      ASSERT_TRUE(r.has_valid_mesh()) << r.message;
      EXPECT_EQ(r.after.irregular_interior_vertices, 0u) << shape.name << factor;
      EXPECT_LE(r.after.strict_size_ratio.max, 1 + 1e-9) << shape.name << factor;
      EXPECT_GE(r.after.efficiency, 0.85) << shape.name << factor;
    }
}
