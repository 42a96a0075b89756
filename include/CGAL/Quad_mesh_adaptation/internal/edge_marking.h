// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_EDGE_MARKING_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_EDGE_MARKING_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/t_join.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

struct Marking_options
{
  double threshold = 1.05; // rho_0: edges longer than sqrt(2) rho_0 times their size want a split
  double bend = 0.25;      // cost of a 3-quad template, which makes a node of valence 3
};

// Splits by edge, all even on every face, nearest to what `wish` asks for: a minimum-weight
// T-join on the dual graph.  Each face is two graph vertices, one per pair of opposite edges,
// joined by an edge that stands for a bend (two adjacent split edges); free border edges lead to
// one outer vertex.  Of a large mesh only what is near odd faces is looked at, and farther about
// those for which that has no solution.
class Even_marks
{
public:
  Even_marks(const Quad_complex& m, const std::vector<double>& wish, double bend)
      : m_(m), wish_(wish), bend_(bend), split_(4 * std::size_t(m.face_end()), 0),
        odd_(2 * std::size_t(m.face_end()), 0)
  {
  }

  // Nothing if there is no solution.
  std::vector<char> operator()()
  {
    mark_wishes();
    if(odd_faces_.empty()) return split_;
    number_.assign(m_.face_end(), -1);
    bool is_whole = m_.number_of_faces() < small;
    std::vector<Index> open = odd_faces_; // those that need more about them
    for(int rings = 4;; rings *= 4) {
      is_whole = is_whole || !add_near(open, rings);
      list_near(is_whole);
      const T_join join = solve();
      open.clear();
      if(!join.is_feasible) list_faces(join, open);
      if(open.empty() && join.is_feasible) {
        apply(join);
        return split_;
      }
      if(is_whole) return {};
    }
  }

private:
  static constexpr Index small = 2000; // faces: not worth a selection

  static Index port(Index h) { return 2 * (h >> 2) + (h & 1); }
  bool is_lower(Index h) const { return !(m_.opposite(h) >= 0 && m_.opposite(h) < h); }

  void mark_wishes()
  {
    for(Index h : m_.halfedges()) {
      if(!(wish_[h] < 0) || !is_lower(h)) continue;
      const Index o = m_.opposite(h);
      split_[h] = 1;
      odd_[port(h)] ^= 1;
      if(o < 0) continue;
      split_[o] = 1;
      odd_[port(o)] ^= 1;
    }
    for(Index f = 0; f < m_.face_end(); ++f)
      if(odd_[2 * f] || odd_[2 * f + 1]) odd_faces_.push_back(f);
  }

  // Adds the faces at most so many rings from the given ones; false where most are near then, or
  // there are no others about these.
  bool add_near(const std::vector<Index>& seeds, int rings)
  {
    std::vector<Index> reached;
    std::vector<char> is_reached(m_.face_end(), 0);
    const auto reach = [&](Index f) {
      if(is_reached[f]) return;
      is_reached[f] = 1;
      reached.push_back(f);
    };
    for(Index f : seeds) reach(f);
    std::size_t begin = 0;
    for(int ring = 0; ring < rings; ++ring)
      for(const std::size_t end = reached.size(); begin < end; ++begin)
        for(Index h = 4 * reached[begin]; h < 4 * reached[begin] + 4; ++h)
          if(m_.opposite(h) >= 0) reach(m_.face(m_.opposite(h)));
    bool is_more = false;
    for(Index f : reached) {
      is_more = is_more || number_[f] < 0;
      number_[f] = 0;
    }
    const auto far = std::count(number_.begin(), number_.end(), Index(-1));
    return is_more && 4 * far > std::ptrdiff_t(number_.size());
  }

  // Numbers the faces that are near, or all.
  void list_near(bool is_whole)
  {
    near_.clear();
    for(Index f : m_.faces())
      if(is_whole || number_[f] >= 0) {
        number_[f] = Index(near_.size());
        near_.push_back(f);
      }
  }

