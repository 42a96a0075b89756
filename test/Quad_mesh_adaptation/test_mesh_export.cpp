// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Writing a changed state back into the caller's graph.

#include "support/places.h"
#include "support/usual_mesh.h"

#include <CGAL/Quad_mesh_adaptation/internal/No_constraints.h>
#include <CGAL/Quad_mesh_adaptation/internal/core_calls.h>
#include <CGAL/Quad_mesh_adaptation/internal/mesh_export.h>
#include <CGAL/Quad_mesh_adaptation/internal/mesh_import.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/chord_collapse.h>

#include <CGAL/Polyhedron_3.h>

#include <gtest/gtest.h>

#include <functional>
#include <random>

namespace {

namespace core = CGAL::Quad_mesh_adaptation::internal;
using core::Adaptation_state;
using core::Index;
using usual_mesh::Mesh;
using usual_mesh::Point;
using Polyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>;
using shape_zoo::Shape;

// The coordinates of a face, from whichever corner comes first.
std::vector<double> points_of(const core::Corners& p)
{
  std::vector<double> least;
  for(std::size_t first = 0; first < 4; ++first) {
    std::vector<double> r;
    for(std::size_t i = 0; i < 4; ++i)
      for(int k = 0; k < 3; ++k) r.push_back(p[(first + i) % 4][k]);
    if(least.empty() || r < least) least = r;
  }
  return least;
}

// Is the graph what the state is, with the topology of `shape`?
template <typename M>
void expect_same(const M& mesh, const Adaptation_state& s, const Shape& shape)
{
  ASSERT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  const Shape after = zoo_mesh::shape_of(mesh);
  const mesh_checks::Facts facts = mesh_checks::facts_of(after.points, after.quads);
  EXPECT_EQ(facts.problem, "");
  EXPECT_TRUE(mesh_checks::same_topology(mesh_checks::facts_of(shape.points, shape.quads), facts));
  EXPECT_EQ(facts.faces, std::size_t(s.mesh.number_of_faces()));
  std::multiset<std::vector<double>> written, wanted;
  for(const auto& q : after.quads)
    written.insert(points_of(
        { after.points[q[0]], after.points[q[1]], after.points[q[2]], after.points[q[3]] }));
  for(Index f : s.mesh.faces()) wanted.insert(points_of(s.corners(f)));
  EXPECT_TRUE(written == wanted);
}

// Imports, lets `change` work on the state, exports, and compares the graph with the state.
template <typename M>
void import_change_export(const Shape& shape, double feature_angle, const std::set<Index>& frozen,
                          const std::function<void(Adaptation_state&)>& change)
{
  using Vertex = typename boost::graph_traits<M>::vertex_descriptor;
  using Edge = typename boost::graph_traits<M>::edge_descriptor;
  M mesh = zoo_mesh::make<M, Point>(shape);
  auto vpm = get(CGAL::vertex_point, mesh);
  const core::No_constraints<Edge> ecm{};
  const core::No_constraints<Vertex> vcm{};
  core::Input_mesh in;
  core::Mesh_descriptors<M> descriptors;
  core::Mesh_import<M, decltype(vpm), core::No_constraints<Edge>, core::No_constraints<Vertex>>
      import(mesh, vpm, ecm, vcm);
  import(faces(mesh), false, in, descriptors);
  in.is_frozen_vertex.resize(in.points.size(), 0); // empty: none is
  for(Index v = 0; v < Index(in.points.size()); ++v)
    for(Index f : frozen) in.is_frozen_vertex[v] |= in.points[v] == shape.points[f];
  Adaptation_state s;
  s.size = core::Size_sampler([](const core::Vec&) { return 1.; }, 1.);
  core::Feature_options features;
  features.feature_angle = feature_angle;
  core::build_state(in, features, core::Geometry_options(), s);
  change(s);
  Adaptation_state used_up = s;
  core::Mesh_export<M, decltype(vpm), core::No_constraints<Edge>> write(mesh, vpm, ecm, in,
                                                                        descriptors, used_up);
  write();

  expect_same(mesh, s, shape);
}

// Random operations, whatever the shape of the faces.
std::function<void(Adaptation_state&)> operations(unsigned seed, int n)
{
  return [=](Adaptation_state& s) {
    std::mt19937 random(seed);
    core::Cavity cavity(s);
    for(int i = 0; i < n; ++i) {
      const std::vector<places::Place> list = places::all_places(s);
      if(list.empty() || s.mesh.number_of_faces() < 8) return;
      list[random() % list.size()].describe(s, cavity);
      if(cavity.close()) cavity.commit();
    }
  };
}

} // namespace

TEST(Mesh_export, NothingChanged)
{
  for(const Shape& shape : shape_zoo::all())
    import_change_export<Mesh>(shape, 40, {}, [](Adaptation_state&) {});
}

// The face under a bump keeps its four vertices while the bump goes: one of its edges comes to lie
// on the border.
TEST(Mesh_export, UnchangedFaceComesToTheBorder)
{
  Shape shape = shape_zoo::plate(3, 1);
  const Index u = 5, v = 6; // (1, 1) and (2, 1)
  const Index w = Index(shape.points.size());
  shape.points.emplace_back(2, 2, 0);
  shape.points.emplace_back(1, 2, 0);
  shape.quads.push_back({ u, v, w, w + 1 });
  const auto remove_bump = [](Adaptation_state& s) {
    core::Chord chord = core::chord_through(s.mesh, 12);
    if(chord.faces.size() > 1) chord = core::chord_through(s.mesh, 13); // the bump's own
    ASSERT_EQ(chord.faces, std::vector<Index>{ 3 });
    ASSERT_TRUE(core::is_chord_collapse_allowed(s, chord));
    core::Cavity cavity(s);
    core::describe_chord_collapse(s, chord, cavity);
    ASSERT_TRUE(cavity.close());
    cavity.commit();
    ASSERT_EQ(s.mesh.number_of_faces(), 3);
  };
  import_change_export<Mesh>(shape, 100, { u, v }, remove_bump);
  import_change_export<Polyhedron>(shape, 100, { u, v }, remove_bump);
}

TEST(Mesh_export, AfterRandomOperations)
{
  const unsigned seed = zoo_mesh::seed();
  for(const Shape& shape : shape_zoo::all())
    for(int n : { 1, 3, 12 })
      for(double angle : { 40., 180. }) {
        SCOPED_TRACE(shape.name + ", " + std::to_string(n) + " operations, angle " +
                     std::to_string(angle) + ", QUAD_MESH_SEED=" + std::to_string(seed));
        import_change_export<Mesh>(shape, angle, {}, operations(seed, n));
        import_change_export<Polyhedron>(shape, angle, {}, operations(seed, n));
      }
}
