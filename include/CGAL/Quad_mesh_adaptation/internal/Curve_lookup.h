// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CURVE_LOOKUP_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CURVE_LOOKUP_H

#include <CGAL/Quad_mesh_adaptation/internal/Feature_curve.h>
#include <CGAL/Quad_mesh_adaptation/internal/boxes.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Finds nearest points of a curve as Feature_curve::nearest() does, in logarithmic time, for many
// questions: boxes about a few segments each, and about two boxes each above these.
class Curve_lookup
{
public:
  // The curve must stay where it is.
  explicit Curve_lookup(const Feature_curve& c) : c_(&c)
  {
    while(leaves_ * in_leaf < segments()) leaves_ *= 2;
    boxes_.resize(2 * leaves_);
    const std::vector<Vec>& p = c.points();
    for(std::size_t i = 0; i < segments(); ++i)
      for(const Vec& end : { p[i], p[i + 1] }) boxes_[leaves_ + i / in_leaf].add(end);
    for(std::size_t k = leaves_ - 1; k > 0; --k)
      for(std::size_t part : { 2 * k, 2 * k + 1 })
        if(!boxes_[part].is_empty())
          for(const Vec& end : { boxes_[part].low, boxes_[part].high }) boxes_[k].add(end);
  }

  const Feature_curve& curve() const { return *c_; }
  const Box& box() const { return boxes_[1]; }

  // Arc length of the point of the curve nearest to p.
  double nearest(const Vec& p) const
  {
    Found best;
    search(1, p, best);
    return best.arc;
  }

  double distance_to(const Vec& p) const { return distance(p, c_->point(nearest(p))); }

private:
  static constexpr std::size_t in_leaf = 8;

  struct Found
  {
    double distance2 = std::numeric_limits<double>::infinity(), arc = 0;
    std::size_t segment = 0; // the first of equals counts
  };

  std::size_t segments() const { return c_->points().empty() ? 0 : c_->points().size() - 1; }

  void search(std::size_t k, const Vec& p, Found& best) const
  {
    if(boxes_[k].squared_distance(p) > best.distance2) return;
    if(k >= leaves_) {
      const std::size_t first = (k - leaves_) * in_leaf;
      for(std::size_t i = first; i < (std::min)(first + in_leaf, segments()); ++i)
        look_at(i, p, best);
      return;
    }
    const bool turned = boxes_[2 * k + 1].squared_distance(p) < boxes_[2 * k].squared_distance(p);
    search(2 * k + (turned ? 1 : 0), p, best);
    search(2 * k + (turned ? 0 : 1), p, best);
  }

  void look_at(std::size_t i, const Vec& p, Found& best) const
  {
    double arc = 0;
    const double d2 = c_->squared_distance_to_segment(i, p, arc);
    if(d2 < best.distance2 || (d2 == best.distance2 && i < best.segment)) best = { d2, arc, i };
  }

  const Feature_curve* c_;
  std::size_t leaves_ = 1;
  std::vector<Box> boxes_; // the parts of box k are 2 k and 2 k + 1
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CURVE_LOOKUP_H
