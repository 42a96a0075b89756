// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISTANCE_FROM_REFERENCE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISTANCE_FROM_REFERENCE_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/Distance_climb.h>
#include <CGAL/Quad_mesh_adaptation/internal/Largest_distance.h>
#include <CGAL/Quad_mesh_adaptation/internal/Mesh_triangles.h>
#include <CGAL/Quad_mesh_adaptation/internal/own_triangles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Distances found on the faces of a mesh, where those above a finite `care` are asked for.
class Distances_by_face
{
public:
  Distances_by_face(Index face_end, double care)
      : care_(care), is_careful_(std::isfinite(care)), of_face_(is_careful_ ? face_end : 0, 0.)
  {
  }

  double care() const { return care_; }
  // What is nearer than this does not matter.
  double enough(const Largest_distance& largest) const
  {
    return is_careful_ ? care_ : largest.threshold();
  }
  bool is_careful() const { return is_careful_; }
  // Is it known of a face by such a distance that it needs care?
  bool has_more_than_care(double d) const { return is_careful_ && d > care_; }
  double operator[](Index f) const { return of_face_[f]; }

  void note(Index f, double d, Largest_distance& largest)
  {
    if(is_careful_) of_face_[f] = (std::max)(of_face_[f], d);
    largest.note(d, f);
  }

private:
  double care_;
  bool is_careful_;
  std::vector<double> of_face_;
};

// How far a reference surface is from the faces, see Distance_measure.
class Distance_from_reference
{
public:
  // `is_own`: is a face two triangles of the reference?  Without care for each face nothing is
  // looked for between samples: walks that went astray would be followed, too, and be too many.
  Distance_from_reference(const Adaptation_state& s, const std::vector<char>& is_own,
                          Distances_by_face& by_face, Largest_distance& largest,
                          Between_samples between)
      : s_(s), is_own_(is_own), by_face_(by_face), largest_(largest),
        climb_(by_face.is_careful() ? between : Between_samples::left_out, true)
  {
  }

  // What a small change has left as it was is on its own triangles, and looked at only near faces
  // that are others now.
  void operator()()
  {
    // before anything is done, no point of an input that is its own reference is off the mesh
    const std::size_t own = std::size_t(std::count(is_own_.begin(), is_own_.end(), 1));
    if(2 * own == s_.surface.triangles().size()) return;
    const std::vector<char> near = faces_near_others(s_.mesh, is_own_);
    Mesh_triangles triangles(s_.mesh, &near);
    face_of_ = triangles.face_of();
    mesh_ = triangles.surface(false, Normals::found_anew);
    find_starts();
    find_places();
    measure_triangles();
    if(by_face_.is_careful() || largest_.settle(mesh_)) return;
    asks_tree_ = true;
    measure_triangles();
  }

private:
  // Each triangle beside one that is measured already, so that its samples are looked for near
  // those of that one, where no node is known to lie on it.
  void measure_triangles()
  {
    const Index n = Index(s_.surface.triangles().size());
    foot_.assign(s_.surface.points().size(), -1);
    std::vector<Index> queue;
    std::vector<char> seen(std::size_t(n), 0);
    const auto reach = [&](Index t) {
      if(t < 0 || seen[t]) return;
      seen[t] = 1;
      queue.push_back(t);
    };
    for(Index t = 0; t < n; ++t) seen[t] = is_same_triangle(t);
    for(bool is_known : { true, false })
      for(Index first = 0; first < n; ++first) {
        if(seen[first] || (is_known && start_[first] < 0)) continue;
        queue.clear();
        reach(first);
        for(std::size_t i = 0; i < queue.size(); ++i) {
          measure_triangle(queue[i]);
          for(int side = 0; side < 3; ++side) reach(s_.surface.neighbour(queue[i], side));
        }
      }
  }

  // Triangles of the mesh beside a node that lies on a triangle of the reference.
  void find_starts()
  {
    start_.assign(s_.surface.triangles().size(), -1);
    for(std::size_t k = face_of_.size(); k-- > 0;)
      for(Index v : s_.mesh.quad(face_of_[k])) {
        const Vertex_record& r = s_.mesh.vertex(v);
        if(r.carrier == Carrier::surface && r.hint >= 0) start_[r.hint] = Index(2 * k);
      }
  }

  void find_places()
  {
    place_of_.assign(s_.mesh.face_end(), -1);
    for(std::size_t k = 0; k < face_of_.size(); ++k) place_of_[face_of_[k]] = Index(k);
  }

  // Is triangle t one of an input that is its own reference, of a face that has been left as it
  // was? No point of it is off the mesh then, and its corners lie on the same triangle of the mesh.
  bool is_same_triangle(Index t)
  {
    const Index f = t / 2;
    if(f >= Index(is_own_.size()) || !is_own_[f]) return false;
    if(place_of_[f] < 0) return true;
    for(Index v : s_.surface.triangles()[t])
      if(foot_[v] < 0) foot_[v] = 2 * place_of_[f] + t % 2;
    return true;
  }

