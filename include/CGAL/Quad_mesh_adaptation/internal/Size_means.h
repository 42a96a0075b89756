// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SIZE_MEANS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SIZE_MEANS_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/Input_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// A mirror plane of vertices and sizes holds the mean of the vertices, also with the sizes or their
// inverses as weights.  Where these means differ they rule out most planes at once, and a change
// of the sizes in a small place is enough for that.
class Size_means
{
public:
  Size_means(const Input_mesh& in, const Adaptation_state& s, const Vec& centre, double reach)
      : points_(in.points), centre_(centre), reach_(reach)
  {
    if(s.size.is_constant()) return;
    std::array<double, 2> weights = { 0, 0 };
    for(std::size_t v = 0; v < points_.size(); ++v) {
      const double h = s.mesh.vertex(Index(v)).h;
      const Vec p = points_[v] - centre;
      weights[0] += h;
      weights[1] += 1 / h;
      lean_[0] = lean_[0] + h * p;
      lean_[1] = lean_[1] + (1 / h) * p;
    }
    for(int i = 0; i < 2; ++i) lean_[i] = lean_[i] / weights[i];
  }

  // Is the plane through the centre none?
  bool rule_out(const Vec& normal) const
  {
    return std::any_of(lean_.begin(), lean_.end(), [&](const Vec& lean) {
      return std::abs(normal * lean) > 10 * error * reach_;
    });
  }

  // Are there none at all but that of the mesh itself, of this normal if it is flat (else zero)?
  bool rule_out_all(const Vec& normal_of_flat) const
  {
    constexpr double most = 1e-4;
    const bool is_flat = norm(normal_of_flat) > 0;
    const Vec n = cross(lean_[0], is_flat ? normal_of_flat : lean_[1]);
    const double sides = norm(lean_[0]) + (is_flat ? 0. : norm(lean_[1]));
    if(!(norm(n) > 0)) return false;
    const double direction = error * reach_ * (is_flat ? 1. : sides) / norm(n);
    return direction < most && !maps_some(normalized(n), (4 * direction + error) * reach_);
  }

private:
  static constexpr double error = 1e-8; // of the means, over the reach, where there is a plane

  // Is there a vertex so near to the image of each of a few?
  bool maps_some(const Vec& normal, double near) const
  {
    const std::size_t step = (std::max)(points_.size() / 7, std::size_t(1));
    for(std::size_t v = 0; v < points_.size(); v += step) {
      const Vec image = points_[v] - 2 * (normal * (points_[v] - centre_)) * normal;
      if(std::none_of(points_.begin(), points_.end(),
                      [&](const Vec& p) { return (p - image).squared_length() <= near * near; }))
        return false;
    }
    return true;
  }

  const std::vector<Vec>& points_;
  Vec centre_;
  double reach_;
  std::array<Vec, 2> lean_ = { Vec(0, 0, 0), Vec(0, 0, 0) }; // of the means, from the centre
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SIZE_MEANS_H
