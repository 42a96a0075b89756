// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_REFERENCE_MATCHER_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_REFERENCE_MATCHER_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/Hermite_curve.h>
#include <CGAL/Quad_mesh_adaptation/internal/Reference_creases.h>
#include <CGAL/Quad_mesh_adaptation/internal/reference_curves.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Takes the curves and corners of a state to those of a separate reference surface: border curves
// to its border, curves inside to its creases where it has some nearby (within half an edge of the
// input); others stay as they are.
class Reference_matcher
{
public:
  Reference_matcher(const Triangle_soup& reference, double cos_angle, bool off, Adaptation_state& s)
      : soup_(reference), creases_(reference, cos_angle, off), s_(s)
  {
  }

  // The edges of the reference that curves of the input follow, and its border.
  const Hermite_edges& edges() const { return edges_; }
  Edge_keys sharp() const
  {
    Edge_keys keys;
    for(const auto& e : edges_) keys.push_back(e.first);
    return keys;
  }

  void operator()()
  {
    const std::vector<Feature_curve> loops = border_loops(soup_);
    for(Feature_curve& c : s_.curves)
      if(!c.is_border() && !c.is_frozen()) follow_crease(c);
    const std::vector<Curve_lookup> lookups(loops.begin(), loops.end());
    if(!loops.empty())
      for(Feature_curve& c : s_.curves)
        if(c.is_border() && !c.is_frozen()) c = curve_on_reference(with_new_ends(c), lookups);
    for(const Feature_curve& c : s_.curves) {
      if(c.is_closed() || !c.is_border() || c.is_frozen() || loops.empty()) continue;
      move_corner(c.first_corner, c.points().front());
      move_corner(c.last_corner, c.points().back());
    }
    for(const auto& [v, u] : corner_) move_corner(v, soup_.points[u]);
    const std::vector<Curve_lookup> curves(s_.curves.begin(), s_.curves.end());
    for(Index v : s_.mesh.vertices()) {
      Vertex_record& r = s_.mesh.vertex(v);
      if(r.carrier == Carrier::curve) r.param = curves[r.curve].nearest(r.p);
    }
    add_border();
  }

private:
  void move_corner(Index v, const Vec& p)
  {
    Vertex_record& r = s_.mesh.vertex(v);
    if(!r.frozen) r.p = p;
  }

  static double reach_of(const Feature_curve& c)
  {
    return 0.5 * c.length() / double(c.points().size() - 1);
  }

  void follow_crease(Feature_curve& c)
  {
    const double reach = reach_of(c);
    std::vector<Index> way;
    if(c.is_closed()) {
      way = creases_.loop(c, reach);
    } else {
      const Index a = corner_target(c.first_corner, reach), b = corner_target(c.last_corner, reach);
      if(a >= 0 && b >= 0) way = creases_.path(c, a, b, reach);
      if(!way.empty()) {
        corner_[c.first_corner] = a;
        corner_[c.last_corner] = b;
      }
    }
    if(way.empty()) return;
    std::vector<Vec> points;
    for(Index v : way) points.push_back(soup_.points[v]);
    for(std::size_t i = 0; i + 1 < way.size(); ++i) add_edge(way[i], way[i + 1]);
    Feature_curve found(points, c.is_closed(), false, false);
    found.constrained = c.constrained;
    found.first_corner = c.first_corner;
    found.last_corner = c.last_corner;
    c = std::move(found);
  }

  // A frozen corner stays, and a curve that ends there with it.
  Index corner_target(Index v, double reach) const
  {
    const auto known = corner_.find(v);
    if(known != corner_.end()) return known->second;
    const Index u = creases_.vertex_near(s_.mesh.point(v), reach);
    const bool stays = s_.mesh.vertex(v).frozen;
    return stays && u >= 0 && soup_.points[u] != s_.mesh.point(v) ? Index(-1) : u;
  }

  Feature_curve with_new_ends(const Feature_curve& c) const
  {
    if(c.is_closed()) return c;
    std::vector<Vec> points = c.points();
    const auto a = corner_.find(c.first_corner), b = corner_.find(c.last_corner);
    if(a != corner_.end()) points.front() = soup_.points[a->second];
    if(b != corner_.end()) points.back() = soup_.points[b->second];
    Feature_curve moved(points, false, true, false);
    moved.constrained = c.constrained;
    moved.first_corner = c.first_corner;
    moved.last_corner = c.last_corner;
    return moved;
  }

  void add_edge(Index a, Index b)
  {
    const std::pair<Index, Index> key = std::minmax(a, b);
    edges_[key] = Hermite_segment::straight(soup_.points[key.first], soup_.points[key.second]);
  }

  void add_border()
  {
    std::vector<std::pair<Index, Index>> all;
    for(const auto& t : soup_.triangles)
      for(int i = 0; i < 3; ++i) all.push_back(std::minmax(t[i], t[(i + 1) % 3]));
    std::sort(all.begin(), all.end());
    for(std::size_t i = 0; i < all.size();) {
      std::size_t j = i;
      while(j < all.size() && all[j] == all[i]) ++j;
      if(j == i + 1) add_edge(all[i].first, all[i].second);
      i = j;
    }
  }

  const Triangle_soup& soup_;
  Reference_creases creases_;
  Adaptation_state& s_;
  Hermite_edges edges_;
  std::map<Index, Index> corner_; // of the input -> vertex of the reference
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_REFERENCE_MATCHER_H