  // Between the pairs of opposite edges of the faces found.
  T_join solve()
  {
    const Index outside = 2 * Index(near_.size());
    const auto vertex = [&](Index h) { return 2 * number_[m_.face(h)] + (h & 1); };
    edges_.clear();
    halfedge_of_.clear();
    std::vector<char> free(near_.size(), 0), odd(std::size_t(outside) + 1, 0);
    for(Index f : near_)
      for(Index h = 4 * f; h < 4 * f + 4; ++h) {
        const Index o = m_.opposite(h);
        if(!is_lower(h) || !std::isfinite(wish_[h]) || (o >= 0 && number_[m_.face(o)] < 0))
          continue;
        free[number_[f]] = 1;
        if(o >= 0) free[number_[m_.face(o)]] = 1;
        edges_.push_back({ vertex(h), o >= 0 ? vertex(o) : outside, std::abs(wish_[h]) });
        halfedge_of_.push_back(h);
      }
    for(std::size_t k = 0; k < near_.size(); ++k) {
      for(int i = 0; i < 2; ++i) {
        odd[2 * k + i] = odd_[2 * near_[k] + i];
        odd[outside] ^= odd[2 * k + i]; // the border takes up an odd one
      }
      if(!free[k]) continue; // no edge of it may be split
      edges_.push_back({ Index(2 * k), Index(2 * k + 1), bend_ });
      halfedge_of_.push_back(-1);
    }
    return minimum_weight_t_join(std::size_t(outside) + 1, edges_, odd);
  }

  void apply(const T_join& join)
  {
    for(std::size_t i = 0; i < edges_.size(); ++i) {
      if(!join.in_join[i] || halfedge_of_[i] < 0) continue;
      const Index h = halfedge_of_[i], o = m_.opposite(h);
      split_[h] ^= 1;
      if(o >= 0) split_[o] ^= 1;
    }
  }

  void list_faces(const T_join& join, std::vector<Index>& faces) const
  {
    for(const auto& component : join.obstructions)
      for(Index v : component)
        if(v < 2 * Index(near_.size())) faces.push_back(near_[v / 2]); // else the outside
  }

  const Quad_complex& m_;
  const std::vector<double>& wish_;
  double bend_;
  std::vector<char> split_, odd_;                // by half-edge, by pair of opposite edges
  std::vector<Index> odd_faces_, near_, number_; // number: among the near ones, -1: is none
  std::vector<T_join_edge> edges_;
  std::vector<Index> halfedge_of_; // of each of these; -1: a bend
};

// `wish`, per half-edge of each edge's lower half: negative asks for a split, its magnitude is the
// cost of doing otherwise; infinite fixes the edge.
// Returns, per half-edge, whether its edge is split; nothing if there is no solution.
inline std::vector<char> even_marks(const Quad_complex& m, const std::vector<double>& wish,
                                    double bend)
{
  return Even_marks(m, wish, bend)();
}

// Length of edge h over its size at the middle times rho_0; infinite where it must not be split.
inline double split_ratio(const Adaptation_state& s, const Marking_options& o, Index h)
{
  const Quad_complex& m = s.mesh;
  const Index c = m.curve(h);
  if(c >= 0 && s.curves[c].is_frozen()) return std::numeric_limits<double>::infinity();
  const Vec &a = m.point(m.origin(h)), &b = m.point(m.target(h));
  return distance(a, b) / (s.size.at(0.5 * (a + b)) * o.threshold);
}

// What splitting an edge of that ratio rho costs: negative where it is too long.  A split changes
// (log rho)^2 by ln 2 (ln 2 - 2 ln rho).
inline double split_wish(double ratio)
{
  const double ln2 = std::log(2.);
  return std::isfinite(ratio) ? ln2 * (ln2 - 2 * std::log(ratio)) : ratio;
}

inline double split_wish(const Adaptation_state& s, const Marking_options& o, Index h)
{
  return split_wish(split_ratio(s, o, h));
}

// Does an edge of that ratio ask for a split?
inline bool asks_for_split(double ratio) { return std::isfinite(ratio) && ratio * ratio > 2; }

// The ratios of all edges, by the lower of their half-edges; infinite, if only the part of the mesh
// to work on is asked for, where an edge leaves that.
inline std::vector<double> split_ratios(const Adaptation_state& s, const Marking_options& o,
                                        bool only_inside)
{
  const Quad_complex& m = s.mesh;
  std::vector<double> ratio(4 * std::size_t(m.face_end()), 0.);
  for(Index h : m.halfedges()) {
    if(m.opposite(h) >= 0 && m.opposite(h) < h) continue;
    const bool is_inside = s.is_to_work_on(m.origin(h)) && s.is_to_work_on(m.target(h));
    ratio[h] =
        only_inside && !is_inside ? std::numeric_limits<double>::infinity() : split_ratio(s, o, h);
  }
  return ratio;
}

// The same as wishes; none if no edge asks for a split.
inline std::vector<double> split_wishes(const Adaptation_state& s, const Marking_options& o,
                                        bool only_inside)
{
  std::vector<double> wish = split_ratios(s, o, only_inside);
  if(std::none_of(wish.begin(), wish.end(), asks_for_split)) return {};
  for(double& w : wish) w = split_wish(w);
  return wish;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_EDGE_MARKING_H
