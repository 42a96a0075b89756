// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISTANCE_MEASURE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISTANCE_MEASURE_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/Input_mesh.h>
#include <CGAL/Quad_mesh_adaptation/internal/curve_order.h>

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
// A distance is the one within the patch.  From the reference it is found by walking over the mesh,
// which may stop too far away; where that gives more than `care` for its face a tree is asked.
// Without `care` only the largest counts: those that may be it are looked at again in the end.
class Distance_measure
{
public:
  explicit Distance_measure(const Adaptation_state& s,
                            double care = (std::numeric_limits<double>::infinity)())
      : s_(s), care_(care), of_face(s.mesh.face_end(), 0.), asks_tree_(std::isfinite(care))
  {
    measure_curves();
    measure_faces();
    measure_reference();
  }

  double to_reference() const { return to_reference_; }
  double from_reference() const { return from_reference_; }
  // The larger of both for what was found on face f: rather too much, but where it is above `care`.
  double of(Index f) const { return of_face[f]; }
  // The face that vertex v of the reference is nearest to; -1 on a plane, where none is looked for.
  Index face_below(Index v) const { return face_below_.empty() ? Index(-1) : face_below_[v]; }

private:
  static constexpr int curve_samples = 8;

  void note(Index f, double d, double& largest)
  {
    of_face[f] = (std::max)(of_face[f], d);
    largest = (std::max)(largest, d);
  }

  void measure_faces()
  {
    const Quad_complex& m = s_.mesh;
    if(s_.surface.is_planar()) return;
    const double at[9][2] = { { .5, .5 }, { .25, .25 }, { .75, .25 }, { .75, .75 }, { .25, .75 },
                              { .5, 0. }, { 1., .5 },   { .5, 1. },   { 0., .5 } };
    for(Index f = 0; f < m.face_end(); ++f) {
      if(!m.is_face(f)) continue;
      const Corners p = s_.corners(f);
      Index hint = s_.triangle_near(f, p[0]);
      for(int k = 0; k < 9; ++k) {
        const Index h = 4 * f + k - 5, o = k < 5 ? Index(-1) : m.opposite(h);
        if(k >= 5 && (m.curve(h) >= 0 || o > h)) continue; // measured as a curve, or over there
        const double u = at[k][0], v = at[k][1];
        const Vec q = (1 - v) * ((1 - u) * p[0] + u * p[1]) + v * (u * p[2] + (1 - u) * p[3]);
        const double d = to_surface(q, f, hint);
        note(f, d, to_reference_);
        if(o >= 0) note(m.face(o), d, to_reference_);
      }
    }
  }

