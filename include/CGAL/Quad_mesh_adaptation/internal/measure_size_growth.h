// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_SIZE_GROWTH_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_SIZE_GROWTH_H

#include <CGAL/Quad_mesh_adaptation/Size_growth.h>
#include <CGAL/Quad_mesh_adaptation/internal/Quad_complex.h>
#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Samples the size on a grid of cells in every face and sums up the cells that are too steep.
class Size_growth_meter
{
public:
  // `cells` per direction of a face.
  Size_growth_meter(const Size_function& size, int cells)
      : size_(size), cells_(cells), points_(std::size_t(cells + 1) * std::size_t(cells + 1)),
        sizes_(points_.size()), densities_(points_.size())
  {
  }

  void add(const std::array<Vec, 4>& face)
  {
    std::array<double, 4> at_corners;
    for(int i = 0; i < 4; ++i) at_corners[i] = size_(face[i]);
    add(face, at_corners);
  }

  // By the sizes at its corners, and those in the middles of its edges, or none.
  void add(const std::array<Vec, 4>& face, const std::array<double, 4>& at_corners,
           const std::array<double, 4>* at_middles = nullptr)
  {
    const int n = cells_;
    for(int j = 0; j <= n; ++j)
      for(int i = 0; i <= n; ++i) {
        const double u = double(i) / n, v = double(j) / n;
        Vec& p = points_[at(i, j)];
        p = (1 - v) * ((1 - u) * face[0] + u * face[1]) + v * ((1 - u) * face[3] + u * face[2]);
        const bool is_corner = i % n == 0 && j % n == 0, is_middle = n == 2 && (i + j) % 2 == 1;
        if(!is_corner && !(is_middle && at_middles)) sizes_[at(i, j)] = size_(p);
      }
    set_sizes({ at(0, 0), at(n, 0), at(n, n), at(0, n) }, at_corners);
    if(at_middles && n == 2) set_sizes({ at(1, 0), at(2, 1), at(1, 2), at(0, 1) }, *at_middles);
    add_cells();
  }

  Size_growth result() const
  {
    Size_growth g = growth_;
    if(area_ > 0) g.steep_area_share /= area_;
    if(faces_ > 0) {
      g.steep_faces_share = g.steep_faces / faces_;
      g.mean_square_slope /= faces_;
    }
    return g;
  }

  // Ideal number of faces, roughly.
  double faces() const { return faces_; }

private:
  std::size_t at(int i, int j) const { return std::size_t(j) * std::size_t(cells_ + 1) + i; }

  void set_sizes(const std::array<std::size_t, 4>& where, const std::array<double, 4>& sizes)
  {
    for(int k = 0; k < 4; ++k) sizes_[where[k]] = sizes[k];
  }

  void add_cells()
  {
    for(std::size_t k = 0; k < sizes_.size(); ++k) densities_[k] = 0.25 / (sizes_[k] * sizes_[k]);
    for(int j = 0; j < cells_; ++j)
      for(int i = 0; i < cells_; ++i)
        add_cell({ at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) });
  }

  // All six pairs of corners: some pair is within 22.5 degrees of the size's gradient.
  void add_cell(const std::array<std::size_t, 4>& c)
  {
    constexpr double followed2 = Size_growth::followed_slope * Size_growth::followed_slope;
    Slope steepest;
    double density = 0;
    for(int i = 0; i < 4; ++i) {
      density += densities_[c[i]];
      for(int j = i + 1; j < 4; ++j) {
        const Slope s = slope(c[i], c[j]);
        if(s.is_steeper_than(steepest)) steepest = s;
      }
    }
    const double steepest2 = steepest.squared();
    note(steepest, steepest2);
    const double area =
        0.5 * norm(cross(points_[c[2]] - points_[c[0]], points_[c[3]] - points_[c[1]]));
    area_ += area;
    faces_ += area * density;
    growth_.mean_square_slope += area * density * (std::min)(steepest2, 1.);
    if(!(steepest2 > followed2)) return;
    growth_.steep_area_share += area;
    growth_.steep_faces += area * density;
    for(int i = 0; i < 4; ++i)
      for(int j = i + 1; j < 4; ++j)
        if(slope(c[i], c[j]).squared() > followed2) note_jump(sizes_[c[i]], sizes_[c[j]]);
  }

  // Between two points; compared without a division.
  struct Slope
  {
    double rise2 = 0, length2 = 1;
    std::size_t from = 0, to = 0;

    bool is_steeper_than(const Slope& o) const { return rise2 * o.length2 > o.rise2 * length2; }
    double squared() const { return length2 > 0 ? rise2 / length2 : 0; }
  };

  Slope slope(std::size_t a, std::size_t b) const
  {
    const double rise = sizes_[a] - sizes_[b], length2 = (points_[a] - points_[b]).squared_length();
    return length2 > 0 ? Slope{ rise * rise, length2, a, b } : Slope{ 0, 1, a, b };
  }

  void note(const Slope& s, double squared)
  {
    if(!(squared > largest2_)) return;
    largest2_ = squared;
    growth_.largest_slope = std::sqrt(squared);
    const Vec middle = 0.5 * (points_[s.from] + points_[s.to]);
    growth_.where = { middle.x(), middle.y(), middle.z() };
  }

  void note_jump(double a, double b)
  {
    growth_.largest_jump = (std::max)(growth_.largest_jump, (std::max)(a, b) / (std::min)(a, b));
  }

  const Size_function& size_;
  int cells_;
  std::vector<Vec> points_;
  std::vector<double> sizes_, densities_; // a quarter of the inverse squares
  Size_growth growth_;
  double area_ = 0, faces_ = 0, largest2_ = 0;
};

