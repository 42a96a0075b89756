// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LARGEST_DISTANCE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LARGEST_DISTANCE_H

#include <CGAL/Quad_mesh_adaptation/internal/Reference_surface.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The largest distance of many points from a surface, by walks over it.  A walk may stop too far
// away, but then it gives too much: so it is enough to look at the largest few again, among all
// triangles, until one is confirmed.
class Largest_distance
{
public:
  // What is no larger than that does not matter, and need not be looked for.
  double threshold() const
  {
    return doubts_.size() == most ? (std::max)(confirmed_, doubts_.back().distance) : confirmed_;
  }

  // One that is known for sure; `face`: where it was found, if that matters.
  void note(double d, Index face = -1)
  {
    if(!(d > confirmed_)) return;
    confirmed_ = d;
    face_ = face;
  }

  // One by walking, of a point that should be looked for on a patch (-1: any) and on triangles that
  // do not face away from `direction`.
  void doubt(double d, const Vec& p, Index patch, const Vec& direction, Index face = -1)
  {
    if(!(d > threshold())) return;
    if(doubts_.size() == most) doubts_.pop_back();
    const auto place = std::find_if(doubts_.begin(), doubts_.end(),
                                    [d](const Doubt& x) { return x.distance < d; });
    doubts_.insert(place, { d, p, direction, patch, face });
  }

  // False if the largest may be among those not kept: all but a few walks went wrong.
  bool settle(const Reference_surface& surface)
  {
    for(const Doubt& x : doubts_) {
      if(x.distance <= confirmed_) return true;
      Index nearer = surface.scan_nearer(x.p, x.patch, x.direction, x.distance);
      double d = x.distance;
      if(nearer >= 0) d = (std::min)(d, distance(x.p, surface.project(x.p, nearer)));
      note(d, x.face);
    }
    const bool is_settled = doubts_.size() < most || doubts_.back().distance <= confirmed_;
    doubts_.clear();
    return is_settled;
  }

  double value() const { return confirmed_; }
  Index face() const { return face_; } // -1: none

private:
  static constexpr std::size_t most = 16;

  struct Doubt
  {
    double distance;
    Vec p, direction;
    Index patch, face;
  };

  std::vector<Doubt> doubts_; // the largest few, in order
  double confirmed_ = 0;
  Index face_ = -1;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_LARGEST_DISTANCE_H