  void measure_triangle(Index t)
  {
    const std::array<Index, 3> corners = s_.surface.triangles()[t];
    const std::array<Vec, 3> c = s_.surface.triangle(t);
    Index hint = start_[t];
    for(Index v : corners)
      if(foot_[v] >= 0) hint = foot_[v];
    if(is_near_enough(c, hint)) {
      for(Index v : corners)
        if(foot_[v] < 0) foot_[v] = hint;
      return;
    }
    const int n = samples_on_side(c, hint);
    Farthest_sample farthest;
    const auto measure = [&](double a, double b) {
      farthest.note(measure_back(at(c, a, b), t, hint), { a, b }, hint);
    };
    for(int i = 0; i <= n; ++i)
      for(int j = 0; i + j <= n; ++j) {
        const int k = n - i - j, corner = i == n ? 0 : j == n ? 1 : k == n ? 2 : -1;
        if(corner >= 0 && foot_[corners[corner]] >= 0) continue;
        measure(double(i) / n, double(j) / n);
        if(corner >= 0) foot_[corners[corner]] = hint;
      }
    measure(1. / 3, 1. / 3);
    const double d = farthest.distance;
    if(climb_.is_any() && d > enough_at_sample() && !by_face_.has_more_than_care(d))
      measure_between(c, t, farthest, 0.5 / n);
  }

  // More where there are several faces to a triangle and each of them counts.
  int samples_on_side(const std::array<Vec, 3>& c, Index hint) const
  {
    constexpr double per_edge = 1.5, most = 64;
    const int few = s_.surface.has_lift() ? 4 : 2;
    if(!climb_.is_any() || hint < 0) return few;
    const double side =
        (std::max)({ distance(c[0], c[1]), distance(c[1], c[2]), distance(c[2], c[0]) });
    const double edge = mean_edge_length(s_.corners(face_of_[hint / 2]));
    return edge > 0 ? (std::max)(few, int((std::min)(most, per_edge * side / edge))) : few;
  }

  static Vec at(const std::array<Vec, 3>& c, double a, double b)
  {
    return a * c[0] + b * c[1] + (1 - a - b) * c[2];
  }

  // Between the samples of triangle t.
  void measure_between(const std::array<Vec, 3>& c, Index t, const Farthest_sample& farthest,
                       double step)
  {
    constexpr std::array<Distance_climb::Place, 6> moves = {
      { { 1, 0 }, { 0, 1 }, { -1, 1 }, { -1, 0 }, { 0, -1 }, { 1, -1 } }
    };
    Index hint = farthest.hint;
    const Distance_climb::Place p =
        climb_(farthest.place, farthest.distance, step, moves,
               [&](const Distance_climb::Place& to, double d) {
                 if(to[0] < 0 || to[1] < 0 || to[0] + to[1] > 1) return -1.;
                 return mesh_.distance_from(s_.surface.lifted(at(c, to[0], to[1]), t), d, hint);
               });
    if(p != farthest.place) measure_back(at(c, p[0], p[1]), t, hint);
  }

  // A sample that is no farther off does not matter, nor do the points near it, most likely.
  double enough_at_sample() const { return by_face_.enough(largest_) / climb_.likely_gain(); }

  // Are all points of a triangle so near to the mesh that they do not matter?  One look tells it of
  // most where the mesh is much coarser than the reference.
  bool is_near_enough(const std::array<Vec, 3>& c, Index& hint) const
  {
    if(by_face_.is_careful() || hint < 0 || s_.surface.has_lift()) return false;
    const Vec centre = (c[0] + c[1] + c[2]) / 3;
    const double radius =
        (std::max)({ distance(c[0], centre), distance(c[1], centre), distance(c[2], centre) });
    const double enough = enough_at_sample() - radius;
    return enough > radius && mesh_.distance_from(centre, enough, hint) <= enough;
  }

  // Returns the distance, or something that does not matter.
  double measure_back(Vec p, Index t, Index& hint)
  {
    p = s_.surface.lifted(p, t);
    if(hint < 0) hint = mesh_.find(p, -1, s_.surface.normal(t));
    const double enough = by_face_.enough(largest_);
    double d = mesh_.distance_from(p, enough_at_sample(), hint);
    if(!by_face_.is_careful() && !asks_tree_) {
      if(!(d > enough)) return d;
      d = walked_anew(p, t, d, hint);
      largest_.doubt(d, p, -1, s_.surface.normal(t));
      return d;
    }
    if(d > enough && !(by_face_.is_careful() && d <= by_face_[face_of_[hint / 2]])) {
      Index nearer = mesh_.find_nearer(p, -1, s_.surface.normal(t), d);
      if(nearer >= 0) {
        d = (std::min)(d, distance(p, mesh_.project(p, nearer)));
        hint = nearer;
      }
    }
    by_face_.note(face_of_[hint / 2], d, largest_);
    return d;
  }

  // A walk that seems to end far off may have been lost from the triangle before on: so it is done
  // again from the triangle's own start.
  double walked_anew(const Vec& p, Index t, double d, Index& hint) const
  {
    if(start_[t] < 0) return d;
    Index other = start_[t];
    const double again = distance(p, mesh_.project(p, other));
    if(!(again < d)) return d;
    hint = other;
    return again;
  }

  const Adaptation_state& s_;
  const std::vector<char>& is_own_;
  Distances_by_face& by_face_;
  Largest_distance& largest_;
  Distance_climb climb_;
  bool asks_tree_ = false;
  Reference_surface mesh_;      // the faces, each cut in two
  std::vector<Index> face_of_;  // of each pair of triangles
  std::vector<Index> place_of_; // among those, by face
  std::vector<Index> start_;    // by triangle of the reference: one of the mesh near it, or -1
  std::vector<Index> foot_;     // by vertex of the reference: the triangle nearest to it
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISTANCE_FROM_REFERENCE_H
