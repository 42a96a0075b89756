// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHORD_THINNING_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHORD_THINNING_H

#include <CGAL/Quad_mesh_adaptation/internal/Chord_set.h>
#include <CGAL/Quad_mesh_adaptation/internal/Merged_nodes.h>
#include <CGAL/Quad_mesh_adaptation/internal/Walk.h>
#include <CGAL/Quad_mesh_adaptation/internal/changed_face_quality.h>
#include <CGAL/Quad_mesh_adaptation/internal/smoothing.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Removes many rows of faces at the same time, those that a set chooses: whole chords, see
// Chord_set, or wedges, see Wedge_set.  Those about which the outcome would be faulty are left out
// again.
template <typename Row_set>
class Row_thinning
{
public:
  // No face may become longer than `limit` sizes, nor, away from curves, worse than `least`.
  Row_thinning(Adaptation_state& s, double limit, double least)
      : s_(s), limit_(limit), least_(least), rows_(s), nodes_(s)
  {
  }

  // Returns the number of faces removed.
  std::size_t operator()()
  {
    constexpr int most_rounds = 12;
    rows_.choose_narrow(0.55 * limit_);
    s_.check_cancelled();
    for(int round = 0; round < most_rounds; ++round) {
      if(rows_.number_of_chosen() == 0) return 0;
      nodes_.merge(rows_);
      if(leave_out_faulty()) continue;
      const std::size_t before = std::size_t(s_.mesh.number_of_faces());
      apply();
      return before - std::size_t(s_.mesh.number_of_faces());
    }
    return 0;
  }

private:
  // --- checks

  // Leaves out the rows about what would be faulty; tells whether there were any.
  bool leave_out_faulty()
  {
    const Quad_complex& m = s_.mesh;
    faces_.assign(m.vertex_end(), 0);
    for(Index f : m.faces())
      if(!rows_.removes(f))
        for(Index v : m.quad(f)) ++faces_[nodes_.image(v)];
    std::vector<Index> faulty;
    for(Index f : m.faces()) {
      if(rows_.removes(f) || !is_touched(f)) continue;
      if(!is_well_shaped(f) || !has_good_nodes(f)) faulty.push_back(f);
    }
    if(faulty.empty()) find_mismatches(faulty);
    for(Index f : faulty)
      for(Index v : m.quad(f)) rows_.leave_out_about(v);
    return !faulty.empty();
  }

  bool is_touched(Index f) const
  {
    const Quad q = s_.mesh.quad(f);
    return std::any_of(q.begin(), q.end(),
                       [&](Index v) { return nodes_.is_merged(nodes_.image(v)); });
  }

  bool is_well_shaped(Index f) const
  {
    // smoothing mends what is less good where nodes are free, but hardly beside curves
    constexpr double least_beside_curves = 0.35;
    for(Index h = 4 * f; h < 4 * f + 4; ++h)
      if(!is_curve_kept(h)) return false;
    const auto node = [this](Index v) -> const Vertex_record& { return nodes_.node(v); };
    const Quad q = s_.mesh.quad(f);
    if(rows_.is_too_long(f, nodes_, limit_)) return false;
    const auto [p, reference] = changed_face(q, node);
    return has_quality(p, reference,
                       is_changed_face_held(q, node) ? least_beside_curves : least_) ||
           Adaptation_state::face_quality(p, reference) >=
               Adaptation_state::face_quality(s_.corners(f), s_.reference_normal(f));
  }

  // An edge of a closed curve stands for the shorter way round.
  bool is_curve_kept(Index h) const
  {
    const Index c = s_.mesh.curve(h);
    if(c < 0 || !s_.curves[c].is_closed()) return true;
    const Vertex_record &a = nodes_.node(s_.mesh.origin(h)), &b = nodes_.node(s_.mesh.target(h));
    if(a.carrier != Carrier::curve || b.carrier != Carrier::curve) return true;
    const Feature_curve& curve = s_.curves[c];
    return std::abs(curve.difference(a.param, b.param)) < 0.15 * curve.length();
  }

  bool has_good_nodes(Index f) const
  {
    constexpr int most = 6;
    for(Index v : s_.mesh.quad(f)) {
      const Index w = nodes_.image(v);
      if(!nodes_.is_merged(w) || s_.mesh.vertex(w).carrier != Carrier::surface) continue;
      if(faces_[w] < 3 || faces_[w] > (std::max)(most, int(s_.mesh.vertex(w).faces))) return false;
    }
    return true;
  }

  // The half-edge on the other side of the edge of h when chosen rows are gone.
  Index opposite_after(Index h) const
  {
    Index o = s_.mesh.opposite(h);
    while(o >= 0 && rows_.removes(Quad_complex::face(o))) o = s_.mesh.opposite(rows_.across(o));
    return o;
  }

