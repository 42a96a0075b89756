// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Many faces are made from a solution for larger sizes, halved everywhere.

#include "support/state_checks.h"
#include "support/usual_calls.h"
#include "support/usual_measures.h"

#include <CGAL/Quad_mesh_adaptation/internal/octaves.h>
#include <CGAL/Quad_mesh_adaptation/internal/refinement_schedule.h>
#include <CGAL/Quad_mesh_adaptation/internal/trial_halving.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace {

namespace QMA = CGAL::Quad_mesh_adaptation;
using namespace state_fixture;
using usual_mesh::Mesh;
using usual_mesh::Point;

Options with_sizes(std::function<double(const Vec&)> size)
{
  Options o;
  o.size = std::move(size);
  return o;
}

int octaves(const Shape& shape, const std::function<double(const Vec&)>& size, int most = 30)
{
  Adaptation_state s = make_state(shape, with_sizes(size));
  return core::octaves_above(s, most);
}

std::function<double(const Vec&)> uniform(double h)
{
  return [h](const Vec&) { return h; };
}

} // namespace

// A plate of 100 faces and of area 100: as long as 400 are left.
TEST(Octaves, AsManyAsTheFacesAllow)
{
  const Shape plate = shape_zoo::plate(10, 10);
  EXPECT_EQ(octaves(plate, uniform(1)), 0);
  EXPECT_EQ(octaves(plate, uniform(10 / std::sqrt(1580.))), 0);
  EXPECT_EQ(octaves(plate, uniform(10 / std::sqrt(1620.))), 1);
  EXPECT_EQ(octaves(plate, uniform(10 / std::sqrt(26000.))), 3);
  EXPECT_EQ(octaves(plate, uniform(10 / std::sqrt(26000.)), 2), 2);
  EXPECT_EQ(octaves(plate, uniform(10 / std::sqrt(26000.)), 0), 0);
}

// Coarser than the input where all of it has another size than wanted; not where it can stay.
TEST(Octaves, FineInput)
{
  const Shape plate = shape_zoo::plate(60, 60);
  EXPECT_EQ(octaves(plate, uniform(60 / std::sqrt(21000.))), 2);
  EXPECT_EQ(octaves(plate, uniform(0.9)), 1);
  EXPECT_EQ(octaves(plate, uniform(2)), 0) << "900 faces";
  EXPECT_EQ(octaves(plate, uniform(1.01)), 0) << "as wanted already";
  EXPECT_EQ(octaves(plate, [](const Vec& p) { return p.x() < 15 ? 0.6 : 1.01; }), 0);
}

// Nor where a surface would turn by too much across a face of the first solution: a tube of twelve
// faces around, 30 degrees each, may be made of six.
TEST(Octaves, TurnOfTheSurface)
{
  const Shape tube = shape_zoo::open_cylinder(12, 400);
  Adaptation_state s = make_state(tube, with_sizes(uniform(0.5)));
  const double edge = core::mean_edge_length(s.corners(0));
  for(const auto& [share, most] :
      { std::make_pair(1.4, 0), std::make_pair(0.7, 1), std::make_pair(0.35, 2) }) {
    s = make_state(tube, with_sizes(uniform(share * edge)));
    EXPECT_GE(core::octaves_by_turn(s, 30), most) << share;
    EXPECT_LE(core::octaves_by_turn(s, 30), most + 1) << share;
  }
  s = make_state(shape_zoo::plate(10, 10), with_sizes(uniform(1)));
  EXPECT_EQ(core::octaves_by_turn(s, 30), 30);
}

TEST(Octaves, SteepSizes)
{
  const auto sloped = [](double slope) {
    return [slope](const Vec& p) { return 0.02 + slope * p.x(); };
  };
  EXPECT_EQ(octaves(shape_zoo::plate(10, 10), sloped(0.16)), 0);
  EXPECT_EQ(octaves(shape_zoo::plate(10, 10), sloped(0.08)), 1);
  EXPECT_GE(octaves(shape_zoo::plate(10, 10), sloped(0.02)), 1);
}

