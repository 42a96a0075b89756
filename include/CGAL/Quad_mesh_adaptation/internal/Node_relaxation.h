// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_NODE_RELAXATION_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_NODE_RELAXATION_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/Star_face.h>
#include <CGAL/Quad_mesh_adaptation/internal/barycentric_weights.h>
#include <CGAL/Quad_mesh_adaptation/internal/relaxation_terms.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

struct Node_relaxation_access; // for the tests of the derivatives

// Best position of one node with its neighbours held: damped Newton on shape and size.
class Node_relaxation
{
  friend struct Node_relaxation_access;

public:
  explicit Node_relaxation(const Adaptation_state& state) : s_(state) {}

  std::vector<Star_face>& star() { return star_; }
  std::vector<Pull>& pulls() { return pulls_; }

  // Moves r to a better place and tells whether it did.  No corner of the star gets worse than
  // the worst before, or than the floor (smoothing.min_corner).
  // Precondition: r.h is the size at r.p.
  bool operator()(Vertex_record& r)
  {
    const int dofs = directions(r);
    if(dofs == 0) return false;
    Local_model m;
    const Evaluation before = evaluate(r, &m);
    double step[2] = { 0, 0 };
    if(!newton_step(m, dofs, step)) return false;
    return line_search(r, dofs, step, before);
  }

  // The worst corner of the star after the last move, or how its faces follow the surface where
  // that is less.
  double worst() const { return worst_; }

  // The share of an edge from which on a move counts; valid after one.
  double wake() const { return wake_; }

  double objective(const Vertex_record& r) const { return evaluate(r).value; }

private:
  // Basis of the directions r may move in; returns their number.
  int directions(const Vertex_record& r) const
  {
    if(r.frozen || r.carrier == Carrier::corner) return 0;
    if(r.carrier == Carrier::curve) {
      if(s_.curves[r.curve].is_frozen()) return 0;
      t_[0] = s_.curves[r.curve].tangent(r.param);
      t_[1] = Vec(0, 0, 0);
      return 1;
    }
    t_ = tangents(r.normal);
    return 2;
  }

  // What cost and derivatives of a face need of the node's position.  D and N by corner, from
  // the node counter-clockwise: n . (a x b) and |a|^2 + |b|^2 of the corner's edges a and b.
  struct Face_terms
  {
    Vec a1, a3, n; // from the node to q1 and q3; the face's normal
    double N[4], D[4], l1, l3, following;
    double x1[2], x3[2]; // a1, a3 along the directions of motion
    bool folded;
  };

  static void measure_face(const Star_face& f, const Vec& x, const Vec& normal, Face_terms& t)
  {
    t.a1 = f.q1 - x;
    t.a3 = f.q3 - x;
    const Vec cross0 = cross(t.a1, t.a3), area = cross0 + f.cross2, ref = f.reference.sum + normal;
    const double a2 = area * area, r2 = ref * ref, both = area * ref;
    // as in Adaptation_state::is_folded
    t.folded = r2 > 0.49 && !(both > 0 && both * both > 0.01 * a2 * r2);
    t.n = t.folded ? (1 / std::sqrt(r2)) * ref : a2 > 0 ? (1 / std::sqrt(a2)) * area : Vec(0, 0, 0);
    const double n1 = t.a1 * t.a1, n3 = t.a3 * t.a3, whole = t.n * area;
    t.l1 = std::sqrt(n1);
    t.l3 = std::sqrt(n3);
    t.N[0] = n1 + n3;
    t.N[1] = n1 + f.n1;
    t.N[2] = f.n1 + f.n3;
    t.N[3] = f.n3 + n3;
    // opposite corners add up to the cross product of the diagonals
    t.D[0] = t.n * cross0;
    t.D[1] = t.n * cross(t.a1, f.e1);
    t.D[2] = whole - t.D[0];
    t.D[3] = whole - t.D[1];
    Facing facing = f.reference;
    facing.add(normal);
    t.following = following(facing.mean_cosine(t.n));
  }

