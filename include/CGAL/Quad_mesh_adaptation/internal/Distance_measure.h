// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISTANCE_MEASURE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISTANCE_MEASURE_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/Largest_distance.h>
#include <CGAL/Quad_mesh_adaptation/internal/Mesh_triangles.h>
#include <CGAL/Quad_mesh_adaptation/internal/curve_order.h>
#include <CGAL/Quad_mesh_adaptation/internal/own_triangles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// How far the bilinear faces of a state are from its reference surface and curves, and these from
// the faces, at sample points: nine per face, fifteen per reference triangle where that is curved
// and seven where it is flat, and along every feature edge all points of the curve's polyline.
//
// A distance is the one within the patch.  It is found by walking, over the surface or over the
// mesh, which may stop too far away; where that gives more than `care` for its face a tree is
// asked. Without `care` only the largest counts: walks end where it cannot be, and those that may
// be it are looked at again in the end.
class Distance_measure
{
public:
  explicit Distance_measure(const Adaptation_state& s,
                            double care = (std::numeric_limits<double>::infinity)())
      : s_(s), care_(care), is_careful_(std::isfinite(care)),
        of_face_(is_careful_ ? s.mesh.face_end() : 0, 0.)
  {
    measure_curves();
    if(s_.surface.is_planar()) return;
    is_own_ = faces_with_own_triangles(s_);
    measure_faces();
    measure_reference();
  }

  double to_reference() const { return to_reference_.value(); }
  double from_reference() const { return from_reference_.value(); }
  // With `care`: the larger of both for what was found on face f; rather too much, but where it is
  // above `care`.
  double of(Index f) const { return of_face_[f]; }

private:
  static constexpr int curve_samples = 8;

  void note(Index f, double d, Largest_distance& largest)
  {
    if(is_careful_) of_face_[f] = (std::max)(of_face_[f], d);
    largest.note(d);
  }

  void measure_faces()
  {
    // some from everywhere first: the largest of these spare most of the others a walk
    constexpr Index one_in = 64;
    const auto measure_all = [&] {
      for(bool is_first : { true, false })
        for(Index f = 0; f < s_.mesh.face_end(); ++f)
          if((f % one_in == 0) == is_first && s_.mesh.is_face(f)) measure_face(f);
    };
    measure_all();
    if(is_careful_ || to_reference_.settle(s_.surface)) return;
    asks_tree_ = true;
    measure_all();
    asks_tree_ = false;
  }

  void measure_face(Index f)
  {
    const Quad_complex& m = s_.mesh;
    const double at[9][2] = { { .5, .5 }, { .25, .25 }, { .75, .25 }, { .75, .75 }, { .25, .75 },
                              { .5, 0. }, { 1., .5 },   { .5, 1. },   { 0., .5 } };
    const Corners p = s_.corners(f);
    if(is_near_own_triangles(f, p)) return;
    Index hint = s_.triangle_near(f, p[0]);
    for(int k = 0; k < 9; ++k) {
      const Index h = 4 * f + k - 5, o = k < 5 ? Index(-1) : m.opposite(h);
      if(k >= 5 && (m.curve(h) >= 0 || o > h)) continue; // measured as a curve, or over there
      const double u = at[k][0], v = at[k][1];
      const Vec q = (1 - v) * ((1 - u) * p[0] + u * p[1]) + v * (u * p[2] + (1 - u) * p[3]);
      measure_to_surface(q, f, o < 0 ? f : m.face(o), hint);
    }
  }

  // Are all points of face f so near to its own triangles that they do not matter?
  bool is_near_own_triangles(Index f, const Corners& p)
  {
    if(!is_own_[f]) return false;
    const double bound = 0.25 * norm(p[0] - p[1] + p[2] - p[3]);
    if(!is_careful_)
      return bound <= to_reference_.threshold() ||
             height_above_halves(p) <= to_reference_.threshold();
    if(bound > care_) return false;
    note(f, bound, to_reference_);
    return true;
  }

  // A bound for how far the points of a convex face are above or below its halves: along their
  // common normal the diagonals lie in two planes, and between these everything does.
  static double height_above_halves(const Corners& p)
  {
    const Vec n = area_vector(p);
    for(int i = 0; i < 4; ++i)
      if(!(n * cross(p[(i + 1) & 3] - p[i], p[(i + 3) & 3] - p[i]) > 0))
        return (std::numeric_limits<double>::infinity)();
    return 0.5 * std::abs((p[0] - p[1] + p[2] - p[3]) * n) / norm(n);
  }

