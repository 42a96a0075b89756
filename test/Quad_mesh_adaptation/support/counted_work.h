// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_TEST_COUNTED_WORK_H
#define QUAD_MESH_ADAPTATION_TEST_COUNTED_WORK_H

#include "usual_mesh.h"

#include <CGAL/Quad_mesh_adaptation/Adaptation_report.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <string>

// What a call of the package costs, in counts and in time of the processor.
namespace counted_work {

using usual_mesh::Mesh;
using usual_mesh::Point;
using usual_mesh::Size;

struct Work
{
  std::size_t faces = 0;       ///< the more of input and output
  std::size_t size_calls = 0;  ///< of the sizing function
  std::size_t projections = 0; ///< of a projector, where the call is given one
  double seconds = 0;          ///< of the processor, not of the wall: other jobs do not count

  double size_calls_per_face() const { return double(size_calls) / double(faces); }
  double projections_per_face() const { return double(projections) / double(faces); }
  double seconds_per_face() const { return seconds / double(faces); }
};

/// Runs `operation(size, mesh, work)` on a fresh mesh of the shape; the size it gets is `size` with
/// its calls counted.
template <typename Operation>
Work measured(const shape_zoo::Shape& shape, const Size& size, const Operation& operation)
{
  SCOPED_TRACE(shape.name + " of " + std::to_string(shape.quads.size()) + " faces");
  Mesh mesh = zoo_mesh::make<Mesh, Point>(shape);
  Work work;
  const Size counting = [&](const Point& p) {
    ++work.size_calls;
    return size(p);
  };
  const std::clock_t start = std::clock();
  const auto report = operation(counting, mesh, work);
  work.seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
  work.faces = (std::max)(shape.quads.size(), std::size_t(mesh.number_of_faces()));
  EXPECT_TRUE(report.has_valid_mesh()) << report.message;
  EXPECT_NE(shape.quads.size(), mesh.number_of_faces()) << "nothing was done";
  return work;
}

} // namespace counted_work

#endif // QUAD_MESH_ADAPTATION_TEST_COUNTED_WORK_H
