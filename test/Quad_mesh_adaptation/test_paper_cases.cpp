// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The three cases of the paper, both schedules: what must hold of the result, not golden counts.

#include "../../examples/Quad_mesh_adaptation/support/paper_cases.h"
#include "support/surface_mesh_checks.h"
#include "support/usual_calls.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

namespace {

namespace Qma = CGAL::Quad_mesh_adaptation;
using paper_cases::Mesh;
using paper_cases::Paper_case;

struct Outcome
{
  Qma::Adaptation_report report;
  Mesh mesh;
  mesh_checks::Facts before, after;
};

Outcome run(const Paper_case& c, Qma::Schedule schedule)
{
  Outcome o;
  o.mesh = c.initial;
  o.before = mesh_checks::facts_of_mesh(o.mesh);
  o.report = Qma::adapt_quad_mesh(c.size, o.mesh,
                                  Qma::schedule(schedule, Qma::reference_surface(c.reference)));
  o.after = mesh_checks::facts_of_mesh(o.mesh);
  return o;
}

std::set<std::tuple<double, double, double>> positions(const Mesh& mesh)
{
  std::set<std::tuple<double, double, double>> all;
  for(auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    all.emplace(p.x(), p.y(), p.z());
  }
  return all;
}

void expect_sound(const Outcome& o)
{
  EXPECT_EQ(o.after.problem, "");
  EXPECT_TRUE(mesh_checks::same_topology(o.before, o.after));
  EXPECT_EQ(o.after.doublets, 0u);
  EXPECT_EQ(o.report.after.faces, o.after.faces);
  EXPECT_NEAR(o.report.after.min_scaled_jacobian, o.after.min_scaled_jacobian, 1e-9);
  EXPECT_GT(o.after.min_scaled_jacobian, 0.);
  EXPECT_TRUE(o.mesh.is_valid());
}

void expect_default_quality(const Outcome& o, double efficiency)
{
  expect_sound(o);
  const Qma::Mesh_measures& m = o.report.after;
  EXPECT_EQ(o.report.status, Qma::Adaptation_status::sizes_met) << o.report.message;
  EXPECT_GE(m.strict_size_ratio.percent_not_larger(), 99.);
  EXPECT_LE(m.strict_size_ratio.max, 1.2);
  EXPECT_GE(m.efficiency, efficiency);
  EXPECT_GE(m.min_scaled_jacobian, 0.3);
  EXPECT_GE(m.interior_valence.begin()->first, 3u);
  EXPECT_LE(m.interior_valence.rbegin()->first, 6u);
}

// Far below what comes out, far above what the paper printed.
TEST(Paper_cases, circular_load_by_default)
{
  const Outcome o = run(paper_cases::circular_load(), Qma::Schedule::progressive);
  expect_default_quality(o, 0.35);
  const auto all = positions(o.mesh);
  for(double x : { -5., 5. })
    for(double y : { -5., 5. }) EXPECT_EQ(all.count({ x, y, 0. }), 1u) << x << ", " << y;
  for(auto v : o.mesh.vertices()) EXPECT_EQ(o.mesh.point(v).z(), 0.);
  EXPECT_NEAR(o.after.area, 100., 1e-9);
}

TEST(Paper_cases, nosecone_by_default)
{
  const Outcome o = run(paper_cases::nosecone(), Qma::Schedule::progressive);
  expect_default_quality(o, 0.5);
  EXPECT_LT(o.report.after.max_distance_to_reference, 1e-6 * 27.7);
}

TEST(Paper_cases, plate_with_hole_by_default)
{
  const Outcome o = run(paper_cases::plate_with_hole(), Qma::Schedule::progressive);
  expect_default_quality(o, 0.5);
  const double exact = 36 - CGAL_PI / 4;
  EXPECT_NEAR(o.after.area, exact, 2e-3 * exact); // facets of the arc
  const auto all = positions(o.mesh);
  for(const auto& corner :
      { std::make_tuple(1., 0., 0.), std::make_tuple(6., 0., 0.), std::make_tuple(6., 6., 0.),
        std::make_tuple(0., 6., 0.), std::make_tuple(0., 1., 0.) })
    EXPECT_EQ(all.count(corner), 1u) << std::get<0>(corner) << ", " << std::get<1>(corner);
}

// The paper's own schedule over-refines, as the paper says; it has to stay sound and to bring
// nearly all faces below their size.
TEST(Paper_cases, papers_schedule)
{
  for(const Paper_case& c :
      { paper_cases::circular_load(), paper_cases::nosecone(), paper_cases::plate_with_hole() }) {
    SCOPED_TRACE(c.name);
    const Outcome o = run(c, Qma::Schedule::paper);
    expect_sound(o);
    EXPECT_GE(o.report.after.size_ratio.percent_not_larger(), 96.5);
    EXPECT_LE(o.report.after.max_valence, 6u);
    EXPECT_GE(o.report.after.efficiency, 0.15);
  }
}

} // namespace
