// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_OPERATION_CANDIDATES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_OPERATION_CANDIDATES_H

#include <CGAL/Quad_mesh_adaptation/internal/curve_operation_bounds.h>
#include <CGAL/Quad_mesh_adaptation/internal/huge_nodes.h>
#include <CGAL/Quad_mesh_adaptation/internal/operation_kinds.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/corner_split.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/edge_swap.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/face_close.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/face_open.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/quad_insertion.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/vertex_rotation.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Lists what could be done about a node, with an O(1) bound on the gain of each, so that most of it
// is dropped before geometry is touched.
class Operation_candidates
{
public:
  Operation_candidates(Adaptation_state& s, const Improvement_options& o)
      : s_(s), options_(o), bounds_(s, o.max_valence)
  {
  }

  // The operations about node v that may lower the energy, the most promising first.
  const std::vector<Operation_candidate>& collect(Index v)
  {
    candidates_.clear();
    s_.mesh.outgoing(v, out_);
    if(options_.close) collect_closes();
    if(options_.open) collect_opens(v);
    if(options_.swap) collect_swaps(v);
    if(options_.rotate) collect_rotation(v);
    if(options_.border && find_border_pair(s_.mesh, v, pair_)) collect_border();
    if(options_.crease && find_crease_star(s_.mesh, v, crease_)) collect_crease_collapse();
    if(options_.corner || options_.insertion) collect_insertions(v);
    std::stable_sort(candidates_.begin(), candidates_.end(),
                     [](const Operation_candidate& a, const Operation_candidate& b) {
                       return a.bound < b.bound;
                     });
    return candidates_;
  }

  // As if the candidates of node v had been collected, for one that is known.
  void look_at(Index v)
  {
    s_.mesh.outgoing(v, out_);
    find_border_pair(s_.mesh, v, pair_);
    find_crease_star(s_.mesh, v, crease_);
  }

  // Fills the cavity of a candidate of the node collected last.
  void describe(const Operation_candidate& c, Cavity& cavity)
  {
    switch(c.kind) {
    case Operation_kind::close:
      describe_face_close(s_, c.h, cavity);
      break;
    case Operation_kind::open:
      describe_face_open(s_, c.h, c.g, cavity);
      break;
    case Operation_kind::swap_left:
      describe_edge_swap(s_, c.h, true, cavity);
      break;
    case Operation_kind::swap_right:
      describe_edge_swap(s_, c.h, false, cavity);
      break;
    case Operation_kind::rotate:
      describe_vertex_rotation(s_, c.h, cavity);
      break;
    case Operation_kind::border_collapse:
      describe_half_ring_collapse(s_, pair_, cavity);
      break;
    case Operation_kind::border_split:
      describe_border_split(s_, pair_, cavity);
      break;
    case Operation_kind::crease_collapse:
      describe_crease_collapse(s_, crease_, cavity);
      break;
    case Operation_kind::corner_split:
      describe_corner_split(s_, corner_split_at(s_.mesh, c.h), cavity);
      break;
    case Operation_kind::insertion:
      describe_quad_insertion(s_, c.h, cavity);
      break;
    }
  }

  // Does the operation take a face from a node that has too many, by any standard?
  bool relieves_crowd(const Operation_candidate& c) const
  {
    const auto crowded = [&](Index v) { return bounds_.is_crowded(v); };
    if(c.kind == Operation_kind::rotate) // all spokes of the node collected last
      return std::any_of(out_.begin(), out_.end(),
                         [&](Index h) { return crowded(s_.mesh.target(h)); });
    if(c.kind != Operation_kind::swap_left && c.kind != Operation_kind::swap_right) return false;
    return crowded(s_.mesh.origin(c.h)) || crowded(s_.mesh.target(c.h));
  }

private:
  // Would v be left with too few faces if it lost one?
  bool loses_last(Index v) const
  {
    return s_.mesh.vertex(v).faces <= (s_.mesh.is_border_vertex(v) ? 1 : 3);
  }

