// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_WORKED_MESH_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_WORKED_MESH_H

#include <CGAL/Quad_mesh_adaptation/internal/Quad_complex.h>
#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// A mesh, and what of it is to be worked on.
struct Worked_mesh
{
  Quad_complex mesh;

  Corners corners(Index f) const
  {
    const Quad q = mesh.quad(f);
    return { mesh.point(q[0]), mesh.point(q[1]), mesh.point(q[2]), mesh.point(q[3]) };
  }

  // Where only a part of the mesh is to be worked on: its nodes; new ones belong to it.
  std::vector<char> region;

  bool is_to_work_on(Index v) const { return v >= Index(region.size()) || region[v]; }
  std::vector<char> all_to_work_on() const
  {
    std::vector<char> all = region;
    all.resize(mesh.vertex_end(), 1);
    return all;
  }

  // Nodes that smoothing should visit, because something about them changed.
  std::vector<char> restless;

  void disturb(Index v)
  {
    if(!is_to_work_on(v)) return;
    if(v >= Index(restless.size())) restless.resize(mesh.vertex_end(), 1);
    restless[v] = 1;
  }
  void disturb_all() { restless = all_to_work_on(); }

  // Nodes about which enough has changed for another operation to pay.
  std::vector<char> stirred;

  void stir(Index v)
  {
    if(!is_to_work_on(v)) return;
    if(v >= Index(stirred.size())) stirred.resize(mesh.vertex_end(), 1);
    stirred[v] = 1;
  }
  void stir_all() { stirred = all_to_work_on(); }
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_WORKED_MESH_H
