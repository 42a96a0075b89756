// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MESH_KEEPER_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MESH_KEEPER_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Remembers the mesh of a state as it is, to go back to it where what follows is not worth while.
class Mesh_keeper
{
public:
  explicit Mesh_keeper(Adaptation_state& s)
      : s_(s), mesh_(s.mesh.packed()), vertex_end_(s.mesh.vertex_end()), operations_(s.operations),
        iterations_(s.iterations)
  {
  }

  Index number_of_faces() const { return mesh_.number_of_faces(); }

  // All is as it was; once only.
  void restore()
  {
    s_.mesh.become(std::move(mesh_), vertex_end_);
    s_.operations = std::move(operations_);
    s_.iterations = iterations_;
    s_.forget_faces();
    s_.disturb_all();
    s_.stir_all();
  }

private:
  Adaptation_state& s_;
  Quad_complex mesh_; // packed
  Index vertex_end_;
  std::vector<std::pair<const char*, std::size_t>> operations_;
  std::size_t iterations_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MESH_KEEPER_H
