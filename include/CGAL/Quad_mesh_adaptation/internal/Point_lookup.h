// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_POINT_LOOKUP_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_POINT_LOOKUP_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Finds points of a list by their position, in logarithmic time: they are sorted along a direction
// that is unlikely to be that of anything in a model.  Points at exactly the same place form a
// class and are known by the lowest number among them.
class Point_lookup
{
public:
  Point_lookup(const std::vector<Vec>& points, double tolerance)
      : points_(points), tolerance_(tolerance), class_(points.size())
  {
    for(std::size_t v = 0; v < points.size(); ++v)
      sorted_.emplace_back(points[v] * direction(), Index(v));
    std::sort(sorted_.begin(), sorted_.end());
    for(std::size_t i = 0; i < sorted_.size(); ++i) {
      const Index v = sorted_[i].second;
      class_[v] = v;
      // equal points have equal keys, and the lower number comes first
      for(std::size_t j = i; j > 0 && sorted_[j - 1].first == sorted_[i].first; --j)
        if(points[sorted_[j - 1].second] == points[v]) class_[v] = class_[sorted_[j - 1].second];
    }
  }

  Index class_of(Index v) const { return class_[v]; }

  // The class of the nearest point within the tolerance, -1 if there is none.
  Index find(const Vec& p) const
  {
    const double key = p * direction();
    Index best = -1;
    double least = tolerance_ * tolerance_;
    for(auto it = std::lower_bound(sorted_.begin(), sorted_.end(),
                                   std::make_pair(key - tolerance_, Index(-1)));
        it != sorted_.end() && it->first <= key + tolerance_; ++it) {
      const double d = (points_[it->second] - p).squared_length();
      if(d > least || (d == least && best >= 0)) continue;
      least = d;
      best = class_[it->second];
    }
    return best;
  }

private:
  static Vec direction() { return Vec(0.69314718, 0.57721566, 0.43181937); } // about unit length

  const std::vector<Vec>& points_;
  double tolerance_;
  std::vector<std::pair<double, Index>> sorted_; // position along the direction, number
  std::vector<Index> class_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_POINT_LOOKUP_H
