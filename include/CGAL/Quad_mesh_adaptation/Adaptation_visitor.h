// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_ADAPTATION_VISITOR_H
#define CGAL_QUAD_MESH_ADAPTATION_ADAPTATION_VISITOR_H

#include <cstddef>

namespace CGAL {
namespace Quad_mesh_adaptation {

/// Default visitor, all functions empty: inherit from it and override what you need.
/// Pass it as `.visitor(std::ref(my_visitor))`.
struct Adaptation_visitor
{
  /// The work begins, and about so many faces will come out, see
  /// `Adaptation_report::expected_number_of_faces`; told where that is foretold, once.
  void foretell(double /*faces*/) {}
  /// A phase of the driver starts ("coarsening", "refinement", "clean-up", "smoothing" ...).
  void start_phase(const char* /*name*/, std::size_t /*iteration*/) {}
  /// It ended; the mesh has `faces` faces now.
  void end_phase(const char* /*name*/, std::size_t /*faces*/) {}
  /// Asked between and during phases, at least once per second of work on meshes of up to a
  /// million faces; `false` cancels the call and leaves the caller's mesh as it was.
  bool go_further() { return true; }
};

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_ADAPTATION_VISITOR_H
