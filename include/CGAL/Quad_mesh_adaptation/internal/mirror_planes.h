// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MIRROR_PLANES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MIRROR_PLANES_H

#include <CGAL/Quad_mesh_adaptation/internal/Mirror_test.h>
#include <CGAL/Quad_mesh_adaptation/internal/Size_means.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Looks for mirror planes of an input.  All of them go through the mean of the vertices.  A vertex
// that does not lie on a plane has its partner among the vertices equally far from the mean, and
// of three vertices in independent directions one at least does not lie on it.
class Mirror_search
{
public:
  Mirror_search(const Input_mesh& in, const Adaptation_state& s)
      : points_(in.points), centre_(mean(in.points)), reach_(reach_of(in.points, centre_)),
        means_(in, s, centre_, reach_), test_(in, s, centre_, reach_)
  {
  }

  // Up to three planes at right angles to each other, as many as possible; those at right angles
  // to the axes first.
  std::vector<Mirror_plane> operator()()
  {
    if(!(reach_ > 0)) return {};
    normal_ = normal_of_flat();
    if(means_.rule_out_all(normal_)) return {};
    for(const Vec& axis : { Vec(1, 0, 0), Vec(0, 1, 0), Vec(0, 0, 1) }) try_plane(axis);
    if(!is_complete()) try_bisectors();
    std::vector<Mirror_plane> planes;
    for(const Mirror_plane* p : best_set()) planes.push_back(at_right_angles(*p, planes));
    return planes;
  }

private:
  // Beyond these the search is given up: a mesh with that many vertices equally far from its
  // middle, or that many planes, has shown a plane that will do long before.
  static constexpr std::size_t most_candidates = 60000, most_tests = 48;

  static Vec mean(const std::vector<Vec>& points)
  {
    Vec sum(0, 0, 0);
    for(const Vec& p : points) sum = sum + p;
    return points.empty() ? sum : sum / double(points.size());
  }

  static double reach_of(const std::vector<Vec>& points, const Vec& centre)
  {
    double far = 0;
    for(const Vec& p : points) far = (std::max)(far, distance(p, centre));
    return far;
  }

  void try_plane(Vec n)
  {
    // of both directions of a normal the one that looks up, for a result that does not depend on
    // the order of vertices
    for(int i = 0; i < 3; ++i)
      if(std::abs(n[i]) > 1e-6) {
        if(n[i] < 0) n = -n;
        break;
      }
    for(const Mirror_plane& p : found_)
      if(are_parallel(p.normal, n)) return;
    const bool is_of_mesh = norm(normal_) > 0 && are_parallel(n, normal_);
    if(is_of_mesh || means_.rule_out(n) || is_refused(n) || !test_.is_plausible(n)) return;
    std::optional<Mirror_plane> p = test_(n);
    if(!p) return refused_.push_back(n);
    found_.push_back(std::move(*p));
    try_right_angles();
  }

  static bool are_parallel(const Vec& a, const Vec& b) { return norm(cross(a, b)) < 1e-6; }

  bool is_refused(const Vec& n) const
  {
    return std::any_of(refused_.begin(), refused_.end(),
                       [&](const Vec& r) { return are_parallel(r, n); });
  }

  // Where there are many planes through one line, those at right angles to each other are not
  // waited for.
  void try_right_angles()
  {
    const Vec n = found_.back().normal;
    std::vector<Vec> lines = { normal_ };
    for(const Mirror_plane& q : found_) lines.push_back(cross(n, q.normal));
    for(const Vec& line : lines) {
      if(!(norm(line) > 0.01)) continue;
      const Vec a = normalized(line);
      if(!is_complete()) try_plane(a);
      if(!is_complete() && std::abs(a * n) < 0.01) try_plane(normalized(cross(a, n)));
    }
  }

  // More planes at right angles to each other than there are now cannot be hoped for.
  bool is_complete() const { return best_set().size() == (norm(normal_) > 0 ? 2u : 3u); }

  // Of the plane that holds all vertices; zero if there is none.
  Vec normal_of_flat() const
  {
    const Vec a = points_[far_from(centre_)] - centre_;
    Vec n(0, 0, 0);
    for(const Vec& p : points_) {
      const Vec c = cross(a, p - centre_);
      if(c * c > n * n) n = c;
    }
    n = normalized(n);
    for(const Vec& p : points_)
      if(std::abs(n * (p - centre_)) > 1e-9 * reach_) return Vec(0, 0, 0);
    return n;
  }

  std::size_t far_from(const Vec& c) const
  {
    return std::size_t(std::max_element(points_.begin(), points_.end(),
                                        [&](const Vec& p, const Vec& q) {
                                          return (p - c).squared_length() <
                                                 (q - c).squared_length();
                                        }) -
                       points_.begin());
  }

