// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_RUN_RECORD_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_RUN_RECORD_H

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Thrown by the progress check, caught at the public header.
struct Cancelled
{
};

// How far a call has got, for those who watch it, and what it has done.
struct Run_record
{
  std::function<void(double)> report_progress = [](double) {}; // throws Cancelled
  double progress = 0;                                         // of the whole call, 0 to 1

  void check_cancelled() const { report_progress(progress); }

  std::function<void(double)> foretell = [](double) {}; // told the faces expected before the work
  // Told when a phase starts (name, iteration) and ends (name, faces).
  std::function<void(const char*, std::size_t)> start_phase = [](const char*, std::size_t) {};
  std::function<void(const char*, std::size_t)> end_phase = [](const char*, std::size_t) {};
  std::size_t detours_left = 150; // trials about poor faces that nothing excuses, in all
  std::size_t iterations = 0;     // passes of the driver's loop
  std::vector<std::pair<const char*, std::size_t>> operations; // how often each was committed

  // `operation` is a literal.
  void count(const char* operation, std::size_t n = 1)
  {
    for(auto& o : operations)
      if(o.first == operation) {
        o.second += n;
        return;
      }
    operations.emplace_back(operation, n);
  }
  std::map<std::string, std::size_t> operation_counts() const
  {
    std::map<std::string, std::size_t> counts;
    for(const auto& o : operations) counts[o.first] += o.second;
    return counts;
  }
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_RUN_RECORD_H
