// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SMOOTHING_WEIGHTS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SMOOTHING_WEIGHTS_H

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// What the smoother minimises: shape + size * (r^power / 2) + hinge * max(0, r - hinge_at)^2.
struct Smoothing_weights
{
  double size = 1;
  int power = 10;
  double hinge = 0; // switched on for the last sweeps
  double hinge_at = 0.985;
  double wake = 0.003;           // neighbours look again after moves above this share of an edge
  double pressed_wake = 0.003;   // the same about a face that is too large, under a hinge
  double stir = 0.02;            // and operations about the node are tried again above this one
  bool keep_within_size = false; // no move leaves a face above its size that was not
  double min_corner = 0.45;      // no corner measure 2 D / N falls below min(this, worst before)
};

// While it exists the smoother presses faces within their sizes.
class Pressing
{
public:
  explicit Pressing(Smoothing_weights& w) : weights_(w), gentle_(w.hinge) { w.hinge = hard; }
  Pressing(const Pressing&) = delete;
  Pressing& operator=(const Pressing&) = delete;
  ~Pressing() { weights_.hinge = gentle_; }

  static constexpr double hard = 2000;

private:
  Smoothing_weights& weights_;
  const double gentle_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SMOOTHING_WEIGHTS_H