// Sizes that faces share, asked for once.
class Shared_sizes
{
public:
  // `links`: of the quads, if they are known; else only the corners are shared.
  Shared_sizes(const std::vector<Vec>& points, const std::vector<Quad>& quads,
               const Size_function& size, const Quad_complex* links)
      : points_(points), quads_(quads), size_(size), links_(links), at_points_(points.size(), 0.),
        at_middles_(links ? 4 * quads.size() : 0)
  {
  }

  std::array<double, 4> at_corners(std::size_t f)
  {
    std::array<double, 4> sizes;
    for(int i = 0; i < 4; ++i) {
      double& h = at_points_[quads_[f][i]]; // not known: zero
      if(!(h > 0)) h = size_(points_[quads_[f][i]]);
      sizes[i] = h;
    }
    return sizes;
  }

  // Faces are asked for in order.  Precondition: links are known.
  std::array<double, 4> at_middles(std::size_t f)
  {
    std::array<double, 4> sizes;
    const Quad& q = quads_[f];
    for(int i = 0; i < 4; ++i) {
      const std::size_t h = 4 * f + std::size_t(i);
      const Index o = links_->opposite(Index(h));
      const bool is_known = o >= 0 && std::size_t(o) < h;
      at_middles_[h] = sizes[i] =
          is_known ? at_middles_[o] : size_(0.5 * (points_[q[i]] + points_[q[(i + 1) & 3]]));
    }
    return sizes;
  }

private:
  const std::vector<Vec>& points_;
  const std::vector<Quad>& quads_;
  const Size_function& size_;
  const Quad_complex* links_;
  std::vector<double> at_points_, at_middles_; // by half-edge
};

// At least two cells along each side of a face, and some 4096 in all.  Less is asked for of a size
// where the links of the quads are known.
inline Size_growth measure_size_growth(const std::vector<Vec>& points,
                                       const std::vector<Quad>& quads, const Size_function& size,
                                       const Quad_complex* links = nullptr)
{
  if(quads.empty()) return Size_growth();
  const int cells = (std::max)(2, int(std::ceil(std::sqrt(4096. / double(quads.size())))));
  Size_growth_meter meter(size, cells);
  Shared_sizes shared(points, quads, size, cells == 2 ? links : nullptr);
  for(std::size_t f = 0; f < quads.size(); ++f) {
    const Quad& q = quads[f];
    const std::array<Vec, 4> p = { points[q[0]], points[q[1]], points[q[2]], points[q[3]] };
    const std::array<double, 4> at_corners = shared.at_corners(f);
    if(links && cells == 2) {
      const std::array<double, 4> at_middles = shared.at_middles(f);
      meter.add(p, at_corners, &at_middles);
    } else {
      meter.add(p, at_corners);
    }
  }
  return meter.result();
}

// What to tell the user; empty when quads can follow.
inline std::string advice_on(const Size_growth& g)
{
  if(!g.is_too_steep()) return std::string();
  std::ostringstream text;
  text.precision(3);
  text
      << "the size grows by up to " << g.largest_slope << " per unit of length (at " << g.where[0]
      << ", " << g.where[1] << ", " << g.where[2] << "), and by more than the "
      << Size_growth::followed_slope
      << " that quads can follow on the part of the surface that holds "
      << 100 * g.steep_faces_share << " % of the ideal number of faces; there many vertices are "
      << "irregular and the efficiency is low; Graded_sizing_field (--gradation) bounds the growth";
  return text.str();
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_SIZE_GROWTH_H
