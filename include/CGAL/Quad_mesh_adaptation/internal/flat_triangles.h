// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FLAT_TRIANGLES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FLAT_TRIANGLES_H

#include <CGAL/Quad_mesh_adaptation/internal/Face_arrays.h>
#include <CGAL/Quad_mesh_adaptation/internal/Input_mesh.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The faces of a mesh cut in triangles as a reference surface is, with its feature edges.
struct Flat_triangles
{
  Face_arrays arrays;
  std::vector<char> is_feature; // by half-edge

  Flat_triangles(const Face_arrays& mesh, const std::vector<char>& features)
      : half_edge_(std::size_t(mesh.number_of_halfedges()), -1)
  {
    arrays.points = mesh.points;
    arrays.first.push_back(0);
    soup_.points = mesh.points;
    for(Index f = 0; f < mesh.number_of_faces(); ++f) cut(mesh, f);
    is_feature.assign(arrays.origin.size(), 0);
    for(Index h = 0; h < mesh.number_of_halfedges(); ++h) {
      const Index o = mesh.opposite[h];
      arrays.opposite[half_edge_[h]] = o < 0 ? Index(-1) : half_edge_[o];
      is_feature[half_edge_[h]] = features[h];
    }
  }

private:
  void cut(const Face_arrays& mesh, Index f)
  {
    const Index start = mesh.first[f], n = mesh.first[f + 1] - start;
    Index turn = 0; // the corner from which it is cut
    if(n == 4) {
      soup_.triangles.clear();
      Quad q;
      for(Index i = 0; i < 4; ++i) q[i] = mesh.origin[start + i];
      append_quad(soup_, q);
      turn = soup_.triangles[0][0] == q[0] ? 0 : 1;
    }
    const auto corner = [&](Index i) { return start + (turn + i) % n; };
    for(Index i = 1; i + 1 < n; ++i) {
      const Index h = arrays.number_of_halfedges();
      for(Index c : { corner(0), corner(i), corner(i + 1) }) {
        arrays.origin.push_back(mesh.origin[c]);
        arrays.face.push_back(arrays.number_of_faces());
        arrays.opposite.push_back(-1);
      }
      arrays.first.push_back(h + 3);
      half_edge_[corner(i)] = h + 1;
      if(i == 1) half_edge_[corner(0)] = h;
      if(i + 2 == n) half_edge_[corner(i + 1)] = h + 2;
      if(i > 1) {
        arrays.opposite[h] = h - 1;
        arrays.opposite[h - 1] = h;
      }
    }
  }

  Triangle_soup soup_;
  std::vector<Index> half_edge_; // of each of the mesh
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FLAT_TRIANGLES_H
