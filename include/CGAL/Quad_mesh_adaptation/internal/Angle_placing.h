// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ANGLE_PLACING_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ANGLE_PLACING_H

#include <CGAL/Quad_mesh_adaptation/internal/faults.h>
#include <CGAL/Quad_mesh_adaptation/internal/huge_nodes.h>
#include <CGAL/Quad_mesh_adaptation/internal/nodes_around.h>
#include <CGAL/Quad_mesh_adaptation/internal/poor_shapes.h>
#include <CGAL/Quad_mesh_adaptation/internal/smoothing.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Moves the nodes about a face of poor shape for the sake of angles alone.  Smoothing looks at
// lengths, too, and at what no move can mend: between features it gives the angles of some faces
// away for a little more in those that stay poor.  So here a face counts by what it lacks of a goal
// only, and those that features keep poor may lose a little.
//
// A corner counts by its sine, and the best of a few places about a node is taken, in ever shorter
// steps: hinges like these give Newton's method nothing to work with.
class Angle_placing
{
public:
  explicit Angle_placing(Adaptation_state& s)
      : s_(s), worst_(std::clamp(least_scaled_jacobian(s), 0., goal))
  {
  }

  // About face f, if nothing excuses its shape; in a wider place where a narrow one does not do.
  // No face comes to be too large by it or worse than all others, nor more faces poor without a
  // reason.
  void operator()(Index f)
  {
    for(int rings = 1; rings <= 2 && is_unexcused(s_, f); ++rings) place_within(f, rings);
  }

private:
  static constexpr double goal = Poor_face::floor + 0.01; // of qualities
  static constexpr double share = 0.85; // of what a face has that features keep poor

  void place_within(Index f, int rings)
  {
    collect(f, rings);
    if(nodes_.size() > std::size_t(boundless_fan)) return; // about such a fan
    std::vector<Vertex_record> before;
    for(Index v : nodes_) before.push_back(s_.mesh.vertex(v));
    const std::size_t poor = number_poor();
    relax();
    if(number_poor() <= poor) return;
    for(std::size_t i = 0; i < nodes_.size(); ++i) s_.mesh.vertex(nodes_[i]) = before[i];
    for(Index v : nodes_) {
      s_.node_moved(v);
      share_witnesses_about(v);
    }
  }

  // The nodes that may move, and all faces about them.
  void collect(Index f, int rings)
  {
    const std::vector<char> near = nodes_around(s_.mesh, { f }, rings);
    nodes_.clear();
    faces_.clear();
    for(Index v = 0; v < Index(near.size()); ++v) {
      if(!near[v] || is_fixed(s_.mesh.vertex(v)) || !s_.is_to_work_on(v)) continue;
      nodes_.push_back(v);
      for(Index h : s_.mesh.outgoing(v)) faces_.push_back(s_.mesh.face(h));
    }
    std::sort(faces_.begin(), faces_.end());
    faces_.erase(std::unique(faces_.begin(), faces_.end()), faces_.end());
    goals_.resize(s_.mesh.face_end());
    least_.resize(s_.mesh.face_end());
    least_jacobian_.resize(s_.mesh.face_end());
    for(Index g : faces_) {
      const double quality = quality_of(g);
      const bool is_poor = is_jacobian_below(s_.corners(g), Poor_face::floor);
      goals_[g] = is_poor && !is_unexcused(s_, g) ? (std::min)(goal, share * quality) : goal;
      least_[g] = (std::min)(worst_, quality);
      least_jacobian_[g] = (std::min)(worst_, scaled_jacobian(s_.corners(g)));
    }
  }

  double quality_of(Index f) const
  {
    return s_.face_quality(s_.corners(f), s_.reference_normal(f));
  }

  bool is_fixed(const Vertex_record& r) const
  {
    return r.frozen || r.carrier == Carrier::corner ||
           (r.carrier == Carrier::curve && s_.curves[r.curve].is_frozen());
  }

  std::size_t number_poor() const
  {
    return std::size_t(std::count_if(faces_.begin(), faces_.end(),
                                     [this](Index f) { return is_unexcused(s_, f); }));
  }

