// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LOCAL_DETOURS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LOCAL_DETOURS_H

#include <CGAL/Quad_mesh_adaptation/internal/Mesh_keeper.h>
#include <CGAL/Quad_mesh_adaptation/internal/shape_mending.h>
#include <CGAL/Quad_mesh_adaptation/internal/total_energy.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The last faces of poor shape lie where no single operation helps.  So one operation about such a
// face may raise the energy, and those that follow lower it again, at first with more weight on
// shapes; where that ends with a better mesh it stays, else all goes back.  That takes a copy of
// the mesh each time, hence only as many trials as the mesh is small.
class Local_detours
{
public:
  Local_detours(Adaptation_state& s, const Improvement_options& o)
      : s_(s), options_(o), trials_left_(std::size_t(most_work / (s.mesh.number_of_faces() + 100)))
  {
    options_.keep_within_size = true;
    options_.valence_gain = -1e9; // swaps for the sake of shapes, too
    trials_left_ = (std::min)(trials_left_, most_trials);
    Improvement_options none = options_;
    none.tolerance = 10;
    none.keep_within_size = false;
    none.min_jacobian = 0.3;
    none.close = none.open = none.swap = none.rotate = none.border = false;
    first_steps_.assign(4, none);
    first_steps_[0].swap = first_steps_[0].rotate = true;
    first_steps_[1].close = true;
    first_steps_[2].border = first_steps_[2].crease = true;
    first_steps_[3].open = first_steps_[3].corner = true;
  }

  void operator()()
  {
    std::vector<Index> poor = poor_faces_by_shape();
    for(std::size_t i = 0; i < poor.size() && trials_left_ > 0;) {
      if(!is_mended(poor[i])) {
        ++i;
        continue;
      }
      poor = poor_faces_by_shape(); // numbers have changed
      i = 0;
    }
  }

private:
  // The worst first.
  std::vector<Index> poor_faces_by_shape() const
  {
    std::vector<std::pair<double, Index>> list;
    for(Index f : faces_to_mend(s_, shape_floor)) list.push_back({ -shape_fault(s_, f), f });
    std::sort(list.begin(), list.end());
    std::vector<Index> faces;
    for(const auto& x : list) faces.push_back(x.second);
    return faces;
  }

  // Each kind of operation about each node near face f, until one helps.
  bool is_mended(Index f)
  {
    std::vector<Index> nodes;
    const std::vector<char> near = nodes_around(s_.mesh, { f }, 1);
    for(Index v = 0; v < Index(near.size()); ++v)
      if(near[v]) nodes.push_back(v);
    for(const Improvement_options& first : first_steps_)
      for(Index v : nodes) {
        if(trials_left_ == 0) return false;
        if(is_better_after(f, v, first)) return true;
      }
    return false;
  }

  // What a trial starts from.  It stays valid for the next one unless there is a better mesh.
  struct Start
  {
    double demerits;
    std::size_t too_large;
    std::vector<char> stirred, restless;
  };

  void begin()
  {
    if(!start_)
      start_ = Start{ demerits_here(), faces_too_large(s_).size(), s_.stirred, s_.restless };
    if(!mesh_) mesh_.emplace(s_);
  }

  void go_back()
  {
    mesh_->restore();
    mesh_.reset();
    s_.stirred = start_->stirred;
    s_.restless = start_->restless;
  }

  bool is_better_after(Index f, Index v, const Improvement_options& first)
  {
    s_.check_cancelled();
    begin();
    const std::vector<char> near = nodes_around(s_.mesh, { f }, 3);
    if(!Local_improvement(s_, first).improve_at(v)) return false;
    --trials_left_;
    const Smoothing_weights smoothing = s_.smoothing;
    const Energy_weights energy = s_.energy;
    s_.smoothing.keep_within_size = true;
    s_.energy.shape = 4 * energy.shape;
    s_.forget_energies();
    improve(near, 2);
    s_.energy = energy;
    s_.forget_energies();
    improve(near, 2);
    s_.smoothing = smoothing;
    const bool is_better = faces_too_large(s_).size() <= start_->too_large &&
                           demerits_here() < start_->demerits - s_.energy.min_gain;
    if(is_better) {
      start_.reset();
      mesh_.reset();
    } else {
      go_back();
    }
    return is_better;
  }

  // Operations about the marked nodes, and those that are new since.
  void improve(std::vector<char> nodes, int passes)
  {
    nodes.resize(s_.mesh.vertex_end(), 1);
    s_.restless = nodes;
    smooth(s_, 4);
    s_.stirred = nodes;
    Local_improvement(s_, options_).passes(passes);
    smooth(s_, 4);
  }

  // A face a tenth below the floor may cost two irregular nodes and two faces.
  double demerits_here() { return total_energy(s_) + 80 * shape_faults(s_); }

  static constexpr Index most_work = 100000; // faces in all copies
  static constexpr std::size_t most_trials = 40;

  Adaptation_state& s_;
  Improvement_options options_;
  std::size_t trials_left_;
  std::vector<Improvement_options> first_steps_;
  std::optional<Start> start_;
  std::optional<Mesh_keeper> mesh_;
};

// The last resorts in turn: sizes first, then shapes, again where one has undone the other, and the
// last poor faces one by one.
inline void enforce_sizes_and_shapes(Adaptation_state& s, const Improvement_options& o)
{
  enforce_sizes(s, o, 16);
  for(int turn = 0; turn < 3; ++turn) {
    mend_shapes(s, o, 12);
    if(faces_to_press(s).empty()) break;
    enforce_sizes(s, o, 12);
  }
  Local_detours local(s, o);
  local();
  s.qualities = Face_values<float>(); // their memory is needed
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LOCAL_DETOURS_H
