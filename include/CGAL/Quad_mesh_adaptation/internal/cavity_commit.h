// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CAVITY_COMMIT_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CAVITY_COMMIT_H

// Part of Cavity.h: writing a replacement into the mesh.

#include <CGAL/Quad_mesh_adaptation/internal/Cavity.h>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// New nodes get vertices, quads get faces: a quad the number of its parent where that is free.
inline void Cavity::write_faces(std::vector<Index>& face_of)
{
  Quad_complex& m = s_.mesh;
  for(std::size_t n = 0; n < nodes.size(); ++n)
    if(ids[n] < 0 && new_corners_[n] > 0) {
      nodes[n].halfedge = 0; // alive
      ids[n] = m.add_vertex(nodes[n]);
    }
  local_of_.resize((std::max)(local_of_.size(), std::size_t(m.vertex_end())), -1);
  std::vector<Index> patch(quads.size());
  for(std::size_t k = 0; k < quads.size(); ++k) patch[k] = m.patch(quads[k].parent);
  face_of.assign(quads.size(), -1);
  for(std::size_t k = 0; k < quads.size(); ++k) {
    const Index f = quads[k].parent;
    if(face_mark_[f] != 1) continue;
    face_mark_[f] = 2; // taken
    face_of[k] = f;
  }
  std::size_t next_free = 0;
  for(std::size_t k = 0; k < quads.size(); ++k) {
    if(face_of[k] >= 0) continue;
    while(next_free < old_faces.size() && face_mark_[old_faces[next_free]] != 1) ++next_free;
    if(next_free == old_faces.size()) continue;
    face_of[k] = old_faces[next_free];
    face_mark_[face_of[k]] = 2;
  }
  for(Index f : old_faces)
    if(face_mark_[f] == 1) m.remove_face(f);
  for(std::size_t k = 0; k < quads.size(); ++k) {
    const auto& v = quads[k].v;
    const Quad q = { ids[v[0]], ids[v[1]], ids[v[2]], ids[v[3]] };
    if(face_of[k] < 0) {
      face_of[k] = m.add_face(q, patch[k]);
    } else {
      m.set_quad(face_of[k], q);
      m.set_patch(face_of[k], patch[k]);
    }
    s_.face_replaced(face_of[k]);
  }
  for(Index f : old_faces) {
    face_mark_[f] = 0;
    s_.face_replaced(f);
  }
  old_faces.clear();
}

inline void Cavity::write_links(const std::vector<Index>& face_of)
{
  Quad_complex& m = s_.mesh;
  for(int h = 0; h < int(partner_.size()); ++h) {
    const Index g = 4 * face_of[h >> 2] + (h & 3);
    if(partner_[h] >= 0)
      m.set_opposites(g, 4 * face_of[partner_[h] >> 2] + (partner_[h] & 3));
    else
      m.set_opposites(g, outer_[h]);
  }
  for(int h = 0; h < int(partner_.size()); ++h)
    m.set_curve(4 * face_of[h >> 2] + (h & 3), quads[h >> 2].curve[h & 3]);
}

inline void Cavity::write_nodes(const std::vector<Index>& face_of, std::vector<Index>* touched)
{
  Quad_complex& m = s_.mesh;
  for(std::size_t n = 0; n < nodes.size(); ++n) {
    if(ids[n] < 0) continue;
    if(new_corners_[n] == 0) {
      m.remove_vertex(ids[n]);
      continue;
    }
    Vertex_record r = nodes[n];
    r.faces = total_corners_[n];
    r.halfedge = -1;
    m.vertex(ids[n]) = r;
    s_.disturb(ids[n]);
    if(touched) touched->push_back(ids[n]);
  }
  for(int h = 0; h < int(partner_.size()); ++h) {
    const Index g = 4 * face_of[h >> 2] + (h & 3);
    const Index v = m.origin(g);
    if(m.vertex(v).halfedge < 0 || m.is_border(g)) m.vertex(v).halfedge = g;
  }
  // a border vertex may have its border outside the cavity
  for(std::size_t n = 0; n < nodes.size(); ++n)
    if(ids[n] >= 0 && new_corners_[n] > 0 && !is_inner(int(n)))
      m.refresh_vertex(ids[n], m.vertex(ids[n]).halfedge);
}

inline void Cavity::commit(std::vector<Index>* touched)
{
  struct Covered
  {
    Index witness;
    int quad;
    double cost;
  };
  std::vector<Covered> covered;
  for_each_witness([&](Index w, int quad, double cost) { covered.push_back({ w, quad, cost }); });
  std::vector<Index> face_of, taken;
  for(Index f : old_faces) s_.coverage.take(f, taken);
  write_faces(face_of);
  write_links(face_of);
  write_nodes(face_of, touched);
  for(const Covered& c : covered) s_.coverage.give(c.witness, face_of[c.quad], c.cost);
  for(std::size_t k = 0; k < face_of.size(); ++k) {
    if(!sizes_.empty()) s_.sizes.set(face_of[k], sizes_[k], s_.mesh.face_end());
    s_.renewed_size_factor(face_of[k]);
  }
  clear();
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CAVITY_COMMIT_H
