// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_REFERENCE_CREASES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_REFERENCE_CREASES_H

#include <CGAL/Quad_mesh_adaptation/internal/Curve_lookup.h>
#include <CGAL/Quad_mesh_adaptation/internal/Input_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Border and crease edges of a reference surface as a graph, for finding in it the curves that an
// input mesh has.
class Reference_creases
{
public:
  // A crease turns by an angle of cosine below `cos_angle`; there are none where `off`.
  Reference_creases(const Triangle_soup& soup, double cos_angle, bool off) : soup_(soup)
  {
    std::vector<std::array<Index, 3>> edges; // and the triangle beside
    std::vector<Vec> normals;
    edges.reserve(3 * soup.triangles.size());
    normals.reserve(soup.triangles.size());
    for(const auto& t : soup.triangles) {
      for(int i = 0; i < 3; ++i) {
        const auto [u, v] = std::minmax(t[i], t[(i + 1) % 3]);
        edges.push_back({ u, v, Index(normals.size()) });
      }
      const Vec& a = soup.points[t[0]];
      normals.push_back(normalized(cross(soup.points[t[1]] - a, soup.points[t[2]] - a)));
    }
    std::sort(edges.begin(), edges.end());
    for(auto first = edges.begin(), last = first; first != edges.end(); first = last) {
      const auto [u, v, t] = *first;
      while(last != edges.end() && (*last)[0] == u && (*last)[1] == v) ++last;
      const bool is_inner = last - first == 2;
      if(is_inner && (off || normals[t] * normals[(*(last - 1))[2]] >= cos_angle)) continue;
      next_[u].push_back(v);
      next_[v].push_back(u);
    }
    for(const auto& [v, ends] : next_) by_x_.push_back({ soup.points[v].x(), v });
    std::sort(by_x_.begin(), by_x_.end());
  }

  // The vertex nearest to p, not farther than `reach`; one where curves end or meet, if there is
  // one.  -1: none.
  Index vertex_near(const Vec& p, double reach) const
  {
    Index best[2] = { -1, -1 };
    double least[2] = { reach, reach };
    const auto first =
        std::lower_bound(by_x_.begin(), by_x_.end(), std::make_pair(p.x() - reach, Index(-1)));
    for(auto it = first; it != by_x_.end() && it->first <= p.x() + reach; ++it) {
      const Index v = it->second;
      const double d = distance(p, soup_.points[v]);
      for(int k = next_.at(v).size() != 2 ? 0 : 1; k < 2; ++k)
        if(d < least[k] || (d == least[k] && !(best[k] > v))) {
          least[k] = d;
          best[k] = v;
        }
    }
    return best[0] >= 0 ? best[0] : best[1];
  }

  // The shortest way along the graph that stays within `reach` of curve c; empty: none.
  std::vector<Index> path(const Feature_curve& c, Index from, Index to, double reach) const
  {
    const Curve_lookup lookup(c);
    std::map<Index, std::pair<double, Index>> found; // cost, vertex before
    std::priority_queue<std::pair<double, Index>> queue;
    found[from] = { 0., -1 };
    queue.push({ 0., from });
    while(!queue.empty()) {
      const auto [negative, v] = queue.top();
      queue.pop();
      if(v == to) break;
      if(-negative > found[v].first) continue;
      for(Index u : next_.at(v)) {
        const Vec middle = 0.5 * (soup_.points[u] + soup_.points[v]);
        const double off = lookup.distance_to(middle) / reach;
        if(off > 1) continue;
        const double cost =
            -negative + distance(soup_.points[u], soup_.points[v]) * (1 + 100 * off * off);
        const auto it = found.find(u);
        if(it != found.end() && it->second.first <= cost) continue;
        found[u] = { cost, v };
        queue.push({ -cost, u });
      }
    }
    std::vector<Index> way;
    if(from == to || !found.count(to)) return way;
    for(Index v = to; v >= 0; v = found[v].second) way.push_back(v);
    std::reverse(way.begin(), way.end());
    return way;
  }

  // The closed curve without junction that starts near the first point of the closed curve c, in
  // its sense; its first vertex is repeated.  Empty: none within `reach` of c.
  std::vector<Index> loop(const Feature_curve& c, double reach) const
  {
    const Index start = vertex_near(c.points().front(), reach);
    if(start < 0) return {};
    const Curve_lookup lookup(c);
    std::vector<Index> way = { start };
    for(Index before = -1, v = start; way.size() == 1 || v != start;) {
      const std::vector<Index>& ends = next_.at(v);
      const Vec& p = soup_.points[v];
      if(ends.size() != 2 || lookup.distance_to(p) > reach) return {};
      const Index u = ends[0] == before ? ends[1] : ends[0];
      before = v;
      v = u;
      way.push_back(v);
    }
    const double arc =
        c.difference(c.nearest(soup_.points[way[0]]), c.nearest(soup_.points[way[way.size() / 4]]));
    if(arc < 0) std::reverse(way.begin(), way.end());
    return way;
  }

  // Its edges by their ends, each once.
  std::vector<std::array<Vec, 2>> segments() const
  {
    std::vector<std::array<Vec, 2>> list;
    for(const auto& [v, ends] : next_)
      for(Index u : ends)
        if(v < u) list.push_back({ soup_.points[v], soup_.points[u] });
    return list;
  }

private:
  const Triangle_soup& soup_;
  std::map<Index, std::vector<Index>> next_;
  std::vector<std::pair<double, Index>> by_x_; // its vertices
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_REFERENCE_CREASES_H
