// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SIZE_SAMPLER_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SIZE_SAMPLER_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Thrown by the sampler, caught at the public header: the caller's sizing field is not a size.
struct Bad_size
{
  Vec where;
  double value;
};

// How the size of a face is judged.
enum class Size_sampling
{
  centre, // eq. 3 of the paper: at the mean of the corners
  strict  // the smaller of that and the inverse root mean square at the 2 x 2 Gauss points
};

// The caller's sizing field, checked at every call.
class Size_sampler
{
public:
  Size_sampler() = default;
  Size_sampler(Size_function f, double constant) : function_(std::move(f)), constant_(constant) {}

  Size_sampling sampling = Size_sampling::strict;

  bool is_constant() const { return constant_ > 0; }

  // From now on, everything works against `factor` times the size that was given.
  void scale_by(double factor) { scale_ = factor; }

  double scale() const { return scale_; }

  double at(const Vec& p) const { return scale_ * unscaled(p); }

  double unscaled(const Vec& p) const
  {
    if(constant_ > 0) return constant_;
    const double h = function_(p);
    if(!(std::isfinite(h) && h > 0)) throw Bad_size{ p, h };
    return h;
  }

  // Wanted edge length of the bilinear face p.
  double at_face(const Corners& p) const
  {
    if(constant_ > 0) return scale_ * constant_;
    return at_face(p, at(face_centre(p)));
  }

  // The same, by what is wanted at its centre.
  double at_face(const Corners& p, double centre) const
  {
    if(constant_ > 0) return scale_ * constant_;
    const Vec c = face_centre(p);
    if(sampling == Size_sampling::centre) return centre;
    const double g = 0.5 / std::sqrt(3.);
    const Vec u = 0.5 * g * (p[1] + p[2] - p[0] - p[3]); // half steps along the two directions
    const Vec v = 0.5 * g * (p[2] + p[3] - p[0] - p[1]);
    const Vec w = g * g * (p[0] - p[1] + p[2] - p[3]);
    double sum = 0;
    for(const Vec& q : { c + u + v + w, c + u - v - w, c - u + v - w, c - u - v + w }) {
      const double h = at(q);
      sum += 1 / (h * h);
    }
    return (std::min)(centre, 2 / std::sqrt(sum));
  }

private:
  Size_function function_;
  double constant_ = 0, scale_ = 1;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SIZE_SAMPLER_H
