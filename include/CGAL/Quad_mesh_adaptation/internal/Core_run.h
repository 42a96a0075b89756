// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CORE_RUN_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CORE_RUN_H

#include <CGAL/Quad_mesh_adaptation/Adaptation_report.h>
#include <CGAL/Quad_mesh_adaptation/Poor_face.h>
#include <CGAL/Quad_mesh_adaptation/internal/Face_figures.h>
#include <CGAL/Quad_mesh_adaptation/internal/Frozen_edges.h>
#include <CGAL/Quad_mesh_adaptation/internal/Prepared_run.h>
#include <CGAL/Quad_mesh_adaptation/internal/compiled_core.h>
#include <CGAL/Quad_mesh_adaptation/internal/core_calls.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// What the public functions differ in but for their algorithms.
struct Call_kind
{
  bool is_paper = false;       // sizes are those at the centres of faces
  bool is_foretold = false;    // the default schedule, whose number of faces can be foretold
  bool keeps_symmetry = false; // may run on a part of a symmetric input that is mirrored then
};

// What every public function does around its algorithm, but for what knows the caller's mesh: that
// is in run_on_mesh.h.
class Core_run
{
public:
  Core_run(const Call_kind& kind, Adaptation_report& report) : kind_(kind), report_(report) {}
  Core_run(const Core_run&) = delete; // s_ is its own
  Core_run& operator=(const Core_run&) = delete;

  // In this order, once all is decoded and the state built.
  void describe_input();
  void measure_input();
  void work(bool keeps_symmetry, const State_algorithm& algorithm);
  void measure_result();
  void judge();

  const Call_kind& kind() const { return kind_; }
  const std::vector<Index>& large_faces() const { return large_; }
  const std::vector<Index>& far_faces() const { return far_; }
  const std::vector<Poor_face>& poor_shapes() const { return poor_; }

  Prepared_run run;

private:
  const Call_kind kind_;
  Adaptation_report& report_;
  Adaptation_state& s_ = run.s;
  std::optional<Figures_of_faces> kept_; // of the input, while it may be left as it is mostly
  std::optional<Frozen_edges> frozen_;
  double ideal_ = 0; // number of faces
  std::vector<Index> large_, far_;
  std::vector<Poor_face> poor_;
};

// What expected_number_of_faces() returns: the formula's number or, where few faces are expected,
// that of a trial run.
CGAL_QUAD_MESH_ADAPTATION_CORE_CALL double foretold_faces(Prepared_run& run, bool keeps_symmetry);

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#ifndef QUAD_MESH_ADAPTATION_COMPILED_CORE
#include <CGAL/Quad_mesh_adaptation/internal/Core_run_impl.h>
#endif

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CORE_RUN_H