  void relax()
  {
    constexpr int most_sweeps = 30;
    constexpr double first_step = 0.2, last_step = 0.008; // of an edge
    double step = first_step, lack = lack_of_all();
    for(int sweep = 0; sweep < most_sweeps && lack > 0 && step > last_step; ++sweep) {
      for(Index v : nodes_) move(v, step);
      const double now = lack_of_all();
      if(now > 0.9 * lack) step *= 0.5;
      lack = now;
    }
  }

  // The sum of the squares of what corners lack, flatness and following as well.
  double lack_of(Index f) const
  {
    constexpr double folded = 10;
    const Corners p = s_.corners(f);
    const Facing reference = s_.reference_normal(f);
    if(s_.is_folded(p, reference.sum)) return folded;
    const Vec n = normalized(area_vector(p));
    double sum = 0;
    const auto add = [&](double quality) {
      const double x = (std::max)(goals_[f] - quality, 0.);
      sum += x * x;
    };
    for(int i = 0; i < 4; ++i) {
      const Vec a = p[(i + 1) & 3] - p[i], b = p[(i + 3) & 3] - p[i];
      const double l = std::sqrt((a * a) * (b * b));
      add(l > 0 ? n * cross(a, b) / l : -1.);
    }
    add(flatness(warp(p)));
    add(following(reference.mean_cosine(n)));
    return sum;
  }

  double lack_of_all() const
  {
    double sum = 0;
    for(Index f : faces_) sum += lack_of(f);
    return sum;
  }

  double lack_about(Index v) const
  {
    double sum = 0;
    for(Index h : s_.mesh.outgoing(v)) sum += lack_of(s_.mesh.face(h));
    return sum;
  }

  // To the best of a few places about node v, if that is better than where it is.
  void move(Index v, double step)
  {
    double least = lack_about(v);
    if(!(least > 0)) return;
    Vertex_record& r = s_.mesh.vertex(v);
    const Vertex_record old = r;
    Vertex_record best = old;
    const double way = step * mean_edge_length(s_.corners(s_.mesh.face(r.halfedge)));
    const double allowed = (std::max)(1., largest_ratio_about(v));
    for(const Vec& to : directions(r)) {
      r = old;
      if(r.carrier == Carrier::curve)
        r.param += way * to.x();
      else
        r.p = r.p + way * to;
      s_.place(r);
      const double lack = lack_about(v);
      if(!(lack < 0.999999 * least) || !may_be_here(v, old, allowed)) continue;
      least = lack;
      best = r;
    }
    r = best;
    s_.node_moved(v);
    if(best.p != old.p) share_witnesses_about(v);
  }

  // Of unit length; along a curve only x counts.
  static std::vector<Vec> directions(const Vertex_record& r)
  {
    if(r.carrier == Carrier::curve) return { Vec(1, 0, 0), Vec(-1, 0, 0) };
    const auto [x, y] = tangents(r.normal);
    const double c = std::sqrt(0.5);
    return { x, y, -x, -y, c * (x + y), c * (y - x), -c * (x + y), c * (x - y) };
  }

  bool may_be_here(Index v, const Vertex_record& old, double allowed_ratio)
  {
    constexpr double hair = 1e-9;
    if(!is_order_kept(s_, v, old)) return false;
    s_.node_moved(v);
    const auto is_too_poor = [this](Index f) {
      return scaled_jacobian(s_.corners(f)) < least_jacobian_[f] - hair ||
             quality_of(f) < least_[f] - hair;
    };
    for(Index h : s_.mesh.outgoing(v))
      if(is_too_poor(s_.mesh.face(h))) return false;
    return largest_ratio_about(v) <= allowed_ratio && !loses_surface(s_, v, old) &&
           !leaves_reference(s_, v, old);
  }

  double largest_ratio_about(Index v) const
  {
    double largest = 0;
    for(Index h : s_.mesh.outgoing(v))
      largest = (std::max)(largest, s_.size_ratio(s_.mesh.face(h)));
    return largest;
  }

  void share_witnesses_about(Index v)
  {
    if(!s_.coverage.is_empty()) share_witnesses(s_, v);
  }

  Adaptation_state& s_;
  const double worst_; // scaled Jacobian; no face falls below it, those of less quality not at all
  std::vector<Index> nodes_, faces_;
  std::vector<double> goals_, least_, least_jacobian_; // by face: hoped for, and to be kept
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ANGLE_PLACING_H
