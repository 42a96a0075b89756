// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISTANCE_MEASURE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISTANCE_MEASURE_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/Distance_climb.h>
#include <CGAL/Quad_mesh_adaptation/internal/Distance_from_reference.h>
#include <CGAL/Quad_mesh_adaptation/internal/Face_figures.h>
#include <CGAL/Quad_mesh_adaptation/internal/Largest_distance.h>
#include <CGAL/Quad_mesh_adaptation/internal/curve_order.h>
#include <CGAL/Quad_mesh_adaptation/internal/own_triangles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
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
// be it are looked at again in the end.  From the farthest sample of a face, and with `care` of a
// triangle, the distance is followed upwards, where that may come to matter.
class Distance_measure
{
public:
  // `own`: the farthest of the faces that an input which is its own reference has had.
  explicit Distance_measure(const Adaptation_state& s, double care = only_largest,
                            const std::optional<Farthest_face>& own = std::nullopt,
                            Between_samples between = Between_samples::climbed)
      : s_(s), by_face_(s.mesh.face_end(), care), climb_(between, by_face_.is_careful())
  {
    measure_curves();
    if(s_.surface.is_planar()) return;
    is_own_ = faces_with_own_triangles(s_);
    use(own);
    Distance_from_reference measure_back(s_, is_own_, by_face_, from_reference_, between);
    // neither knows of the other, but for what is noted of each face
    Workers one_by_one;
    (by_face_.is_careful() ? one_by_one : s_.workers).run(2, [&](std::size_t i) {
      i == 0 ? measure_faces() : measure_back();
    });
  }

  // No face needs care.
  static constexpr double only_largest = std::numeric_limits<double>::infinity();

  // Of those that consist of their own triangles, if one of them is the farthest of all.
  std::optional<Farthest_face> farthest_own() const
  {
    const Index f = to_reference_.face();
    if(f < 0 || is_own_.empty() || !is_own_[f]) return std::nullopt;
    return Farthest_face{ f, to_reference_.value() };
  }

  double to_reference() const { return to_reference_.value(); }
  double from_reference() const { return from_reference_.value(); }
  // With `care`: the larger of both for what was found on face f; rather too much, but where it is
  // above `care`.
  double of(Index f) const { return by_face_[f]; }

private:
  static constexpr int curve_samples = 8;

  // While that is still there no other face that has been left as it was is farther.
  void use(const std::optional<Farthest_face>& own)
  {
    if(!own || own->face >= Index(is_own_.size()) || !is_own_[own->face]) return;
    is_own_known_ = true;
    to_reference_.note(own->distance, own->face);
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
    if(by_face_.is_careful() || to_reference_.settle(s_.surface)) return;
    asks_tree_ = true;
    measure_all();
    asks_tree_ = false;
  }

  void measure_face(Index f)
  {
    const Quad_complex& m = s_.mesh;
    const double at[9][2] = { { .5, .5 }, { .25, .25 }, { .75, .25 }, { .75, .75 }, { .25, .75 },
                              { .5, 0. }, { 1., .5 },   { .5, 1. },   { 0., .5 } };
    if(is_own_known_ && is_own_[f]) return;
    const Corners p = s_.corners(f);
    if(is_near_own_triangles(f, p)) return;
    Index hint = triangle_near(f, p[0]);
    Farthest_sample farthest;
    for(int k = 0; k < 9; ++k) {
      const Index h = 4 * f + k - 5, o = k < 5 ? Index(-1) : m.opposite(h);
      if(k >= 5 && (m.curve(h) >= 0 || o > h)) continue; // measured as a curve, or over there
      const double d =
          measure_to_surface(bilinear(p, at[k][0], at[k][1]), f, o < 0 ? f : m.face(o), hint);
      farthest.note(d, { at[k][0], at[k][1] }, hint);
    }
    const double d = farthest.distance;
    if(climb_.is_any() && d > enough_at_sample() && !by_face_.has_more_than_care(d))
      measure_between(f, p, farthest);
  }

  // A sample that is no farther off does not matter, nor do the points near it, most likely.
  double enough_at_sample() const { return by_face_.enough(to_reference_) / climb_.likely_gain(); }

