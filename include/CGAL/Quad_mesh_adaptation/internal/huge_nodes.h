// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_HUGE_NODES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_HUGE_NODES_H

#include <CGAL/Quad_mesh_adaptation/internal/Quad_complex.h>

#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// With so many faces at a node, each look at all of them counts.
inline bool is_huge(const Quad_complex& m, Index v) { return m.vertex(v).faces > 24; }

inline std::vector<Index> huge_nodes(const Quad_complex& m)
{
  std::vector<Index> list;
  for(Index v : m.vertices())
    if(is_huge(m, v)) list.push_back(v);
  return list;
}

// In a fan of more faces whatever is tried takes all the time there is, and hardly anything helps.
constexpr int boundless_fan = 100;

inline bool has_boundless_fan(const Quad_complex& m)
{
  for(Index v : m.vertices())
    if(m.vertex(v).faces > boundless_fan) return true;
  return false;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_HUGE_NODES_H
