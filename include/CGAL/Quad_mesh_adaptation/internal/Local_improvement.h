// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LOCAL_IMPROVEMENT_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LOCAL_IMPROVEMENT_H

#include <CGAL/Quad_mesh_adaptation/internal/Changed_nodes.h>
#include <CGAL/Quad_mesh_adaptation/internal/Operation_search.h>
#include <CGAL/Quad_mesh_adaptation/internal/Walk.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// One pass after the other over the stirred nodes: of all local operations about a node, the one
// that lowers the energy most is committed, or the first that lowers it.  Without a tolerance every
// commit lowers the energy by at least energy.min_gain; with one it may rise by less than that.
// Either way the number of passes is bounded, and with it the work.
//
// A pass walks over a large mesh at many places at once, a step at each in turn.  Several threads
// search at all of them ahead of the commits; where a commit has changed what a search has read,
// that search is done again.  So the outcome is that of one thread, which searches once.
class Local_improvement
{
public:
  Local_improvement(Adaptation_state& s, const Improvement_options& o)
      : s_(s), own_(s, o), searches_([&s, o] { return std::make_unique<Operation_search>(s, o); }),
        changed_(s)
  {
  }

  // One pass over the stirred nodes; returns the number of operations committed.
  std::size_t pass()
  {
    s_.prepare_coverage();
    Walk walk = walk_over_stirred();
    std::size_t done = 0, visited = 0;
    for(std::size_t step = 0; step < walk.steps(); ++step, visited += batch_.size()) {
      batch_ = walk.step(step);
      if(visited % 1024 < batch_.size()) s_.check_cancelled();
      if(is_searched_ahead()) search_ahead();
      for(std::size_t i = 0; i < batch_.size(); ++i)
        if(s_.mesh.is_vertex(batch_[i]) && improve_in_turn(i)) ++done;
      changed_.clear();
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
    const Operation_proposal found = own_(v);
    if(found.node < 0) return false;
    touched_.clear();
    own_.commit(touched_);
    note(found);
    return true;
  }

private:
  Walk walk_over_stirred()
  {
    std::vector<char> now;
    now.swap(s_.stirred);
    now.resize(s_.mesh.vertex_end(), 1);
    s_.stirred.assign(now.size(), 0);
    return Walk(s_.mesh, now, 500, 128, s_.order);
  }

  bool is_searched_ahead() const { return s_.workers.are_several() && batch_.size() > 1; }

  void search_ahead()
  {
    s_.make_room();
    found_.assign(batch_.size(), Operation_proposal());
    s_.workers.run(batch_.size(), [&](std::size_t i) {
      if(s_.mesh.is_vertex(batch_[i])) found_[i] = searches_.mine().for_later(batch_[i]);
    });
  }

  bool improve_in_turn(std::size_t i)
  {
    const bool is_ahead = is_searched_ahead();
    bool done = false;
    if(!is_ahead || changed_.has(batch_[i])) {
      done = improve_at(batch_[i]);
    } else if(found_[i].node >= 0) {
      touched_.clear();
      own_.commit(found_[i], touched_);
      note(found_[i]);
      done = true;
    }
    if(done && is_ahead) changed_.add(touched_);
    return done;
  }

  void note(const Operation_proposal& p)
  {
    s_.count(operation_name(p.candidate.kind));
    for(Index u : touched_) s_.stir(u);
  }

  Adaptation_state& s_;
  Operation_search own_;
  Worker_own<Operation_search> searches_;
  Changed_nodes changed_;
  std::vector<Index> batch_;
  std::vector<Operation_proposal> found_; // about the nodes of the batch
  std::vector<Index> touched_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LOCAL_IMPROVEMENT_H
