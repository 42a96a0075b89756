// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_CACHES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_CACHES_H

#include <CGAL/Quad_mesh_adaptation/internal/Face_values.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// What is known of each face until it changes, see Adaptation_state.
struct Face_caches
{
  Face_values<float> energies;          // see cached_energy()
  mutable Face_values<double> sizes;    // see wanted_size()
  mutable Face_values<double> ratios;   // see size_ratio(); none unless the mesh fits mostly
  Face_values<float> factors;           // see size_factor()
  std::vector<std::uint8_t> factor_age; // moves of its corners since then
  mutable Face_values<float> qualities; // see known_quality(); none unless shapes are mended

  // A corner of face f has moved.
  void face_moved(Index f)
  {
    energies.forget(f);
    sizes.forget(f);
    ratios.forget(f);
    qualities.forget(f);
    if(f < Index(factor_age.size()) && factor_age[f] < 255) ++factor_age[f];
  }
  // Face f is another one now.
  void face_replaced(Index f)
  {
    energies.forget(f);
    sizes.forget(f);
    ratios.forget(f);
    qualities.forget(f);
    factors.forget(f);
  }
  // From now on faces may change without notice, as long as sizes do not.
  void forget_ratios() { ratios = Face_values<double>(); }
  void forget_energies() { energies.forget_all(); }
  void forget_sizes()
  {
    energies.forget_all();
    sizes.forget_all();
    ratios.forget_all();
  }
  void forget_values()
  {
    forget_sizes();
    factors.forget_all();
    qualities.forget_all();
    factor_age.clear();
  }
  // Before threads ask: nothing has to grow then.
  void fit_values(Index face_end)
  {
    energies.fit(face_end);
    sizes.fit(face_end);
    factors.fit(face_end);
    factor_age.resize(face_end, 0);
  }
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_CACHES_H
