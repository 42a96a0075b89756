// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LOCAL_IMPROVEMENT_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LOCAL_IMPROVEMENT_H

#include <CGAL/Quad_mesh_adaptation/internal/operation_candidates.h>
#include <CGAL/Quad_mesh_adaptation/internal/smoothing.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// One pass after the other over the stirred nodes: of all local operations about a node, the one
// that lowers the energy most is committed, or the first that lowers it.  Without a tolerance every
// commit lowers the energy by at least energy.min_gain; with one it may rise by less than that.
// Either way the number of passes is bounded, and with it the work.
class Local_improvement
{
public:
  Local_improvement(Adaptation_state& s, const Improvement_options& o)
      : s_(s), options_(o), first_(s), second_(s), candidates_(s, options_)
  {
  }

  // One pass over the stirred nodes; returns the number of operations committed.
  std::size_t pass()
  {
    s_.prepare_coverage();
    std::size_t done = 0;
    std::vector<char> now;
    now.swap(s_.stirred);
    now.resize(s_.mesh.vertex_end(), 1);
    s_.stirred.assign(now.size(), 0);
    for(Index v = 0; v < s_.mesh.vertex_end(); ++v) {
      if((v & 1023) == 0) s_.check_cancelled();
      if(v >= Index(now.size()) || !now[v] || !s_.mesh.is_vertex(v)) continue;
      if(improve_at(v)) ++done;
    }
    return done;
  }

  // At most `max` passes, until one finds nothing to do.
  std::size_t passes(int max)
  {
    std::size_t total = 0;
    for(int i = 0; i < max; ++i) {
      const std::size_t done = pass();
      total += done;
      if(done == 0) break;
    }
    return total;
  }

  // The best operation about node v, if any lowers the energy.
  bool improve_at(Index v)
  {
    double best_change = options_.tolerance - s_.energy.min_gain;
    const char* best_name = nullptr;
    for(const Operation_candidate& c : candidates_.collect(v)) {
      if(c.bound >= best_change) continue;
      candidates_.describe(c, *trial_);
      const bool wide = candidates_.relieves_crowd(c); // worth a look although it starts badly
      if(wide) trial_->add_halo();
      const double reach = halo_gain(c.kind);
      double change = try_cavity(*trial_, best_change, wide ? 50 : reach);
      if(!wide && change >= best_change && change < best_change + reach) {
        trial_->add_halo(); // the nodes around may move, too
        change = try_cavity(*trial_, best_change, 0);
      }
      if(change >= best_change) continue;
      best_change = change;
      best_name = operation_name(c.kind);
      std::swap(trial_, best_);
      if(options_.first_gain) break;
    }
    if(!best_name) return false;
    touched_.clear();
    best_->commit(&touched_);
    s_.count(best_name);
    for(Index u : touched_) s_.stir(u);
    return true;
  }

private:
  // Change of energy, or more than any bound where it is not legal, or where an estimate is above
  // `to_beat` by more than `reach`.
  double try_cavity(Cavity& c, double to_beat, double reach)
  {
    constexpr double refused = 1e300, error = 0.5; // of the estimate
    if(!c.close()) return refused;
    const double hopeless = c.energy_before() + to_beat;
    for(int sweep = 0; sweep < options_.sweeps; ++sweep) {
      c.relax(1);
      const bool last = sweep + 1 == options_.sweeps;
      const double allowed = last ? reach + error : (std::max)(reach, options_.sweep_below);
      if(c.estimate_after() > hopeless + allowed) return refused;
    }
    const double change = c.energy_after() - c.energy_before();
    if(!(change < to_beat)) return change;
    if(!c.keeps_shape(options_.min_jacobian)) return refused;
    if(options_.keep_within_size &&
       c.largest_after() > (std::max)(s_.energy.tolerated, c.largest_before()))
      return refused;
    return change;
  }

  Adaptation_state& s_;
  Improvement_options options_;
  Cavity first_, second_;
  Cavity *trial_ = &first_, *best_ = &second_;
  Operation_candidates candidates_;
  std::vector<Index> touched_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LOCAL_IMPROVEMENT_H
