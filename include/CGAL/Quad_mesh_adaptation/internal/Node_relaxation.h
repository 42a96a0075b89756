// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_NODE_RELAXATION_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_NODE_RELAXATION_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>

#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// A face as seen from one of its corners, the node that moves.
struct Star_face
{
  Vec q1, q2, q3; // the other corners, counter-clockwise
  Vec reference;  // direction the face should show
  Vec grad_h;     // of the size, along the face; for the derivative only
  double floor = 0;
  double target = 0; // wanted size where the node stands before it moves
};

// Value, gradient and Hessian in the (at most two) directions a node may move in.
struct Local_model
{
  double g[2] = { 0, 0 };
  double H[3] = { 0, 0, 0 }; // xx, xy, yy
};

struct Node_relaxation_access; // for the tests of the derivatives

// Best position of one node with its neighbours held: damped Newton on shape and size.
class Node_relaxation
{
  friend struct Node_relaxation_access;

public:
  explicit Node_relaxation(const Adaptation_state& state) : s_(state) {}

  std::vector<Star_face>& star() { return star_; }

  // Moves r to a better place and tells whether it did.  No corner of the star gets worse than
  // the worst before, or than the floor (smoothing.min_corner).
  bool operator()(Vertex_record& r)
  {
    const int dofs = directions(r);
    if(dofs == 0) return false;
    ask_sizes(r.p);
    const Evaluation before = evaluate(r.p, r.normal, true);
    Local_model m;
    for(const Star_face& f : star_) add_derivatives(r, f, dofs, m);
    double step[2] = { 0, 0 };
    if(!newton_step(m, dofs, step)) return false;
    return line_search(r, dofs, step, before);
  }

  double objective(const Vertex_record& r) const { return evaluate(r.p, r.normal).value; }

  // Moves shorter than this fraction of the edges are not worth a trial.
  static constexpr double least_move = 5e-4;

private:
  static double integer_power(double x, int n)
  {
    double result = 1;
    for(; n > 0; n >>= 1, x *= x)
      if(n & 1) result *= x;
    return result;
  }

  // The sizes of the star with the node at x, once for value and derivatives.
  void ask_sizes(const Vec& x)
  {
    const Smoothing_weights& w = s_.smoothing;
    sized_ = w.size > 0 || w.hinge > 0 || w.keep_within_size;
    if(!sized_) return;
    for(Star_face& f : star_) f.target = s_.target({ x, f.q1, f.q2, f.q3 }, f.floor);
  }

  struct Evaluation
  {
    double value = 0, worst = 1; // worst corner t = 2 D / N
    double largest = 0;          // size ratio
  };

  // Basis of the directions r may move in; returns their number.
  int directions(const Vertex_record& r) const
  {
    if(r.frozen || r.carrier == Carrier::corner) return 0;
    if(r.carrier == Carrier::curve) {
      if(s_.curves[r.curve].is_frozen()) return 0;
      t_[0] = s_.curves[r.curve].tangent(r.param);
      return 1;
    }
    const Vec n = r.normal;
    const Vec a = std::abs(n.x()) < 0.6 ? Vec(1, 0, 0) : Vec(0, 1, 0);
    t_[0] = normalized(cross(n, a));
    t_[1] = cross(n, t_[0]);
    return 2;
  }

  // With `here`, x is where the node stands and the sizes are known.
  Evaluation evaluate(const Vec& x, const Vec& normal, bool here = false) const
  {
    Evaluation e;
    for(const Star_face& f : star_) {
      const Corners p = { x, f.q1, f.q2, f.q3 };
      if(Adaptation_state::is_folded(p, f.reference + normal)) e.worst = -1;
      const Vec n = Adaptation_state::facing(p, f.reference + normal);
      for(int i = 0; i < 4; ++i) {
        const Vec a = p[(i + 1) & 3] - p[i], b = p[(i + 3) & 3] - p[i];
        const double N = a * a + b * b, D = n * cross(a, b);
        e.value += 0.25 * Corner_cost::value(N, D);
        e.worst = (std::min)(e.worst, N > 0 ? 2 * D / N : -1.);
      }
      if(!sized_) continue;
      const double r = mean_edge_length(p) / (here ? f.target : s_.target(p, f.floor));
      e.value += size_cost(r);
      e.largest = (std::max)(e.largest, r);
    }
    return e;
  }

