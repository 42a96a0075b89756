// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_OPPOSITE_SHEETS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_OPPOSITE_SHEETS_H

#include <CGAL/Quad_mesh_adaptation/internal/Face_arrays.h>
#include <CGAL/Quad_mesh_adaptation/internal/Triangle_tree.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Distances from a surface to the sheet of it that lies opposite, by rays along the normals.
class Opposite_sheets
{
public:
  // Precondition: some face has an area.
  explicit Opposite_sheets(const Face_arrays& mesh) : mesh_(mesh)
  {
    std::vector<Core_kernel::Triangle_3> triangles;
    for(Index f = 0; f < mesh.number_of_faces(); ++f) append(f, triangles);
    tree_ = std::make_unique<const Triangle_tree>(std::move(triangles));
  }

  // At each vertex the smallest distance from the faces around it, behind them (side = -1) or in
  // front of them (side = 1); infinite where there is none.
  std::vector<double> distances(double side) const
  {
    // Rays start near the corners: on a coarse mesh thickness varies within a face.  There are two
    // a corner, off the edges of the fan: on a symmetric mesh a ray from one such edge may slip
    // between the two triangles of another.
    constexpr double towards_corner = 0.6, towards_neighbour = 0.13;
    std::vector<double> result(mesh_.points.size(), std::numeric_limits<double>::infinity());
    for(Index h = 0; h < mesh_.number_of_halfedges(); ++h) {
      const Index f = mesh_.face[h];
      const Vec c = mesh_.centre(f), corner = c + towards_corner * (mesh_.source(h) - c);
      double& d = result[mesh_.origin[h]];
      for(const Vec& q : { mesh_.source(mesh_.prev(h)), mesh_.target(h) })
        d = (std::min)(d, distance_from(corner + towards_neighbour * (q - c), f, side));
    }
    return result;
  }

private:
  // Square to the sheet that the ray meets.  None if that is turned by more than 60 degrees: then
  // the sides only meet somewhere.
  double distance_from(const Vec& p, Index f, double side) const
  {
    const double none = std::numeric_limits<double>::infinity();
    const Vec direction = side * normalized(mesh_.area_vector(f));
    if(!(direction * direction > 0)) return none;
    const Index t = tree_->first_on_ray(p, direction, [&](Index k) { return face_of_[k] == f; });
    if(t < 0 || std::abs(normals_[t] * direction) < 0.5) return none;
    return std::abs((corners_[t] - p) * normals_[t]);
  }

  // A fan of triangles about the centre, which is as good for warped faces.
  void append(Index f, std::vector<Core_kernel::Triangle_3>& triangles)
  {
    const Vec c = mesh_.centre(f);
    const auto point = [](const Vec& p) { return Core_kernel::Point_3(p.x(), p.y(), p.z()); };
    for(Index h = mesh_.first[f]; h < mesh_.first[f + 1]; ++h) {
      const Vec normal = cross(mesh_.source(h) - c, mesh_.target(h) - c);
      if(!(norm(normal) > 0)) continue;
      triangles.emplace_back(point(c), point(mesh_.source(h)), point(mesh_.target(h)));
      face_of_.push_back(f);
      normals_.push_back(normalized(normal));
      corners_.push_back(c);
    }
  }

  const Face_arrays& mesh_;
  std::vector<Index> face_of_;         // of each triangle
  std::vector<Vec> normals_, corners_; // of each triangle
  std::unique_ptr<const Triangle_tree> tree_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_OPPOSITE_SHEETS_H
