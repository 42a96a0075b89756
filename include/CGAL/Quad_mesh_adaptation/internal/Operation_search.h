// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_OPERATION_SEARCH_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_OPERATION_SEARCH_H

#include <CGAL/Quad_mesh_adaptation/internal/trial_limits.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// An operation that pays, and whether the nodes around it may move, too.
struct Operation_proposal
{
  enum class Halo
  {
    none,
    at_once,
    after_a_trial
  };
  Index node = -1; // -1: none
  Operation_candidate candidate = {};
  Halo halo = Halo::none;
  std::vector<Vertex_record> nodes; // of the cavity, where they are to go; if found for later
};

// Looks for the local operation about a node that lowers the energy most, or the first that lowers
// it.  With a tolerance it may rise by less than that.  Changes nothing but its own memory and
// values of faces, so that several of them can search one mesh at the same time.
class Operation_search
{
public:
  Operation_search(Adaptation_state& s, const Improvement_options& o)
      : s_(s), options_(o), first_(s), second_(s), candidates_(s, options_)
  {
  }
  Operation_search(const Operation_search&) = delete; // candidates_ knows where options_ are
  Operation_search& operator=(const Operation_search&) = delete;

  Operation_proposal operator()(Index v)
  {
    constexpr double far = 50;
    using Halo = Operation_proposal::Halo;
    Operation_proposal found;
    double best_change = options_.tolerance - s_.energy.min_gain;
    for(const Operation_candidate& c : candidates_.collect(v)) {
      if(c.bound >= best_change) continue;
      candidates_.describe(c, *trial_);
      const bool wide = candidates_.relieves_crowd(c); // worth a look although it starts badly
      if(wide) trial_->add_halo();
      const Trial_limits limits = trial_limits(c.kind, s_.energy);
      Halo halo = wide ? Halo::at_once : Halo::none;
      double change = wide ? try_cavity(best_change, far, far)
                           : try_cavity(best_change, limits.after_a_sweep, limits.for_a_halo);
      if(!wide && change >= best_change && change < best_change + limits.for_a_halo) {
        trial_->add_halo(); // the nodes around may move, too
        halo = Halo::after_a_trial;
        change = try_cavity(best_change, limits.after_a_sweep_with_halo, 0);
      }
      if(change >= best_change) continue;
      best_change = change;
      found = { v, c, halo, {} };
      std::swap(trial_, best_);
      if(options_.first_gain) break;
    }
    return found;
  }

  // The same, to be committed by another search.
  Operation_proposal for_later(Index v)
  {
    Operation_proposal found = (*this)(v);
    if(found.node >= 0) found.nodes = best_->nodes;
    return found;
  }

  // Commits what was found by the last search.
  void commit(std::vector<Index>& touched) { best_->commit(&touched); }

  // Commits what another search has found for later in the same place.
  void commit(const Operation_proposal& p, std::vector<Index>& touched)
  {
    using Halo = Operation_proposal::Halo;
    candidates_.look_at(p.node);
    candidates_.describe(p.candidate, *best_);
    if(p.halo == Halo::at_once) best_->add_halo();
    best_->close();
    if(p.halo == Halo::after_a_trial) { // as in the search, closed before and after
      best_->add_halo();
      best_->close();
    }
    best_->nodes = p.nodes;
    best_->commit(&touched);
  }

private:
  // Change of energy, or more than any bound where it is not legal, or where an estimate is above
  // `to_beat` by more than `early` after a sweep or by more than `reach` in the end.
  double try_cavity(double to_beat, double early, double reach)
  {
    constexpr double refused = 1e300, error = 0.5; // of the estimate
    Cavity& c = *trial_;
    if(!c.close()) return refused;
    const double hopeless = c.energy_before() + to_beat;
    for(int sweep = 0; sweep < options_.sweeps; ++sweep) {
      c.relax(1);
      const bool last = sweep + 1 == options_.sweeps;
      if(c.estimate_after() > hopeless + (last ? reach + error : early)) return refused;
    }
    const double change = c.energy_after() - c.energy_before();
    if(!(change < to_beat)) return change;
    if(!c.keeps_shape(options_.min_jacobian)) return refused;
    if(options_.keep_within_size &&
       c.largest_after() > (std::max)(s_.energy.tolerated, c.largest_before()) && !is_rescue(c))
      return refused;
    return change;
  }

  // An inverted face is worse than one that is too large.
  static bool is_rescue(const Cavity& c) { return c.worst_before() <= 0 && c.worst_after() > 0.2; }

  Adaptation_state& s_;
  Improvement_options options_;
  Cavity first_, second_;
  Cavity *trial_ = &first_, *best_ = &second_;
  Operation_candidates candidates_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_OPERATION_SEARCH_H
