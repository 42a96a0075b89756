// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_SIZE_RANGE_H
#define CGAL_QUAD_MESH_ADAPTATION_SIZE_RANGE_H

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace CGAL {
namespace Quad_mesh_adaptation {

/// Bounds of edge lengths, in units of the coordinates.
struct Size_range
{
  double smallest = 0;
  double largest = std::numeric_limits<double>::infinity();

  double clamp(double size) const { return (std::min)((std::max)(size, smallest), largest); }

  /// \throws std::invalid_argument unless 0 <= smallest <= largest and largest > 0.
  void check() const
  {
    if(!(smallest >= 0 && smallest <= largest && largest > 0 &&
         smallest < std::numeric_limits<double>::infinity()))
      throw std::invalid_argument("Size_range: 0 <= smallest <= largest does not hold");
  }
};

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_SIZE_RANGE_H
