// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHORD_COARSENING_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHORD_COARSENING_H

#include <CGAL/Quad_mesh_adaptation/internal/operators/chord_collapse.h>
#include <CGAL/Quad_mesh_adaptation/internal/smoothing.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Coarsening by whole chords, which makes no irregular node: where the faces of a chord are too
// small on average its collapse is proposed to the energy, the smallest first.
class Chord_coarsening
{
public:
  Chord_coarsening(Adaptation_state& s, double min_jacobian)
      : s_(s), cavity_(s), min_jacobian_(min_jacobian)
  {
  }

  // One batch of chords that share no node; returns the number of faces removed.
  std::size_t batch()
  {
    used_.assign(s_.mesh.vertex_end(), 0);
    std::size_t removed = 0;
    for(const auto& candidate : candidates()) {
      const Index h = candidate.second;
      if(!s_.mesh.is_face(s_.mesh.face(h)) || used_[s_.mesh.origin(h)]) continue;
      removed += try_chord(chord_through(s_.mesh, h));
    }
    return removed;
  }

private:
  // Mean size ratio of a chord, and one of its half-edges.
  std::vector<std::pair<double, Index>> candidates()
  {
    const Quad_complex& m = s_.mesh;
    std::vector<float> ratio(m.face_end(), 0);
    for(Index f = 0; f < m.face_end(); ++f)
      if(m.is_face(f)) ratio[f] = float(s_.size_ratio(f));
    std::vector<char> seen(4 * std::size_t(m.face_end()), 0);
    std::vector<std::pair<double, Index>> list;
    for(Index h = 0; h < 4 * m.face_end(); ++h) {
      if(!m.is_face(m.face(h)) || seen[h]) continue;
      const Chord c = chord_through(m, h);
      double sum = 0;
      for(Index g : c.rungs) {
        seen[g] = 1;
        if(m.opposite(g) >= 0) seen[m.opposite(g)] = 1;
      }
      for(Index f : c.faces) sum += ratio[f];
      const double mean = sum / double(c.faces.size());
      if(mean < 0.75) list.push_back({ mean, c.rungs.front() });
    }
    std::stable_sort(list.begin(), list.end());
    return list;
  }

  std::size_t try_chord(const Chord& c)
  {
    s_.check_cancelled();
    for(Index h : c.rungs)
      if(used_[s_.mesh.origin(h)] || used_[s_.mesh.target(h)]) return 0;
    if(!is_chord_collapse_allowed(s_, c)) return 0;
    describe_chord_collapse(s_, c, cavity_);
    if(!cavity_.close()) return 0;
    cavity_.relax(2);
    if(cavity_.energy_after() > cavity_.energy_before() - s_.energy.min_gain) return 0;
    if(cavity_.worst_after() < (std::min)(min_jacobian_, cavity_.worst_before())) return 0;
    std::vector<Index> touched;
    cavity_.commit(&touched);
    s_.count("chord collapse");
    for(Index v : touched) used_[v] = 1;
    return c.faces.size();
  }

  Adaptation_state& s_;
  Cavity cavity_;
  double min_jacobian_;
  std::vector<char> used_;
};

inline std::size_t coarsen_by_chords(Adaptation_state& s, double min_jacobian)
{
  Chord_coarsening chords(s, min_jacobian);
  std::size_t total = 0;
  for(int batch = 0; batch < 40; ++batch) {
    const std::size_t removed = chords.batch();
    total += removed;
    if(removed == 0) break;
    smooth(s, 2);
  }
  return total;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHORD_COARSENING_H