  // The objective with the node at r, and its derivatives if m is given.
  Evaluation evaluate(const Vertex_record& r, Local_model* m = nullptr) const
  {
    const Smoothing_weights& w = s_.smoothing;
    const bool sized = w.size > 0 || w.hinge > 0;
    Evaluation e;
    Face_terms t;
    for(const Star_face& f : star_) {
      measure_face(f, r.p, r.normal, t);
      const bool turned = t.n * r.normal < 0; // as a node gone round a thin rim would see it
      e.worst = (std::min)(e.worst, t.folded || turned ? -1. : t.following);
      const Corner_terms c[4] = { add_corner(t.N[0], t.D[0], e), add_corner(t.N[1], t.D[1], e),
                                  add_corner(t.N[2], t.D[2], e), add_corner(t.N[3], t.D[3], e) };
      e.inverted +=
          t.folded || t.following < 0 || (std::min)({ c[0].t, c[1].t, c[2].t, c[3].t }) <= 0;
      if(m) {
        for(int k = 0; k < 2; ++k) {
          t.x1[k] = t.a1 * t_[k];
          t.x3[k] = t.a3 * t_[k];
        }
        add_shape_slopes(f, t, c, *m);
      }
      if(!sized) continue;
      const double h = f.target(r.h), ratio = 0.25 * (t.l1 + t.l3 + f.l) / h;
      if(ratio > e.largest) e.largest = ratio;
      double d1, d2;
      e.value += size_cost(w, ratio, d1, d2);
      if(m) add_size_slopes(f, t, h, ratio, d1, d2, *m);
    }
    for(const Pull& p : pulls_) add_pull(p, r.p, e, m);
    return e;
  }

  // The point of a face that is nearest to its witness moves with the node by its weight there.
  void add_pull(const Pull& pull, const Vec& x, Evaluation& e, Local_model* m) const
  {
    const Star_face& f = star_[pull.face];
    const Witness& w = *pull.witness;
    const std::array<Vec, 3> a = { x, f.q1, pull.from_node ? f.q2 : f.q3 },
                             b = { pull.from_node ? x : f.q1, f.q2, f.q3 };
    const Vec qa = closest_on_triangle(w.p, a).point;
    const double da = (w.p - qa).squared_length(), enough = w.allowed * w.allowed;
    if(da <= enough) return;
    const Vec qb = closest_on_triangle(w.p, b).point;
    const double db = (w.p - qb).squared_length();
    if(db <= enough) return;
    const bool first = da <= db;
    const Vec q = first ? qa : qb;
    const double d = std::sqrt(first ? da : db), over = (d - w.allowed) * w.inverse_h;
    e.value += w.cost_at(d);
    if(!m || (!first && !pull.from_node)) return;
    const double share = barycentric_weights(first ? a : b, q)[0] * w.inverse_h / d;
    const double s[2] = { share * ((q - w.p) * t_[0]), share * ((q - w.p) * t_[1]) };
    const double c1 = 2 * Witness::weight * (std::min)(over, 1.), c2 = 2 * Witness::weight;
    for(int k = 0; k < 2; ++k) m->g[k] += c1 * s[k];
    m->H[0] += c2 * s[0] * s[0];
    m->H[1] += c2 * s[0] * s[1];
    m->H[2] += c2 * s[1] * s[1];
  }

  // Is no face too large, by the exact sizes, with the node at r, or none more so than one is now?
  // Most moves that fail do so by one face, so the one that is largest by the estimate goes first.
  bool keeps_within_size(const Vertex_record& r, const Vec& now) const
  {
    const std::size_t first = largest_face(r);
    for(std::size_t i = 0; i < star_.size(); ++i) {
      const Star_face& f = star_[i == 0 ? first : i <= first ? i - 1 : i];
      const double ratio = ratio_with(f, r.p);
      if(ratio > 1 && ratio > largest_now(now)) return false;
    }
    return true;
  }

  std::size_t largest_face(const Vertex_record& r) const
  {
    std::size_t largest = 0;
    double most = 0;
    for(std::size_t i = 0; i < star_.size(); ++i) {
      const Star_face& f = star_[i];
      const double ratio = (distance(r.p, f.q1) + distance(r.p, f.q3) + f.l) / f.target(r.h);
      if(ratio > most) most = ratio, largest = i;
    }
    return largest;
  }

  double ratio_with(const Star_face& f, const Vec& x) const
  {
    const Corners p = { x, f.q1, f.q2, f.q3 };
    return mean_edge_length(p) / s_.target(p, f.floor);
  }

