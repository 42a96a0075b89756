// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TRIAL_HALVING_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TRIAL_HALVING_H

#include <CGAL/Quad_mesh_adaptation/internal/Mesh_keeper.h>
#include <CGAL/Quad_mesh_adaptation/internal/faults.h>
#include <CGAL/Quad_mesh_adaptation/internal/octaves.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The nodes of now about which halved faces would not lie well on the surface: in narrow folds and
// at sharp tips they may come out folded over, and once they are nothing unfolds them.
inline std::vector<Index> nodes_folded_by_halving(Adaptation_state& s)
{
  constexpr double useless = 0.02;
  std::vector<Index> nodes;
  if(s.surface.is_planar()) return nodes;
  const double enough = (std::min)(useless, worst_quality(s));
  std::vector<char> is_old(s.mesh.vertex_end(), 0);
  for(Index v = 0; v < Index(is_old.size()); ++v) is_old[v] = s.mesh.is_vertex(v);
  Mesh_keeper mesh(s);
  s.scale_sizes(0.5);
  cut_all_faces(s);
  smooth(s, 1);
  for(Index f = 0; f < s.mesh.face_end(); ++f) {
    if(!s.mesh.is_face(f) || s.face_quality(s.corners(f), s.reference_normal(f)) >= enough)
      continue;
    for(Index v : s.mesh.quad(f))
      if(v < Index(is_old.size()) && is_old[v]) nodes.push_back(v);
  }
  s.scale_sizes(2);
  mesh.restore();
  return nodes;
}

// Do halved faces lie well on the surface?  Where few do not, those about them are cut before, so
// that they follow the surface better.
inline bool halves_well(Adaptation_state& s)
{
  constexpr std::size_t few = 100; // one node in so many
  constexpr int most_rounds = 3;
  for(int round = 0;; ++round) {
    const std::vector<Index> folded = nodes_folded_by_halving(s);
    if(folded.empty()) return true;
    if(round == most_rounds || few * folded.size() > std::size_t(s.mesh.number_of_faces()))
      return false;
    std::vector<Index> faces, out;
    for(Index v : folded) {
      s.mesh.outgoing(v, out);
      for(Index h : out) faces.push_back(s.mesh.face(h));
    }
    refine_faces(s, faces);
    smooth(s, 3);
  }
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TRIAL_HALVING_H
