// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PHASE_CLOCK_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PHASE_CLOCK_H

#include <CGAL/Quad_mesh_adaptation/Adaptation_report.h>

#include <chrono>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Adds up wall-clock time by phase, in the order of first appearance.
class Phase_clock
{
  using Clock = std::chrono::steady_clock;

public:
  void start(const char*) { started_ = Clock::now(); }

  void stop(const char* name)
  {
    const double seconds = std::chrono::duration<double>(Clock::now() - started_).count();
    for(Phase_time& t : times_)
      if(t.name == name) {
        t.seconds += seconds;
        return;
      }
    times_.push_back({ name, seconds });
  }

  const std::vector<Phase_time>& times() const { return times_; }

private:
  Clock::time_point started_ = Clock::now();
  std::vector<Phase_time> times_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PHASE_CLOCK_H
