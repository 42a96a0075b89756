// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DETOUR_SEARCHES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DETOUR_SEARCHES_H

#include <CGAL/Quad_mesh_adaptation/internal/operation_kinds.h>

#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// What is tried about a face: the first operations, a kind or two at a time, about the nodes within
// so many rings of it, and how much better the mesh must be for it in the end.
struct Detour_search
{
  std::vector<Improvement_options> first;
  int rings;
  double least_gain;
  bool splits = false; // of the edges about the face, after all operations
};

inline Improvement_options made_careful(Improvement_options o)
{
  o.keep_within_size = true;
  o.valence_gain = -1e9; // swaps for the sake of shapes, too
  return o;
}

inline Improvement_options made_to_do_nothing(Improvement_options o)
{
  o.tolerance = 10;
  o.keep_within_size = false;
  o.min_jacobian = 0.3;
  o.close = o.open = o.swap = o.rotate = o.border = o.insertion = false;
  return o;
}

inline Detour_search usual_search(const Improvement_options& o, double least_gain)
{
  Detour_search x = { std::vector<Improvement_options>(4, made_to_do_nothing(o)), 1, least_gain };
  x.first[0].swap = x.first[0].rotate = true;
  x.first[1].close = true;
  x.first[2].border = x.first[2].crease = true;
  x.first[3].open = x.first[3].corner = x.first[3].insertion = true;
  return x;
}

// Splits that give a flat corner a second face are not left to be hidden by cheaper operations, and
// may leave narrow faces until others follow.  Any of them may crowd a node, which others relieve.
// Gains of less than a face hardly show, and take trials.
inline Detour_search thorough_search(const Improvement_options& o, int rings)
{
  Improvement_options none = made_to_do_nothing(o);
  none.max_valence = 6;
  none.at_corners = true;
  Detour_search x = { std::vector<Improvement_options>(6, none), rings, 1 };
  x.first[0].corner = true;
  x.first[1].swap = x.first[1].rotate = true;
  x.first[2].close = true;
  x.first[3].border = x.first[3].crease = true;
  x.first[4].open = true;
  x.first[5].insertion = true;
  for(int i : { 0, 5 }) {
    x.first[i].tolerance = 30;
    x.first[i].min_jacobian = 0.1;
  }
  return x;
}

// To have fewer faces: half rows between curves, or single faces.  Others hardly ever lead there.
inline Detour_search thinning_search(const Improvement_options& o, bool half_rows)
{
  Improvement_options none = made_to_do_nothing(o);
  none.max_valence = 6;
  none.tolerance = 30;
  none.min_jacobian = 0.1;
  none.border = none.crease = half_rows;
  none.close = !half_rows;
  return { { none }, 1, 0.5 };
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DETOUR_SEARCHES_H
