// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SIZE_SAMPLER_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SIZE_SAMPLER_H

#include <CGAL/Quad_mesh_adaptation/internal/Face_sizes.h>

#include <cmath>
#include <optional>
#include <utility>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Thrown by the sampler, caught at the public header: the caller's sizing field is not a size.
struct Bad_size
{
  double value;
  std::optional<Vec> where; // a number is wrong everywhere
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
    if(!(std::isfinite(h) && h > 0)) throw Bad_size{ h, p };
    return h;
  }

  // Wanted edge length of the bilinear face p.
  double at_face(const Corners& p) const
  {
    if(constant_ > 0) return scale_ * constant_;
    if(sampling == Size_sampling::centre) return at(face_centre(p));
    return sizes_of_face(p, [this](const Vec& q) { return unscaled(q); }).strict(scale_);
  }

private:
  Size_function function_;
  double constant_ = 0, scale_ = 1;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SIZE_SAMPLER_H
