// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LOCAL_IMPROVEMENT_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LOCAL_IMPROVEMENT_H

#include <CGAL/Quad_mesh_adaptation/internal/operators/border_half_ring.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/edge_swap.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/face_close.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/face_open.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/vertex_rotation.h>
#include <CGAL/Quad_mesh_adaptation/internal/smoothing.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

struct Improvement_options
{
  bool close = true, open = true, swap = true, rotate = true, border = true;
  int max_valence = 5;           // of inner nodes, unless it was higher before
  bool keep_within_size = false; // no operation may leave a face above its size
  double min_jacobian = 0.5;     // no face may fall below min(this, worst before)
  int sweeps = 2;                // of the local relaxation
  double halo_below = 2; // try again with more nodes free to move where this close to a gain
};

// One pass after the other over the nodes: of all local operations about a node, the one that
// lowers the energy most is committed.  Every commit lowers the energy by at least
// energy.min_gain, so passes end.
class Local_improvement
{
public:
  Local_improvement(Adaptation_state& s, const Improvement_options& o)
      : s_(s), options_(o), first_(s), second_(s)
  {
  }

  // All nodes, or those marked, are worth a visit.
  void activate_all() { active_.assign(s_.mesh.vertex_end(), 1); }
  void activate(Index v)
  {
    if(v >= Index(active_.size())) active_.resize(v + 1, 0);
    active_[v] = 1;
  }

  // One pass over the active nodes; returns the number of operations committed.
  std::size_t pass()
  {
    std::size_t done = 0;
    std::vector<char> now;
    now.swap(active_);
    now.resize(s_.mesh.vertex_end(), 0);
    active_.assign(now.size(), 0);
    for(Index v = 0; v < s_.mesh.vertex_end(); ++v) {
      if(v >= Index(now.size()) || !now[v] || !s_.mesh.is_vertex(v)) continue;
      if((v & 1023) == 0) s_.check_cancelled();
      if(improve_at(v)) ++done;
    }
    return done;
  }

  // The best operation about node v, if any lowers the energy.
  bool improve_at(Index v)
  {
    collect_candidates(v);
    double best_change = -s_.energy.min_gain;
    const char* best_name = nullptr;
    for(const Candidate& c : candidates_) {
      if(c.bound >= best_change) continue;
      describe(c, *trial_);
      double change = try_cavity(*trial_, best_change);
      if(change >= best_change && change < best_change + options_.halo_below) {
        describe(c, *trial_);
        trial_->add_halo();
        change = try_cavity(*trial_, best_change);
      }
      if(change >= best_change) continue;
      best_change = change;
      best_name = name(c.kind);
      std::swap(trial_, best_);
    }
    if(!best_name) return false;
    touched_.clear();
    best_->commit(&touched_);
    s_.count(best_name);
    for(Index u : touched_) activate(u);
    return true;
  }

private:
  enum class Kind
  {
    close,
    open,
    swap_left,
    swap_right,
    rotate,
    border_collapse,
    border_split
  };
  struct Candidate
  {
    Kind kind;
    Index h, g;
    double bound; // no outcome can be lower
  };

  static const char* name(Kind k)
  {
    return k == Kind::close             ? "face close"
           : k == Kind::open            ? "face open"
           : k == Kind::rotate          ? "vertex rotation"
           : k == Kind::border_collapse ? "half-ring collapse"
           : k == Kind::border_split    ? "border split"
                                        : "edge swap";
  }

  void describe(const Candidate& c, Cavity& cavity)
  {
    switch(c.kind) {
    case Kind::close:
      describe_face_close(s_, c.h, cavity);
      break;
    case Kind::open:
      describe_face_open(s_, c.h, c.g, cavity);
      break;
    case Kind::swap_left:
      describe_edge_swap(s_, c.h, true, cavity);
      break;
    case Kind::swap_right:
      describe_edge_swap(s_, c.h, false, cavity);
      break;
    case Kind::rotate:
      describe_vertex_rotation(s_, c.h, cavity);
      break;
    case Kind::border_collapse:
      describe_half_ring_collapse(s_, pair_, cavity);
      break;
    case Kind::border_split:
      describe_border_split(s_, pair_, cavity);
      break;
    }
  }