TEST(Octaves, FrozenNodesHaveTheirSize)
{
  Adaptation_state s = make_state(shape_zoo::plate(10, 10), with_sizes(uniform(0.03)));
  EXPECT_GT(core::octaves_above(s, 30), 0);
  s.mesh.vertex(50).frozen = true;
  EXPECT_EQ(core::octaves_above(s, 30), 0);
}

// Every face gives four, no irregular node is added, and what is known of sizes is true.
TEST(Octaves, HalvingKeepsThePattern)
{
  for(const Shape& shape : shape_zoo::all()) {
    SCOPED_TRACE(shape.name);
    Adaptation_state s = make_state(
        shape, with_sizes([](const Vec& p) { return 0.5 + 0.01 * std::abs(p.x() - p.y()); }));
    for(Index f : s.mesh.faces()) s.size_ratio(f);
    const Index faces = s.mesh.number_of_faces();
    const std::size_t irregular = irregular_nodes(s);
    core::halve_all(s);
    EXPECT_EQ(s.mesh.number_of_faces(), 4 * faces);
    EXPECT_EQ(irregular_nodes(s), irregular);
    EXPECT_EQ(state_checks::halfedge_problem(s.mesh), "");
    EXPECT_EQ(s.size.scale(), 0.5);
    for(Index v : s.mesh.vertices()) {
      EXPECT_NEAR(s.mesh.vertex(v).h, s.size.at(s.mesh.point(v)), 1e-12);
    }
    for(Index f : s.mesh.faces()) {
      const core::Corners p = s.corners(f);
      EXPECT_NEAR(s.size_ratio(f), core::mean_edge_length(p) / s.size.at_face(p), 1e-12);
    }
  }
}

// A trial leaves no trace.
TEST(Octaves, TrialOfHalving)
{
  for(const Shape& shape : shape_zoo::all()) {
    SCOPED_TRACE(shape.name);
    Adaptation_state s = make_state(shape);
    std::vector<Vec> before, after;
    const auto quads = state_checks::quads_of(s.mesh, before);
    for(Index f : core::faces_folded_by_halving(s)) EXPECT_TRUE(s.mesh.is_face(f));
    EXPECT_EQ(state_checks::quads_of(s.mesh, after), quads);
    EXPECT_EQ(after, before);
    EXPECT_EQ(s.size.scale(), 1);
  }
}

// Few faces are cut until none are left, at most three times, and never many.
TEST(Octaves, FewFacesAreCut)
{
  Adaptation_state plate = make_state(shape_zoo::plate());
  for(int time = 0; time < 2; ++time) core::halve_all(plate);
  const Index given = plate.mesh.number_of_faces();
  ASSERT_GE(given, 200);
  const Vec corner = plate.corners(0)[0];
  const double edge = core::mean_edge_length(plate.corners(0));
  // faces longer than `length` that touch a ball about a corner of the first
  const auto longer_than = [corner](double length, double radius) {
    return [=](const Adaptation_state& s) {
      std::vector<Index> faces;
      for(Index f : s.mesh.faces()) {
        if(core::mean_edge_length(s.corners(f)) <= length) continue;
        const core::Corners p = s.corners(f);
        if(std::any_of(p.begin(), p.end(),
                       [&](const Vec& q) { return core::distance(q, corner) <= radius; }))
          faces.push_back(f);
      }
      return faces;
    };
  };
  Adaptation_state s = plate;
  EXPECT_TRUE(core::is_mended_by_cuts(s, longer_than(0.8 * edge, 0.1 * edge)));
  EXPECT_GT(s.mesh.number_of_faces(), given);
  EXPECT_EQ(state_checks::halfedge_problem(s.mesh), "");
  s = plate;
  EXPECT_FALSE(core::is_mended_by_cuts(s, longer_than(0.001 * edge, 0.1 * edge)));
  EXPECT_EQ(state_checks::halfedge_problem(s.mesh), "");
  s = plate;
  EXPECT_FALSE(core::is_mended_by_cuts(s, longer_than(0.8 * edge, 1e9)));
  EXPECT_EQ(s.mesh.number_of_faces(), given);
}