  double size_cost(double r) const
  {
    double d1, d2;
    return size_cost(r, d1, d2);
  }

  // r^power / 2 up to r = 1.5, then its parabola, so that far too large faces do not swamp all.
  double size_cost(double r, double& d1, double& d2) const
  {
    const Smoothing_weights& w = s_.smoothing;
    const double c = (std::min)(r, 1.5), k = w.power;
    const double p2 = integer_power(c, w.power - 2), b1 = 0.5 * k * p2 * c,
                 b2 = 0.5 * k * (k - 1) * p2;
    double v = 0.5 * p2 * c * c + b1 * (r - c) + 0.5 * b2 * (r - c) * (r - c);
    d1 = w.size * (b1 + b2 * (r - c));
    d2 = w.size * b2;
    v *= w.size;
    if(w.hinge > 0 && r > w.hinge_at) {
      const double x = r - w.hinge_at;
      v += w.hinge * x * x;
      d1 += 2 * w.hinge * x;
      d2 += 2 * w.hinge;
    }
    return v;
  }

  // Derivatives at x of the cost of one face, normals frozen.
  void add_derivatives(const Vertex_record& r, const Star_face& f, int dofs, Local_model& m) const
  {
    const Vec& x = r.p;
    const Corners p = { x, f.q1, f.q2, f.q3 };
    const Vec n = Adaptation_state::facing(p, f.reference + r.normal);
    // N = |a|^2 + |b|^2 and D = n . (a x b) at the corners x, q1 and q3; both edges depend on x
    // at the first, one at the others
    add_corner(f.q1 - x, f.q3 - x, 4, 2 * (x - f.q1) + 2 * (x - f.q3), cross(n, f.q3 - f.q1), n,
               dofs, m);
    add_corner(f.q2 - f.q1, x - f.q1, 2, 2 * (x - f.q1), cross(n, f.q2 - f.q1), n, dofs, m);
    add_corner(x - f.q3, f.q2 - f.q3, 2, 2 * (x - f.q3), cross(f.q2 - f.q3, n), n, dofs, m);
    if(sized_) add_size(p, f, dofs, m);
  }

  void add_corner(const Vec& a, const Vec& b, double hN, const Vec& gN, const Vec& gD, const Vec& n,
                  int dofs, Local_model& m) const
  {
    const double N = a * a + b * b;
    if(!(N > 0)) return;
    const double D = n * cross(a, b), t = 2 * D / N;
    // cost as a function of t, then t of N and D
    double c1, c2;
    if(t >= 2 * Corner_cost::flat) {
      const double i = 1 / t;
      c1 = -(2 * i - 1) * i * i;
      c2 = (6 * i - 2) * i * i * i;
    } else {
      c1 = -Corner_cost::slope();
      c2 = 0;
    }
    double dN[2], dD[2], dt[2];
    for(int i = 0; i < dofs; ++i) {
      dN[i] = gN * t_[i];
      dD[i] = gD * t_[i];
      dt[i] = (2 * dD[i] - t * dN[i]) / N;
      m.g[i] += 0.25 * c1 * dt[i];
    }
    for(int i = 0, k = 0; i < dofs; ++i)
      for(int j = i; j < dofs; ++j, ++k) {
        // N t = 2 D, differentiated twice (D is linear in x)
        const double ddt = -(t * (i == j ? hN : 0.) + dN[i] * dt[j] + dN[j] * dt[i]) / N;
        m.H[dofs == 1 ? 0 : k] += 0.25 * (c2 * dt[i] * dt[j] + c1 * ddt);
      }
  }

