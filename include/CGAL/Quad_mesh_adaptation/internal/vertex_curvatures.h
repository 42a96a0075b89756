// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_VERTEX_CURVATURES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_VERTEX_CURVATURES_H

#include <CGAL/Quad_mesh_adaptation/internal/Feature_turns.h>
#include <CGAL/Quad_mesh_adaptation/internal/Face_arrays.h>
#include <CGAL/Quad_mesh_adaptation/internal/Principal_curvatures.h>
#include <CGAL/Quad_mesh_adaptation/internal/feature_edges.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Curvatures of the smooth surface that a polygon mesh stands for.  At a vertex the normals of the
// faces around are fitted by a linear function of the faces' centres; its derivative is the shape
// operator.  On spheres and cylinders normals are linear in the centres, so that coarse meshes do
// no harm, and a fit of one side is as good as one of all sides, so that creases and borders need
// no special case but not to be crossed.
class Curvature_estimator
{
public:
  // Feature curves are those of `feature_edges()`.
  Curvature_estimator(const Face_arrays& mesh, double cos_feature)
      : mesh_(mesh), cos_feature_(cos_feature), is_feature_(feature_edges(mesh, cos_feature)),
        visit_(mesh.first.size(), -1)
  {
    for(Index f = 0; f < mesh.number_of_faces(); ++f) {
      const Vec a = mesh.area_vector(f);
      areas_.push_back(norm(a));
      normals_.push_back(normalized(a));
      centres_.push_back(mesh.centre(f));
    }
  }

  std::vector<Principal_curvatures> operator()()
  {
    std::vector<Principal_curvatures> result(mesh_.points.size());
    std::vector<Index> visited(std::size_t(mesh_.number_of_halfedges()), -1);
    Index sector = 0;
    for(Index h = 0; h < mesh_.number_of_halfedges(); ++h) {
      if(visited[h] >= 0) continue;
      std::vector<Index> faces; // around the origin of h, up to feature edges
      for(Index g : fan_of(mesh_, is_feature_, h)) {
        visited[g] = sector;
        faces.push_back(mesh_.face[g]);
      }
      add(fit(mesh_.source(h), faces, sector++), result[mesh_.origin[h]]);
    }
    add_curves(result);
    return result;
  }

  // By half-edge.
  const std::vector<char>& features() const { return is_feature_; }

private:
  // The neighbours of the faces, once or until there are enough for a fit that forgives noise.
  void grow(std::vector<Index>& faces, Index sector)
  {
    constexpr std::size_t enough = 8;
    for(Index f : faces) visit_[f] = sector;
    std::size_t begin = 0;
    for(int ring = 0; ring < 3 && (ring == 0 || faces.size() < enough); ++ring) {
      const std::size_t end = faces.size();
      for(; begin < end; ++begin)
        for(Index h = mesh_.first[faces[begin]]; h < mesh_.first[faces[begin] + 1]; ++h) {
          if(is_feature_[h]) continue;
          const Index f = mesh_.face[mesh_.opposite[h]];
          if(visit_[f] == sector) continue;
          visit_[f] = sector;
          faces.push_back(f);
        }
    }
  }

  // The shape operator [a b; b c] from n = n0 + S x at the centres x, in the tangent plane.
  Principal_curvatures fit(const Vec& p, std::vector<Index> faces, Index sector)
  {
    Vec normal(0, 0, 0);
    for(Index f : faces) normal = normal + areas_[f] * normals_[f];
    normal = normalized(normal);
    const auto [u, v] = tangents(normal);
    grow(faces, sector);
    double radius = 0;
    for(Index f : faces) radius = (std::max)(radius, distance(centres_[f], p));
    if(!(radius > 0)) return {};

    Eigen::Matrix<double, Eigen::Dynamic, 5> equations(2 * Eigen::Index(faces.size()), 5);
    Eigen::VectorXd values(equations.rows());
    equations.setZero();
    values.setZero();
    Eigen::Index row = 0;
    for(Index f : faces) {
      if(normals_[f] * normal < 0.2) continue; // nearly beside the tangent plane
      const double w = std::sqrt(areas_[f]);
      const double x = (centres_[f] - p) * u / radius, y = (centres_[f] - p) * v / radius;
      equations.row(row) << w, 0, w * x, w * y, 0;
      values[row++] = w * (normals_[f] * u);
      equations.row(row) << 0, w, 0, w * x, w * y;
      values[row++] = w * (normals_[f] * v);
    }
    // least norm: a strip of faces says nothing of the direction across, and gets 0
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
    decomposition.setThreshold(1e-6);
    decomposition.compute(equations);
    const Eigen::VectorXd s = decomposition.solve(values) / radius;
    const double mean = 0.5 * (s[2] + s[4]), half = std::hypot(0.5 * (s[2] - s[4]), s[3]);
    return { mean + half, mean - half };
  }

  // Of whichever side of the feature curves bends most.
  static void add(const Principal_curvatures& c, Principal_curvatures& sum)
  {
    sum.largest = (std::max)(sum.largest, c.largest);
    sum.other = (std::max)(sum.other, c.other);
  }

  // Curvature of the feature curves; an end of a curve has that of the node next to it.
  void add_curves(std::vector<Principal_curvatures>& result) const
  {
    const Feature_turns turns(mesh_, is_feature_, cos_feature_);
    for(Index v = 0; v < Index(result.size()); ++v) {
      double k = turns.curvature(v);
      if(k == 0)
        for(Index w : turns.neighbours(v)) k = (std::max)(k, turns.curvature(w));
      add({ k, 0 }, result[v]);
    }
  }

  const Face_arrays& mesh_;
  double cos_feature_;
  std::vector<char> is_feature_;
  std::vector<double> areas_;
  std::vector<Vec> normals_, centres_;
  std::vector<Index> visit_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_VERTEX_CURVATURES_H
