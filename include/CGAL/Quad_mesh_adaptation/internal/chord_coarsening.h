// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHORD_COARSENING_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHORD_COARSENING_H

#include <CGAL/Quad_mesh_adaptation/internal/operators/chord_collapse.h>
#include <CGAL/Quad_mesh_adaptation/internal/Walk.h>
#include <CGAL/Quad_mesh_adaptation/internal/large_mesh.h>
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
  Chord_coarsening(Adaptation_state& s, double min_jacobian, bool quick)
      : s_(s), cavity_(s), min_jacobian_(min_jacobian), quick_(quick)
  {
  }

  // One batch of chords that share no node; returns the number of faces removed.
  std::size_t batch()
  {
    s_.prepare_coverage();
    used_.assign(s_.mesh.vertex_end(), 0);
    balance_ = 4;
    std::size_t removed = 0;
    for(const auto& candidate : candidates()) {
      const Index h = candidate.second;
      if(!s_.mesh.is_face(s_.mesh.face(h)) || used_[s_.mesh.origin(h)]) continue;
      removed += try_chord(chord_through(s_.mesh, h), candidate.first);
    }
    return removed;
  }

private:
  // Chords of faces too small on average, by their mean width over the wanted size, so that a mesh
  // is thinned in the direction in which it is finer; and one half-edge of each.
  std::vector<std::pair<float, Index>> candidates()
  {
    const Quad_complex& m = s_.mesh;
    std::vector<float> ratio(m.face_end(), 0);
    for(Index f : m.faces()) ratio[f] = float(s_.size_ratio(f));
    std::vector<std::pair<float, Index>> list; // rounded: equals are told by the order
    for_each_chord(m, [&](const Chord& c, Index h) {
      double width = 0, size = 0;
      bool may_go = true;
      for(Index g : c.rungs) {
        may_go = may_go && s_.is_to_work_on(m.origin(g)) && s_.is_to_work_on(m.target(g));
        const Vertex_record &u = m.vertex(m.origin(g)), &v = m.vertex(m.target(g));
        width += 2 * distance(u.p, v.p) / (u.h + v.h);
      }
      for(Index f : c.faces) size += ratio[f];
      width /= double(c.rungs.size());
      if(may_go && size < 0.95 * double(c.faces.size()) && width < 1)
        list.push_back({ float(width), h });
    });
    put_in_order(list, s_.order);
    std::stable_sort(list.begin(), list.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    return list;
  }

  std::size_t try_chord(const Chord& c, double width)
  {
    s_.check_cancelled();
    for(Index h : c.rungs)
      if(used_[s_.mesh.origin(h)] || used_[s_.mesh.target(h)]) return 0;
    if(!is_chord_collapse_allowed(s_, c)) return 0;
    describe_chord_collapse(s_, c, cavity_);
    if(!is_worth_it(c, width)) return 0;
    std::vector<Index> touched;
    cavity_.commit(&touched);
    s_.count("chord collapse");
    for(Index v : touched) used_[v] = 1;
    return c.faces.size();
  }

  // The width that is left over spreads over the rows on both sides: over none where the chord is
  // very narrow, and over more and more where it is nearly wide enough and few rows do not do.
  bool is_worth_it(const Chord& c, double width)
  {
    if(quick_ && width < 0.6 && relaxed_change(0, 0) < -s_.energy.min_gain && is_well_shaped())
      return true; // faces far too small: their nodes may stay for now
    if(quick_ && balance_ < 0) return false;
    const bool worth = is_worth_care(c, width);
    balance_ += worth ? 1 : -1;
    return worth;
  }

  bool is_worth_care(const Chord& c, double width)
  {
    if(width < 0.5) return relaxed_change(0, 2) < -s_.energy.min_gain && is_well_shaped();
    for(const int rings : { 2, 2, 4 }) {
      const double change = relaxed_change(rings, 4 * rings, 20 * c.faces.size() + 200);
      if(change < -s_.energy.min_gain) return is_well_shaped();
      if(change > 1.2 * double(c.faces.size())) return false;
    }
    return false;
  }

  // No more than `most` faces take part: about a node of huge valence it would be all, each time.
  double relaxed_change(int rings, int sweeps, std::size_t most = std::size_t(-1))
  {
    constexpr double refused = 1e300;
    for(int ring = 0; ring < rings && cavity_.quads.size() <= most; ++ring) cavity_.add_halo();
    if(cavity_.quads.size() > most || !cavity_.close()) return refused;
    cavity_.relax(sweeps);
    return cavity_.energy_after() - cavity_.energy_before();
  }

  bool is_well_shaped() const { return cavity_.keeps_shape(min_jacobian_); }

  Adaptation_state& s_;
  Cavity cavity_;
  double min_jacobian_;
  bool quick_; // with less care
  // Of trials with care that paid and that did not, in this batch of a large mesh.  They are dear:
  // where most fail, as with sizes that change along the chords, local operations are cheaper.
  int balance_ = 0;
  std::vector<char> used_;
};

// Batches of chords with smoothing after each, which spreads the width they leave: a little in
// large meshes, for speed, until no chord is worth while any more; more of it may show another one
// then. Ends with a batch that removes less than `least_share` of the faces.
inline std::size_t remove_chords(Adaptation_state& s, double min_jacobian, double least_share,
                                 int max_batches)
{
  const bool quick = is_large(s);
  const double fine = s.smoothing.wake;
  Chord_coarsening chords(s, min_jacobian, quick);
  std::size_t total = 0, since_smooth = 0;
  for(int batch = 0; batch < max_batches; ++batch) {
    const std::size_t removed = chords.batch();
    total += removed;
    since_smooth += removed;
    if(removed == 0 && (!quick || since_smooth == 0)) break;
    if(quick && removed > 0) s.smoothing.wake = 0.05;
    smooth(s, quick && removed > 0 ? 2 : 12);
    s.smoothing.wake = fine;
    if(double(removed) < least_share * double(s.mesh.number_of_faces())) break;
    if(removed == 0) since_smooth = 0;
  }
  return total;
}

inline std::size_t coarsen_by_chords(Adaptation_state& s, double min_jacobian,
                                     double least_share = 0)
{
  // whole rows at the limit would leave no room for those a little above it
  const double tolerated = s.energy.tolerated;
  s.energy.tolerated *= 0.97;
  s.forget_energies();
  const std::size_t removed = remove_chords(s, min_jacobian, least_share, 60);
  s.energy.tolerated = tolerated;
  s.forget_energies();
  return removed;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHORD_COARSENING_H
