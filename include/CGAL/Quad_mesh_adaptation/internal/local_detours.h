// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LOCAL_DETOURS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LOCAL_DETOURS_H

#include <CGAL/Quad_mesh_adaptation/internal/Angle_placing.h>
#include <CGAL/Quad_mesh_adaptation/internal/Detour_trial.h>
#include <CGAL/Quad_mesh_adaptation/internal/Work_part.h>
#include <CGAL/Quad_mesh_adaptation/internal/detour_searches.h>
#include <CGAL/Quad_mesh_adaptation/internal/detour_targets.h>
#include <CGAL/Quad_mesh_adaptation/internal/huge_nodes.h>
#include <CGAL/Quad_mesh_adaptation/internal/poor_shapes.h>
#include <CGAL/Quad_mesh_adaptation/internal/shape_mending.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The last faces of poor shape lie where no single operation helps.  So one operation about such a
// face may raise the energy, and those that follow lower it again, at first with more weight on
// shapes; where that ends with a better mesh it stays, else all goes back.  That takes a copy of
// the mesh each time, hence only as many trials as the mesh is small; but faces that nothing
// excuses are tried in the part of the mesh about them.  In the end the same is done about faces
// that are far too small, where features leave no single operation that gains.
class Local_detours
{
public:
  Local_detours(Adaptation_state& s, const Improvement_options& o)
      : s_(s), options_(made_careful(o)), trial_(s, options_),
        usual_(usual_search(options_, s.energy.min_gain)), near_(thorough_search(options_, 1)),
        farther_(thorough_search(options_, 2)), rows_(thinning_search(options_, true)),
        closes_(thinning_search(options_, false))
  {
  }

  // What `in_vain` remembers is not tried again.
  void operator()(Places_in_vain& in_vain)
  {
    try_in_parts(unexcused_faces(), { &near_, &farther_ });
    trials_left_ = affordable_trials(most_work, most_trials);
    const std::vector<char> about = in_vain.changed_nodes(s_);
    std::vector<Index> poor = poor_faces_by_shape(about);
    std::size_t i = 0;
    while(i < poor.size() && trials_left_ > 0) {
      if(!is_mended(poor[i], usual_)) {
        ++i;
        continue;
      }
      poor = poor_faces_by_shape(about); // numbers have changed
      i = 0;
    }
    poor.resize(i);
    for(Index f : faces_to_mend(s_, shape_floor))
      if(!is_about(s_, f, about)) poor.push_back(f);
    in_vain.remember(s_, poor);
  }

  // For a mesh that is to stay: on the way to it, all trials may have gone to meshes that did not.
  // Crowded nodes count here, too.  First come moves for the sake of angles, then operations, and
  // such moves after each: near each place, then more faces there, then operations farther off.
  void in_the_end()
  {
    s_.detours_left = trials_in_the_end;
    trial_.count_all_crowds();
    trial_.move_for_angles();
    place_for_angles();
    for(const Detour_search* search : { &near_, &splits_, &farther_ })
      try_in_parts(unexcused_and_crowded_faces(), { search });
    thin_out_in_the_end();
    s_.qualities = Face_values<float>();
  }

  // The moves alone.
  void move_in_the_end()
  {
    place_for_angles();
    s_.qualities = Face_values<float>();
  }

private:
  using Searches = std::vector<const Detour_search*>;

  // Half rows between curves go before single faces: fewer trials, and more faces each time.  Where
  // few are too small that would not matter.
  void thin_out_in_the_end()
  {
    constexpr double few = 0.001;
    if(are_sizes_out_of_reach(s_) || fraction_below(s_, far_too_small) <= few) return;
    s_.detours_left = trials_to_thin_out;
    trial_.spare_shapes();
    for(const Detour_search* search : { &rows_, &closes_, &rows_ })
      try_in_parts(far_too_small_faces(), { search });
  }

  // The cheapest that helps, and it makes no faces.
  void place_for_angles()
  {
    Angle_placing place(s_);
    std::size_t left = most_placings;
    for(Index f = 0; f < s_.mesh.face_end() && left > 0; ++f) {
      if(!s_.mesh.is_face(f) || !is_unexcused(s_, f)) continue;
      place(f);
      --left;
    }
  }

  // The worst first, each for itself.
  void try_in_parts(const Detour_target& target, const Searches& searches)
  {
    const std::vector<char> stirred = s_.stirred, restless = s_.restless;
    Tried_faces tried;
    double work_left = most_work_in_parts;
    while(work_left > 0 && s_.detours_left > 0) {
      const Index f = target.worst(s_, tried);
      if(f < 0) break;
      tried.add(s_, f);
      work_left -= work_to_find_it * s_.mesh.number_of_faces();
      const Part_choice choice(s_.mesh, { f }, rings);
      if(s_.region.empty() && choice.is_small(s_.mesh)) {
        Work_part part(s_, { f }, choice, rings);
        trial_.forget_start(); // of another mesh
        work_left -= try_on(part.work().front(), target, searches, work_left);
        part.put_back();
        trial_.forget_start();
      } else {
        work_left -= try_on(f, target, searches, work_left);
      }
    }
    const auto give_back = [&](std::vector<char>& to, const std::vector<char>& marks) {
      to = marks;
      to.resize(s_.mesh.vertex_end(), 1);
    };
    give_back(s_.stirred, stirred);
    give_back(s_.restless, restless);
  }

