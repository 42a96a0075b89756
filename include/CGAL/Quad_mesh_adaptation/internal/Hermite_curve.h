// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_HERMITE_CURVE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_HERMITE_CURVE_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// A cubic from one point of a polyline to the next; the tangents have the length of the chord
// where they are straight.
struct Hermite_segment
{
  Vec p0, p1, m0, m1;

  Vec at(double t) const
  {
    const double a = t * t * (3 - 2 * t), s = 1 - t;
    return (1 - a) * p0 + a * p1 + (t * s * s) * m0 - (t * t * s) * m1;
  }
  bool is_straight() const
  {
    const Vec e = p1 - p0;
    const double tiny = 1e-24 * (e * e);
    return (m0 - e).squared_length() <= tiny && (m1 - e).squared_length() <= tiny;
  }
  Hermite_segment reversed() const { return { p1, p0, -m1, -m0 }; }
  static Hermite_segment straight(const Vec& a, const Vec& b) { return { a, b, b - a, b - a }; }
};

// By the numbers of the ends of an edge, from the lower to the higher.
using Hermite_edges = std::map<std::pair<Index, Index>, Hermite_segment>;

// Smooth curve through all points of a polyline: cubics whose tangents are those of the polynomial
// through the (at most) five points around, over the chord length.
class Hermite_curve
{
public:
  // A closed polyline repeats its first point at the end.
  Hermite_curve(const std::vector<Vec>& points, bool is_closed)
      : points_(points), closed_(is_closed), n_(int(points.size()) - 1)
  {
    std::vector<Vec> tangents(points.size());
    for(int i = 0; i <= n_; ++i) tangents[i] = tangent(i);
    if(closed_) tangents[n_] = tangents[0];
    for(int i = 0; i < n_; ++i) {
      const double l = distance(points[i], points[i + 1]);
      segments_.push_back({ points[i], points[i + 1], l * tangents[i], l * tangents[i + 1] });
    }
  }

  const std::vector<Hermite_segment>& segments() const { return segments_; }

  // The curve as a fine polyline through all points, straight parts with no more points; `where`
  // receives the number of each original point in it.
  std::vector<Vec> polyline(int per_segment, std::vector<std::size_t>& where) const
  {
    std::vector<Vec> fine = { points_[0] };
    where = { 0 };
    for(int i = 0; i < n_; ++i) {
      if(!segments_[i].is_straight())
        for(int k = 1; k < per_segment; ++k)
          fine.push_back(segments_[i].at(double(k) / per_segment));
      where.push_back(fine.size());
      fine.push_back(points_[i + 1]);
    }
    return fine;
  }

private:
  Vec at(int i) const { return closed_ ? points_[((i % n_) + n_) % n_] : points_[i]; }

  // Derivative at point i by chord length; 2 or 3 points at a time for short curves.
  Vec tangent(int i) const
  {
    int low = i - 2, high = i + 2;
    if(closed_ ? n_ < 5 : n_ < 4) {
      low = i - 1;
      high = i + 1;
    }
    if(!closed_) {
      low = (std::max)(low, 0);
      high = (std::min)(high, n_);
      if(high - low < 2) { // the ends see two more points
        low = (std::max)(0, high - 2);
        high = (std::min)(n_, low + 2);
      }
    }
    const Vec best = derivative(i, low, high);
    return is_sound(best, i) ? best
                             : derivative(i, closed_ ? i - 1 : (std::max)(i - 1, 0),
                                          closed_ ? i + 1 : (std::min)(i + 1, n_));
  }

  Vec derivative(int i, int low, int high) const
  {
    std::vector<double> s = { 0 };
    for(int k = low; k < high; ++k) s.push_back(s.back() + distance(at(k), at(k + 1)));
    const int m = int(s.size()), j = i - low;
    Vec sum(0, 0, 0); // of differences to point i, so that a straight line stays one
    for(int k = 0; k < m; ++k) {
      if(k == j) continue;
      double w = 1 / (s[k] - s[j]);
      for(int l = 0; l < m; ++l)
        if(l != k && l != j) w *= (s[j] - s[l]) / (s[k] - s[l]);
      sum = sum + w * (at(low + k) - at(i));
    }
    return sum;
  }

  // Near the directions of both edges, and about of length one.
  bool is_sound(const Vec& d, int i) const
  {
    const auto agrees = [&](int a, int b) {
      return d * normalized(at(b) - at(a)) > 0.6 && d * d < 2;
    };
    return (!closed_ && i == 0 ? true : agrees(i - 1, i)) &&
           (!closed_ && i == n_ ? true : agrees(i, i + 1));
  }

  const std::vector<Vec>& points_;
  bool closed_;
  int n_; // segments
  std::vector<Hermite_segment> segments_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_HERMITE_CURVE_H