  // Of a point of faces f and g.  Walking over the surface may stop at a border or behind a fold,
  // too far away.
  void measure_to_surface(const Vec& q, Index f, Index g, Index& hint)
  {
    const double enough = is_careful_ ? care_ : to_reference_.threshold();
    double d = s_.surface.distance_from(q, enough, hint);
    if(d <= enough && !is_careful_) return; // it may be less, but does not matter
    if(d > enough) {
      const Index k = s_.mesh.patch(f);
      const Index patch = k < Index(s_.reference_patch.size()) ? s_.reference_patch[k] : Index(-1);
      const Vec direction = area_vector(s_.corners(f));
      if(!is_careful_ && !asks_tree_) return to_reference_.doubt(d, q, patch, direction);
      Index nearer = s_.surface.find_nearer(q, patch, direction, d);
      if(nearer >= 0) {
        hint = nearer;
        d = (std::min)(d, distance(q, s_.surface.project(q, hint)));
      }
    }
    note(f, d, to_reference_);
    note(g, d, to_reference_);
  }

  void measure_curves()
  {
    const Quad_complex& m = s_.mesh;
    for(Index h = 0; h < 4 * m.face_end(); ++h) {
      if(!m.is_face(m.face(h)) || m.curve(h) < 0 || m.opposite(h) > h) continue;
      const Feature_curve& c = s_.curves[m.curve(h)];
      const Vec &a = m.point(m.origin(h)), e = m.point(m.target(h)) - a;
      double su, sv, largest = 0;
      ends_on_curve(s_, h, su, sv);
      const double l = c.difference(su, sv);
      const auto look_at = [&](double offset) {
        Vec p = c.point(su + offset);
        if(s_.curve_lift && !c.is_frozen()) p = s_.curve_lift(p);
        const double t = (std::min)((std::max)((p - a) * e / (e * e), 0.), 1.);
        largest = (std::max)(largest, distance(p, a + t * e));
      };
      for(int k = 1; k < curve_samples; ++k) look_at(l * k / curve_samples);
      for_each_arc(c, su, l, look_at);
      note(m.face(h), largest, from_reference_);
      to_reference_.note(largest);
      if(m.opposite(h) >= 0) note(m.face(m.opposite(h)), largest, from_reference_);
    }
  }

  // What a small change has left as it was is on its own triangles, and looked at only near faces
  // that are others now.
  void measure_reference()
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
    if(is_careful_ || from_reference_.settle(mesh_)) return;
    asks_tree_ = true;
    measure_triangles();
  }

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
    const int n = s_.surface.has_lift() ? 4 : 2;
    for(int i = 0; i <= n; ++i)
      for(int j = 0; i + j <= n; ++j) {
        const int k = n - i - j, corner = i == n ? 0 : j == n ? 1 : k == n ? 2 : -1;
        if(corner >= 0 && foot_[corners[corner]] >= 0) continue;
        measure_back((double(i) / n) * c[0] + (double(j) / n) * c[1] + (double(k) / n) * c[2], t,
                     hint);
        if(corner >= 0) foot_[corners[corner]] = hint;
      }
    measure_back((c[0] + c[1] + c[2]) / 3, t, hint);
  }

  // Are all points of a triangle so near to the mesh that they do not matter?  One look tells it of
  // most where the mesh is much coarser than the reference.
  bool is_near_enough(const std::array<Vec, 3>& c, Index& hint) const
  {
    if(is_careful_ || hint < 0 || s_.surface.has_lift()) return false;
    const Vec centre = (c[0] + c[1] + c[2]) / 3;
    const double radius =
        (std::max)({ distance(c[0], centre), distance(c[1], centre), distance(c[2], centre) });
    const double enough = from_reference_.threshold() - radius;
    return enough > radius && mesh_.distance_from(centre, enough, hint) <= enough;
  }

  void measure_back(Vec p, Index t, Index& hint)
  {
    const Vec direction = s_.surface.normal(t);
    p = s_.surface.lifted(p, t);
    if(hint < 0) hint = mesh_.find(p, -1, direction);
    const double enough = is_careful_ ? care_ : from_reference_.threshold();
    double d = mesh_.distance_from(p, enough, hint);
    if(!is_careful_ && !asks_tree_) {
      if(d > enough) from_reference_.doubt(walked_anew(p, t, d, hint), p, -1, direction);
      return;
    }
    if(d > enough && !(is_careful_ && d <= of_face_[face_of_[hint / 2]])) {
      Index nearer = mesh_.find_nearer(p, -1, direction, d);
      if(nearer >= 0) {
        d = (std::min)(d, distance(p, mesh_.project(p, nearer)));
        hint = nearer;
      }
    }
    note(face_of_[hint / 2], d, from_reference_);
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
  double care_;
  bool is_careful_, asks_tree_ = false;
  std::vector<double> of_face_;
  Largest_distance to_reference_, from_reference_;
  Reference_surface mesh_;      // the faces, each cut in two
  std::vector<Index> face_of_;  // of each pair of triangles
  std::vector<Index> place_of_; // among those, by face
  std::vector<char> is_own_;    // is a face two triangles of the reference?
  std::vector<Index> start_;    // by triangle of the reference: one of the mesh near it, or -1
  std::vector<Index> foot_;     // by vertex of the reference: the triangle nearest to it
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISTANCE_MEASURE_H
