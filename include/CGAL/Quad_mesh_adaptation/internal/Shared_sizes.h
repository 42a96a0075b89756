// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SHARED_SIZES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SHARED_SIZES_H

#include <CGAL/Quad_mesh_adaptation/internal/Quad_complex.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Sizes that faces share, asked for once.
template <typename Size>
class Shared_sizes
{
public:
  // `links`: of the quads, if they are known; else only the corners are shared.  `has_sizes`: its
  // nodes have their sizes already.  `asks_all`: all faces are asked for.
  Shared_sizes(const std::vector<Vec>& points, const std::vector<Quad>& quads, const Size& size,
               const Quad_complex* links, bool has_sizes, bool asks_all)
      : points_(points), quads_(quads), size_(size), links_(links), has_sizes_(has_sizes),
        asks_all_(asks_all), at_points_(has_sizes ? 0 : points.size(), 0.),
        at_middles_(links && asks_all ? 4 * quads.size() : 0)
  {
  }

  std::array<double, 4> at_corners(std::size_t f)
  {
    std::array<double, 4> sizes;
    for(int i = 0; i < 4; ++i) sizes[i] = at_point(quads_[f][i]);
    return sizes;
  }

  // Faces are asked for in order.  Precondition: links are known.
  std::array<double, 4> at_middles(std::size_t f)
  {
    std::array<double, 4> sizes;
    const Quad& q = quads_[f];
    for(int i = 0; i < 4; ++i) {
      const auto ask = [&] { return size_(0.5 * (points_[q[i]] + points_[q[(i + 1) & 3]])); };
      if(!asks_all_) {
        sizes[i] = ask();
        continue;
      }
      const std::size_t h = 4 * f + std::size_t(i);
      const Index o = links_->opposite(Index(h));
      const bool is_known = o >= 0 && std::size_t(o) < h;
      at_middles_[h] = sizes[i] = is_known ? at_middles_[o] : ask();
    }
    return sizes;
  }

private:
  double at_point(Index v)
  {
    if(has_sizes_) { // but where the node has been put somewhere else
      const Vertex_record& r = links_->vertex(v);
      return r.p == points_[v] && !r.frozen ? r.h : size_(points_[v]);
    }
    double& h = at_points_[v]; // not known: zero
    if(!(h > 0)) h = size_(points_[v]);
    return h;
  }

  const std::vector<Vec>& points_;
  const std::vector<Quad>& quads_;
  const Size& size_;
  const Quad_complex* links_;
  bool has_sizes_, asks_all_;
  std::vector<double> at_points_, at_middles_; // by half-edge
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SHARED_SIZES_H
