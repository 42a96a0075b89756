// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Tips of a surface without features: kept when the mesh gets coarse, found again, and within the
// distance that is asked for.

#include "support/more_shapes.h"
#include "support/state_fixture.h"
#include "support/usual_calls.h"

#include <CGAL/Quad_mesh_adaptation/internal/clean_up.h>
#include <CGAL/Quad_mesh_adaptation/internal/refinement.h>
#include <CGAL/Quad_mesh_adaptation/internal/spatial_order.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

namespace QMA = CGAL::Quad_mesh_adaptation;
namespace core = CGAL::Quad_mesh_adaptation::internal;
using more_shapes::Index;
using more_shapes::Shape;
using more_shapes::Vec;
using usual_mesh::Mesh;
using usual_mesh::mesh_of;
using usual_mesh::Point;

// A unit sphere with a thorn of length 1.2 at its north pole.
Shape thorn(Index n)
{
  Shape s = more_shapes::sphere(n);
  s.name = "thorn";
  for(Vec& p : s.points) {
    const double angle = std::acos((std::min)((std::max)(p.z(), -1.), 1.)) / 0.25;
    p = (1 + 1.2 * std::exp(-angle * angle)) * p;
  }
  return s;
}

template <typename NP>
QMA::Adaptation_report adapt(Mesh& mesh, double size, const NP& np)
{
  return QMA::adapt_quad_mesh(size, mesh, QMA::feature_angle(180, QMA::symmetry(false, np)));
}

double height(const Mesh& mesh)
{
  double z = 0;
  for(auto v : mesh.vertices()) z = (std::max)(z, mesh.point(v).z());
  return z;
}

core::Adaptation_state state_of(const Shape& s, double size)
{
  state_fixture::Options o;
  o.feature_angle = 180;
  o.size = [size](const Vec&) { return size; };
  core::Adaptation_state state = state_fixture::make_state(s, o);
  state.prepare_coverage();
  return state;
}

// Each witness is kept by one face, at its cost there; returns their number.
std::size_t check_witnesses(const core::Adaptation_state& s)
{
  std::vector<const core::Witness*> seen;
  for(Index f = 0; f < s.mesh.face_end(); ++f)
    s.coverage.for_each(f, [&](Index, const core::Witness& w) {
      EXPECT_TRUE(s.mesh.is_face(f));
      EXPECT_DOUBLE_EQ(w.cost, w.cost_at(w.distance_to(s.corners(f))));
      seen.push_back(&w);
    });
  std::sort(seen.begin(), seen.end());
  EXPECT_EQ(std::adjacent_find(seen.begin(), seen.end()), seen.end());
  return seen.size();
}

} // namespace

// The face that covers a witness best is the one that looking at all of them finds.
TEST(Coverage, BestOfSomeFaces)
{
  const core::Adaptation_state s = state_of(thorn(6), 0.3);
  core::Covering_faces covers;
  std::vector<Index> faces;
  for(Index f = 0; f < s.mesh.face_end(); f += 7) {
    faces.push_back(f);
    covers.add(s.corners(f));
  }
  std::size_t seen = 0;
  for(Index f = 0; f < s.mesh.face_end(); ++f)
    s.coverage.for_each(f, [&](Index, const core::Witness& w) {
      std::size_t nearest = 0;
      for(std::size_t k = 1; k < faces.size(); ++k)
        if(w.distance_to(s.corners(faces[k])) < w.distance_to(s.corners(faces[nearest])))
          nearest = k;
      for(const std::size_t likely : { std::size_t(0), seen % faces.size() })
        EXPECT_EQ(covers.best_cover(w, likely).second, nearest);
      ++seen;
    });
  EXPECT_GT(seen, 10u);
}

TEST(Coverage, NoWitnessesWhereFlatOrGentle)
{
  EXPECT_TRUE(state_of(more_shapes::plate(8, 8), 3).coverage.is_empty());
  EXPECT_TRUE(state_of(more_shapes::sphere(16), 0.3).coverage.is_empty());
  EXPECT_FALSE(state_of(more_shapes::sphere(16), 1.4).coverage.is_empty());
  core::Adaptation_state box =
      state_fixture::make_state(more_shapes::thin_box(0.08)); // its edges are features
  box.prepare_coverage();
  EXPECT_TRUE(box.coverage.is_empty());
}

