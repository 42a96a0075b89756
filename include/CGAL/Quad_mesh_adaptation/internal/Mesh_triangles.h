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
  explicit Mesh_triangles(const Quad_complex& m, const std::vector<char>* marked = nullptr) : m_(m)
  {
    const auto is_wanted = [&](Index f) { return m.is_face(f) && (!marked || (*marked)[f]); };
    std::size_t wanted = 0;
    for(Index f = 0; f < m.face_end(); ++f) wanted += is_wanted(f);
    soup_.points.reserve(m.vertex_end());
    soup_.triangles.reserve(2 * wanted);
    face_of_.reserve(wanted);
    for(Index v = 0; v < m.vertex_end(); ++v) soup_.points.push_back(m.point(v));
    for(Index f = 0; f < m.face_end(); ++f) {
      if(!is_wanted(f)) continue;
      append_quad(soup_, m.quad(f));
      face_of_.push_back(f);
    }
  }

  // Of each pair of triangles.
  const std::vector<Index>& face_of() const { return face_of_; }

  // Parted by the curves, if asked for.  Once only: the triangles are in the surface then.
  Reference_surface surface(bool is_parted)
  {
    std::vector<std::array<Index, 3>> across = neighbours(is_parted);
    return Reference_surface(std::move(soup_.points), std::move(soup_.triangles),
                             std::move(across));
  }

private:
  // What lies across the sides of the triangles is known.
  std::vector<std::array<Index, 3>> neighbours(bool is_parted) const
  {
    std::vector<Index> first_side(m_.face_end(), -1); // of the first triangle of a face
    for(std::size_t k = 0; k < face_of_.size(); ++k) {
      const bool turned = soup_.triangles[2 * k][0] != m_.origin(4 * face_of_[k]);
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
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MESH_TRIANGLES_H