  // Change of energy, or +infinity where it is not legal.
  double try_cavity(Cavity& c, double to_beat)
  {
    constexpr double refused = 1e300;
    if(!c.close()) return refused;
    c.relax(options_.sweeps);
    const double change = c.energy_after() - c.energy_before();
    if(!(change < to_beat)) return change;
    if(c.worst_after() < (std::min)(options_.min_jacobian, c.worst_before())) return refused;
    if(options_.keep_within_size &&
       c.largest_after() > (std::max)(s_.energy.tolerated, c.largest_before()))
      return refused;
    return change;
  }

  // Change of the valence term if v gets d more faces.
  double valence_change(Index v, int d) const
  {
    const Vertex_record& r = s_.mesh.vertex(v);
    if(d == -1 && r.faces == 3 && r.carrier == Carrier::surface) // goes as a doublet
      return -s_.valence_energy(3, r) - s_.energy.face - 2 * s_.energy.valence;
    if(d > 0 && !s_.mesh.is_border_vertex(v) && r.faces + d > options_.max_valence) return 1e6;
    return s_.valence_energy(r.faces + d, r) - s_.valence_energy(r.faces, r);
  }

  // What the shapes and sizes of the star of v cost above the bare faces.
  double slack(Index v)
  {
    double sum = 0;
    const Index start = s_.mesh.vertex(v).halfedge;
    Index h = start;
    do {
      sum += s_.cached_energy(s_.mesh.face(h)) - s_.energy.face;
      h = s_.mesh.turn_left(h);
    } while(h >= 0 && h != start);
    return sum;
  }

  void add(Kind k, Index h, Index g, double bound)
  {
    if(bound < -s_.energy.min_gain) candidates_.push_back({ k, h, g, bound });
  }

  void collect_candidates(Index v)
  {
    candidates_.clear();
    s_.mesh.outgoing(v, out_);
    if(options_.close) collect_closes();
    if(options_.open) collect_opens(v);
    if(options_.swap) collect_swaps(v);
    if(options_.rotate) collect_rotation(v);
    if(options_.border && find_border_pair(s_.mesh, v, pair_)) collect_border();
    std::stable_sort(candidates_.begin(), candidates_.end(),
                     [](const Candidate& a, const Candidate& b) { return a.bound < b.bound; });
  }

  void collect_closes()
  {
    const Quad_complex& m = s_.mesh;
    for(Index h : out_) {
      const Index n = Quad_complex::next(h);
      const Index a = m.origin(h), b = m.target(h), c = m.target(n), e = m.origin(m.prev(h));
      const bool a_wins = carrier_rank(m.vertex(a)) >= carrier_rank(m.vertex(c));
      const Index w = a_wins ? a : c, l = a_wins ? c : a;
      double bound = -s_.energy.face + valence_change(w, m.vertex(l).faces - 2) -
                     s_.valence_energy(m.vertex(l).faces, m.vertex(l)) + valence_change(b, -1) +
                     valence_change(e, -1);
      if(bound > 1e5) continue;
      bound -= slack(a) + slack(c) - (s_.cached_energy(m.face(h)) - s_.energy.face);
      if(bound < -s_.energy.min_gain && is_face_close_allowed(s_, h))
        add(Kind::close, h, -1, bound);
    }
  }

