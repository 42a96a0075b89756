// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DETOUR_TRIAL_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DETOUR_TRIAL_H

#include <CGAL/Quad_mesh_adaptation/Poor_face.h>
#include <CGAL/Quad_mesh_adaptation/internal/Angle_placing.h>
#include <CGAL/Quad_mesh_adaptation/internal/Mesh_keeper.h>
#include <CGAL/Quad_mesh_adaptation/internal/faults.h>
#include <CGAL/Quad_mesh_adaptation/internal/shape_mending.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// One operation that may raise the energy, and those that follow and lower it again, at first with
// more weight on shapes.  What that leads to stays if it is better, else all goes back.
class Detour_trial
{
public:
  // `follow`: what may be done after the first operation.
  Detour_trial(Adaptation_state& s, const Improvement_options& follow) : s_(s), follow_(follow) {}

  enum class Outcome
  {
    no_operation,
    taken_back,
    better
  };

  // Calls first() for the first operation, and if that is true looks for others within three rings
  // of face f after it.
  template <typename First>
  Outcome operator()(Index f, const First& first, double least_gain)
  {
    begin();
    look_about(f);
    if(!first()) return Outcome::no_operation;
    improve_about(near_);
    if(moves_for_angles_) place_about(near_);
    const bool is_better = faces_too_large(s_).size() <= start_->too_large &&
                           worst_quality(s_) >= start_->least_quality - hair &&
                           least_scaled_jacobian(s_) >= start_->least_jacobian - hair &&
                           crowding() <= start_->crowding &&
                           unexcused_to_spare() <= start_->unexcused &&
                           demerits_here() < start_->demerits - least_gain;
    if(!is_better) {
      go_back();
      return Outcome::taken_back;
    }
    forget_start();
    return Outcome::better;
  }

  // Faces too many at nodes of curves count like those at others from now on.
  void count_all_crowds()
  {
    counts_all_crowds_ = true;
    forget_start();
  }

  // What is left poor after the operations is mended by moves for the sake of angles from now on.
  void move_for_angles() { moves_for_angles_ = true; }

  // No more faces are poor without an excuse from now on, whatever is gained for them.
  void spare_shapes()
  {
    spares_shapes_ = true;
    forget_start();
  }

  // The mesh has been changed since the last trial.
  void forget_start()
  {
    start_.reset();
    mesh_.reset();
    near_face_ = -1;
  }

private:
  // What a trial starts from, measured once for all trials up to the first that is better.
  struct Start
  {
    double demerits, least_quality, least_jacobian; // folds may hide the latter from the former
    int crowding;
    std::size_t too_large, unexcused;
    std::vector<char> stirred, restless;
    Face_values<double> sizes; // of all faces
  };

  void begin()
  {
    if(!start_)
      start_ = Start{ demerits_here(),
                      (std::min)(worst_quality(s_), Poor_face::floor),
                      (std::min)(least_scaled_jacobian(s_), Poor_face::floor),
                      crowding(),
                      faces_too_large(s_).size(),
                      unexcused_to_spare(),
                      s_.stirred,
                      s_.restless,
                      s_.sizes };
    if(!mesh_) mesh_.emplace(s_);
  }

  // Found once for all trials about one face.
  void look_about(Index f)
  {
    if(f == near_face_) return;
    near_ = nodes_around(s_.mesh, { f }, 3);
    near_face_ = f;
  }

  // Faces too many at inner nodes of the whole, on creases as well.
  int crowding() const
  {
    constexpr int allowed = 5;
    const Quad_complex& m = s_.mesh;
    int faces = 0;
    for(Index v = 0; v < m.vertex_end(); ++v) {
      if(!m.is_vertex(v)) continue;
      const int images = s_.images_at(m.vertex(v));
      if(images > 1 || !m.is_border_vertex(v))
        faces += (std::max)(images * m.vertex(v).faces - allowed, 0);
    }
    return faces;
  }

  std::size_t unexcused_to_spare() const
  {
    if(!spares_shapes_) return 0;
    std::size_t faces = 0;
    for(Index f : s_.mesh.faces())
      if(is_unexcused(s_, f)) ++faces;
    return faces;
  }

  void go_back()
  {
    mesh_->restore();
    mesh_.reset();
    s_.stirred = start_->stirred;
    s_.restless = start_->restless;
    s_.sizes = start_->sizes;
    s_.ratios.forget_all();
  }

  void improve_about(const std::vector<char>& nodes)
  {
    const Smoothing_weights smoothing = s_.smoothing;
    const Energy_weights energy = s_.energy;
    s_.smoothing.keep_within_size = true;
    s_.energy.shape = 4 * energy.shape;
    s_.forget_energies();
    improve(nodes, 2);
    s_.energy = energy;
    s_.forget_energies();
    improve(nodes, 2);
    s_.smoothing = smoothing;
  }

  // Where many faces are poor only some of them, or that would be most of the work of a trial.
  void place_about(std::vector<char> nodes)
  {
    int left = most_placings;
    nodes.resize(s_.mesh.vertex_end(), 1);
    Angle_placing place(s_);
    for(Index f = 0; f < s_.mesh.face_end() && left > 0; ++f) {
      if(!s_.mesh.is_face(f)) continue;
      const Quad q = s_.mesh.quad(f);
      const bool is_near = std::any_of(q.begin(), q.end(), [&](Index v) { return nodes[v]; });
      if(!is_near || !is_unexcused(s_, f)) continue;
      place(f);
      --left;
    }
  }

  // Operations about the marked nodes, and those that are new since.
  void improve(std::vector<char> nodes, int passes)
  {
    nodes.resize(s_.mesh.vertex_end(), 1);
    s_.restless = nodes;
    smooth(s_, 4);
    s_.stirred = nodes;
    Local_improvement(s_, follow_).passes(passes);
    smooth(s_, 4);
  }

  double demerits_here() { return energy_and_faults(s_, crowds_left_out()); }

  // Faces too many at nodes that the faults of shape do not count.
  int crowds_left_out() const
  {
    int faces = 0;
    for(Index v = 0; counts_all_crowds_ && v < s_.mesh.vertex_end(); ++v)
      if(s_.mesh.is_vertex(v) && !is_crowded(s_, v)) faces += faces_too_many(s_, v);
    return faces;
  }

  static constexpr int most_placings = 40;
  static constexpr double hair = 0.005; // moves measure shape in another way

  Adaptation_state& s_;
  Improvement_options follow_;
  bool counts_all_crowds_ = false, moves_for_angles_ = false, spares_shapes_ = false;
  std::optional<Start> start_;
  std::optional<Mesh_keeper> mesh_;
  Index near_face_ = -1;
  std::vector<char> near_; // nodes within three rings of it, while the mesh is that of start_
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DETOUR_TRIAL_H