  // Until face f is good enough or nothing helps; returns the work.
  double try_on(Index f, const Detour_target& target, const Searches& searches, double work_left)
  {
    double work = 0;
    bool again = true;
    while(again && s_.mesh.is_face(f) && target.is_left(s_, f) && work < work_left) {
      const Index faces = s_.mesh.number_of_faces();
      const std::size_t trials =
          affordable_trials(work_left - work, (std::min)(most_trials_each, s_.detours_left));
      trials_left_ = trials;
      again = std::any_of(searches.begin(), searches.end(),
                          [&](const Detour_search* search) { return is_mended(f, *search); });
      work += double(trials - trials_left_) * (faces + 100);
      s_.detours_left -= trials - trials_left_;
    }
    return work;
  }

  std::size_t affordable_trials(double work, std::size_t most) const
  {
    return (std::min)(most, std::size_t(work / (s_.mesh.number_of_faces() + 100)));
  }

  // Those about the nodes given, or all; the worst first.
  std::vector<Index> poor_faces_by_shape(const std::vector<char>& about) const
  {
    std::vector<std::pair<double, Index>> list;
    for(Index f : faces_to_mend(s_, shape_floor))
      if(is_about(s_, f, about)) list.push_back({ -shape_fault(s_, f), f });
    std::sort(list.begin(), list.end());
    std::vector<Index> faces;
    for(const auto& x : list) faces.push_back(x.second);
    return faces;
  }

  // Nodes to operate at about face f; only its own in a fan of very many faces, since nearly all
  // such trials find no operation.
  std::vector<Index> nodes_to_try(Index f, int rings) const
  {
    std::vector<Index> nodes;
    const std::vector<char> near = nodes_around(s_.mesh, { f }, rings);
    for(Index v = 0; v < Index(near.size()); ++v)
      if(near[v]) nodes.push_back(v);
    if(nodes.size() <= std::size_t(boundless_fan)) return nodes;
    const Quad q = s_.mesh.quad(f);
    return { q.begin(), q.end() };
  }

  // Each kind of operation about each node near face f, until one helps.
  bool is_mended(Index f, const Detour_search& search)
  {
    const std::vector<Index> nodes = nodes_to_try(f, search.rings);
    for(const Improvement_options& first : search.first)
      for(Index v : nodes) {
        if(trials_left_ == 0) return false;
        const auto operate = [&] { return Local_improvement(s_, first).improve_at(v); };
        if(is_better_after(f, operate, search.least_gain)) return true;
      }
    return search.splits && is_mended_by_splits(f, search.least_gain);
  }

  // More faces about face f, by splits of its own edges or of all edges about one of its nodes;
  // what there are too many of goes again.
  bool is_mended_by_splits(Index f, double least_gain)
  {
    constexpr int reach = 4; // rings
    const auto split = [&](const std::vector<Index>& faces, Edges_of_face edges) {
      const auto cut = [&] { return split_within(s_, faces, reach, edges) > 0; };
      return trials_left_ > 0 && is_better_after(f, cut, least_gain);
    };
    if(split({ f }, longer_edges) || split({ f }, shorter_edges) || split({ f }, all_edges))
      return true;
    const Quad q = s_.mesh.quad(f);
    return std::any_of(q.begin(), q.end(),
                       [&](Index v) { return split(faces_about(v), all_edges); });
  }

  std::vector<Index> faces_about(Index v) const
  {
    std::vector<Index> list;
    s_.mesh.outgoing(v, list);
    for(Index& h : list) h = s_.mesh.face(h);
    return list;
  }

  template <typename First>
  bool is_better_after(Index f, const First& first, double least_gain)
  {
    s_.check_cancelled();
    const Detour_trial::Outcome outcome = trial_(f, first, least_gain);
    if(outcome != Detour_trial::Outcome::no_operation) --trials_left_;
    return outcome == Detour_trial::Outcome::better;
  }

  static constexpr double most_work = 1e5; // faces in all copies
  static constexpr double most_work_in_parts = 8e5;
  static constexpr double work_to_find_it = 0.1; // a face, and to take a part out, for each face
  static constexpr std::size_t most_trials = 40, most_trials_each = 100, trials_in_the_end = 600,
                               trials_to_thin_out = 1000, most_placings = 500;
  static constexpr int rings = 4; // of faces to work on about a face

  Adaptation_state& s_;
  Improvement_options options_;
  Detour_trial trial_;
  const Detour_search usual_, near_, farther_, rows_, closes_, splits_ = { {}, 1, 1, true };
  std::size_t trials_left_ = 0;
};

// What the last resorts have tried in vain in one mesh.
struct Last_resorts_in_vain
{
  bool has_detours = true; // else none is tried
  Places_in_vain mending = {}, detours = {};
};

// The last resorts in turn: sizes first, then shapes, again where one has undone the other, and the
// last poor faces one by one.
inline void enforce_sizes_and_shapes(Adaptation_state& s, const Improvement_options& o,
                                     Last_resorts_in_vain& in_vain)
{
  enforce_sizes(s, o, 16);
  for(int turn = 0; turn < 3; ++turn) {
    mend_shapes(s, o, 12, in_vain.mending);
    if(faces_to_press(s).empty() || are_sizes_out_of_reach(s)) break;
    enforce_sizes(s, o, 12);
  }
  if(in_vain.has_detours) Local_detours(s, o)(in_vain.detours);
  s.qualities = Face_values<float>(); // their memory is needed
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LOCAL_DETOURS_H
