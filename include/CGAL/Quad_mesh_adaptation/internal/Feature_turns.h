// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FEATURE_TURNS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FEATURE_TURNS_H

#include <CGAL/Quad_mesh_adaptation/internal/Face_arrays.h>

#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// How the feature curves of a mesh bend at its vertices.
class Feature_turns
{
public:
  // `is_feature`: by half-edge.  Turns from the angle of `cos_feature` on are corners.
  Feature_turns(const Face_arrays& mesh, const std::vector<char>& is_feature, double cos_feature)
      : mesh_(mesh), cos_feature_(cos_feature), neighbours_(mesh.points.size())
  {
    for(Index h = 0; h < mesh.number_of_halfedges(); ++h) {
      if(!is_feature[h] || mesh.opposite[h] > h) continue;
      const Index a = mesh.origin[h], b = mesh.origin[mesh.next(h)];
      neighbours_[a].push_back(b);
      neighbours_[b].push_back(a);
    }
  }

  // Along curves.
  const std::vector<Index>& neighbours(Index v) const { return neighbours_[v]; }

  // Of the circle through v and its two neighbours; zero at corners, ends and off the curves.
  double curvature(Index v) const
  {
    if(neighbours_[v].size() != 2) return 0;
    const Vec &a = mesh_.points[neighbours_[v][0]], &c = mesh_.points[neighbours_[v][1]];
    const Vec in = mesh_.points[v] - a, out = c - mesh_.points[v];
    const double product = norm(in) * norm(out), chord = norm(in + out);
    if(!(in * out > cos_feature_ * product) || !(chord > 0)) return 0;
    return 2 * norm(cross(in, out)) / (product * chord);
  }

  // The longest line across the bend at v that is off by no more than the error: a line over one
  // bend by the angle t is off by t L / 4, one over several at distances d by up to
  // k (L^2 + d^2) / 8.
  double longest_line(Index v, double error) const
  {
    const double k = curvature(v);
    if(!(k > 0)) return (std::numeric_limits<double>::infinity)();
    const double d = 0.5 * (distance(mesh_.points[v], mesh_.points[neighbours_[v][0]]) +
                            distance(mesh_.points[v], mesh_.points[neighbours_[v][1]]));
    return k * d * d >= 4 * error ? 4 * error / (k * d) : std::sqrt(8 * error / k - d * d);
  }

private:
  const Face_arrays& mesh_;
  double cos_feature_;
  std::vector<std::vector<Index>> neighbours_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FEATURE_TURNS_H
