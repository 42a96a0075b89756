// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_QUAD_TOPOLOGY_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_QUAD_TOPOLOGY_H

#include <CGAL/Quad_mesh_adaptation/internal/Vertex_record.h>

#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Quads only, as arrays: half-edge 4 f + i runs from corner i of face f to corner i + 1.
// No printing, no geometry: topology, carriers and the records of the vertices.  This part answers
// questions, Quad_complex changes it.
class Quad_topology
{
public:
  static Index face(Index h) { return h >> 2; }
  static Index next(Index h) { return (h & ~3) | ((h + 1) & 3); }
  static Index prev(Index h) { return (h & ~3) | ((h + 3) & 3); }
  Index origin(Index h) const { return origin_[h]; }
  Index target(Index h) const { return origin_[next(h)]; }
  Index opposite(Index h) const { return opposite_[h]; } // -1 on the border
  Index curve(Index h) const { return curve_[h]; }       // -1 inside a surface patch
  bool is_border(Index h) const { return opposite_[h] < 0; }
  // the outgoing half-edge next counter-clockwise about origin(h), -1 past the border
  Index turn_left(Index h) const { return opposite_[prev(h)]; }
  // and clockwise
  Index turn_right(Index h) const { return opposite_[h] < 0 ? Index(-1) : next(opposite_[h]); }

  // sizes of the arrays, deleted records included
  Index face_end() const { return Index(origin_.size() / 4); }
  Index halfedge_end() const { return Index(origin_.size()); }
  Index vertex_end() const { return Index(vertices_.size()); }
  bool is_face(Index f) const { return origin_[4 * f] >= 0; }
  bool is_halfedge(Index h) const { return is_face(face(h)); }
  bool is_vertex(Index v) const { return vertices_[v].halfedge >= 0; }
  Index number_of_faces() const { return face_count_; }

  Quad quad(Index f) const
  {
    return { origin_[4 * f], origin_[4 * f + 1], origin_[4 * f + 2], origin_[4 * f + 3] };
  }

  const Vertex_record& vertex(Index v) const { return vertices_[v]; }
  const Vec& point(Index v) const { return vertices_[v].p; }
  bool is_border_vertex(Index v) const { return opposite_[vertices_[v].halfedge] < 0; }
  // number of edges at v
  int valence(Index v) const { return vertices_[v].faces + (is_border_vertex(v) ? 1 : 0); }

  Index patch(Index f) const { return patch_[f]; }

  // The numbers of records that exist; those of new ones are met as well.
  template <Index (Quad_topology::*End)() const, bool (Quad_topology::*Exists)(Index) const>
  class Record_range
  {
  public:
    class iterator
    {
    public:
      iterator(const Quad_topology* mesh, Index i) : mesh_(mesh), i_(i) { skip_deleted(); }
      Index operator*() const { return i_; }
      iterator& operator++()
      {
        ++i_;
        skip_deleted();
        return *this;
      }
      bool operator!=(const iterator&) const { return is_inside(); } // asked of the end only

    private:
      bool is_inside() const { return i_ < (mesh_->*End)(); }
      void skip_deleted()
      {
        while(is_inside() && !(mesh_->*Exists)(i_)) ++i_;
      }

      const Quad_topology* mesh_;
      Index i_;
    };

    explicit Record_range(const Quad_topology* mesh) : mesh_(mesh) {}
    iterator begin() const { return { mesh_, 0 }; }
    iterator end() const { return { mesh_, (mesh_->*End)() }; }

  private:
    const Quad_topology* mesh_;
  };
  using Face_range = Record_range<&Quad_topology::face_end, &Quad_topology::is_face>;
  using Halfedge_range = Record_range<&Quad_topology::halfedge_end, &Quad_topology::is_halfedge>;
  using Vertex_range = Record_range<&Quad_topology::vertex_end, &Quad_topology::is_vertex>;

  Face_range faces() const { return Face_range(this); }
  Halfedge_range halfedges() const { return Halfedge_range(this); }
  Vertex_range vertices() const { return Vertex_range(this); }

  // Half-edges around a node, found on the way: all that leave it counter-clockwise from `first`,
  // up to the border.
  class Outgoing_range
  {
  public:
    class iterator
    {
    public:
      iterator(const Quad_topology* mesh, Index h, Index first) : mesh_(mesh), h_(h), first_(first)
      {
      }
      Index operator*() const { return h_; }
      iterator& operator++()
      {
        h_ = mesh_->turn_left(h_);
        if(h_ == first_) h_ = -1;
        return *this;
      }
      bool operator!=(const iterator&) const { return h_ >= 0; } // asked of the end only

    private:
      const Quad_topology* mesh_;
      Index h_, first_;
    };

    Outgoing_range(const Quad_topology& mesh, Index first) : mesh_(&mesh), first_(first) {}
    iterator begin() const { return { mesh_, first_, first_ }; }
    iterator end() const { return { mesh_, -1, first_ }; }
    int size() const // counts
    {
      int n = 0;
      for(iterator i = begin(); i != end(); ++i) ++n;
      return n;
    }

  private:
    const Quad_topology* mesh_;
    Index first_;
  };

  // Outgoing half-edges of v, counter-clockwise from halfedge(v); at the border that is the first
  // one.  Links must not change on the way.
  Outgoing_range outgoing(Index v) const { return { *this, vertices_[v].halfedge }; }

  // The same, to be kept.
  void outgoing(Index v, std::vector<Index>& out) const
  {
    out.clear();
    for(Index h : outgoing(v)) out.push_back(h);
  }

  // The half-edge from u to v, -1 if there is none that has a face on its left.
  Index find_halfedge(Index u, Index v) const
  {
    for(Index h : outgoing(u))
      if(target(h) == v) return h;
    return -1;
  }

protected:
  std::vector<Index> origin_, opposite_, curve_, patch_;
  std::vector<Vertex_record> vertices_;
  Index face_count_ = 0;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_QUAD_TOPOLOGY_H
