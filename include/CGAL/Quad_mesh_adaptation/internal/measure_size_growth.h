// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_SIZE_GROWTH_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_SIZE_GROWTH_H

#include <CGAL/Quad_mesh_adaptation/Size_growth.h>
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
        sizes_(points_.size())
  {
  }

  void add(const std::array<Vec, 4>& face)
  {
    for(int j = 0; j <= cells_; ++j)
      for(int i = 0; i <= cells_; ++i) {
        const double u = double(i) / cells_, v = double(j) / cells_;
        Vec& p = points_[at(i, j)];
        p = (1 - v) * ((1 - u) * face[0] + u * face[1]) + v * ((1 - u) * face[3] + u * face[2]);
        sizes_[at(i, j)] = size_(p);
      }
    for(int j = 0; j < cells_; ++j)
      for(int i = 0; i < cells_; ++i)
        add_cell({ at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) });
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

  // All six pairs of corners: some pair is within 22.5 degrees of the size's gradient.
  void add_cell(const std::array<std::size_t, 4>& c)
  {
    double steepest = 0, density = 0;
    for(int i = 0; i < 4; ++i) {
      density += 0.25 / (sizes_[c[i]] * sizes_[c[i]]);
      for(int j = i + 1; j < 4; ++j) steepest = (std::max)(steepest, slope(c[i], c[j]));
    }
    const double area =
        0.5 * norm(cross(points_[c[2]] - points_[c[0]], points_[c[3]] - points_[c[1]]));
    area_ += area;
    faces_ += area * density;
    growth_.mean_square_slope += area * density * (std::min)(steepest * steepest, 1.);
    if(!(steepest > Size_growth::followed_slope)) return;
    growth_.steep_area_share += area;
    growth_.steep_faces += area * density;
  }

  double slope(std::size_t a, std::size_t b)
  {
    const double length = distance(points_[a], points_[b]);
    if(!(length > 0)) return 0;
    const double result = std::abs(sizes_[a] - sizes_[b]) / length;
    if(result > growth_.largest_slope) {
      growth_.largest_slope = result;
      const Vec middle = 0.5 * (points_[a] + points_[b]);
      growth_.where = { middle.x(), middle.y(), middle.z() };
    }
    if(result > Size_growth::followed_slope)
      growth_.largest_jump = (std::max)(growth_.largest_jump, (std::max)(sizes_[a], sizes_[b]) /
                                                                  (std::min)(sizes_[a], sizes_[b]));
    return result;
  }

  const Size_function& size_;
  int cells_;
  std::vector<Vec> points_;
  std::vector<double> sizes_;
  Size_growth growth_;
  double area_ = 0, faces_ = 0;
};

// At least two cells along each side of a face, and some 4096 in all.
inline Size_growth measure_size_growth(const std::vector<Vec>& points,
                                       const std::vector<Quad>& quads, const Size_function& size)
{
  if(quads.empty()) return Size_growth();
  const int cells = (std::max)(2, int(std::ceil(std::sqrt(4096. / double(quads.size())))));
  Size_growth_meter meter(size, cells);
  for(const Quad& q : quads) meter.add({ points[q[0]], points[q[1]], points[q[2]], points[q[3]] });
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