  void collect_opens(Index v)
  {
    const Quad_complex& m = s_.mesh;
    const int n = int(out_.size());
    if(n < 3) return;
    const bool border = m.is_border_vertex(v);
    const double base = s_.energy.face - slack(v);
    for(int i = 0; i < n; ++i)
      for(int sector = 2; sector < n; ++sector) {            // faces that the new node takes
        if(border ? i + sector >= n : sector > n - 2) break; // v keeps three faces, too
        const Index ha = out_[i], hb = out_[(i + sector) % n];
        const int fresh = sector + 1 - 4;
        const double bound = base + s_.energy.valence * fresh * fresh +
                             valence_change(v, 1 - sector) + valence_change(m.target(ha), 1) +
                             valence_change(m.target(hb), 1);
        if(bound < -s_.energy.min_gain && is_face_open_allowed(s_, ha, hb))
          add(Kind::open, ha, hb, bound);
      }
  }

  void collect_swaps(Index v)
  {
    const Quad_complex& m = s_.mesh;
    for(Index h : out_) {
      if(!is_edge_swap_allowed(s_, h)) continue;
      const Index o = m.opposite(h), u = m.target(h);
      const double base =
          valence_change(v, -1) + valence_change(u, -1) -
          (s_.cached_energy(m.face(h)) + s_.cached_energy(m.face(o)) - 2 * s_.energy.face);
      const Index x1 = m.target(m.next(h)), y1 = m.origin(m.prev(h));
      const Index x2 = m.target(m.next(o)), y2 = m.origin(m.prev(o));
      add(Kind::swap_left, h, -1, base + valence_change(x1, 1) + valence_change(x2, 1));
      add(Kind::swap_right, h, -1, base + valence_change(y1, 1) + valence_change(y2, 1));
    }
  }

  void collect_rotation(Index v)
  {
    const Quad_complex& m = s_.mesh;
    if(m.is_border_vertex(v)) return;
    double bound = -slack(v);
    for(Index h : out_)
      bound += valence_change(m.target(h), -1) + valence_change(m.target(m.next(h)), 1);
    if(bound < -s_.energy.min_gain && is_vertex_rotation_allowed(s_, v))
      add(Kind::rotate, v, -1, bound);
  }

  void collect_border()
  {
    const Quad_complex& m = s_.mesh;
    const Border_pair& b = pair_;
    const double ends = s_.cached_energy(m.face(b.left)) + s_.cached_energy(m.face(b.right));
    const double split = 6 * s_.energy.face + 2 * s_.energy.valence + valence_change(b.p, 1) +
                         valence_change(b.q, 1) - ends;
    if(split < -s_.energy.min_gain && is_border_split_allowed(s_, b))
      add(Kind::border_split, b.v, -1, split);
    if(!is_half_ring_collapse_allowed(s_, b)) return;
    const auto own = [&](Index u) { return s_.valence_energy(m.vertex(u).faces, m.vertex(u)); };
    const bool corner = carrier_rank(m.vertex(b.a)) > 1 || carrier_rank(m.vertex(b.c)) > 1;
    const Index keep = carrier_rank(m.vertex(b.a)) > 1   ? b.a
                       : carrier_rank(m.vertex(b.c)) > 1 ? b.c
                                                         : b.v;
    const int faces = m.vertex(b.a).faces + m.vertex(b.c).faces + m.vertex(b.m).faces - 4;
    double collapse = -2 * s_.energy.face + s_.valence_energy(faces, m.vertex(keep)) - own(b.a) -
                      own(b.c) - own(b.m) - (corner ? 0. : own(b.v)) + valence_change(b.p, -1) +
                      valence_change(b.q, -1);
    collapse -= slack(b.a) + slack(b.c) + slack(b.m) - (ends - 2 * s_.energy.face);
    if(faces <= options_.max_valence) add(Kind::border_collapse, b.v, -1, collapse);
  }

  Adaptation_state& s_;
  Improvement_options options_;
  Border_pair pair_;
  Cavity first_, second_;
  Cavity *trial_ = &first_, *best_ = &second_;
  std::vector<char> active_;
  std::vector<Candidate> candidates_;
  std::vector<Index> out_, touched_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LOCAL_IMPROVEMENT_H
