// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FOLD_CURVATURE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FOLD_CURVATURE_H

#include <CGAL/Quad_mesh_adaptation/internal/Face_arrays.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The half-edges that leave the origin of h, from feature edge to feature edge or all around.
inline std::vector<Index> fan_of(const Face_arrays& mesh, const std::vector<char>& is_feature,
                                 Index h)
{
  std::vector<Index> list = { h };
  for(Index g = h; !is_feature[mesh.prev(g)];) {
    g = mesh.opposite[mesh.prev(g)];
    if(g == h) return list;
    list.push_back(g);
  }
  for(Index g = h; !is_feature[g];) {
    g = mesh.next(mesh.opposite[g]);
    list.push_back(g);
  }
  return list;
}

// Curvature as it is found on the edges of a mesh, where neighbouring faces turn against each other
// (the normal cycle of Cohen-Steiner and Morvan, SoCG 2003): half the turn of an edge to either
// end.  A fold of two or three faces, which a smooth fit to all faces around levels by half, counts
// in full; over the length of a wanted edge, folds and their like are averaged.
class Fold_curvature
{
public:
  // `is_feature`: by half-edge; curvature is not averaged across those.
  Fold_curvature(const Face_arrays& mesh, const std::vector<char>& is_feature)
      : mesh_(mesh), is_feature_(is_feature), sector_(std::size_t(mesh.number_of_halfedges()), -1)
  {
    for(Index f = 0; f < mesh.number_of_faces(); ++f) areas_.push_back(mesh.area_vector(f));
    for(Index h = 0; h < mesh.number_of_halfedges(); ++h)
      if(sector_[h] < 0) add_sector(h);
    seen_.assign(sectors_.size(), -1);
  }

  // For each vertex the largest |k1|, |k2| or |k1 + k2| of its sectors, each on the scale of the
  // edges of length size(k) that it asks for.
  template <typename Size>
  std::vector<double> operator()(const Size& size, double error, double longer_edges)
  {
    std::vector<double> result(mesh_.points.size(), 0.);
    for(Index s = 0; s < Index(sectors_.size()); ++s) {
      double k = largest(sectors_[s]);
      const double on_facets = at_one_fold(k, sectors_[s].area, error, longer_edges);
      for(int step = 0; step < 2 && k > 0; ++step)
        k = (std::min)(k, largest(average(s, size(k) / 3.14159265358979323846)));
      k = (std::max)(k, on_facets);
      double& all = result[mesh_.origin[sectors_[s].halfedge]];
      all = (std::max)(all, k);
    }
    return result;
  }

private:
  // The faces about a vertex that no feature edge parts.
  struct Sector
  {
    Index halfedge = -1;
    Eigen::Matrix3d turn = Eigen::Matrix3d::Zero(); // integral of the shape operator
    double area = 0;                                // over this
  };

  // Edges shorter than two of the mesh meet one fold, which turns by the curvature times the length
  // d of an edge, and leave its facets by a quarter of their length times that.  As the curvature
  // of which chord_error() makes that length; facets are not asked to be cut below d / 2.
  static double at_one_fold(double k, double area, double error, double longer_edges)
  {
    if(!(area > 0)) return 0;
    constexpr double factor = 3.3; // of four, since edges are longer than the mean of their face
    return (std::min)(8 * k * k * area / (factor * factor * longer_edges * error),
                      32 * error / (longer_edges * area));
  }

  void add_sector(Index h)
  {
    Sector s;
    s.halfedge = h;
    for(Index g : fan_of(mesh_, is_feature_, h)) {
      sector_[g] = Index(sectors_.size());
      const Index f = mesh_.face[g];
      s.area += norm(areas_[f]) / double(mesh_.first[f + 1] - mesh_.first[f]);
      if(!is_feature_[g]) add_turn(g, s.turn);
    }
    sectors_.push_back(s);
  }

  void add_turn(Index g, Eigen::Matrix3d& sum) const
  {
    const Index f = mesh_.face[g], o = mesh_.face[mesh_.opposite[g]];
    const Vec n = areas_[f], m = areas_[o];
    const double angle = std::atan2(norm(cross(n, m)), n * m);
    if(!(angle > 1e-9)) return;
    const Vec apart = mesh_.centre(o) - mesh_.centre(f);
    const double sign = (normalized(m) - normalized(n)) * apart > 0 ? 1 : -1;
    const Vec edge = mesh_.target(g) - mesh_.source(g);
    const Vec t = normalized(cross(normalized(n) + normalized(m), edge));
    const Eigen::Vector3d d(t.x(), t.y(), t.z());
    sum += 0.5 * sign * angle * norm(edge) * d * d.transpose();
  }

  static double largest(const Sector& s)
  {
    if(!(s.area > 0)) return 0;
    const Eigen::Matrix3d k = s.turn / s.area;
    const Eigen::Vector3d values =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(k, Eigen::EigenvaluesOnly).eigenvalues();
    return (std::max)(values.cwiseAbs().maxCoeff(), std::abs(k.trace()));
  }

  // Over the sectors that can be reached within the radius.  In a disc of radius h / pi a straight
  // fold through the middle has the same mean curvature as the circle from which a chord of length
  // h is as far.
  Sector average(Index start, double radius)
  {
    constexpr std::size_t most = 64; // enough for a mean; a smaller disc errs to the safe side
    const Vec middle = mesh_.source(sectors_[start].halfedge);
    Sector sum;
    std::vector<Index> reached = { start };
    seen_[start] = start;
    for(std::size_t i = 0; i < reached.size(); ++i) {
      const Sector& s = sectors_[reached[i]];
      sum.turn += s.turn;
      sum.area += s.area;
      for(Index g : fan_of(mesh_, is_feature_, s.halfedge))
        for(Index h : { mesh_.next(g), mesh_.prev(g) }) {
          const Index other = sector_[h];
          if(reached.size() == most || seen_[other] == start ||
             distance(mesh_.source(h), middle) > radius)
            continue;
          seen_[other] = start;
          reached.push_back(other);
        }
    }
    return sum;
  }

  const Face_arrays& mesh_;
  const std::vector<char>& is_feature_;
  std::vector<Vec> areas_;
  std::vector<Index> sector_; // of the origin of each half-edge
  std::vector<Sector> sectors_;
  std::vector<Index> seen_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FOLD_CURVATURE_H
