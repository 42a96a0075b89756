// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_SIZES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_SIZES_H

#include <CGAL/Quad_mesh_adaptation/Mesh_measures.h>
#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Column of the paper's table for a size ratio: intervals closed on the left below one, on the
// right above it.
inline std::size_t size_ratio_bin(double f)
{
  if(std::abs(f - 1.) <= 1e-9) f = 1.;
  if(f < 0.5) return 0;
  if(f < 0.8) return 1;
  if(f < 0.9) return 2;
  if(f <= 1.0) return 3;
  if(f <= 1.1) return 4;
  if(f <= 1.2) return 5;
  return f <= 1.5 ? 6 : 7;
}

// Collects the ratios of all faces into a table.
class Size_ratio_counter
{
public:
  void add(double f)
  {
    ++table.counts[size_ratio_bin(f)];
    sum += f;
    min = (std::min)(min, f);
    max = (std::max)(max, f);
  }
  Size_ratio_table result() const
  {
    Size_ratio_table t = table;
    if(const std::size_t n = t.total()) {
      t.min = min;
      t.max = max;
      t.mean = sum / double(n);
    }
    return t;
  }

private:
  Size_ratio_table table;
  double sum = 0, max = 0, min = std::numeric_limits<double>::infinity();
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_SIZES_H
