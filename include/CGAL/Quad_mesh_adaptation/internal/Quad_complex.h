// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_QUAD_COMPLEX_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_QUAD_COMPLEX_H

#include <CGAL/Quad_mesh_adaptation/internal/Halfedge_links.h>
#include <CGAL/Quad_mesh_adaptation/internal/Quad_topology.h>
#include <CGAL/Quad_mesh_adaptation/internal/permute.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Quads that can be built, linked and changed.
class Quad_complex : public Quad_topology
{
public:
  using Quad_topology::vertex;
  Vertex_record& vertex(Index v) { return vertices_[v]; }

  void set_patch(Index f, Index p) { patch_[f] = p; }

  // Vertices below v are never recycled: they stand for vertices of the caller.
  void protect_vertices_below(Index v) { first_reusable_ = v; }
  bool is_protected(Index v) const { return v < first_reusable_; }

  void reserve(std::size_t vertices, std::size_t faces)
  {
    vertices_.reserve(vertices);
    origin_.reserve(4 * faces);
    opposite_.reserve(4 * faces);
    curve_.reserve(4 * faces);
    patch_.reserve(faces);
  }

  // For so many in all, with some to spare where there is not room already.
  void make_room(std::size_t vertices, std::size_t faces)
  {
    const auto fit = [](auto& list, std::size_t n) {
      if(list.capacity() < n) list.reserve(n + n / 16);
    };
    fit(vertices_, vertices);
    for(auto* list : { &origin_, &opposite_, &curve_ }) fit(*list, 4 * faces);
    fit(patch_, faces);
  }

  Index add_vertex(const Vertex_record& r)
  {
    if(!free_vertices_.empty()) {
      const Index v = free_vertices_.back();
      free_vertices_.pop_back();
      vertices_[v] = r;
      return v;
    }
    grow(vertices_, 1);
    vertices_.push_back(r);
    return Index(vertices_.size()) - 1;
  }

  Index add_face(const Quad& q, Index patch)
  {
    Index f;
    if(!free_faces_.empty()) {
      f = free_faces_.back();
      free_faces_.pop_back();
    } else {
      f = face_end();
      for(auto* list : { &origin_, &opposite_, &curve_ }) grow(*list, 4);
      grow(patch_, 1);
      origin_.resize(origin_.size() + 4, -1);
      opposite_.resize(opposite_.size() + 4, -1);
      curve_.resize(curve_.size() + 4, -1);
      patch_.push_back(-1);
    }
    set_quad(f, q);
    patch_[f] = patch;
    ++face_count_;
    return f;
  }

  // All faces of an empty complex.
  void add_faces(const std::vector<Quad>& quads, Index patch)
  {
    const std::size_t n = quads.size();
    origin_.reserve(4 * n);
    for(const Quad& q : quads) origin_.insert(origin_.end(), q.begin(), q.end());
    opposite_.assign(4 * n, -1);
    curve_.assign(4 * n, -1);
    patch_.assign(n, patch);
    face_count_ = Index(n);
  }

  void set_quad(Index f, const Quad& q)
  {
    for(int i = 0; i < 4; ++i) {
      origin_[4 * f + i] = q[i];
      opposite_[4 * f + i] = -1;
      curve_[4 * f + i] = -1;
    }
  }

  void set_origin(Index h, Index v) { origin_[h] = v; }

  void set_curve(Index h, Index c)
  {
    curve_[h] = c;
    if(opposite_[h] >= 0) curve_[opposite_[h]] = c;
  }

  void set_opposites(Index h, Index o)
  {
    if(h >= 0) opposite_[h] = o;
    if(o >= 0) opposite_[o] = h;
  }

  // Half-edge h takes the place of `old` beside another face.
  void replace(Index old, Index h)
  {
    set_opposites(h, opposite_[old]);
    set_curve(h, curve_[old]);
  }

  // Vertex v has a face less; `gone`, an outgoing half-edge of it, is replaced by another one.
  void lose_face(Index v, Index gone, Index other)
  {
    --vertices_[v].faces;
    if(vertices_[v].halfedge == gone) vertices_[v].halfedge = other;
  }

  void remove_face(Index f)
  {
    for(int i = 0; i < 4; ++i) origin_[4 * f + i] = opposite_[4 * f + i] = curve_[4 * f + i] = -1;
    free_faces_.push_back(f);
    --face_count_;
  }

  void remove_vertex(Index v)
  {
    vertices_[v].halfedge = -1;
    vertices_[v].faces = 0;
    if(v >= first_reusable_) free_vertices_.push_back(v);
  }

