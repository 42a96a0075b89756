// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SPREAD_SIZES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SPREAD_SIZES_H

#include <CGAL/Quad_mesh_adaptation/internal/Face_arrays.h>
#include <CGAL/Quad_mesh_adaptation/internal/lower_values.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Lowers sizes at vertices so that faces whose middle is elsewhere, but that reach a vertex, are no
// larger than asked there: within half a size about it its size holds, and grows by `slope` from
// there on.  Distances are straight, from vertices that are found along edges.
inline void spread_sizes(const Face_arrays& mesh, double slope, std::vector<double>& size)
{
  constexpr double least_gain = 1e-9; // relative; makes the revisits end
  std::vector<std::vector<Index>> neighbours(size.size());
  for(Index h = 0; h < mesh.number_of_halfedges(); ++h) {
    const Index v = mesh.origin[h], w = mesh.origin[mesh.next(h)];
    neighbours[v].push_back(w);
    if(mesh.opposite[h] < 0) neighbours[w].push_back(v);
  }
  const std::vector<double> asked = size;
  std::vector<Index> from(size.size()); // whose size counts
  std::iota(from.begin(), from.end(), Index(0));
  lower_values(size, [&](double, Index v, const auto& lower) {
    const Index s = from[v];
    for(Index w : neighbours[v]) {
      const double apart = distance(mesh.points[s], mesh.points[w]) - asked[s] / 2;
      const double here = asked[s] + slope * (std::max)(apart, 0.);
      if(!(here < size[w] * (1 - least_gain))) continue;
      from[w] = s;
      lower(w, here);
    }
  });
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SPREAD_SIZES_H