  // Walking over the surface may stop at a border or behind a fold, too far away.
  double to_surface(const Vec& q, Index f, Index& hint) const
  {
    const double d = distance(q, s_.surface.project(q, hint));
    if(d <= to_reference_ && d <= care_) return d;
    const Index k = s_.mesh.patch(f);
    const Index patch = k < Index(s_.reference_patch.size()) ? s_.reference_patch[k] : Index(-1);
    Index nearer = s_.surface.find_nearer(q, patch, area_vector(s_.corners(f)), d);
    if(nearer < 0) return d;
    hint = nearer;
    return (std::min)(d, distance(q, s_.surface.project(q, hint)));
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
      to_reference_ = (std::max)(to_reference_, largest);
      if(m.opposite(h) >= 0) note(m.face(m.opposite(h)), largest, from_reference_);
    }
  }

  // Calls f(offset from s) for the points of the polyline between s and s + l.
  template <typename F>
  static void for_each_arc(const Feature_curve& c, double s, double l, const F& f)
  {
    const std::vector<double>& arcs = c.arcs();
    const double low = c.wrapped(l < 0 ? s + l : s), span = std::abs(l);
    std::size_t i = std::size_t(std::upper_bound(arcs.begin(), arcs.end(), low) - arcs.begin());
    for(std::size_t seen = 0; seen < arcs.size(); ++seen, ++i) {
      if(i == arcs.size()) {
        if(!c.is_closed()) return;
        i = 0;
      }
      double up = arcs[i] - low;
      if(up < 0) up += c.length();
      if(up >= span) return;
      f(l < 0 ? up + l : up);
    }
  }

  void measure_reference()
  {
    if(s_.surface.is_planar()) return;
    collect_mesh();
    if(is_mesh_the_reference()) return;
    find_starts();
    measure_triangles();
    if(!are_doubts_settled()) {
      asks_tree_ = true;
      measure_triangles();
    }
    face_below_.assign(s_.surface.points().size(), -1);
    for(std::size_t v = 0; v < foot_.size(); ++v)
      if(foot_[v] >= 0) face_below_[v] = face_of_[foot_[v] / 2];
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
    for(bool is_known : { true, false })
      for(Index first = 0; first < n; ++first) {
        if(is_known && start_[first] < 0) continue;
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

  // An input that is its own reference, before anything is done: no point is off the mesh.
  bool is_mesh_the_reference()
  {
    if(s_.surface.has_lift() || mesh_.triangles() != s_.surface.triangles() ||
       mesh_.points() != s_.surface.points())
      return false;
    face_below_.assign(s_.surface.points().size(), -1);
    for(std::size_t t = mesh_.triangles().size(); t-- > 0;)
      for(Index v : mesh_.triangles()[t]) face_below_[v] = face_of_[t / 2];
    return true;
  }

  void measure_triangle(Index t)
  {
    const std::array<Index, 3> corners = s_.surface.triangles()[t];
    const std::array<Vec, 3> c = s_.surface.triangle(t);
    Index hint = start_[t];
    for(Index v : corners)
      if(foot_[v] >= 0) hint = foot_[v];
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

  void measure_back(Vec p, Index t, Index& hint)
  {
    const Vec direction = s_.surface.normal(t);
    p = s_.surface.lifted(p, t);
    if(hint < 0) hint = mesh_.find(p, -1, direction);
    double d = distance(p, mesh_.project(p, hint));
    if(!asks_tree_ && d > from_reference_) {
      d = walked_anew(p, t, d, hint);
      of_face[face_of_[hint / 2]] = (std::max)(of_face[face_of_[hint / 2]], d);
      return doubt(d, p, direction);
    }
    if(d > from_reference_ || (d > care_ && d > of_face[face_of_[hint / 2]])) {
      Index nearer = mesh_.find_nearer(p, -1, direction, d);
      if(nearer >= 0) {
        d = (std::min)(d, distance(p, mesh_.project(p, nearer)));
        hint = nearer;
      }
    }
    note(face_of_[hint / 2], d, from_reference_);
  }

  // A distance by walking that may be the largest.
  struct Doubt
  {
    double distance;
    Vec p, direction;
  };

  // A walk that seems to end far off may have been lost from the triangle before on: so it is done
  // again from the triangle's own start.
  double walked_anew(const Vec& p, Index t, double d, Index& hint) const
  {
    if(start_[t] < 0 || (doubts_.size() == most_doubts && d <= doubts_.back().distance)) return d;
    Index other = start_[t];
    const double again = distance(p, mesh_.project(p, other));
    if(!(again < d)) return d;
    hint = other;
    return again;
  }

  // Keeps the largest few, in order.
  void doubt(double d, const Vec& p, const Vec& direction)
  {
    if(doubts_.size() == most_doubts) {
      if(!(d > doubts_.back().distance)) return;
      doubts_.pop_back();
    }
    const auto place = std::find_if(doubts_.begin(), doubts_.end(),
                                    [d](const Doubt& x) { return x.distance < d; });
    doubts_.insert(place, { d, p, direction });
  }

  // False if the largest may be among those not kept: all but a few walks went wrong.
  bool are_doubts_settled()
  {
    for(const Doubt& x : doubts_) {
      if(x.distance <= from_reference_) return true;
      const Index nearer = mesh_.scan_nearer(x.p, x.direction, x.distance);
      double d = x.distance;
      if(nearer >= 0) d = distance(x.p, closest_on_triangle(x.p, mesh_.triangle(nearer)).point);
      from_reference_ = (std::max)(from_reference_, d);
    }
    return doubts_.size() < most_doubts || doubts_.back().distance <= from_reference_;
  }

  // The faces, each cut in two; what lies across their sides is known.
  void collect_mesh()
  {
    const Quad_complex& m = s_.mesh;
    Triangle_soup soup;
    soup.points.reserve(m.vertex_end());
    soup.triangles.reserve(2 * std::size_t(m.number_of_faces()));
    for(Index v = 0; v < m.vertex_end(); ++v) soup.points.push_back(m.point(v));
    std::vector<Index> first_side(m.face_end(), -1); // of the first triangle of a face
    for(Index f = 0; f < m.face_end(); ++f) {
      if(!m.is_face(f)) continue;
      first_side[f] = Index(4 * face_of_.size());
      append_quad(soup, m.quad(f));
      if(soup.triangles.back()[0] != m.origin(4 * f)) ++first_side[f];
      face_of_.push_back(f);
    }
    std::vector<std::array<Index, 3>> across(soup.triangles.size(), { -1, -1, -1 });
    for(std::size_t k = 0; k < face_of_.size(); ++k) {
      const Index f = face_of_[k], turned = first_side[f] & 3;
      across[2 * k][2] = Index(2 * k + 1);
      across[2 * k + 1][0] = Index(2 * k);
      for(Index i = 0; i < 4; ++i) {
        const Index o = m.opposite(4 * f + ((i + turned) & 3));
        if(o < 0) continue;
        const Index there = first_side[m.face(o)], j = ((o & 3) - (there & 3)) & 3;
        across[2 * k + std::size_t(i / 2)][i - i / 2] = 2 * (there / 4) + j / 2;
      }
    }
    mesh_ = Reference_surface(std::move(soup.points), std::move(soup.triangles), std::move(across));
    mesh_.expect_few_questions();
  }

  static constexpr std::size_t most_doubts = 16;

  const Adaptation_state& s_;
  double care_;
  std::vector<double> of_face;
  double to_reference_ = 0, from_reference_ = 0;
  Reference_surface mesh_;        // the faces, each cut in two
  std::vector<Index> face_of_;    // of each pair of triangles
  std::vector<Index> start_;      // by triangle of the reference: one of the mesh near it, or -1
  std::vector<Index> foot_;       // by vertex of the reference: the triangle nearest to it
  std::vector<Index> face_below_; // by vertex of the reference
  bool asks_tree_ = false;        // about every distance that seems to be the largest so far
  std::vector<Doubt> doubts_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISTANCE_MEASURE_H
