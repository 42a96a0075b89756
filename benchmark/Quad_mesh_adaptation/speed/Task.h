// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_BENCHMARK_SPEED_TASK_H
#define QUAD_MESH_ADAPTATION_BENCHMARK_SPEED_TASK_H

#include "../../../examples/Quad_mesh_adaptation/support/paper_cases.h"

#include <CGAL/Quad_mesh_adaptation/Adaptation_report.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace speed {

using paper_cases::Mesh;
using paper_cases::Point;
using paper_cases::Sizing;

/// What a timed call did.
struct Outcome
{
  double cpu = 0, wall = 0; ///< seconds
  double faces_in = 0;      ///< or triangles, for peers that make these
  double faces_out = 0;
  std::vector<CGAL::Quad_mesh_adaptation::Phase_time> phases; ///< wall-clock
};

/// One thing to measure.  `prepare` makes the input, untimed, and returns the call.
struct Task
{
  std::string what, shape;
  int level; ///< about 10^level faces, of the larger of input and output
  std::function<std::function<Outcome()>()> prepare;
  bool measures_memory = false; ///< only of our own calls

  std::string name() const { return what + "/" + shape + "/1e" + std::to_string(level); }

  /// Short calls are repeated more often.
  int repetitions() const { return level <= 4 ? 5 : level == 5 ? 3 : 1; }
};

} // namespace speed

#endif // QUAD_MESH_ADAPTATION_BENCHMARK_SPEED_TASK_H
