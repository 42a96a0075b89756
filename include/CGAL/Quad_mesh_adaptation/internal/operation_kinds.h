// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_OPERATION_KINDS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_OPERATION_KINDS_H

#include <CGAL/Quad_mesh_adaptation/internal/Quad_complex.h>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

struct Improvement_options
{
  bool close = true, open = true, swap = true, rotate = true, border = true;
  bool corner = false;           // flat corners are split, which shapes are worth, and little else
  bool insertion = true;         // of quads into faces at flat corners
  bool at_corners = false;       // these two where curves meet, too
  bool crease = false;           // creases inside the surface lose single edges, not only by chords
  int max_valence = 5;           // of inner nodes, unless it was higher before
  bool keep_within_size = false; // no operation may leave a face above its size
  double min_jacobian = 0.5;     // no face may fall below min(this, worst before)
  int sweeps = 2;                // of the local relaxation
  double tolerance = 0;          // an operation may raise the energy by this much
  bool first_gain = false;       // the first operation that gains will do, else the best
  // Swaps and rotations are tried only where the valences gain this much: the others hardly ever
  // pay, one in three hundred.
  double valence_gain = 1;
};

enum class Operation_kind
{
  close,
  open,
  swap_left,
  swap_right,
  rotate,
  border_collapse,
  border_split,
  crease_collapse,
  corner_split,
  insertion
};

inline const char* operation_name(Operation_kind k)
{
  switch(k) {
  case Operation_kind::close:
    return "face close";
  case Operation_kind::open:
    return "face open";
  case Operation_kind::rotate:
    return "vertex rotation";
  case Operation_kind::border_collapse:
    return "half-ring collapse";
  case Operation_kind::border_split:
    return "border split";
  case Operation_kind::crease_collapse:
    return "crease collapse";
  case Operation_kind::corner_split:
    return "corner split";
  case Operation_kind::insertion:
    return "quad insertion";
  default:
    return "edge swap";
  }
}

struct Operation_candidate
{
  Operation_kind kind;
  Index h, g;
  double bound; // of the change of energy: no outcome can be lower
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_OPERATION_KINDS_H
