// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_REFERENCE_CURVES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_REFERENCE_CURVES_H

#include <CGAL/Quad_mesh_adaptation/internal/Feature_curve.h>
#include <CGAL/Quad_mesh_adaptation/internal/Input_mesh.h>

#include <algorithm>
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
  for(int turn = 0; turn < 2; ++turn)
    for(std::size_t i = 0; i + 1 < loop.points().size(); ++i) {
      const double s = loop.arcs()[i] + turn * L;
      if(s > a + 1e-9 * L && s < b - 1e-9 * L) points.push_back(loop.points()[i]);
    }
  points.push_back(loop.point(b));
  return points;
}

// The part of the reference border that curve c of the input stands for: the loop nearest to it,
// between the points nearest to its ends, on the side of its inner points.
inline Feature_curve curve_on_reference(const Feature_curve& c,
                                        const std::vector<Feature_curve>& loops)
{
  const std::vector<Vec>& p = c.points();
  std::size_t best = 0;
  double least = (std::numeric_limits<double>::max)();
  for(std::size_t i = 0; i < loops.size(); ++i) {
    double sum = 0;
    for(const Vec& q : p) sum += distance(q, loops[i].point(loops[i].nearest(q)));
    if(sum < least) {
      least = sum;
      best = i;
    }
  }
  const Feature_curve& loop = loops[best];
  if(c.is_closed()) {
    Feature_curve whole(loop.points(), true, true, false);
    whole.constrained = c.constrained;
    return whole;
  }
  const double a = loop.nearest(p.front()), b = loop.nearest(p.back());
  const Vec inside = p.size() > 2 ? p[p.size() / 2] : 0.5 * (p.front() + p.back());
  std::vector<Vec> forward = stretch(loop, a, b), backward = stretch(loop, b, a);
  std::reverse(backward.begin(), backward.end());
  Feature_curve f(forward, false, true, false), g(backward, false, true, false);
  const double df = distance(f.point(f.nearest(inside)), inside);
  const double dg = distance(g.point(g.nearest(inside)), inside);
  Feature_curve result = df <= dg ? f : g;
  result.constrained = c.constrained;
  result.first_corner = c.first_corner;
  result.last_corner = c.last_corner;
  return result;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_REFERENCE_CURVES_H
