// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Any number of threads makes, to the last bit, the mesh that one makes.

#include "support/more_shapes.h"
#include "support/shape_zoo.h"
#include "support/usual_calls.h"
#include "support/usual_passes.h"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace {

namespace QMA = CGAL::Quad_mesh_adaptation;
using usual_mesh::Mesh;
using usual_mesh::Point;

// Runs something with so many threads, whatever the machine has.
template <typename Action>
void with_threads(int n, const Action& action)
{
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, std::size_t(n));
  tbb::task_arena arena(n);
  arena.execute(action);
}

struct Bytes
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::size_t> corners;

  explicit Bytes(const Mesh& mesh)
  {
    for(auto v : mesh.vertices()) {
      const Point& p = mesh.point(v);
      points.push_back({ p.x(), p.y(), p.z() });
    }
    for(auto f : mesh.faces())
      for(auto v : mesh.vertices_around_face(mesh.halfedge(f))) corners.push_back(v);
  }
  bool operator==(const Bytes& other) const
  {
    return points == other.points && corners == other.corners;
  }
};

// Both tags, and several numbers of threads, of an adaptation of a mesh.
template <typename Adapt>
void expect_same(const Mesh& initial, const Adapt& adapt)
{
  Mesh one = initial;
  adapt(one, CGAL::Sequential_tag());
  EXPECT_FALSE(Bytes(one) == Bytes(initial)) << "nothing to compare";
  for(int threads : { 2, 7 }) {
    SCOPED_TRACE(std::to_string(threads) + " threads");
    Mesh several = initial;
    with_threads(threads, [&] { adapt(several, CGAL::Parallel_tag()); });
    EXPECT_TRUE(Bytes(several) == Bytes(one));
  }
}

struct Graded
{
  double least, growth;
  Point centre;
  double operator()(const Point& p) const
  {
    return least + growth * std::sqrt(CGAL::squared_distance(p, centre));
  }
};

TEST(Threads, Plate_refined_and_coarsened)
{
  const Mesh plate = zoo_mesh::make<Mesh, Point>(shape_zoo::plate(40, 40));
  expect_same(plate, [](Mesh& mesh, auto tag) {
    QMA::adapt_quad_mesh(Graded{ 0.25, 0.05, Point(12, 13, 0) }, mesh,
                         QMA::symmetry(false, QMA::concurrency(tag)));
  });
}

TEST(Threads, Curved_surface_with_features)
{
  const Mesh can = zoo_mesh::make<Mesh, Point>(more_shapes::closed_cylinder(6));
  expect_same(can, [](Mesh& mesh, auto tag) {
    QMA::adapt_quad_mesh(Graded{ 0.04, 0.1, Point(1, 0, 0) }, mesh, QMA::concurrency(tag));
  });
}

TEST(Threads, Closed_surface_much_too_fine)
{
  const Mesh torus = zoo_mesh::make<Mesh, Point>(shape_zoo::torus(120, 50));
  expect_same(
      torus, [](Mesh& mesh, auto tag) { QMA::adapt_quad_mesh(0.25, mesh, QMA::concurrency(tag)); });
}

TEST(Threads, Paper_schedule)
{
  const Mesh plate = zoo_mesh::make<Mesh, Point>(shape_zoo::plate(30, 30));
  expect_same(plate, [](Mesh& mesh, auto tag) {
    QMA::adapt_quad_mesh(Graded{ 0.6, 0.1, Point(12, 13, 0) }, mesh,
                         QMA::schedule(QMA::Schedule::paper, QMA::concurrency(tag)));
  });
}

TEST(Threads, Single_phases)
{
  const Mesh torus = zoo_mesh::make<Mesh, Point>(shape_zoo::torus(60, 30));
  expect_same(torus, [](Mesh& mesh, auto tag) {
    const auto np = QMA::concurrency(tag);
    QMA::refine(Graded{ 0.06, 0.1, Point(1, 0, 0) }, mesh, np);
    QMA::smooth(Graded{ 0.06, 0.1, Point(1, 0, 0) }, mesh, np);
    QMA::coarsen(0.2, mesh, np);
  });
}

// A field that goes wrong in the midst of the work is refused as with one thread, the mesh
// unchanged.
TEST(Threads, Bad_size_in_a_thread)
{
  const Mesh plate = zoo_mesh::make<Mesh, Point>(shape_zoo::plate(60, 60));
  Mesh mesh = plate;
  std::atomic<int> calls(0);
  QMA::Adaptation_report report;
  with_threads(3, [&] {
    report = QMA::adapt_quad_mesh(
        [&](const Point& p) { return ++calls > 2000000 ? -1. : 0.4 + 0.01 * p.x(); }, mesh,
        QMA::symmetry(false, QMA::concurrency(CGAL::Parallel_tag())));
  });
  EXPECT_EQ(report.status, QMA::Adaptation_status::sizes_refused) << calls << " calls";
  EXPECT_TRUE(Bytes(mesh) == Bytes(plate));
}

} // namespace
