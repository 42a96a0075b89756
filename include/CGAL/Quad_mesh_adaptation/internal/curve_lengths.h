// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CURVE_LENGTHS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CURVE_LENGTHS_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Which curves have kept their length, to one in a thousand?  Those along which a mirror plane cuts
// the surface are none of the caller's and do not count.
inline std::vector<char> curves_that_kept_length(const Adaptation_state& s)
{
  constexpr double tolerance = 1e-3;
  const Quad_complex& m = s.mesh;
  std::vector<double> length(s.curves.size(), 0);
  for(Index h = 0; h < 4 * m.face_end(); ++h)
    if(m.is_face(m.face(h)) && m.curve(h) >= 0 && m.opposite(h) < h) // each edge once
      length[m.curve(h)] += distance(m.point(m.origin(h)), m.point(m.target(h)));
  std::vector<char> kept;
  for(std::size_t c = 0; c < length.size(); ++c)
    kept.push_back(!s.curves[c].is_cut && length[c] >= (1 - tolerance) * s.curves[c].length());
  return kept;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CURVE_LENGTHS_H