  // Vertices equally far from the centre, as ranges of a sorted list; small ones first, among
  // those of equal size far ones first.
  struct Shell
  {
    std::size_t first, last;
  };

  void try_bisectors()
  {
    std::vector<std::pair<double, Index>> by_distance;
    for(std::size_t v = 0; v < points_.size(); ++v)
      by_distance.emplace_back(distance(points_[v], centre_), Index(v));
    std::sort(by_distance.begin(), by_distance.end());
    std::vector<Shell> shells;
    for(std::size_t i = 0, j = 0; i < by_distance.size(); i = j) {
      for(j = i + 1; j < by_distance.size(); ++j)
        if(by_distance[j].first - by_distance[j - 1].first > 1e-9 * reach_) break;
      if(by_distance[i].first > 0.01 * reach_) shells.push_back({ i, j });
    }
    std::sort(shells.begin(), shells.end(), [](const Shell& a, const Shell& b) {
      return std::make_pair(a.last - a.first, b.first) < std::make_pair(b.last - b.first, a.first);
    });
    std::size_t candidates = 0;
    for(const auto& [v, shell] : independent_vertices(by_distance, shells))
      for(std::size_t i = shell.first; i < shell.last; ++i) {
        const Vec d = points_[by_distance[i].second] - points_[v];
        if(!(norm(d) > 1e-6 * reach_)) continue;
        if(++candidates > most_candidates || found_.size() + refused_.size() > most_tests) return;
        const std::size_t before = found_.size();
        try_plane(normalized(d));
        if(found_.size() > before && is_complete()) return;
      }
  }

  // Up to three vertices, each with its shell, in directions from the centre that are independent.
  std::vector<std::pair<Index, Shell>>
  independent_vertices(const std::vector<std::pair<double, Index>>& by_distance,
                       const std::vector<Shell>& shells) const
  {
    std::vector<std::pair<Index, Shell>> chosen;
    std::vector<Vec> basis; // orthonormal
    for(const Shell& shell : shells)
      for(std::size_t i = shell.first; i < shell.last && basis.size() < 3; ++i) {
        Vec d = normalized(points_[by_distance[i].second] - centre_);
        for(const Vec& b : basis) d = d - (b * d) * b;
        if(!(norm(d) > 0.01)) continue;
        basis.push_back(normalized(d));
        chosen.push_back({ by_distance[i].second, shell });
      }
    return chosen;
  }

  std::vector<const Mirror_plane*> best_set() const
  {
    std::vector<const Mirror_plane*> all, best;
    for(const Mirror_plane& p : found_) all.push_back(&p);
    const auto rank = [](const Mirror_plane* p) {
      return std::make_tuple(p->axis < 0 ? 3 : p->axis, -p->normal.x(), -p->normal.y(),
                             -p->normal.z());
    };
    std::sort(all.begin(), all.end(),
              [&](const Mirror_plane* a, const Mirror_plane* b) { return rank(a) < rank(b); });
    for(const Mirror_plane* first : all) {
      std::vector<const Mirror_plane*> set = { first };
      for(const Mirror_plane* p : all)
        if(std::all_of(set.begin(), set.end(), [&](const Mirror_plane* q) {
             return std::abs(p->normal * q->normal) < 1e-7;
           }))
          set.push_back(p);
      if(set.size() > best.size()) best = set;
    }
    return best;
  }

  // Reflections in planes at right angles commute: what is left of a lean is taken off.
  Mirror_plane at_right_angles(Mirror_plane p, const std::vector<Mirror_plane>& others) const
  {
    if(p.axis >= 0) return p;
    const Vec on = p.project(centre_);
    for(const Mirror_plane& q : others) p.normal = p.normal - (p.normal * q.normal) * q.normal;
    p.normal = normalized(p.normal);
    p.offset = p.normal * on;
    return p;
  }

  const std::vector<Vec>& points_;
  Vec centre_;
  double reach_;
  Size_means means_;
  Mirror_test test_;
  Vec normal_ = Vec(0, 0, 0); // of a flat mesh
  std::vector<Mirror_plane> found_;
  std::vector<Vec> refused_; // normals of others that were plausible
};

// Planes in which the input, its constraints and its sizes are mirror images of themselves and
// along which it can be cut: up to three, at right angles to each other.  Rotations without such
// planes are not looked for.  Takes O(n log n), with a bound on how many candidates are looked at.
inline std::vector<Mirror_plane> mirror_planes(const Input_mesh& in, const Adaptation_state& s)
{
  return Mirror_search(in, s)();
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MIRROR_PLANES_H