  void add_size(const Corners& p, const Star_face& f, int dofs, Local_model& m) const
  {
    const double l1 = distance(p[0], p[1]), l3 = distance(p[0], p[3]);
    if(!(l1 > 0 && l3 > 0)) return;
    const double h = f.target, r = mean_edge_length(p) / h;
    double d1, d2;
    size_cost(r, d1, d2);
    const Vec u1 = (p[0] - p[1]) / l1, u3 = (p[0] - p[3]) / l3;
    double dr[2], a1[2], a3[2];
    for(int i = 0; i < dofs; ++i) {
      a1[i] = u1 * t_[i];
      a3[i] = u3 * t_[i];
      dr[i] = 0.25 * (a1[i] + a3[i] - r * (f.grad_h * t_[i])) / h;
      m.g[i] += d1 * dr[i];
    }
    for(int i = 0, k = 0; i < dofs; ++i)
      for(int j = i; j < dofs; ++j, ++k) {
        const double id = i == j ? 1. : 0.;
        const double ddr = 0.25 * ((id - a1[i] * a1[j]) / l1 + (id - a3[i] * a3[j]) / l3) / h;
        m.H[dofs == 1 ? 0 : k] += d2 * dr[i] * dr[j] + d1 * ddr;
      }
  }

  // Newton step, with the Hessian shifted to be positive definite.
  static bool newton_step(const Local_model& m, int dofs, double* step)
  {
    if(dofs == 1) {
      const double h = std::abs(m.H[0]);
      if(!(h > 0)) return false;
      step[0] = -m.g[0] / h;
      return std::isfinite(step[0]);
    }
    double a = m.H[0], b = m.H[1], c = m.H[2];
    const double mean = 0.5 * (a + c), dev = std::sqrt(0.25 * (a - c) * (a - c) + b * b);
    const double low = mean - dev, want = 0.1 * (std::abs(mean) + dev);
    if(low < want) {
      a += want - low;
      c += want - low;
    }
    const double det = a * c - b * b;
    if(!(det > 0)) return false;
    step[0] = -(c * m.g[0] - b * m.g[1]) / det;
    step[1] = -(a * m.g[1] - b * m.g[0]) / det;
    return std::isfinite(step[0]) && std::isfinite(step[1]);
  }

  bool line_search(Vertex_record& r, int dofs, const double* step, const Evaluation& before) const
  {
    double reach = 0;
    for(const Star_face& f : star_)
      reach = (std::max)({ reach, distance(r.p, f.q1), distance(r.p, f.q3) });
    double length = 0;
    for(int i = 0; i < dofs; ++i) length += step[i] * step[i];
    length = std::sqrt(length);
    if(!(length > least_move * reach)) return false;
    double scale = (std::min)(1., 0.5 * reach / length);
    for(int attempt = 0; attempt < 4; ++attempt, scale *= 0.35) {
      Vertex_record t = r;
      if(r.carrier == Carrier::curve)
        t.param = r.param + scale * step[0];
      else
        t.p = r.p + (scale * step[0]) * t_[0] + (scale * step[1]) * t_[1];
      s_.place(t);
      const Evaluation after = evaluate(t.p, t.normal);
      if(after.value < before.value - 1e-7 * std::abs(before.value) &&
         after.worst >= (std::min)(before.worst, s_.smoothing.min_corner) &&
         (!s_.smoothing.keep_within_size || after.largest <= (std::max)(before.largest, 1.))) {
        r = t;
        return true;
      }
    }
    return false;
  }

  const Adaptation_state& s_;
  std::vector<Star_face> star_;
  mutable Vec t_[2];
  bool sized_ = true; // do sizes count at all?
};

// Gradient of the size along a face from its values at the corners (least squares on the
// diagonals); zero where it is constant.
inline Vec size_gradient(const Corners& p, const std::array<double, 4>& h)
{
  const Vec d1 = p[2] - p[0], d2 = p[3] - p[1];
  const double h1 = h[2] - h[0], h2 = h[3] - h[1];
  if(h1 == 0 && h2 == 0) return Vec(0, 0, 0);
  const double a = d1 * d1, b = d1 * d2, c = d2 * d2, det = a * c - b * b;
  if(!(det > 1e-6 * a * c)) return Vec(0, 0, 0);
  return ((c * h1 - b * h2) / det) * d1 + ((a * h2 - b * h1) / det) * d2;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_NODE_RELAXATION_H