  // Faces at nodes that would have two umbrellas, or two edges to the same node.
  void find_mismatches(std::vector<Index>& faulty) const
  {
    const Quad_complex& m = s_.mesh;
    std::vector<char> is_seen(m.vertex_end(), 0);
    for(Index h : m.halfedges()) {
      if(rows_.removes(m.face(h))) continue;
      const Index v = nodes_.image(m.origin(h));
      if(is_seen[v] || !nodes_.is_merged(v)) continue;
      is_seen[v] = 1;
      if(!has_one_umbrella(h, faces_[v])) faulty.push_back(m.face(h));
    }
  }

  bool has_one_umbrella(Index h, int faces) const
  {
    const auto turn_left = [&](Index g) { return opposite_after(Quad_complex::prev(g)); };
    Index start = h;
    for(int i = 0; i <= faces; ++i) { // clockwise to the border
      const Index o = opposite_after(start);
      if(o < 0 || Quad_complex::next(o) == h) break;
      start = Quad_complex::next(o);
    }
    std::vector<Index> around;
    Index g = start;
    int n = 0;
    do {
      around.push_back(nodes_.image(s_.mesh.target(g)));
      const Index last = nodes_.image(s_.mesh.origin(Quad_complex::prev(g)));
      g = turn_left(g);
      ++n;
      if(g < 0) around.push_back(last);
    } while(g >= 0 && g != start && n <= faces);
    std::sort(around.begin(), around.end());
    return n == faces && std::adjacent_find(around.begin(), around.end()) == around.end();
  }

  // --- outcome

  void apply()
  {
    Quad_complex& m = s_.mesh;
    std::vector<std::pair<Index, Index>> pairs;
    std::vector<Index> gone;
    for(Index f : m.faces()) {
      if(rows_.removes(f)) {
        gone.push_back(f);
        continue;
      }
      for(Index h = 4 * f; h < 4 * f + 4; ++h)
        if(m.opposite(h) >= 0 && rows_.removes(m.face(m.opposite(h))))
          pairs.push_back({ h, opposite_after(h) });
    }
    for(const auto& p : pairs) hand_curve_on(p.first);
    for(const auto& p : pairs) {
      m.set_opposites(p.first, p.second);
      m.set_curve(p.first, m.curve(p.first));
    }
    for(Index h : m.halfedges()) m.set_origin(h, nodes_.image(m.origin(h)));
    for(Index f : gone) m.remove_face(f);
    for(Index v = 0; v < m.vertex_end(); ++v)
      if(nodes_.is_merged(v)) {
        m.vertex(v) = nodes_.node(v);
        s_.disturb(v);
      }
    m.refresh_vertices();
    s_.count(Row_set::operation, rows_.number_of_chosen());
    s_.forget_faces();
  }

  // Faces that go hand the curve of one side on to the other side.
  void hand_curve_on(Index h)
  {
    Quad_complex& m = s_.mesh;
    Index o = m.opposite(h);
    while(o >= 0 && m.curve(h) < 0 && rows_.removes(Quad_complex::face(o))) {
      const Index across = rows_.across(o);
      if(m.curve(across) >= 0) m.set_curve(h, m.curve(across));
      o = m.opposite(across);
    }
  }

  Adaptation_state& s_;
  double limit_, least_;
  Row_set rows_;
  Merged_nodes nodes_;
  std::vector<int> faces_; // of each node afterwards
};

// Thins out a mesh with far too many faces by removing many whole chords, about every other one of
// neighbours, which makes no irregular node and leaves an even mesh even.
using Chord_thinning = Row_thinning<Chord_set>;

// One sweep over the restless nodes, without witnesses; none is restless then.
inline void smooth_plainly(Adaptation_state& s)
{
  const double fine = s.smoothing.wake;
  s.smoothing.wake = 0.05;
  Smoothing_sweep sweep(s);
  const std::vector<char> now = s.restless;
  sweep(now);
  s.restless.assign(now.size(), 0);
  s.smoothing.wake = fine;
}

// Removes chords as long as that takes many faces, until the mesh has no more than `enough`, and no
// face about them is longer than `limit` sizes or, away from curves, worse than `least`.
inline void thin_by_chords(Adaptation_state& s, double limit, double least, Index enough)
{
  constexpr double few = 0.15, many = 0.3; // of the faces that are left
  s.restless.assign(s.mesh.vertex_end(), 0);
  for(bool again = true; again && s.mesh.number_of_faces() > enough;) {
    const double removed = double(Chord_thinning(s, limit, least)());
    if(removed > many * double(s.mesh.number_of_faces())) smooth_plainly(s);
    again = removed > few * double(s.mesh.number_of_faces());
  }
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHORD_THINNING_H