  // Links all half-edges by their end points and refreshes the vertices.  False, with the
  // offending half-edge in `bad`, if two half-edges run the same way between the same vertices.
  bool link(Index* bad = nullptr)
  {
    if(!Halfedge_links(origin_, opposite_, curve_, vertex_end())(bad)) return false;
    refresh_vertices();
    return true;
  }

  // Recomputes halfedge and face count of every vertex; those without a face are deleted.
  void refresh_vertices()
  {
    for(Vertex_record& r : vertices_) {
      r.halfedge = -1;
      r.faces = 0;
    }
    for(Index h = 0; h < Index(origin_.size()); ++h) {
      if(origin_[h] < 0) continue;
      Vertex_record& r = vertices_[origin_[h]];
      ++r.faces;
      if(r.halfedge < 0 || opposite_[h] < 0) r.halfedge = h;
    }
    free_vertices_.clear();
    for(Index v = vertex_end() - 1; v >= first_reusable_; --v)
      if(vertices_[v].halfedge < 0) free_vertices_.push_back(v);
  }

  // Recounts vertex v from one of its outgoing half-edges.
  void refresh_vertex(Index v, Index h)
  {
    Index start = h;
    for(Index r = turn_right(h); r >= 0 && r != h; r = turn_right(r)) start = r;
    if(!is_border(start)) start = h;
    vertices_[v].halfedge = start;
    vertices_[v].faces = outgoing(v).size();
  }

  // Gives the faces the numbers of their places in `order`, which names each face once, and the
  // vertices that may be recycled those of their first use: what is near each other is near in
  // memory then.
  void renumber(const std::vector<Index>& order)
  {
    const std::size_t spare = order.size() / 16; // for a few more later
    std::vector<Index> vertex(vertices_.size(), -1);
    Index vertices = (std::min)(first_reusable_, vertex_end());
    for(Index v = 0; v < vertices; ++v) vertex[v] = v;
    for(Index f : order)
      for(Index v : quad(f))
        if(vertex[v] < 0) vertex[v] = vertices++;
    std::vector<Index> place(face_end(), -1);
    for(std::size_t i = 0; i < order.size(); ++i) place[order[i]] = Index(i);
    const auto moved = [&](Index h) { return h < 0 ? h : 4 * place[h >> 2] + (h & 3); };
    const auto same = [](Index i) { return i; };
    for(Vertex_record& v : vertices_) v.halfedge = moved(v.halfedge);
    take_in_order(origin_, order, 4, spare, [&](Index v) { return vertex[v]; });
    take_in_order(opposite_, order, 4, spare, moved);
    take_in_order(curve_, order, 4, spare, same);
    take_in_order(patch_, order, 1, spare, same);
    place = std::vector<Index>();
    move_to_places(vertices_, vertex, std::size_t(vertices));
    free_faces_.clear();
    free_vertices_.clear();
    face_count_ = Index(order.size());
  }

  // Where only the links are needed any more.
  void forget_vertices() { vertices_ = std::vector<Vertex_record>(); }

  // A copy to be kept, in which only the vertices that exist have records, for another one to
  // become().  Those of the caller that are gone may be as many as those that are there.
  Quad_complex packed() const
  {
    Quad_complex r;
    r.origin_ = origin_;
    r.opposite_ = opposite_;
    r.curve_ = curve_;
    r.patch_ = patch_;
    r.free_faces_ = free_faces_;
    r.free_vertices_ = free_vertices_;
    r.face_count_ = face_count_;
    r.first_reusable_ = first_reusable_;
    std::size_t n = 0;
    for(Index v = 0; v < vertex_end(); ++v) n += is_vertex(v) ? 1 : 0;
    r.vertices_.reserve(n);
    for(Index v : vertices()) r.vertices_.push_back(vertices_[v]);
    return r;
  }

  // Becomes what has been packed, with so many records as there were; the place of its own is used
  // again.
  void become(Quad_complex&& packed, Index vertex_end)
  {
    std::vector<Vertex_record> all = std::move(vertices_);
    const std::vector<Vertex_record> kept = std::move(packed.vertices_);
    *this = std::move(packed);
    all.assign(std::size_t(vertex_end), Vertex_record());
    for(Index v : origin_)
      if(v >= 0) all[v].halfedge = 0; // it exists
    auto next = kept.begin();
    for(Vertex_record& r : all)
      if(r.halfedge >= 0) r = *next++;
    vertices_ = std::move(all);
  }

private:
  // Room for n more, by a quarter where it is used up: twice as much would be much for large
  // meshes.
  template <typename T>
  static void grow(std::vector<T>& list, std::size_t n)
  {
    if(list.size() + n > list.capacity()) list.reserve(list.size() + list.size() / 4 + n + 64);
  }

  std::vector<Index> free_faces_, free_vertices_;
  Index first_reusable_ = 0;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_QUAD_COMPLEX_H
