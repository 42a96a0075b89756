// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISTANCE_BOUND_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISTANCE_BOUND_H

#include <CGAL/Quad_mesh_adaptation/Mesh_measures.h>
#include <CGAL/Quad_mesh_adaptation/internal/Distance_limit.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The largest distance to the reference that the caller allows, as a limit of the sizes of a state;
// an infinite one does nothing.
class Distance_bound
{
public:
  // From now on the sizes of the state are limited, once start() has been called.
  Distance_bound(Adaptation_state& s, double allowed) : s_(s), allowed_(allowed)
  {
    if(!is_asked_for()) return;
    const Size_sampling sampling = s.size.sampling;
    const double scale = s.size.scale();
    s.size = Size_sampler(
        [this, given = s.size](const Vec& p) {
          const double h = given.unscaled(p);
          return limit_ && h > limit_->least() ? (std::min)(h, (*limit_)(p)) : h;
        },
        0);
    s.size.sampling = sampling;
    s.size.scale_by(scale);
  }
  Distance_bound(const Distance_bound&) = delete; // the sizes refer to it
  Distance_bound& operator=(const Distance_bound&) = delete;

  double allowed() const { return allowed_; }

  // With nodes, curves and reference surface in place.
  void start()
  {
    if(!is_asked_for()) return;
    limit_ = std::make_unique<Distance_limit>(s_, allowed_);
    s_.limit_distance(allowed_);
    s_.renew_sizes();
  }

  // Sizes are those given again.
  void lift()
  {
    if(!is_asked_for()) return;
    limit_.reset();
    s_.renew_sizes();
  }

  // The faces that are too far off, looked at more closely than for the distances of the report,
  // which are raised then.
  std::vector<Index> faces_too_far(Mesh_measures& report) const
  {
    std::vector<Index> list;
    if(!is_asked_for()) return list;
    const Distance_measure distances(s_, allowed_);
    for(Index f : s_.mesh.faces())
      if(distances.of(f) > allowed_) list.push_back(f);
    raise(report.mesh_to_reference, distances.to_reference());
    raise(report.reference_to_mesh, distances.from_reference());
    return list;
  }

  bool is_asked_for() const { return std::isfinite(allowed_); }

private:
  // Those within the bound may be too much.
  void raise(double& reported, double found) const
  {
    if(found > allowed_) reported = (std::max)(reported, found);
  }

  Adaptation_state& s_;
  double allowed_;
  std::unique_ptr<Distance_limit> limit_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISTANCE_BOUND_H
