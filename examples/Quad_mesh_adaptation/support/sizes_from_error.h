// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_EXAMPLES_SIZES_FROM_ERROR_H
#define QUAD_MESH_ADAPTATION_EXAMPLES_SIZES_FROM_ERROR_H

#include "zienkiewicz_zhu.h"

#include <CGAL/Quad_mesh_adaptation/limit_size_gradation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace plane_stress {

struct Size_limits
{
  double smallest, largest;
  double growth = 0.25; ///< largest slope of the size, see `limit_size_gradation()`
};

/// Size that every element should have for the error norm of the whole body to become
/// `allowed_error` with the fewest elements: with bilinear elements the error of an element of
/// size h goes like h^2, and the fewest are needed when all new elements have the same error;
/// both together give  h_new = h allowed / sqrt(e_i sum_k e_k).
inline std::vector<double> element_sizes(const Plane_mesh& mesh, const Error_estimate& estimate,
                                         double allowed_error)
{
  const std::vector<double>& error = estimate.element_error;
  const double sum = std::accumulate(error.begin(), error.end(), 0.);
  std::vector<double> sizes(error.size());
  for(std::size_t e = 0; e < error.size(); ++e) {
    const double product = error[e] * sum;
    sizes[e] = product > 0 ? mesh.mean_edge_length(e) * allowed_error / std::sqrt(product)
                           : std::numeric_limits<double>::infinity();
  }
  return sizes;
}

/// Nodal sizes from element sizes: the geometric mean over the elements at a node, each first
/// brought within the limits, in the node order of the mesh.
inline std::vector<double> nodal_sizes(const Plane_mesh& mesh, const std::vector<double>& sizes,
                                       const Size_limits& limits)
{
  std::vector<double> log_sum(mesh.nodes.size(), 0.);
  std::vector<int> count(mesh.nodes.size(), 0);
  for(std::size_t e = 0; e < mesh.quads.size(); ++e)
    for(int n : mesh.quads[e]) {
      log_sum[n] += std::log((std::min)(limits.largest, (std::max)(limits.smallest, sizes[e])));
      ++count[n];
    }
  std::vector<double> result(mesh.nodes.size(), limits.largest);
  for(std::size_t n = 0; n < result.size(); ++n)
    if(count[n] > 0) result[n] = std::exp(log_sum[n] / count[n]);
  return result;
}

/// The whole way from an error estimate to sizes at the vertices of the mesh it was made on,
/// written to `size_map` with their growth limited.
template <class QuadMesh, class VertexSizeMap>
void sizes_from_error(const QuadMesh& mesh, const Plane_mesh& plane, const Error_estimate& estimate,
                      double allowed_error, const Size_limits& limits, VertexSizeMap size_map)
{
  const std::vector<double> sizes =
      nodal_sizes(plane, element_sizes(plane, estimate, allowed_error), limits);
  std::size_t n = 0;
  for(auto v : vertices(mesh)) put(size_map, v, sizes[n++]);
  CGAL::Quad_mesh_adaptation::limit_size_gradation(mesh, size_map, limits.growth);
}

} // namespace plane_stress

#endif // QUAD_MESH_ADAPTATION_EXAMPLES_SIZES_FROM_ERROR_H
