// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_MESH_MEASURES_H
#define CGAL_QUAD_MESH_ADAPTATION_MESH_MEASURES_H

#include <array>
#include <cstddef>
#include <map>

namespace CGAL {
namespace Quad_mesh_adaptation {

/// Distribution of the size ratio over the faces of a mesh, in the bins of Tables 1-3 of
/// Anderson, Benzley and Owen (2009): `<0.5 [0.5,0.8) [0.8,0.9) [0.9,1] (1,1.1] (1.1,1.2]
/// (1.2,1.5] >1.5`.  A ratio within 1e-9 of one counts as one, that is, as not too large.
struct Size_ratio_table
{
  static constexpr std::size_t number_of_bins = 8;

  /// Column titles of the paper's tables, in the order of `counts`.
  static const std::array<const char*, number_of_bins>& titles()
  {
    static const std::array<const char*, number_of_bins> names = { "<0.5",    "0.5-0.8", "0.8-0.9",
                                                                   "0.9-1.0", "1.0-1.1", "1.1-1.2",
                                                                   "1.2-1.5", ">1.5" };
    return names;
  }

  std::array<std::size_t, number_of_bins> counts = {};
  double min = 0, mean = 0, max = 0;

  std::size_t total() const
  {
    std::size_t n = 0;
    for(std::size_t c : counts) n += c;
    return n;
  }
  /// Number of faces not larger than asked for.
  std::size_t not_larger() const { return counts[0] + counts[1] + counts[2] + counts[3]; }
  double percent(std::size_t bin) const { return total() ? 100. * counts[bin] / total() : 0.; }
  double percent_not_larger() const { return total() ? 100. * not_larger() / total() : 0.; }
};

/// What can be said of a quad mesh, on its own and against a size.  All definitions agree with
/// those of the paper and of the Verdict library; lengths are in units of the coordinates.
struct Mesh_measures
{
  // counts and topology
  std::size_t vertices = 0, edges = 0, faces = 0;
  std::size_t components = 0, boundary_edges = 0, boundary_loops = 0;
  long euler_characteristic = 0;

  // size
  Size_ratio_table size_ratio; ///< f_s of eq. 3, the size taken at the face's centre
  Size_ratio_table
      strict_size_ratio; ///< against min(h(centre), (mean of 1/h^2)^(-1/2) at 2x2 Gauss points)
  double ideal_number_of_faces = 0; ///< integral of 1/h^2 over the surface
  double efficiency = 0;            ///< ideal_number_of_faces / faces

  // quality (Verdict)
  double min_scaled_jacobian = 0, p5_scaled_jacobian = 0, mean_scaled_jacobian = 0;
  double min_angle = 0, max_angle = 0; ///< corner angles, in degrees
  /// How far faces are from plane: the distance between the middles of the diagonals along the
  /// normal, over half the mean edge length.  A square folded by 30 degrees along a diagonal has
  /// 0.37.
  double max_warp = 0;
  std::size_t inverted_faces = 0; ///< scaled Jacobian <= 0

  // valence = number of edges of a vertex
  std::map<std::size_t, std::size_t> interior_valence; ///< valence -> number of interior vertices
  std::size_t irregular_interior_vertices = 0; ///< interior vertices of valence other than 4
  std::size_t interior_vertices = 0;
  std::size_t max_valence = 0;

  // distance of the vertices to the reference surface, 0 where there is none
  double max_distance_to_reference = 0;
  // the same both ways: of points of the faces (seen as bilinear) to the reference surface and its
  // curves, and of points of these to the faces; 0 where there is none.  Where a bound was asked
  // for and is missed, more points are looked at
  double mesh_to_reference = 0, reference_to_mesh = 0;
};

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_MESH_MEASURES_H