  // Largest size ratio of the star before the node moves.
  double largest_now(const Vec& now) const
  {
    if(largest_now_ >= 0) return largest_now_;
    largest_now_ = 0;
    for(const Star_face& f : star_) {
      const double ratio = f.face < 0 ? ratio_with(f, now)
                                      : mean_edge_length({ now, f.q1, f.q2, f.q3 }) /
                                            (std::max)(s_.wanted_size(f.face), f.floor);
      largest_now_ = (std::max)(largest_now_, ratio);
    }
    return largest_now_;
  }

  // Derivatives of the shape cost of one face, normals frozen.  Both edges depend on the node at
  // corner 0, one at its neighbours, none at corner 2 (but through the normal).
  void add_shape_slopes(const Star_face& f, const Face_terms& t, const Corner_terms* c,
                        Local_model& m) const
  {
    const Vec w = t.a3 - t.a1;
    double dN[3][2], dD[3][2];
    for(int k = 0; k < 2; ++k) {
      const Vec p = cross(t_[k], t.n); // (n x u) . t = u . (t x n)
      dN[0][k] = -2 * (t.x1[k] + t.x3[k]);
      dN[1][k] = -2 * t.x1[k];
      dN[2][k] = -2 * t.x3[k];
      dD[0][k] = w * p;
      dD[1][k] = f.e1 * p;
      dD[2][k] = -(f.e3 * p);
    }
    add_corner_slopes(c[0], 4, dN[0], dD[0], m);
    add_corner_slopes(c[1], 2, dN[1], dD[1], m);
    add_corner_slopes(c[3], 2, dN[2], dD[2], m);
  }

  void add_size_slopes(const Star_face& f, const Face_terms& t, double h, double r, double d1,
                       double d2, Local_model& m) const
  {
    if(!(t.l1 > 0 && t.l3 > 0)) return;
    const double i1 = 1 / t.l1, i3 = 1 / t.l3, q = 0.25 / h;
    const double slope = h > f.floor ? 4 * f.factor * r : 0.;
    const double ax = -t.x1[0] * i1, ay = -t.x1[1] * i1, bx = -t.x3[0] * i3, by = -t.x3[1] * i3;
    const double x = q * (ax + bx - slope * (f.grad_h * t_[0])),
                 y = q * (ay + by - slope * (f.grad_h * t_[1]));
    m.g[0] += d1 * x;
    m.g[1] += d1 * y;
    m.H[0] += d2 * x * x + d1 * q * ((1 - ax * ax) * i1 + (1 - bx * bx) * i3);
    m.H[1] += d2 * x * y - d1 * q * (ax * ay * i1 + bx * by * i3);
    m.H[2] += d2 * y * y + d1 * q * ((1 - ay * ay) * i1 + (1 - by * by) * i3);
  }

  bool line_search(Vertex_record& r, int dofs, const double* step, const Evaluation& before)
  {
    double reach2 = 0;
    for(const Star_face& f : star_)
      reach2 = (std::max)({ reach2, (r.p - f.q1).squared_length(), (r.p - f.q3).squared_length() });
    const double reach = std::sqrt(reach2);
    double length = 0;
    for(int i = 0; i < dofs; ++i) length += step[i] * step[i];
    length = std::sqrt(length);
    const Smoothing_weights& w = s_.smoothing;
    wake_ = w.hinge > 0 && before.largest > 1 ? (std::min)(w.wake, w.pressed_wake) : w.wake;
    if(!(length > 0.25 * wake_ * reach)) return false; // not worth a trial
    double scale = (std::min)(1., 0.5 * reach / length);
    largest_now_ = -1;
    for(int attempt = 0; attempt < 4; ++attempt, scale *= 0.35) {
      Vertex_record t = r;
      if(r.carrier == Carrier::curve)
        t.param = r.param + scale * step[0];
      else
        t.p = r.p + (scale * step[0]) * t_[0] + (scale * step[1]) * t_[1];
      s_.place(t);
      const Evaluation after = evaluate(t);
      if(after.value < before.value - 1e-7 * std::abs(before.value) &&
         after.inverted <= before.inverted &&
         after.worst >= (std::min)(before.worst, s_.smoothing.min_corner) &&
         (!s_.smoothing.keep_within_size || keeps_within_size(t, r.p))) {
        r = t;
        worst_ = after.worst;
        return true;
      }
    }
    return false;
  }

  const Adaptation_state& s_;
  std::vector<Star_face> star_;
  std::vector<Pull> pulls_;
  double worst_ = 1, wake_ = 0;
  mutable double largest_now_ = -1; // negative: not known
  mutable std::array<Vec, 2> t_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_NODE_RELAXATION_H
