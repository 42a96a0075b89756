// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHORD_SIZES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHORD_SIZES_H

#include <CGAL/Quad_mesh_adaptation/internal/Feature_turns.h>
#include <CGAL/Quad_mesh_adaptation/internal/Fold_curvature.h>
#include <CGAL/Quad_mesh_adaptation/internal/Principal_curvatures.h>
#include <CGAL/Quad_mesh_adaptation/internal/flat_triangles.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Lines in a face of mean edge h are up to sqrt(2) h long: its diagonals, and edges of longish
// faces; and sizes between vertices are interpolated, with some growth within a face.  The middle
// of a longish face is farther off than its longer edges by what the shorter ones, of 0.6 h, add.
inline double chord_curvature(const Principal_curvatures& k)
{
  return k.largest + 0.18 * (std::max)(k.other, 0.);
}
constexpr double longest_chord = 1.48; // of the mean edge

// The largest L for which a line of length L is off the folds by no more than the error.
inline double longest_line(const Fold_curvature& folds, double error)
{
  const auto off = [&](double length) {
    return chord_curvature(folds(length)) * length * length / 8;
  };
  const double far = folds.largest_length();
  double high = far / 32;
  if(!(high > 0)) return (std::numeric_limits<double>::infinity)();
  while(high < far && off(high) <= error) high *= 1.3;
  if(high >= far) { // curvature does not depend on the length any more
    high = far;
    const double k = chord_curvature(folds(far));
    if(k * far * far <= 8 * error)
      return k > 0 ? std::sqrt(8 * error / k) : (std::numeric_limits<double>::infinity)();
  }
  double low = 0;
  for(int step = 0; step < 8; ++step) {
    const double middle = (low + high) / 2;
    (off(middle) <= error ? low : high) = middle;
  }
  return low;
}

// By vertex, the largest edges of faces that leave the facets of a mesh and its curves, which turn
// less than the angle of `cos_feature`, by no more than the error; infinite where all is flat.
inline std::vector<double> chord_sizes(const Face_arrays& mesh, const std::vector<char>& features,
                                       double cos_feature, double error)
{
  const Flat_triangles flat(mesh, features);
  const Face_arrays& t = flat.arrays;
  Fold_curvature folds(t, flat.is_feature);
  std::vector<double> sizes(t.points.size(), (std::numeric_limits<double>::infinity)());
  const auto lower = [&](Index v, double size) { sizes[v] = (std::min)(sizes[v], size); };
  std::vector<char> is_done(flat.is_feature.size(), 0);
  for(Index h = 0; h < t.number_of_halfedges(); ++h) {
    if(is_done[h]) continue;
    const std::vector<Index> fan = fan_of(t, flat.is_feature, h);
    for(Index g : fan) is_done[g] = 1;
    folds.look_at_vertex(fan);
    lower(t.origin[h], longest_line(folds, error) / longest_chord);
  }
  for(Index h = 0; h < t.number_of_halfedges(); ++h) {
    if(flat.is_feature[h] || t.opposite[h] > h) continue;
    const Index v = t.origin[h], w = t.origin[t.next(h)];
    const double length = distance(t.points[v], t.points[w]);
    if(length < 0.5 * (std::min)(sizes[v], sizes[w])) continue; // the ends see what it sees
    folds.look_at_edge(h);
    const double size = longest_line(folds, error) / longest_chord;
    lower(v, size);
    lower(w, size);
  }
  const Feature_turns turns(mesh, features, cos_feature);
  for(Index v = 0; v < Index(sizes.size()); ++v)
    lower(v, turns.longest_line(v, error) / longest_chord);
  return sizes;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHORD_SIZES_H
