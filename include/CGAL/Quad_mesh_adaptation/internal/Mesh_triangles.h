// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MESH_TRIANGLES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MESH_TRIANGLES_H

#include <CGAL/Quad_mesh_adaptation/internal/Input_mesh.h>
#include <CGAL/Quad_mesh_adaptation/internal/Quad_complex.h>
#include <CGAL/Quad_mesh_adaptation/internal/Reference_surface.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The faces of a mesh, or those of them that are marked, each cut in two, as a surface to look for
// nearest points on.
class Mesh_triangles
{
public:
  // Points have the numbers of their nodes, but where faces are marked.
  explicit Mesh_triangles(const Quad_complex& m, const std::vector<char>* marked = nullptr) : m_(m)
  {
    const auto is_wanted = [&](Index f) { return m.is_face(f) && (!marked || (*marked)[f]); };
    face_of_.reserve(m.number_of_faces());
    for(Index f = 0; f < m.face_end(); ++f)
      if(is_wanted(f)) face_of_.push_back(f);
    if(marked)
      take_points_of_faces();
    else
      take_all_points();
    soup_.triangles.reserve(2 * face_of_.size());
    for(Index f : face_of_) {
      const Quad q = m.quad(f);
      append_quad(soup_, { number(q[0]), number(q[1]), number(q[2]), number(q[3]) });
    }
  }

  // Of each pair of triangles.
  const std::vector<Index>& face_of() const { return face_of_; }

  // Parted by the curves into the patches of the mesh, if asked for.  Once only: the triangles are
  // in the surface then.
  Reference_surface surface(bool is_parted, Normals normals)
  {
    std::vector<std::array<Index, 3>> across = neighbours(is_parted);
    return Reference_surface(std::move(soup_.points), std::move(soup_.triangles), std::move(across),
                             is_parted ? patches() : std::vector<Index>(), normals);
  }

private:
  Index number(Index v) const { return number_.empty() ? v : number_[v]; }

  void take_all_points()
  {
    soup_.points.reserve(m_.vertex_end());
    for(Index v = 0; v < m_.vertex_end(); ++v) soup_.points.push_back(m_.point(v));
  }

  void take_points_of_faces()
  {
    number_.assign(m_.vertex_end(), -1);
    for(Index f : face_of_)
      for(Index v : m_.quad(f)) number_[v] = 0;
    Index points = 0;
    for(Index& n : number_)
      if(n == 0) n = points++;
    soup_.points.reserve(points);
    for(Index v = 0; v < m_.vertex_end(); ++v)
      if(number_[v] >= 0) soup_.points.push_back(m_.point(v));
  }

  std::vector<Index> patches() const
  {
    std::vector<Index> list;
    list.reserve(2 * face_of_.size());
    for(Index f : face_of_) list.insert(list.end(), 2, m_.patch(f));
    return list;
  }

  // What lies across the sides of the triangles is known.
  std::vector<std::array<Index, 3>> neighbours(bool is_parted) const
  {
    std::vector<Index> first_side(m_.face_end(), -1); // of the first triangle of a face
    for(std::size_t k = 0; k < face_of_.size(); ++k) {
      const bool turned = soup_.triangles[2 * k][0] != number(m_.origin(4 * face_of_[k]));
      first_side[face_of_[k]] = Index(4 * k) + (turned ? 1 : 0);
    }
    std::vector<std::array<Index, 3>> across(soup_.triangles.size(), { -1, -1, -1 });
    for(std::size_t k = 0; k < face_of_.size(); ++k) {
      const Index f = face_of_[k], turned = first_side[f] & 3;
      across[2 * k][2] = Index(2 * k + 1);
      across[2 * k + 1][0] = Index(2 * k);
      for(Index i = 0; i < 4; ++i) {
        const Index o = m_.opposite(4 * f + ((i + turned) & 3));
        if(o < 0 || (is_parted && m_.curve(o) >= 0) || first_side[m_.face(o)] < 0) continue;
        const Index there = first_side[m_.face(o)], j = ((o & 3) - (there & 3)) & 3;
        across[2 * k + std::size_t(i / 2)][i - i / 2] = 2 * (there / 4) + j / 2;
      }
    }
    return across;
  }

  const Quad_complex& m_;
  Triangle_soup soup_;
  std::vector<Index> face_of_;
  std::vector<Index> number_; // of the point of a node; empty: the same
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MESH_TRIANGLES_H
