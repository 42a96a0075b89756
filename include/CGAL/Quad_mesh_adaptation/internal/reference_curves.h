// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_REFERENCE_CURVES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_REFERENCE_CURVES_H

#include <CGAL/Quad_mesh_adaptation/internal/Curve_lookup.h>
#include <CGAL/Quad_mesh_adaptation/internal/Input_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The border of a reference surface, one closed curve per loop.
inline std::vector<Feature_curve> border_loops(const Triangle_soup& soup)
{
  std::vector<std::pair<Index, Index>> edges;
  for(const auto& t : soup.triangles)
    for(int i = 0; i < 3; ++i) edges.emplace_back(t[i], t[(i + 1) % 3]);
  std::sort(edges.begin(), edges.end());
  std::map<Index, Index> next;
  for(const auto& e : edges)
    if(!std::binary_search(edges.begin(), edges.end(), std::make_pair(e.second, e.first)))
      next[e.first] = e.second;
  std::vector<Feature_curve> loops;
  while(!next.empty()) {
    const Index start = next.begin()->first;
    std::vector<Vec> points = { soup.points[start] };
    Index v = start;
    for(auto it = next.find(v); it != next.end(); it = next.find(v)) {
      v = it->second;
      next.erase(it);
      points.push_back(soup.points[v]);
      if(v == start) break;
    }
    if(v == start && points.size() > 3) loops.emplace_back(std::move(points), true, true, false);
  }
  return loops;
}

// Points of a closed curve from arc length a forward to b.
inline std::vector<Vec> stretch(const Feature_curve& loop, double a, double b)
{
  const double L = loop.length();
  if(b <= a) b += L;
  std::vector<Vec> points = { loop.point(a) };
  const std::vector<double>& arcs = loop.arcs(); // the last point is the first again
  const std::size_t n = arcs.size() - 1;
  std::size_t i =
      std::size_t(std::upper_bound(arcs.begin(), arcs.end(), a + 1e-9 * L) - arcs.begin());
  for(; arcs[i % n] + double(i / n) * L < b - 1e-9 * L; ++i) points.push_back(loop.points()[i % n]);
  points.push_back(loop.point(b));
  return points;
}

// The loop nearest to curve c, by the sum of the distances of points of c.
inline const Curve_lookup& nearest_loop(const Feature_curve& c,
                                        const std::vector<Curve_lookup>& loops)
{
  constexpr std::size_t many = 100; // points to tell
  const std::vector<Vec>& p = c.points();
  const std::size_t step = 1 + p.size() / many, looked_at = (p.size() + step - 1) / step;
  const Box box(p);
  const Curve_lookup* best = &loops.front();
  double least = (std::numeric_limits<double>::max)();
  for(const Curve_lookup& loop : loops) {
    if(double(looked_at) * std::sqrt(box.squared_distance(loop.box())) > least) continue;
    double sum = 0;
    for(std::size_t i = 0; i < p.size() && sum < least; i += step) sum += loop.distance_to(p[i]);
    if(!(sum < least)) continue;
    least = sum;
    best = &loop;
  }
  return *best;
}

// The part of the reference border that curve c of the input stands for: the loop nearest to it,
// between the points nearest to its ends, on the side of its inner points.
inline Feature_curve curve_on_reference(const Feature_curve& c,
                                        const std::vector<Curve_lookup>& loops)
{
  const std::vector<Vec>& p = c.points();
  const Curve_lookup& lookup = nearest_loop(c, loops);
  const Feature_curve& loop = lookup.curve();
  if(c.is_closed()) {
    Feature_curve whole(loop.points(), true, true, false);
    whole.constrained = c.constrained;
    return whole;
  }
  const double a = lookup.nearest(p.front()), b = lookup.nearest(p.back());
  const Vec inside = p.size() > 2 ? p[p.size() / 2] : 0.5 * (p.front() + p.back());
  const double at = loop.wrapped(lookup.nearest(inside) - a), whole = loop.wrapped(b - a);
  const bool is_forward = !(whole > 0) || at <= whole;
  std::vector<Vec> points = is_forward ? stretch(loop, a, b) : stretch(loop, b, a);
  if(!is_forward) std::reverse(points.begin(), points.end());
  Feature_curve result(std::move(points), false, true, false);
  result.constrained = c.constrained;
  result.first_corner = c.first_corner;
  result.last_corner = c.last_corner;
  return result;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_REFERENCE_CURVES_H
