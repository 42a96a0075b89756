// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A row of faces goes and a shorter one comes, where that takes fewer faces in all.

#include "../../examples/Quad_mesh_adaptation/support/paper_cases.h"
#include "support/state_checks.h"
#include "support/state_fixture.h"

#include <CGAL/Quad_mesh_adaptation/internal/row_trades.h>
#include <CGAL/adapt_quad_mesh.h>

#include <gtest/gtest.h>

#include <cmath>

namespace {

namespace QMA = CGAL::Quad_mesh_adaptation;
using namespace state_fixture;

// 3 x 3 squares of edge one, to have this size.
Adaptation_state three_by_three(double size, Options o = {})
{
  o.size = [size](const Vec&) { return size; };
  return make_state(shape_zoo::plate(3, 3), o);
}

} // namespace

// 2 x 4 faces of 1.5 x 0.75 are within a size of 1.14, of which the square has 6.9.
TEST(Row_trades, TwoByFourInsteadOfThreeByThree)
{
  Adaptation_state s = three_by_three(1.14);
  const state_checks::Snapshot before = state_checks::snapshot(s);
  core::Row_trades(s, core::Improvement_options())();
  EXPECT_VALID_STATE(s, before, true);
  EXPECT_EQ(s.mesh.number_of_faces(), 8);
  EXPECT_TRUE(core::faces_too_large(s).empty());
}

TEST(Row_trades, NoneWhereFacesFit)
{
  Adaptation_state s = three_by_three(1.02);
  const auto before = s.mesh;
  core::Row_trades(s, core::Improvement_options())();
  ASSERT_EQ(s.mesh.number_of_faces(), before.number_of_faces());
  for(Index v = 0; v < before.vertex_end(); ++v) EXPECT_EQ(s.mesh.point(v), before.point(v));
}

// Edges that must stay, here of two sides, are neither merged nor cut.
TEST(Row_trades, NoneAcrossFrozenEdges)
{
  Options o;
  for(Index i = 0; i < 3; ++i) o.frozen.insert({ i, i + 1 });
  for(Index j = 0; j < 3; ++j) o.frozen.insert({ 4 * j, 4 * j + 4 });
  Adaptation_state s = three_by_three(1.14, o);
  core::Row_trades(s, core::Improvement_options())();
  EXPECT_EQ(s.mesh.number_of_faces(), 9);
}

// The quarter plate of the paper, four times coarser: 6.5 faces are asked for, and rows that end
// on the hole leave few ways to come near that.
TEST(Row_trades, FewFacesOnAPlateWithAHole)
{
  const paper_cases::Paper_case plate = paper_cases::plate_with_hole();
  paper_cases::Mesh mesh = plate.initial;
  double edges = 0;
  for(auto e : mesh.edges())
    edges += std::sqrt(
        CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  const auto report = QMA::adapt_quad_mesh(4 * edges / double(mesh.number_of_edges()), mesh,
                                           QMA::reference_surface(plate.reference));
  EXPECT_EQ(report.status, QMA::Adaptation_status::sizes_met);
  EXPECT_EQ(mesh.number_of_faces(), 8u);
  EXPECT_GE(report.after.min_scaled_jacobian, 0.45);
  EXPECT_EQ(report.after.irregular_interior_vertices, 0u);
}