  static Vec bilinear(const Corners& p, double u, double v)
  {
    return (1 - v) * ((1 - u) * p[0] + u * p[1]) + v * (u * p[2] + (1 - u) * p[3]);
  }

  // Between the samples of face f.
  void measure_between(Index f, const Corners& p, const Farthest_sample& farthest)
  {
    constexpr std::array<Distance_climb::Place, 8> moves = {
      { { 1, 0 }, { 0, 1 }, { -1, 0 }, { 0, -1 }, { 1, 1 }, { -1, 1 }, { -1, -1 }, { 1, -1 } }
    };
    Index hint = farthest.hint;
    const Distance_climb::Place q =
        climb_(farthest.place, farthest.distance, 0.25, moves,
               [&](const Distance_climb::Place& to, double d) {
                 if((std::min)(to[0], to[1]) < 0 || (std::max)(to[0], to[1]) > 1) return -1.;
                 return s_.surface.distance_from(bilinear(p, to[0], to[1]), d, hint);
               });
    if(q != farthest.place) measure_to_surface(bilinear(p, q[0], q[1]), f, f, hint);
  }

  // The first faces that have no corner on the surface do not make it build a tree.
  Index triangle_near(Index f, const Vec& p)
  {
    const Index hint = s_.triangle_about(f);
    if(hint >= 0 || scans_left_ == 0) return hint >= 0 ? hint : s_.triangle_near(f, p);
    --scans_left_;
    const Vec direction = area_vector(s_.corners(f));
    const Index found = s_.surface.scan_nearer(p, s_.reference_patch_of(f), direction, 1e150);
    return found >= 0 ? found : s_.triangle_near(f, p);
  }

  // Are all points of face f so near to its own triangles that they do not matter?
  bool is_near_own_triangles(Index f, const Corners& p)
  {
    if(!is_own_[f]) return false;
    const double bound = 0.25 * norm(p[0] - p[1] + p[2] - p[3]);
    if(!by_face_.is_careful())
      return bound <= to_reference_.threshold() ||
             height_above_halves(p) <= to_reference_.threshold();
    if(bound > by_face_.care()) return false;
    by_face_.note(f, bound, to_reference_);
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

  // Of a point of faces f and g; returns the distance, or something that does not matter.  Walking
  // over the surface may stop at a border or behind a fold, too far away.
  double measure_to_surface(const Vec& q, Index f, Index g, Index& hint)
  {
    const double enough = by_face_.enough(to_reference_);
    double d = s_.surface.distance_from(q, enough_at_sample(), hint);
    if(d <= enough && !by_face_.is_careful()) return d; // it may be less, but does not matter
    if(d > enough) {
      const Index patch = s_.reference_patch_of(f);
      const Vec direction = area_vector(s_.corners(f));
      if(!by_face_.is_careful() && !asks_tree_) {
        to_reference_.doubt(d, q, patch, direction, f);
        return d;
      }
      Index nearer = s_.surface.find_nearer(q, patch, direction, d);
      if(nearer >= 0) {
        hint = nearer;
        d = (std::min)(d, distance(q, s_.surface.project(q, hint)));
      }
    }
    by_face_.note(f, d, to_reference_);
    by_face_.note(g, d, to_reference_);
    return d;
  }

  void measure_curves()
  {
    const Quad_complex& m = s_.mesh;
    for(Index h : m.halfedges()) {
      if(m.curve(h) < 0 || m.opposite(h) > h) continue;
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
      by_face_.note(m.face(h), largest, from_reference_);
      to_reference_.note(largest);
      if(m.opposite(h) >= 0) by_face_.note(m.face(m.opposite(h)), largest, from_reference_);
    }
  }

  const Adaptation_state& s_;
  Distances_by_face by_face_;
  Distance_climb climb_;
  bool asks_tree_ = false, is_own_known_ = false;
  int scans_left_ = 8; // of all triangles, each takes a few per cent of building a tree
  Largest_distance to_reference_, from_reference_;
  std::vector<char> is_own_; // is a face two triangles of the reference?
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISTANCE_MEASURE_H
