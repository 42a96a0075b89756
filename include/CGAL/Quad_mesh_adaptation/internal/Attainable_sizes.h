// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ATTAINABLE_SIZES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ATTAINABLE_SIZES_H

#include <CGAL/Quad_mesh_adaptation/internal/face_curvatures.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// To foretell by, a curve has one edge at least, a closed one three.  Operations leave a closed one
// four, see Closed_curve_check, but sizes from here are no bound and their factors are fitted: with
// four, numbers of faces were foretold worse, 8.9 % off instead of 7.9 on average.
inline double fewest_edges(const Feature_curve& c) { return c.is_closed() ? 3. : 1.; }

// Sizes at vertices of an input that its faces can have at most.  Two things hold them small:
// - the surface turns.  Fewer than three edges do not go around anything, so that a face spans a
//   third of a full turn at most, in either principal direction;
// - a feature curve is shorter than the size.
// From there they grow no faster than quads do.
class Attainable_sizes
{
public:
  explicit Attainable_sizes(const Adaptation_state& s) : s_(s)
  {
    find_turns();
    find_short_curves();
    spread();
  }

  // How many ideal faces there are beyond those for the sizes asked for.  A face of the input never
  // needs more than one where it is within its size: the input has them.
  double forced_faces() const
  {
    const Quad_complex& m = s_.mesh;
    double forced = 0;
    for(Index f = 0; f < m.face_end() && !size_.empty(); ++f) {
      if(!m.is_face(f)) continue;
      double asked = 0, needed = 0; // per area
      for(Index v : m.quad(f)) {
        asked += 0.25 / (m.vertex(v).h * m.vertex(v).h);
        needed += 0.25 / (size_[v] * size_[v]);
      }
      if(!(needed > asked)) continue;
      const double a = area(f);
      forced += (std::max)(0., (std::min)(needed * a, (std::max)(1., asked * a)) - asked * a);
    }
    return forced;
  }

private:
  static constexpr double most_turn = 2.0943951023931953; // a third of a full turn
  static constexpr double growth = 0.75;                  // of the size, per unit of length

  double area(Index f) const { return 0.5 * norm(area_vector(s_.corners(f))); }

  double narrowest_width(Index f) const
  {
    const Corners p = s_.corners(f);
    double longest = 0; // squared
    for(int i = 0; i < 4; ++i)
      longest = (std::max)(longest, (p[(i + 1) & 3] - p[i]).squared_length());
    return area(f) / std::sqrt(longest);
  }

  // The size at v is no larger than this.
  void lower(Index v, double size)
  {
    const Quad_complex& m = s_.mesh;
    if(!(size < m.vertex(v).h)) return;
    if(size_.empty()) {
      size_.reserve(m.vertex_end());
      for(Index w = 0; w < m.vertex_end(); ++w) size_.push_back(m.vertex(w).h);
    }
    constexpr double least_gain = 1e-9; // relative
    if(size < size_[v] * (1 - least_gain)) queue_.emplace(size_[v] = size, v);
  }

  std::vector<Vec> centres() const
  {
    std::vector<Vec> list;
    list.reserve(s_.mesh.face_end());
    for(Index f = 0; f < s_.mesh.face_end(); ++f)
      list.push_back(s_.mesh.is_face(f) ? centre_of(s_.corners(f)) : Vec(0, 0, 0));
    return list;
  }

  // How many times more faces the surface at f needs than its size asks for.  Normals differ by two
  // at most, so that faces no narrower than their size need no closer look, nor most others.
  double times_more(Index f, const std::vector<Vec>& centres) const
  {
    double h = 0;
    for(Index v : s_.mesh.quad(f)) h += 0.25 * s_.mesh.vertex(v).h;
    if(h * largest_curvature(s_, f, centres) < most_turn || narrowest_width(f) >= h) return 1;
    double times = 1;
    for(double k : face_curvatures(s_, f)) times *= (std::max)(1., h * k / most_turn);
    return times;
  }

  // At vertices by the mean over the faces around.
  void find_turns()
  {
    if(s_.surface.is_planar()) return;
    const Quad_complex& m = s_.mesh;
    const std::vector<Vec> centres = this->centres();
    std::vector<double> excess; // times area; there is none in most meshes
    for(Index f = 0; f < m.face_end(); ++f) {
      const double times = m.is_face(f) ? times_more(f, centres) : 1;
      if(!(times > 1)) continue;
      if(excess.empty()) excess.resize(m.vertex_end(), 0);
      for(Index v : m.quad(f)) excess[v] += area(f) * (times - 1);
    }
    for(Index v = 0; v < Index(excess.size()); ++v) {
      if(!(excess[v] > 0)) continue;
      double of_all = 0;
      for(Index h : m.outgoing(v)) of_all += area(m.face(h));
      lower(v, m.vertex(v).h / std::sqrt(1 + excess[v] / of_all));
    }
  }

  void find_short_curves()
  {
    const Quad_complex& m = s_.mesh;
    for(Index h : m.halfedges()) {
      if(m.curve(h) < 0) continue;
      const Feature_curve& c = s_.curves[m.curve(h)];
      const double longest_edge = c.length() / fewest_edges(c);
      lower(m.origin(h), longest_edge);
      lower(m.target(h), longest_edge);
    }
  }

  // Dijkstra's algorithm along edges and diagonals, as far as sizes are lowered.
  void spread()
  {
    const Quad_complex& m = s_.mesh;
    while(!queue_.empty()) {
      const auto [h, v] = queue_.top();
      queue_.pop();
      if(h > size_[v]) continue;
      for(Index out : m.outgoing(v))
        for(Index w : m.quad(m.face(out)))
          if(w != v) lower(w, h + growth * distance(m.point(v), m.point(w)));
    }
  }

  using Entry = std::pair<double, Index>;
  const Adaptation_state& s_;
  std::vector<double> size_; // by vertex; none if all can be as asked for
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ATTAINABLE_SIZES_H
