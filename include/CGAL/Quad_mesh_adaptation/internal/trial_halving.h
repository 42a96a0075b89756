// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TRIAL_HALVING_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TRIAL_HALVING_H

#include <CGAL/Quad_mesh_adaptation/internal/Distance_measure.h>
#include <CGAL/Quad_mesh_adaptation/internal/Mesh_keeper.h>
#include <CGAL/Quad_mesh_adaptation/internal/faults.h>
#include <CGAL/Quad_mesh_adaptation/internal/octaves.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Faces from which the reference surface is so far off that halving them would not find it again,
// as tips are where faces are too large for them.
inline std::vector<Index> faces_off_the_surface(const Adaptation_state& s)
{
  constexpr double far = 0.3; // edges; across a face that turns by t it is t / 4
  std::vector<Index> faces;
  if(s.surface.is_planar() && s.curves.empty()) return faces;
  std::vector<double> allowed(s.mesh.face_end(), (std::numeric_limits<double>::infinity)());
  for(Index f : s.mesh.faces()) allowed[f] = far * mean_edge_length(s.corners(f));
  const Distance_measure distances(s, *std::min_element(allowed.begin(), allowed.end()),
                                   std::nullopt, Between_samples::left_out);
  s.surface.forget_tree();
  for(Index f : s.mesh.faces())
    if(distances.of(f) > allowed[f]) faces.push_back(f);
  return faces;
}

// The faces of now about nodes where halved faces would not lie well on the surface: in narrow
// folds and at sharp tips they may come out folded over, and once they are nothing unfolds them.
inline std::vector<Index> faces_folded_by_halving(Adaptation_state& s)
{
  constexpr double useless = 0.02;
  std::vector<Index> nodes, faces;
  if(s.surface.is_planar()) return faces;
  const double enough = (std::min)(useless, worst_quality(s));
  std::vector<char> is_old(s.mesh.vertex_end(), 0);
  for(Index v = 0; v < Index(is_old.size()); ++v) is_old[v] = s.mesh.is_vertex(v);
  Mesh_keeper mesh(s);
  s.scale_sizes(0.5);
  cut_all_faces(s);
  smooth(s, 1);
  for(Index f : s.mesh.faces()) {
    if(s.face_quality(s.corners(f), s.reference_normal(f)) >= enough) continue;
    for(Index v : s.mesh.quad(f))
      if(v < Index(is_old.size()) && is_old[v]) nodes.push_back(v);
  }
  s.scale_sizes(2);
  mesh.restore();
  for(Index v : nodes)
    for(Index h : s.mesh.outgoing(v)) faces.push_back(s.mesh.face(h));
  return faces;
}

// Cuts the faces that `find` finds, as long as there are few of them; tells whether none are left.
template <typename Find>
bool is_mended_by_cuts(Adaptation_state& s, const Find& find)
{
  constexpr std::size_t few = 50; // one face in so many
  constexpr int most_rounds = 3;
  for(int round = 0;; ++round) {
    const std::vector<Index> faces = find(s);
    if(faces.empty()) return true;
    if(round == most_rounds || few * faces.size() > std::size_t(s.mesh.number_of_faces()))
      return false;
    refine_faces(s, faces);
    smooth(s, 3);
  }
}

// Does the mesh cover the surface well enough to be halved?  Where few faces do not they are cut.
inline bool is_made_to_cover(Adaptation_state& s)
{
  return is_mended_by_cuts(s, faces_off_the_surface);
}

// Will halved faces lie well on the surface?  Where few will not, those about them are cut before,
// so that they follow the surface better.
inline bool is_made_to_halve_well(Adaptation_state& s)
{
  return is_mended_by_cuts(s, faces_folded_by_halving);
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TRIAL_HALVING_H
