// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_EXPECTED_COUNT_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_EXPECTED_COUNT_H

#include <CGAL/Quad_mesh_adaptation/internal/Attainable_sizes.h>
#include <CGAL/Quad_mesh_adaptation/internal/curve_lengths.h>
#include <CGAL/Quad_mesh_adaptation/internal/edge_marking.h>
#include <CGAL/Quad_mesh_adaptation/internal/work_to_do.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Edges that the curves ask for: their lengths in units of the size, or their fewest edges.
struct Curve_edges
{
  double border = 0, inner = 0;
};

inline Curve_edges curve_edges(const Adaptation_state& s)
{
  Curve_edges sum;
  for(const Feature_curve& c : s.curves)
    (c.is_border() ? sum.border : sum.inner) +=
        (std::max)(length_in_sizes(c, s.size), fewest_edges(c));
  return sum;
}

// Sizes that hardly vary against the faces: each is halved as often as all others, and the pattern
// stays if no more than one of a hundred then has edges that would not have been halved.  The
// number of faces then, 0 if this is not so.
inline double count_of_even_halvings(const Adaptation_state& s)
{
  constexpr double tolerated = 0.01;
  const double too_small = 0.5 * std::sqrt(2.) * Marking_options().threshold;
  const Quad_complex& m = s.mesh;
  std::vector<double> ratios;
  for(Index f : m.faces()) ratios.push_back(s.size_ratio(f));
  const double largest = *std::max_element(ratios.begin(), ratios.end());
  const double parts = std::exp2(std::ceil(std::log2(largest) - 1e-9)); // per edge
  if(!(parts > 1)) return 0;
  const auto small =
      std::count_if(ratios.begin(), ratios.end(), [=](double r) { return r < too_small * parts; });
  return double(small) > tolerated * double(ratios.size()) ? 0. : parts * parts * ratios.size();
}

// How many faces the default schedule makes, from the state before it.  The factors are fitted to
// runs on the meshes of the benchmark and of the tests' shapes with uniform, smooth and steep
// sizes, with the absolute relative error as measure, so that few odd ones do not count much:
// - each ideal face costs 1.067, since the largest faces and not their mean must reach the size;
// - a border rounds the rows along it up to whole faces, and a crease holds the pattern on both of
//   its sides to the same edges;
// - where the size grows, irregular vertices cost;
// - where faces cannot be as large as asked, see Attainable_sizes, there are more of them, but less
//   than one for each that is forced: those sizes are no bound.
// `scale`: what the sizes in the state are multiplied by.
inline double expected_count(const Adaptation_state& s, double ideal_number_of_faces,
                             double mean_square_slope, double scale)
{
  constexpr double per_face = 1.067, per_border_edge = 0.06, per_inner_edge = 0.5, per_slope = 0.41,
                   per_forced_face = 0.8;
  if(is_adapted(s)) return double(s.mesh.number_of_faces());
  const double even = count_of_even_halvings(s);
  // the schedule takes rows out again where halving leaves far too many
  if(even > 0 && ideal_number_of_faces / (scale * scale) > 0.75 * even) return even;
  const Curve_edges edges = curve_edges(s);
  const double faces =
      (per_face + per_slope * mean_square_slope) * ideal_number_of_faces / (scale * scale) +
      per_forced_face * Attainable_sizes(s).forced_faces();
  return (std::max)(1., faces + per_border_edge * edges.border + per_inner_edge * edges.inner);
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_EXPECTED_COUNT_H
