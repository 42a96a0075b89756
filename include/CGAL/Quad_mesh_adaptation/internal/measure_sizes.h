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

// The size a face must meet wherever its centre lies: the smaller of the size at the centre and
// the inverse root mean square of the sizes at the 2x2 Gauss points of the bilinear patch.
template <typename Size>
double strict_size(const Corners& p, const Size& size, double size_at_centre)
{
  const double offset = 0.5 / std::sqrt(3.);
  double density = 0;
  for(double u : { 0.5 - offset, 0.5 + offset })
    for(double v : { 0.5 - offset, 0.5 + offset }) {
      const double h =
          size((1 - u) * (1 - v) * p[0] + u * (1 - v) * p[1] + u * v * p[2] + (1 - u) * v * p[3]);
      density += 0.25 / (h * h);
    }
  return (std::min)(size_at_centre, 1. / std::sqrt(density));
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
