// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CURVE_LENGTHS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CURVE_LENGTHS_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/Curve_bend.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The edges that the size asks for along a curve.
inline double length_in_sizes(const Feature_curve& c, const Size_sampler& size)
{
  double sum = 0;
  for(std::size_t i = 0; i + 1 < c.points().size(); ++i) {
    const Vec &a = c.points()[i], &b = c.points()[i + 1];
    // Simpson's rule
    sum += distance(a, b) * (1 / size.at(a) + 4 / size.at(0.5 * (a + b)) + 1 / size.at(b)) / 6;
  }
  return sum;
}

// A curve with more bends than that can not have a node at each.
inline bool may_keep_length(const Feature_curve& c, const Size_sampler& size)
{
  constexpr double surplus = 1.25; // edges are no longer than asked
  return double(bends_of(c).size()) <= surplus * length_in_sizes(c, size);
}

// Which curves have kept their length, to one in a thousand, where the sizes let them?  Those along
// which a mirror plane cuts the surface are none of the caller's and do not count.
inline std::vector<char> curves_that_kept_length(const Adaptation_state& s)
{
  constexpr double tolerance = 1e-3;
  const Quad_complex& m = s.mesh;
  std::vector<double> length(s.curves.size(), 0);
  for(Index h : m.halfedges())
    if(m.curve(h) >= 0 && m.opposite(h) < h) // each edge once
      length[m.curve(h)] += distance(m.point(m.origin(h)), m.point(m.target(h)));
  std::vector<char> kept;
  for(std::size_t c = 0; c < length.size(); ++c)
    kept.push_back(!s.curves[c].is_cut && length[c] >= (1 - tolerance) * s.curves[c].length() &&
                   may_keep_length(s.curves[c], s.size));
  return kept;
}

// Have all curves their length that had it?
inline bool have_kept_length(const Adaptation_state& s, const std::vector<char>& before)
{
  const std::vector<char> now = curves_that_kept_length(s);
  for(std::size_t c = 0; c < now.size(); ++c)
    if(before[c] && !now[c]) return false;
  return true;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CURVE_LENGTHS_H
