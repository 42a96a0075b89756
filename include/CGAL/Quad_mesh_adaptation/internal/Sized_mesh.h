// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SIZED_MESH_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SIZED_MESH_H

#include <CGAL/Quad_mesh_adaptation/internal/Face_caches.h>
#include <CGAL/Quad_mesh_adaptation/internal/Quad_complex.h>
#include <CGAL/Quad_mesh_adaptation/internal/Size_sampler.h>
#include <CGAL/Quad_mesh_adaptation/internal/face_energy.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// A mesh, and what of it is to be worked on.
struct Worked_mesh
{
  Quad_complex mesh;

  BOOST_FORCEINLINE Corners corners(Index f) const
  {
    const Quad q = mesh.quad(f);
    return { mesh.point(q[0]), mesh.point(q[1]), mesh.point(q[2]), mesh.point(q[3]) };
  }

  // Where only a part of the mesh is to be worked on: its nodes; new ones belong to it.
  std::vector<char> region;

  bool is_to_work_on(Index v) const { return v >= Index(region.size()) || region[v]; }
  bool is_face_to_work_on(Index f) const
  {
    const Quad q = mesh.quad(f);
    return std::all_of(q.begin(), q.end(), [this](Index v) { return is_to_work_on(v); });
  }
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

// A mesh, and what sizes its faces are to have and have; known until a corner moves.
struct Sized_mesh : Worked_mesh, Face_caches
{
  Size_sampler size;

  // The size a face is to have now, the floor of under-resolved places included.
  double target(const Corners& p, double floor) const { return (std::max)(size.at_face(p), floor); }

  double face_floor(Index f) const
  {
    double s = 0;
    for(Index v : mesh.quad(f)) s += 0.25 * mesh.vertex(v).floor;
    return s;
  }

  // Size ratio of eq. 3, in the sampling in use, against the size without floors.
  double size_ratio(Index f) const
  {
    return ratios.is_known(f) ? ratios[f] : mean_edge_length(corners(f)) / wanted_size(f);
  }
  // The same where the mean edge length and the sizes, not scaled, are at hand; known from then on.
  double size_ratio(Index f, double mean_length, const Face_sizes& at_hand) const
  {
    if(size.is_constant()) return ratios.set(f, mean_length / wanted_size(f), mesh.face_end());
    if(!sizes.is_known(f)) sizes.set(f, at_hand.strict(size.scale()), mesh.face_end());
    return ratios.set(f, mean_length / sizes[f], mesh.face_end());
  }

  // The same size as in the ratio.  All who judge face f share it: to find it takes five values of
  // the caller's function, which may be slow.
  double wanted_size(Index f) const
  {
    if(size.is_constant()) return size.at_face(Corners());
    if(!sizes.is_known(f)) sizes.set(f, size.at_face(corners(f)), mesh.face_end());
    return sizes[f];
  }

  // Wanted size of face f over the sum of the sizes at its corners.  It changes little while the
  // corners move, so that smoothing asks for one size per move instead of five per face.
  double size_factor(Index f) const
  {
    if(size.is_constant()) return 0.25;
    return factors.is_known(f) ? factors[f] : size_factor_now(f);
  }

  // Renewed after a few moves.
  double renewed_size_factor(Index f)
  {
    if(size.is_constant()) return 0.25;
    if(!factors.is_known(f) || factor_age[f] >= 6) {
      factors.set(f, size_factor_now(f), mesh.face_end());
      factor_age.resize(mesh.face_end(), 0);
      factor_age[f] = 0;
    }
    return factors[f];
  }

  float size_factor_now(Index f) const
  {
    double sum = 0;
    for(Index v : mesh.quad(f)) sum += mesh.vertex(v).h;
    return float(wanted_size(f) / sum);
  }

  // Node v is elsewhere now, and so its faces are.
  void node_moved(Index v)
  {
    for(Index h : mesh.outgoing(v)) face_moved(mesh.face(h));
  }
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SIZED_MESH_H
