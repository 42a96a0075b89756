// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_REFINEMENT_SCHEDULE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_REFINEMENT_SCHEDULE_H

#include <CGAL/Quad_mesh_adaptation/internal/Mesh_keeper.h>
#include <CGAL/Quad_mesh_adaptation/internal/octaves.h>
#include <CGAL/Quad_mesh_adaptation/internal/curve_bends.h>
#include <CGAL/Quad_mesh_adaptation/internal/faults.h>
#include <CGAL/Quad_mesh_adaptation/internal/spatial_order.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Those that `wanted` marks, all nodes on curves, and of the others so many that each has one of
// them beside it or across a face: where these have a good place, all have mostly.
inline std::vector<char> probes(const Quad_complex& m, std::vector<char> wanted)
{
  wanted.resize(m.vertex_end(), 1);
  std::vector<char> is_covered(m.vertex_end(), 0);
  for(Index v : m.vertices()) {
    if(m.vertex(v).carrier == Carrier::corner) continue;
    if(is_covered[v] && m.vertex(v).carrier == Carrier::surface) continue;
    wanted[v] = 1;
    if(m.vertex(v).carrier == Carrier::curve) continue;
    for(Index h : m.outgoing(v))
      for(Index u : m.quad(m.face(h))) is_covered[u] = 1;
  }
  return wanted;
}

// The last smoothing of a pattern of faces that was smooth but for the nodes that are restless, as
// one is that was halved: first a few nodes are asked, then those near the ones that moved, and in
// the end those near the ones that moved far.
inline void smooth_by_probes(Adaptation_state& s)
{
  constexpr double near = 0.04, far = 0.08; // shares of an edge
  std::vector<char> wanted = probes(s.mesh, s.restless);
  clear_floors(s);
  s.restless.swap(wanted);
  s.smoothing.wake = near;
  smooth(s, 1);
  s.smoothing.wake = far;
  smooth(s, 2);
}

// Smooths where faces have poor shapes still, again as long as there are some.
inline void smooth_poor_faces(Adaptation_state& s)
{
  constexpr double poor = 0.5;
  s.smoothing.wake = 0.005;
  for(int round = 0; round < 4; ++round) {
    s.restless.assign(s.mesh.vertex_end(), 0);
    bool is_any = false;
    for(Index f : s.mesh.faces()) {
      if(scaled_jacobian(s.corners(f)) >= poor) continue;
      for(Index v : s.mesh.quad(f)) s.disturb(v);
      is_any = true;
    }
    if(!is_any) return;
    smooth(s, 3);
  }
}

// The place of a refinement among the octaves.
struct Octave
{
  bool is_first = true, is_last = true; // no halving before, none to follow
};

// Refinement with templates and smoothing only.  An edge that no pass can split, because parity and
// constraints forbid it, does not keep the loop going.  Smoothing lengthens a few edges beyond the
// limit again, so that after it a few faces would be cut in each of some twenty passes over the
// whole mesh: where few are left they are cut without.  Before the last pass a little smoothing
// will do, since all nodes move again; in the last octave, which has nearly all faces, it is about
// the faces that were cut alone, unless these are many.
inline void refine_by_templates(Adaptation_state& s, const Marking_options& marking,
                                std::size_t max_passes, const Octave& octave = Octave())
{
  constexpr std::size_t few = 100, many = 8; // one face in so many
  constexpr std::size_t large = 5000;        // faces that do not fit in a cache
  const double fine = s.smoothing.wake;
  s.smoothing.wake = octave.is_last ? 0.04 : 0.02;
  Curve_bends(s).hold();
  const Growth_limit limit(s);
  bool is_smooth = true;
  for(std::size_t pass = 0; pass < max_passes && !limit.is_exceeded(); ++pass) {
    Phase_scope phase(s, "refinement");
    if(is_smooth) s.restless.assign(s.mesh.vertex_end(), 0);
    const std::size_t cut = refine_once(s, marking);
    if(cut == 0) break;
    ++s.iterations;
    const std::size_t faces = std::size_t(s.mesh.number_of_faces());
    is_smooth = few * cut >= faces;
    if(!is_smooth) continue;
    const bool is_local = octave.is_last && many * cut < faces;
    if(!is_local && faces > large && std::size_t(s.mesh.face_end()) == faces) renumber_by_place(s);
    std::vector<char> near_cuts = s.restless;
    set_floors(s);
    if(is_local) s.restless.swap(near_cuts);
    smooth(s, 2);
  }
  if(octave.is_first && !octave.is_last) {
    clear_floors(s);
    smooth(s, 2);
  } else {
    smooth_by_probes(s);
    if(octave.is_last) smooth_poor_faces(s);
  }
  release_bends(s);
  s.smoothing.wake = fine;
}

// The same by octaves: the passes that cut some faces only work on the sizes doubled as often as
// no face asks for less, where the mesh has few faces yet, and each octave ends with all faces cut
// in four, which needs no decision and keeps shapes; bad ones, too, so then it is not done.
inline void refine_by_octaves(Adaptation_state& s, const Marking_options& marking,
                              std::size_t max_passes)
{
  constexpr double well_shaped = 0.2;
  const std::size_t last = s.iterations + max_passes;
  int octaves = octaves_below_faces(s, int((std::min)(max_passes, std::size_t(30))));
  s.scale_sizes(std::exp2(octaves));
  std::optional<Mesh_keeper> input;
  if(octaves > 0) input.emplace(s);
  refine_by_templates(s, marking, max_passes - std::size_t(octaves), { true, octaves == 0 });
  if(octaves > 0 && least_scaled_jacobian(s) < well_shaped) {
    input->restore();
    s.scale_sizes(std::exp2(-octaves));
    refine_by_templates(s, marking, max_passes, { true, true });
    return;
  }
  for(; octaves > 0; --octaves) {
    halve_all(s, 0); // nodes between those of a smooth mesh are well placed, and move later
    refine_by_templates(s, marking, last - s.iterations - std::size_t(octaves - 1),
                        { false, octaves == 1 });
  }
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_REFINEMENT_SCHEDULE_H
