// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CLEAN_UP_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CLEAN_UP_H

#include <CGAL/Quad_mesh_adaptation/internal/Local_improvement.h>
#include <CGAL/Quad_mesh_adaptation/internal/Phase_scope.h>
#include <CGAL/Quad_mesh_adaptation/internal/smoothing.h>

#include <cstddef>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Topological clean-up about the stirred nodes: passes of local operations, each lowering the
// energy (or raising it by less than the tolerance), until one finds nothing to do, then a little
// smoothing.  Returns the number of operations.
inline std::size_t clean_up_stirred(Adaptation_state& s, const Improvement_options& o,
                                    int max_passes, int smoothing_sweeps)
{
  Phase_scope phase(s, "clean-up");
  const std::size_t done = Local_improvement(s, o).passes(max_passes);
  smooth(s, smoothing_sweeps);
  return done;
}

// The same everywhere.
inline std::size_t clean_up(Adaptation_state& s, const Improvement_options& o, int max_passes,
                            int smoothing_sweeps)
{
  s.stir_all();
  return clean_up_stirred(s, o, max_passes, smoothing_sweeps);
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CLEAN_UP_H