// A fine sphere thinned out and halved again is round as before.
TEST(Octaves, FineSphereIsFoundAgain)
{
  const Shape sphere = shape_zoo::sphere(30);
  Mesh mesh = zoo_mesh::make<Mesh, Point>(sphere);
  const double h = 1.3 * std::sqrt(4 * 3.14159 / double(sphere.quads.size()));
  const auto r = QMA::adapt_quad_mesh(h, mesh, CGAL::Quad_mesh_adaptation::symmetry(false));
  EXPECT_EQ(r.after.strict_size_ratio.percent_not_larger(), 100.) << r.message;
  EXPECT_GE(r.after.efficiency, 0.85);
  EXPECT_LT(r.after.reference_to_mesh, 0.6 * h * h); // the sagitta of the longest diagonals
  EXPECT_LT(double(r.after.irregular_interior_vertices), 0.06 * double(r.after.interior_vertices));
}

// Refinement alone: as many faces as without octaves, fewer irregular nodes, none cut in vain.
TEST(Octaves, OfRefinement)
{
  const auto sloped = [](const Vec& p) { return 0.05 + 0.01 * p.x(); };
  Adaptation_state with = make_state(shape_zoo::plate(10, 10), with_sizes(sloped)), without = with;
  EXPECT_GE(core::octaves_below_faces(with, 30), 2);
  core::refine_by_octaves(with, core::Marking_options(), 40);
  core::refine_by_templates(without, core::Marking_options(), 40);
  EXPECT_EQ(state_checks::halfedge_problem(with.mesh), "");
  EXPECT_EQ(with.size.scale(), 1);
  EXPECT_NEAR(double(with.mesh.number_of_faces()) / without.mesh.number_of_faces(), 1, 0.2);
  EXPECT_LT(irregular_nodes(with), irregular_nodes(without));
  EXPECT_LT(core::fraction_below(with, 0.5), 0.001);
  // one face small enough already, and there are none
  Adaptation_state held = make_state(shape_zoo::plate(10, 10),
                                     with_sizes([](const Vec& p) { return p.x() > 9 ? 1. : 0.1; }));
  EXPECT_EQ(core::octaves_below_faces(held, 30), 0);
}

// What it is for: many faces with few irregular nodes, within their sizes all the same.
TEST(Octaves, ManyFacesWithFewIrregularNodes)
{
  for(const Shape& shape : { shape_zoo::sphere(6), shape_zoo::torus(24, 12) }) {
    SCOPED_TRACE(shape.name);
    Mesh mesh = zoo_mesh::make<Mesh, Point>(shape);
    const double area = QMA::measure_quad_mesh(mesh, 1.).ideal_number_of_faces; // of size 1
    const double h = std::sqrt(area / 9000);
    const auto r = QMA::adapt_quad_mesh(h, mesh);
    EXPECT_EQ(r.after.strict_size_ratio.percent_not_larger(), 100.) << r.message;
    EXPECT_GE(r.after.efficiency, 0.85);
    EXPECT_GE(r.after.min_scaled_jacobian, 0.5);
    EXPECT_LE(r.after.max_valence, 5u);
    EXPECT_LT(double(r.after.irregular_interior_vertices),
              0.03 * double(r.after.interior_vertices));
  }
}

// A limit of the number of iterations counts halvings.
TEST(Octaves, IterationsAreLimited)
{
  Mesh mesh = zoo_mesh::make<Mesh, Point>(shape_zoo::plate(10, 10));
  const auto r = QMA::adapt_quad_mesh(0.04, mesh, CGAL::parameters::number_of_iterations(3));
  EXPECT_LE(r.iterations, 3u);
}