  void add(Operation_kind k, Index h, Index g, double bound)
  {
    if(bound < options_.tolerance - s_.energy.min_gain) candidates_.push_back({ k, h, g, bound });
  }

  void collect_closes()
  {
    const Quad_complex& m = s_.mesh;
    for(Index h : out_) {
      const Index n = Quad_complex::next(h);
      const Index a = m.origin(h), b = m.target(h), c = m.target(n), e = m.origin(m.prev(h));
      const bool a_wins = carrier_rank(m.vertex(a)) >= carrier_rank(m.vertex(c));
      const Index w = a_wins ? a : c, l = a_wins ? c : a;
      double bound = -s_.energy.face + bounds_.valence_change(w, m.vertex(l).faces - 2) -
                     s_.valence_energy(m.vertex(l).faces, m.vertex(l)) +
                     bounds_.valence_change(b, -1) + bounds_.valence_change(e, -1);
      if(bound > 1e5) continue;
      bound -= bounds_.slack(a) + bounds_.slack(c) - (s_.cached_energy(m.face(h)) - s_.energy.face);
      const double allowed = options_.tolerance - s_.energy.min_gain;
      if(bound >= allowed) continue;
      bound += bounds_.oversize_without(m.face(h), a, c);
      if(bound < allowed && is_face_close_allowed(s_, h)) add(Operation_kind::close, h, -1, bound);
    }
  }

  void collect_opens(Index v)
  {
    const int n = int(out_.size());
    if(is_huge(s_.mesh, v)) return collect_halvings(v);
    for(int i = 0; i < n; ++i)
      for(int sector = 2; sector < n; ++sector) // faces that the new node takes
        if(!collect_open(v, i, sector)) break;
  }

  // A node with very many faces is best opened in two halves; a few of these are enough.
  void collect_halvings(Index v)
  {
    constexpr int few = 6;
    const int n = int(out_.size());
    const bool border = s_.mesh.is_border_vertex(v);
    for(int k = 0; k < few; ++k) collect_open(v, border ? n / 4 + k : k * n / (2 * few), n / 2);
  }

  // False if there is no such sector from the i-th half-edge on, nor a larger one.
  bool collect_open(Index v, int i, int sector)
  {
    const Quad_complex& m = s_.mesh;
    const int n = int(out_.size());
    if(m.is_border_vertex(v) ? i + sector >= n : sector > n - 2) return false; // v keeps three, too
    const Index ha = out_[i], hb = out_[(i + sector) % n];
    const int fresh = sector + 1 - 4;
    const double bound = s_.energy.face - bounds_.slack(v) + s_.energy.valence * fresh * fresh +
                         bounds_.valence_change(v, 1 - sector) +
                         bounds_.valence_change(m.target(ha), 1) +
                         bounds_.valence_change(m.target(hb), 1);
    if(bound < options_.tolerance - s_.energy.min_gain && is_face_open_allowed(s_, ha, hb))
      add(Operation_kind::open, ha, hb, bound);
    return true;
  }

  void collect_swaps(Index v)
  {
    const Quad_complex& m = s_.mesh;
    for(Index h : out_) {
      if(!is_edge_swap_allowed(s_, h) || loses_last(v) || loses_last(m.target(h))) continue;
      if(is_huge(m, v) || is_huge(m, m.target(h))) continue; // it is halved
      const Index o = m.opposite(h), u = m.target(h);
      const bool relief = bounds_.is_crowded(v) || bounds_.is_crowded(u);
      const double lost = bounds_.valence_change(v, -1) + bounds_.valence_change(u, -1);
      const double slack =
          s_.cached_energy(m.face(h)) + s_.cached_energy(m.face(o)) - 2 * s_.energy.face;
      const auto propose = [&](Operation_kind kind, Index a, Index b) {
        const double valences =
            lost + bounds_.valence_change(a, 1, relief) + bounds_.valence_change(b, 1, relief);
        if(relief || valences < options_.tolerance - options_.valence_gain)
          add(kind, h, -1, valences - slack);
      };
      propose(Operation_kind::swap_left, m.target(m.next(h)), m.target(m.next(o)));
      propose(Operation_kind::swap_right, m.origin(m.prev(h)), m.origin(m.prev(o)));
    }
  }

