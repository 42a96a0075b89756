// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CLEAN_UP_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CLEAN_UP_H

#include <CGAL/Quad_mesh_adaptation/internal/Local_improvement.h>
#include <CGAL/Quad_mesh_adaptation/internal/Phase_scope.h>

#include <cstddef>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Topological clean-up of the whole mesh: passes of local operations, each lowering the energy,
// until one finds nothing to do, then a little smoothing.  Returns the number of operations.
inline std::size_t clean_up(Adaptation_state& s, const Improvement_options& o, int max_passes,
                            int smoothing_sweeps)
{
  Phase_scope phase(s, "clean-up");
  Local_improvement improvement(s, o);
  improvement.activate_all();
  std::size_t total = 0;
  for(int pass = 0; pass < max_passes; ++pass) {
    const std::size_t done = improvement.pass();
    total += done;
    if(done == 0) break;
  }
  smooth(s, smoothing_sweeps);
  return total;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CLEAN_UP_H
