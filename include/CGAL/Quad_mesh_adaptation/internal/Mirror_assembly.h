// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MIRROR_ASSEMBLY_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MIRROR_ASSEMBLY_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/Input_mesh.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

struct Mirrored_face
{
  Quad v;
  std::array<Index, 4> curve;
  Index patch = -1;
  Index slot = -1; // number of the quad of the input that it is, or that it stands for now
};

// Makes one mesh of the part and its images.
class Mirror_assembly
{
public:
  // Bit i of `touched` says of a vertex that it lies on plane i.  Vertices and faces are used up.
  Mirror_assembly(const Input_mesh& in, const Adaptation_state& whole,
                  std::vector<Vertex_record>& vertices, std::vector<Mirrored_face>& faces,
                  const std::vector<unsigned char>& touched, int planes, Quad_complex& mesh)
      : in_(in), whole_(whole), vertices_(vertices), faces_(faces), touched_(touched),
        planes_(planes), mesh_(mesh)
  {
  }

  // The plane to blame if the images do not fit together, -1 if all is well.
  int operator()()
  {
    add_vertices();
    const std::vector<const Mirrored_face*> placed = placed_faces();
    add_faces(placed);
    Index bad = -1;
    if(!mesh_.link(&bad)) return plane_of(mesh_.origin(bad), mesh_.target(bad));
    for(std::size_t f = 0; f < placed.size(); ++f)
      for(int k = 0; placed[f] && k < 4; ++k)
        if(placed[f]->curve[k] >= 0) mesh_.set_curve(Index(4 * f) + k, placed[f]->curve[k]);
    std::vector<Mirrored_face>().swap(faces_);
    const int blamed = find_bad_vertex();
    if(blamed < 0) place_on_surface();
    return blamed;
  }

private:
  void add_vertices()
  {
    mesh_.reserve(vertices_.size(), 0);
    for(Vertex_record& v : vertices_) {
      v.halfedge = 0;
      mesh_.add_vertex(v);
    }
    std::vector<Vertex_record>().swap(vertices_); // not twice for longer than needed
    mesh_.protect_vertices_below(Index(in_.points.size()));
  }

  // Faces of the input in their places, new ones behind.
  std::vector<const Mirrored_face*> placed_faces() const
  {
    std::vector<const Mirrored_face*> placed(in_.quads.size(), nullptr);
    for(const Mirrored_face& f : faces_) {
      if(f.slot >= 0)
        placed[f.slot] = &f;
      else
        placed.push_back(&f);
    }
    return placed;
  }

  void add_faces(const std::vector<const Mirrored_face*>& placed)
  {
    mesh_.reserve(0, placed.size());
    for(const Mirrored_face* f : placed) mesh_.add_face(f ? f->v : faces_[0].v, f ? f->patch : 0);
    for(std::size_t f = 0; f < placed.size(); ++f)
      if(!placed[f]) mesh_.remove_face(Index(f));
  }

  // Two faces that share two edges, or two fans of faces at one vertex: -1 if there are none.
  int find_bad_vertex() const
  {
    for(Index v : mesh_.vertices()) {
      if(touched_[v] == 0) continue;
      const int faces = mesh_.vertex(v).faces;
      const bool doublet = faces < 3 && !mesh_.is_border_vertex(v) &&
                           !(v < Index(in_.points.size()) && whole_.mesh.vertex(v).faces == faces);
      if(doublet || mesh_.outgoing(v).size() != faces) return plane_of(v, v);
    }
    return -1;
  }

  // Nodes of former cuts lie on the surface already; what they miss is their triangle.
  void place_on_surface()
  {
    for(Index v : mesh_.vertices()) {
      Vertex_record& r = mesh_.vertex(v);
      if(r.carrier != Carrier::surface || r.hint >= 0) continue;
      r.hint = whole_.surface.find(r.p, -1, Vec(0, 0, 0));
      r.normal = whole_.surface.normal(r.hint);
    }
  }

  int plane_of(Index u, Index v) const
  {
    for(int i = planes_ - 1; i > 0; --i)
      if(((touched_[u] & touched_[v]) >> i) & 1) return i;
    return 0;
  }

  const Input_mesh& in_;
  const Adaptation_state& whole_;
  std::vector<Vertex_record>& vertices_;
  std::vector<Mirrored_face>& faces_;
  const std::vector<unsigned char>& touched_;
  int planes_;
  Quad_complex& mesh_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MIRROR_ASSEMBLY_H
