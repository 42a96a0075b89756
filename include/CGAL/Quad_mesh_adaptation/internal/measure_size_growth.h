// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_SIZE_GROWTH_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_SIZE_GROWTH_H

#include <CGAL/Quad_mesh_adaptation/Size_growth.h>
#include <CGAL/Quad_mesh_adaptation/internal/Shared_sizes.h>
#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>
#include <CGAL/Quad_mesh_adaptation/internal/number_text.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Samples the size on a grid of cells in every face and sums up the cells that are too steep.
template <typename Size>
class Size_growth_meter
{
public:
  // `cells` per direction of a face.
  Size_growth_meter(const Size& size, int cells)
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

  // By the sizes at its corners.
  void add(const std::array<Vec, 4>& face, const std::array<double, 4>& at_corners)
  {
    const int n = cells_;
    for(int j = 0; j <= n; ++j)
      for(int i = 0; i <= n; ++i) {
        const double u = double(i) / n, v = double(j) / n;
        Vec& p = points_[at(i, j)];
        p = (1 - v) * ((1 - u) * face[0] + u * face[1]) + v * ((1 - u) * face[3] + u * face[2]);
        if(i % n != 0 || j % n != 0) sizes_[at(i, j)] = size_(p);
      }
    set_sizes({ at(0, 0), at(n, 0), at(n, n), at(0, n) }, at_corners);
    for(std::size_t k = 0; k < sizes_.size(); ++k) densities_[k] = 0.25 / (sizes_[k] * sizes_[k]);
    for(int j = 0; j < n; ++j)
      for(int i = 0; i < n; ++i) {
        const Cell c = { at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) };
        add_cell(c, steepest_in(c).squared());
      }
  }

  // The same in four cells, by those in the middles of its edges, too.
  void add(const std::array<Vec, 4>& face, const std::array<double, 4>& at_corners,
           const std::array<double, 4>& at_middles)
  {
    const Vec low = 0.5 * (face[0] + face[1]), high = 0.5 * (face[3] + face[2]);
    points_ = { face[0],
                low,
                face[1],
                0.5 * (face[0] + face[3]),
                0.5 * (low + high),
                0.5 * (face[1] + face[2]),
                face[3],
                high,
                face[2] };
    sizes_ = { at_corners[0], at_middles[0], at_corners[1], at_middles[3], size_(points_[4]),
               at_middles[1], at_corners[3], at_middles[2], at_corners[2] };
    for(std::size_t k = 0; k < 9; ++k) densities_[k] = 0.25 / (sizes_[k] * sizes_[k]);
    std::array<double, 6> rows, columns; // squared slopes along edges of the cells
    for(std::size_t k = 0; k < 6; ++k) {
      const std::size_t r = k / 2 * 3 + k % 2;
      rows[k] = slope(r, r + 1).squared();
      columns[k] = slope(k, k + 3).squared();
    }
    for(std::size_t k = 0; k < 4; ++k) {
      const std::size_t j = k / 2, i = k % 2, c = 3 * j + i;
      const double steepest =
          (std::max)({ rows[2 * j + i], rows[2 * j + 2 + i], columns[c], columns[c + 1],
                       slope(c, c + 4).squared(), slope(c + 1, c + 3).squared() });
      add_cell({ c, c + 1, c + 4, c + 3 }, steepest);
    }
  }

  // As one cell, if nothing steep shows at its corners; tells whether that is so.
  bool add_gentle(const std::array<Vec, 4>& face, const std::array<double, 4>& at_corners)
  {
    constexpr double gentle2 = 0.25 * Size_growth::followed_slope * Size_growth::followed_slope;
    std::copy(face.begin(), face.end(), points_.begin());
    std::copy(at_corners.begin(), at_corners.end(), sizes_.begin());
    const double steepest = steepest_in({ 0, 1, 2, 3 }).squared();
    if(steepest > gentle2) return false;
    for(std::size_t k = 0; k < 4; ++k) densities_[k] = 0.25 / (sizes_[k] * sizes_[k]);
    add_cell({ 0, 1, 2, 3 }, steepest);
    return true;
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

  using Cell = std::array<std::size_t, 4>; // corners

  // `steepest`: the largest squared slope between its corners.
  void add_cell(const Cell& c, double steepest)
  {
    constexpr double followed2 = Size_growth::followed_slope * Size_growth::followed_slope;
    double density = 0;
    for(std::size_t k : c) density += densities_[k];
    if(steepest > largest2_) note(steepest_in(c), steepest);
    const double area =
        0.5 * norm(cross(points_[c[2]] - points_[c[0]], points_[c[3]] - points_[c[1]]));
    area_ += area;
    faces_ += area * density;
    growth_.mean_square_slope += area * density * (std::min)(steepest, 1.);
    if(!(steepest > followed2)) return;
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

  // All six pairs of corners: some pair is within 22.5 degrees of the size's gradient.
  Slope steepest_in(const Cell& c) const
  {
    Slope steepest;
    for(int i = 0; i < 4; ++i)
      for(int j = i + 1; j < 4; ++j) {
        const Slope s = slope(c[i], c[j]);
        if(s.is_steeper_than(steepest)) steepest = s;
      }
    return steepest;
  }

  void note(const Slope& s, double squared)
  {
    largest2_ = squared;
    growth_.largest_slope = std::sqrt(squared);
    const Vec middle = 0.5 * (points_[s.from] + points_[s.to]);
    growth_.where = { middle.x(), middle.y(), middle.z() };
  }

  void note_jump(double a, double b)
  {
    growth_.largest_jump = (std::max)(growth_.largest_jump, (std::max)(a, b) / (std::min)(a, b));
  }

  const Size& size_;
  int cells_;
  std::vector<Vec> points_;
  std::vector<double> sizes_, densities_; // a quarter of the inverse squares
  Size_growth growth_;
  double area_ = 0, faces_ = 0, largest2_ = 0;
};

// What is known before the size is asked for.
struct Known_for_growth
{
  const Quad_complex* links = nullptr; // of the quads
  bool has_sizes = false;              // do the nodes there have their sizes?
  bool fits_mostly = false;            // are the quads about as large as the size?
};

// At least two cells along each side of a face, and some 4096 in all.  Less is asked for of a size
// where the links of the quads are known, and less still where the nodes there have their sizes.
// Where the quads fit, too, their corners tell of most that the size hardly grows there.
template <typename Size>
Size_growth measure_size_growth(const std::vector<Vec>& points, const std::vector<Quad>& quads,
                                const Size& size, const Known_for_growth& known = {})
{
  if(quads.empty()) return Size_growth();
  const int cells = (std::max)(2, int(std::ceil(std::sqrt(4096. / double(quads.size())))));
  const bool is_linked = known.links && cells == 2, has_sizes = is_linked && known.has_sizes;
  const bool looks_first = has_sizes && known.fits_mostly;
  Size_growth_meter meter(size, cells);
  Shared_sizes shared(points, quads, size, is_linked ? known.links : nullptr, has_sizes,
                      !looks_first);
  for(std::size_t f = 0; f < quads.size(); ++f) {
    const Quad& q = quads[f];
    const std::array<Vec, 4> p = { points[q[0]], points[q[1]], points[q[2]], points[q[3]] };
    const std::array<double, 4> at_corners = shared.at_corners(f);
    if(looks_first && meter.add_gentle(p, at_corners)) continue;
    if(is_linked)
      meter.add(p, at_corners, shared.at_middles(f));
    else
      meter.add(p, at_corners);
  }
  return meter.result();
}

// What to tell the user; empty when quads can follow.
inline std::string advice_on(const Size_growth& g)
{
  if(!g.is_too_steep()) return std::string();
  return "the size grows by up to " + rounded_text(g.largest_slope, 3) + " per unit of length at " +
         point_text(Vec(g.where[0], g.where[1], g.where[2])) + ", and by more than the " +
         number_text(Size_growth::followed_slope) +
         " that quads can follow on the part of the surface that holds " +
         rounded_text(100 * g.steep_faces_share, 3) +
         " % of the ideal number of faces; there many vertices are irregular and the efficiency is "
         "low; Graded_sizing_field bounds the growth";
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_SIZE_GROWTH_H