  void collect_rotation(Index v)
  {
    const Quad_complex& m = s_.mesh;
    if(m.is_border_vertex(v)) return;
    double bound = 0;
    for(Index h : out_)
      bound +=
          bounds_.valence_change(m.target(h), -1) + bounds_.valence_change(m.target(m.next(h)), 1);
    if(bound >= options_.tolerance - options_.valence_gain) return;
    bound -= bounds_.slack(v);
    if(bound < options_.tolerance - s_.energy.min_gain && is_vertex_rotation_allowed(s_, v))
      add(Operation_kind::rotate, v, -1, bound);
  }

  void collect_border()
  {
    if(is_border_split_allowed(s_, pair_))
      add(Operation_kind::border_split, pair_.v, -1, border_split_bound(s_, bounds_, pair_));
    if(is_half_ring_collapse_allowed(s_, pair_) &&
       faces_after_half_ring(s_.mesh, pair_) <= options_.max_valence)
      add(Operation_kind::border_collapse, pair_.v, -1, half_ring_bound(s_, bounds_, pair_));
  }

  void collect_crease_collapse()
  {
    const int before = s_.mesh.vertex(crease_.v).faces;
    if(faces_after_crease_collapse(s_.mesh, crease_) <= (std::max)(options_.max_valence, before) &&
       is_crease_collapse_allowed(s_, crease_))
      add(Operation_kind::crease_collapse, crease_.v, -1,
          crease_collapse_bound(s_, bounds_, crease_));
  }

  // A node on a curve with one flat face on a side gets a second one.  Where curves meet, that is
  // mostly settled by the number of faces that the node is to have.
  void collect_insertions(Index v)
  {
    const Quad_complex& m = s_.mesh;
    const bool border = out_.size() == 1;
    const bool on_curve = m.vertex(v).carrier == Carrier::curve ||
                          (options_.at_corners && m.vertex(v).carrier == Carrier::corner);
    if(border ? m.vertex(v).ideal_faces < 2 : !on_curve) return;
    for(Index h : out_)
      if(border || (m.curve(h) >= 0 && m.curve(m.prev(h)) >= 0)) {
        if(options_.corner) collect_corner_split(h);
        if(options_.insertion) collect_insertion(v, m.face(h));
      }
  }

  void collect_corner_split(Index h)
  {
    const Quad_complex& m = s_.mesh;
    const Corner_split c = corner_split_at(m, h);
    if(!is_corner_split_allowed(s_, c)) return;
    const Index x = m.origin(c.left), q = m.origin(m.prev(c.left)), r = m.target(m.next(c.right));
    add(Operation_kind::corner_split, h, -1,
        3 * s_.energy.face + 2 * s_.energy.valence + bounds_.valence_change(m.origin(h), 1) +
            bounds_.valence_change(x, -1) + bounds_.valence_change(q, 1) +
            bounds_.valence_change(r, 1) - bounds_.slack(x));
  }

  void collect_insertion(Index v, Index f)
  {
    double bound = 4 * (s_.energy.face + s_.energy.valence) - bounds_.slack(v);
    for(Index u : s_.mesh.quad(f)) bound += bounds_.valence_change(u, 1);
    if(is_quad_insertion_allowed(s_, f)) add(Operation_kind::insertion, f, -1, bound);
  }

  Adaptation_state& s_;
  const Improvement_options& options_;
  Energy_bounds bounds_;
  Border_pair pair_;
  Crease_star crease_;
  std::vector<Operation_candidate> candidates_;
  std::vector<Index> out_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_OPERATION_CANDIDATES_H
