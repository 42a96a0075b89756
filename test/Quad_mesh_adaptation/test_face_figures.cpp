// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Figures that are kept of faces left as they were give what measuring all of the mesh gives.

#include "support/state_fixture.h"

#include <CGAL/Quad_mesh_adaptation/internal/core_calls.h>
#include <CGAL/Quad_mesh_adaptation/internal/measure_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/progressive_schedule.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

namespace {

namespace core = CGAL::Quad_mesh_adaptation::internal;
using CGAL::Quad_mesh_adaptation::Mesh_measures;
using CGAL::Quad_mesh_adaptation::Size_ratio_table;
using core::Adaptation_state;
using core::Index;
using core::Vec;
using shape_zoo::Shape;
using state_fixture::Options;

void expect_same(const Size_ratio_table& a, const Size_ratio_table& b)
{
  EXPECT_EQ(a.counts, b.counts);
  EXPECT_EQ(a.min, b.min);
  EXPECT_EQ(a.mean, b.mean);
  EXPECT_EQ(a.max, b.max);
}

void expect_same(const Mesh_measures& a, const Mesh_measures& b)
{
  EXPECT_EQ(a.faces, b.faces);
  EXPECT_EQ(a.components, b.components);
  expect_same(a.size_ratio, b.size_ratio);
  expect_same(a.strict_size_ratio, b.strict_size_ratio);
  EXPECT_EQ(a.ideal_number_of_faces, b.ideal_number_of_faces);
  EXPECT_EQ(a.min_scaled_jacobian, b.min_scaled_jacobian);
  EXPECT_EQ(a.p5_scaled_jacobian, b.p5_scaled_jacobian);
  EXPECT_EQ(a.mean_scaled_jacobian, b.mean_scaled_jacobian);
  EXPECT_EQ(a.min_angle, b.min_angle);
  EXPECT_EQ(a.max_angle, b.max_angle);
  EXPECT_EQ(a.max_warp, b.max_warp);
  EXPECT_EQ(a.inverted_faces, b.inverted_faces);
  EXPECT_EQ(a.max_distance_to_reference, b.max_distance_to_reference);
  EXPECT_EQ(a.mesh_to_reference, b.mesh_to_reference);
  EXPECT_EQ(a.reference_to_mesh, b.reference_to_mesh);
}

// A state whose faces are measured, changed, and measured again with what was kept.
class Measured
{
public:
  Measured(const Shape& shape, const Options& o, const std::vector<Index>& patch = {})
      : in_(state_fixture::input_of(shape, o))
  {
    in_.patch = patch;
    state.size = core::Size_sampler(o.size, 0);
    core::build_state(in_, core::Feature_options(), core::Geometry_options(), state);
    kept_.emplace(in_);
    check();
  }

  void check()
  {
    const Mesh_measures with = core::measure_state(state, std::nullopt, &*kept_);
    state.forget_sizes();
    expect_same(core::measure_state(state, std::nullopt), with);
  }

  void move(Index v, const Vec& p)
  {
    state.mesh.vertex(v).p = p;
    for(Index f = 0; f < state.mesh.face_end(); ++f) {
      const core::Quad q = state.mesh.quad(f);
      if(std::find(q.begin(), q.end(), v) != q.end()) state.face_moved(f);
    }
  }

  Adaptation_state state;

private:
  core::Input_mesh in_;
  std::optional<core::Figures_of_faces> kept_;
};

// Halved near one place of a shape with edges of length `edge`.
Options with_small_change(const Shape& shape, double edge, Options o = Options())
{
  const Vec centre = shape.points[shape.points.size() / 3];
  o.size = [=](const Vec& p) {
    return edge * (core::distance(p, centre) < 4 * edge ? 0.55 : 1.06 + 0.01 * std::sin(p.x()));
  };
  return o;
}

// Not regular, so that each face has other figures.
Shape jittered(Shape shape, double by)
{
  for(std::size_t v = 0; v < shape.points.size(); ++v) {
    const double a = double(v * v % 101), b = double(v * 7 % 13);
    shape.points[v] = shape.points[v] + by * Vec(std::sin(a), std::cos(a + b), 0);
  }
  return shape;
}

} // namespace

// Where one of the faces that stand out changes, the next one after it does.
TEST(FaceFigures, WhenTheWorstFacesAreMended)
{
  Shape shape = jittered(shape_zoo::plate(12, 12), 0.05);
  const std::vector<Vec> good = shape.points;
  const std::vector<Index> bad = { 28, 70, 110 };
  for(std::size_t i = 0; i < bad.size(); ++i)
    shape.points[bad[i]] = shape.points[bad[i]] + Vec(0.3 + 0.1 * i, 0.3, 0.2 * (i + 1));
  Options o;
  o.size = [](const Vec& p) { return 1 + 0.01 * p.x(); };
  Measured m(shape, o);
  for(Index v : bad) {
    m.move(v, good[v]);
    m.check();
  }
  m.move(100, good[100] + Vec(0.45, 0.4, 0.9)); // worse than all before
  m.check();
}

TEST(FaceFigures, AfterASmallChange)
{
  const Shape plate = jittered(shape_zoo::plate(100, 100), 0.04), sphere = shape_zoo::sphere(40),
              torus = shape_zoo::torus(60, 40);
  Options frozen = state_fixture::with_crease(plate);
  for(const auto& e : frozen.constrained)
    if(plate.points[e.first].y() < 30) frozen.frozen.insert(e);
  std::vector<Index> patch;
  for(const auto& q : sphere.quads) patch.push_back(sphere.points[q[0]].z() > 0.1);
  const double edge = zoo_mesh::mean_edge(sphere);
  std::vector<std::unique_ptr<Measured>> all;
  all.push_back(std::make_unique<Measured>(plate, with_small_change(plate, 1)));
  all.push_back(std::make_unique<Measured>(plate, with_small_change(plate, 1, frozen)));
  all.push_back(std::make_unique<Measured>(sphere, with_small_change(sphere, edge), patch));
  all.push_back(
      std::make_unique<Measured>(torus, with_small_change(torus, zoo_mesh::mean_edge(torus))));
  for(const auto& m : all) {
    SCOPED_TRACE(&m - &all[0]);
    const Index before = m->state.mesh.number_of_faces();
    core::progressive_schedule(m->state, 30);
    EXPECT_NE(m->state.mesh.number_of_faces(), before);
    m->check();
  }
}
