// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_FACES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_FACES_H

#include <CGAL/Quad_mesh_adaptation/Mesh_measures.h>
#include <CGAL/Quad_mesh_adaptation/internal/Face_figures.h>
#include <CGAL/Quad_mesh_adaptation/internal/Face_sizes.h>
#include <CGAL/Quad_mesh_adaptation/internal/ideal_count.h>
#include <CGAL/Quad_mesh_adaptation/internal/measure_quality.h>
#include <CGAL/Quad_mesh_adaptation/internal/measure_sizes.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Measures faces one after the other.
template <typename Size>
class Face_meter
{
public:
  // `integrates`: what the sizes ask for is wanted, too.
  Face_meter(const Size& size, bool integrates) : size_(size), integrates_(integrates) {}

  Face_figures operator()(std::size_t k, const std::array<Vec, 4>& p)
  {
    Face_figures x;
    const Face_shape shape = look_at(k, p);
    x.jacobian = shape.jacobian;
    mean_length_ = shape.mean_length;
    sizes_ = sizes_of_face(p, size_);
    x.ratio_at_centre = mean_length_ / sizes_.at_centre;
    if(integrates_) x.asked = inverse_square_on(p, sizes_, size_);
    return x;
  }

  // Of the last face.
  double mean_length() const { return mean_length_; }
  const Face_sizes& sizes() const { return sizes_; }

  // Only its extremes.
  Face_shape look_at(std::size_t k, const std::array<Vec, 4>& p)
  {
    const Face_shape shape = quality_.add(p);
    for(std::size_t i = 0; i < extremes_.size(); ++i)
      if(quality_.records()[i]) extremes_[i] = k;
    return shape;
  }

  const Quality_meter& quality() const { return quality_; }
  // The faces that have them.
  std::vector<std::size_t> extremes() const { return { extremes_.begin(), extremes_.end() }; }

private:
  const Size& size_;
  bool integrates_;
  Quality_meter quality_;
  std::array<std::size_t, Quality_meter::extremes> extremes_ = {};
  double mean_length_ = 0;
  Face_sizes sizes_ = {};
};

// Number of ideal faces on n faces themselves: few are cut, of many `asked(k)` tells what is asked
// of face k.
template <typename Asked, typename Corners_of, typename Size>
double ideal_number_on(std::size_t n, const Asked& asked, const Corners_of& corners_of,
                       const Size& size)
{
  const Halves_of_faces<Corners_of> halves(n, corners_of);
  if(halves.size() < least_triangles) return ideal_number_of_faces(halves, size);
  Ideal_count<Size> count(size);
  return count.finish(count.round(n, asked, [&](std::size_t k, std::vector<Triangle>& parts) {
    for(std::size_t i : { 2 * k, 2 * k + 1 }) append_quarters(halves[i], parts);
  }));
}

// Shapes and sizes of all faces of a mesh in one sweep: their corners are far apart in memory, and
// sizes are dear.  `corners_of(k)`: of face k.  Strict size ratios: `known_strict(k)` of faces of
// which the figures are known, `strict(k, mean edge length, sizes)` of others.
// `reference_triangles` as in measure().
template <typename Corners_of, typename Size, typename Strict, typename Known_strict>
void measure_faces(const Corners_of& corners_of, const Size& size, const Strict& strict,
                   const Known_strict& known_strict,
                   const std::vector<Triangle>* reference_triangles, Figures_of_faces& figures,
                   Mesh_measures& m)
{
  const std::size_t n = figures.size();
  if(n == 0) return;
  Face_meter<Size> meter(size, !reference_triangles && 2 * n >= least_triangles);
  Jacobian_counter jacobians;
  jacobians.reserve(n);
  Size_ratio_counter at_centre, strictly;
  for(std::size_t k = 0; k < n; ++k) {
    Face_figures& x = figures[k];
    if(x.is_known()) {
      if(figures.may_be_extreme(k)) meter.look_at(k, corners_of(k));
      strictly.add(known_strict(k));
    } else {
      const std::array<Vec, 4> p = corners_of(k);
      x = meter(k, p);
      strictly.add(strict(k, meter.mean_length(), meter.sizes()));
    }
    jacobians.add(x.jacobian);
    at_centre.add(x.ratio_at_centre);
  }
  figures.set_extremes(meter.extremes());
  jacobians.put_into(m);
  meter.quality().put_into(m);
  m.size_ratio = at_centre.result();
  m.strict_size_ratio = strictly.result();
  const auto asked = [&](std::size_t k) { return figures[k].asked; };
  m.ideal_number_of_faces = reference_triangles ? ideal_number_of_faces(*reference_triangles, size)
                                                : ideal_number_on(n, asked, corners_of, size);
  m.efficiency = m.ideal_number_of_faces / double(n);
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_FACES_H