TEST(Coverage, WitnessesFollowOperationsAndMoves)
{
  core::Adaptation_state s = state_of(thorn(16), 0.35);
  const std::size_t witnesses = check_witnesses(s);
  EXPECT_GT(witnesses, 20u);
  for(int round = 0; round < 4; ++round) {
    core::clean_up(s, core::Improvement_options(), 1, 1);
    EXPECT_EQ(check_witnesses(s), witnesses);
  }
  s.scale_sizes(0.25);
  s.prepare_coverage();
  EXPECT_NE(check_witnesses(s), witnesses);
}

// Each goes to the part that it is nearest to, which is nearly always the face that a search among
// all of them finds.
TEST(Coverage, WitnessesOfCutFaces)
{
  core::Adaptation_state s = state_of(thorn(16), 0.35);
  const std::size_t witnesses = check_witnesses(s);
  const auto cost = [&s] {
    double sum = 0;
    for(Index f = 0; f < s.mesh.face_end(); ++f) sum += s.coverage.cost(f);
    return sum;
  };
  const double whole = cost();
  core::refine_faces(s, { 0, 100, 101, 200 });
  EXPECT_EQ(check_witnesses(s), witnesses);
  core::renumber_by_place(s);
  EXPECT_EQ(check_witnesses(s), witnesses);
  const double kept = cost();
  EXPECT_LE(kept, 1.05 * whole);
  s.coverage.lose();
  s.prepare_coverage();
  EXPECT_EQ(check_witnesses(s), witnesses);
  EXPECT_NEAR(kept, cost(), 1e-3 * whole + 1e-12);
}

TEST(Coverage, TipStaysInCoarseMeshes)
{
  for(double size : { 0.25, 0.35 }) {
    Mesh mesh = mesh_of(thorn(16));
    const QMA::Adaptation_report r = adapt(mesh, size, QMA::smooth_reference(false));
    EXPECT_EQ(r.status, QMA::Adaptation_status::sizes_met) << size;
    EXPECT_LT(r.after.reference_to_mesh, 0.55 * size) << size;
    EXPECT_LT(r.after.mesh_to_reference, 0.48 * size) << size;
    EXPECT_GT(r.after.min_scaled_jacobian, 0.45) << size;
    EXPECT_GT(r.after.efficiency, 0.85) << size;
  }
}

// A mesh that has lost the tip altogether gets it back from the reference.
TEST(Coverage, TipIsFoundAgain)
{
  const Mesh reference = mesh_of(thorn(16));
  Mesh mesh = mesh_of(more_shapes::sphere(4));
  const QMA::Adaptation_report r = adapt(mesh, 0.3, QMA::reference_surface(reference));
  EXPECT_EQ(r.status, QMA::Adaptation_status::sizes_met);
  EXPECT_GT(height(mesh), 2.05);
  EXPECT_LT(r.after.reference_to_mesh, 0.2);
}

// Also where all its faces have their size already.
TEST(Coverage, TipIsFoundByAGoodMesh)
{
  const Mesh reference = mesh_of(thorn(16));
  Mesh mesh = mesh_of(more_shapes::sphere(4));
  adapt(mesh, 0.3, QMA::smooth_reference(false));
  EXPECT_LT(height(mesh), 1.01);
  adapt(mesh, 0.3, QMA::reference_surface(reference));
  EXPECT_GT(height(mesh), 2.05);
}

TEST(Coverage, DistanceIsKeptBothWays)
{
  for(double size : { 0.3, 0.8 }) {
    Mesh mesh = mesh_of(thorn(16));
    const double bound = 0.04;
    const QMA::Adaptation_report r = adapt(mesh, size, QMA::max_distance(bound));
    const double far = (std::max)(r.after.mesh_to_reference, r.after.reference_to_mesh);
    EXPECT_LT(far, 1.1 * bound) << size;
    EXPECT_EQ(r.faces_too_far.empty(), far <= bound) << size; // met, or the faces are named
    EXPECT_GT(r.after.min_scaled_jacobian, 0.4) << size;
  }
}
