// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MESH_EXPORT_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MESH_EXPORT_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/Input_mesh.h>
#include <CGAL/Quad_mesh_adaptation/internal/Old_halfedges.h>
#include <CGAL/Quad_mesh_adaptation/internal/mesh_import.h>
#include <CGAL/Quad_mesh_adaptation/internal/reserve_in.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Writes the state back into the caller's graph with the low-level functions of MutableFaceGraph.
// A face whose four vertices did not change keeps its descriptor, and so do its edges and every
// edge and vertex that still exists; other faces, edges and vertices are removed or new.  Uses the
// vertices of the state up.
template <typename QuadMesh, typename VertexPointMap, typename EdgeConstrainedMap>
class Mesh_export
{
  using Traits = boost::graph_traits<QuadMesh>;
  using vertex_descriptor = typename Traits::vertex_descriptor;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;
  using face_descriptor = typename Traits::face_descriptor;
  using Point = typename boost::property_traits<VertexPointMap>::value_type;

public:
  Mesh_export(QuadMesh& mesh, VertexPointMap vpm, EdgeConstrainedMap ecm, const Input_mesh& in,
              const Mesh_descriptors<QuadMesh>& old, Adaptation_state& s)
      : mesh_(mesh), vpm_(vpm), ecm_(ecm), in_(in), old_(old), s_(s), m_(s.mesh)
  {
  }

  void operator()()
  {
    find_changed_faces();
    remember_old_edges();
    make_vertices();
    make_room();
    make_edges();
    remove_old_faces();
    make_faces();
    link_border();
    remove_old_edges_and_vertices();
  }

  // The caller's face for face f of the state, after the call.
  face_descriptor face_of(Index f) const { return face(halfedge_of_[4 * f], mesh_); }
  vertex_descriptor vertex_of(Index v) const
  {
    return source(halfedge_of_[nodes_[v].halfedge], mesh_);
  }

private:
  struct Node // what is needed of a vertex of the state
  {
    Index halfedge;
    bool is_frozen;
  };

  bool is_vertex(Index v) const { return nodes_[v].halfedge >= 0; }

  // Does a half-edge run from u to v?
  bool leads_to(Index u, Index v) const
  {
    for(Index h : Quad_complex::Outgoing_range(m_, nodes_[u].halfedge))
      if(m_.target(h) == v) return true;
    return false;
  }

  static halfedge_descriptor null() { return Traits::null_halfedge(); }

  bool was_face(Index f) const { return f < Index(in_.quads.size()); }

  void find_changed_faces()
  {
    changed_.assign(m_.face_end(), 1);
    for(Index f = 0; f < m_.face_end(); ++f)
      if(was_face(f) && m_.is_face(f) && m_.quad(f) == in_.quads[f]) changed_[f] = 0;
    for(std::size_t f = m_.face_end(); f < in_.quads.size(); ++f) changed_.push_back(1);
    halfedge_of_.assign(4 * std::size_t(m_.face_end()), null());
    for(Index f = 0; f < m_.face_end(); ++f) {
      if(changed_[f]) continue;
      halfedge_descriptor h = old_.first_halfedge[f];
      for(int i = 0; i < 4; ++i, h = next(h, mesh_)) halfedge_of_[4 * f + i] = h;
    }
  }

  // The half-edges of changed faces, by where they start; and, where the border leaves the region
  // at an end, the neighbours along it.
  void remember_old_edges()
  {
    old_edges_.make_room(in_, changed_);
    for(std::size_t f = 0; f < in_.quads.size(); ++f) {
      if(!changed_[f]) continue;
      halfedge_descriptor h = old_.first_halfedge[f];
      for(int i = 0; i < 4; ++i, h = next(h, mesh_)) {
        const Index u = in_.quads[f][i], v = in_.quads[f][(i + 1) & 3];
        old_edges_.add(u, v, h);
        const halfedge_descriptor o = opposite(h, mesh_);
        if(!is_border(o, mesh_)) continue;
        border_after_.push_back({ u, next(o, mesh_) });
        border_before_.push_back({ v, prev(o, mesh_) });
      }
    }
    const auto less = [](const auto& a, const auto& b) { return a.first < b.first; };
    std::stable_sort(border_after_.begin(), border_after_.end(), less);
    std::stable_sort(border_before_.begin(), border_before_.end(), less);
  }

  halfedge_descriptor old_halfedge(Index u, Index v) const { return old_edges_.find(u, v, null()); }

  template <typename List, typename Key>
  static halfedge_descriptor lookup(const List& list, const Key& key)
  {
    const auto it = std::lower_bound(list.begin(), list.end(), key,
                                     [](const auto& a, const Key& k) { return a.first < k; });
    return it != list.end() && it->first == key ? it->second : null();
  }

  // Gives the vertices of the state back, which are most of its memory.
  void make_vertices()
  {
    const Index n = m_.vertex_end();
    std::size_t added = 0;
    for(Index v = Index(in_.points.size()); v < n; ++v) added += m_.is_vertex(v);
    reserve_in(mesh_, added, 0, 0, 0);
    vertex_of_.assign(n, Traits::null_vertex());
    nodes_.resize(n);
    for(Index v = 0; v < n; ++v) {
      const bool old = v < Index(in_.points.size());
      if(old) vertex_of_[v] = old_.vertices[v];
      nodes_[v] = { m_.vertex(v).halfedge, m_.vertex(v).frozen };
      if(!m_.is_vertex(v)) continue;
      if(!old) vertex_of_[v] = add_vertex(mesh_);
      const Vec& p = m_.point(v);
      if(!old || p != in_.points[v]) put(vpm_, vertex_of_[v], Point(p.x(), p.y(), p.z()));
    }
    s_.mesh.forget_vertices();
  }

  // Only the places of old faces are free when new ones are made.
  void make_room()
  {
    std::size_t sides = 0;
    std::ptrdiff_t faces = -std::count(changed_.begin(), changed_.begin() + in_.quads.size(), 1);
    for(Index f : m_.faces()) {
      if(!changed_[f]) continue;
      ++faces;
      for(Index h = 4 * f; h < 4 * f + 4; ++h) sides += m_.is_border(h) ? 2 : 1;
    }
    reserve_in(mesh_, 0, sides / 2, std::size_t((std::max)(faces, std::ptrdiff_t(0))), 0);
  }

  void make_edges()
  {
    for(Index h = 0; h < 4 * m_.face_end(); ++h) {
      if(halfedge_of_[h] != null() || !m_.is_face(m_.face(h))) continue;
      const Index o = m_.opposite(h);
      halfedge_descriptor d;
      if(o >= 0 && halfedge_of_[o] != null()) {
        d = opposite(halfedge_of_[o], mesh_);
      } else {
        d = old_halfedge(m_.origin(h), m_.target(h));
        if(d == null()) {
          d = old_halfedge(m_.target(h), m_.origin(h));
          if(d != null()) d = opposite(d, mesh_);
        }
        if(d == null()) {
          d = halfedge(add_edge(mesh_), mesh_);
          const Index c = m_.curve(h);
          put(ecm_, edge(d, mesh_), c >= 0 && s_.curves[c].is_constrained());
        }
      }
      halfedge_of_[h] = d;
      if(o >= 0) halfedge_of_[o] = opposite(d, mesh_);
    }
    for(Index h = 0; h < 4 * m_.face_end(); ++h) {
      if(!changed_[m_.face(h)] || !m_.is_face(m_.face(h))) continue;
      const halfedge_descriptor d = halfedge_of_[h];
      set_target(d, vertex_of_[m_.target(h)], mesh_);
      set_target(opposite(d, mesh_), vertex_of_[m_.origin(h)], mesh_);
    }
  }

  void remove_old_faces()
  {
    for(std::size_t f = 0; f < in_.quads.size(); ++f)
      if(changed_[f]) {
        const halfedge_descriptor h = old_.first_halfedge[f];
        old_faces_.push_back(face(h, mesh_));
      }
    // old edges are kept where the new mesh uses them, or a face that did not change
    keep_.assign(old_edges_.size(), 0);
    old_edges_.for_each([&](Index i, Index u, const auto& e) {
      const Index v = e.target;
      keep_[i] = is_vertex(u) && is_vertex(v) && (leads_to(u, v) || leads_to(v, u));
    });
    for(face_descriptor f : old_faces_) remove_face(f, mesh_);
  }

  void make_faces()
  {
    for(Index f : m_.faces()) {
      if(!changed_[f]) continue;
      const face_descriptor d = add_face(mesh_);
      set_halfedge(d, halfedge_of_[4 * f], mesh_);
      for(int i = 0; i < 4; ++i) {
        const halfedge_descriptor h = halfedge_of_[4 * f + i];
        set_face(h, d, mesh_);
        set_next(h, halfedge_of_[4 * f + ((i + 1) & 3)], mesh_);
        // a frozen vertex may lie on the border of the mesh outside the region
        const Index v = m_.target(4 * f + i);
        if(!nodes_[v].is_frozen || !is_border(halfedge(vertex_of_[v], mesh_), mesh_))
          set_halfedge(vertex_of_[v], h, mesh_);
      }
    }
  }

  // Half-edges along the border: those whose outer side has no face of the caller's mesh.
  void link_border()
  {
    std::vector<Index> entering(nodes_.size(), -1); // border half-edge with that target
    for(Index h = 0; h < 4 * m_.face_end(); ++h)
      if(is_true_border(h)) entering[m_.target(h)] = h;
    for(Index h = 0; h < 4 * m_.face_end(); ++h) {
      if(!is_true_border(h)) continue;
      const halfedge_descriptor b = opposite(halfedge_of_[h], mesh_);
      const Index u = m_.origin(h), v = m_.target(h);
      set_face(b, Traits::null_face(), mesh_); // also beside a face that did not change
      if(entering[u] >= 0)
        set_next(b, opposite(halfedge_of_[entering[u]], mesh_), mesh_);
      else if(lookup(border_after_, u) != null())
        set_next(b, lookup(border_after_, u), mesh_);
      set_halfedge(vertex_of_[u], b, mesh_);
      if(!leaving_is_outside(v) || lookup(border_before_, v) == null()) continue;
      set_next(lookup(border_before_, v), b, mesh_);
      set_halfedge(vertex_of_[v], lookup(border_before_, v), mesh_);
    }
  }

  // No border half-edge of the complex starts at v: the border goes on outside the region.
  bool leaving_is_outside(Index v) const
  {
    const Index h = nodes_[v].halfedge;
    return !(m_.is_border(h) && is_true_border(h));
  }

  bool is_true_border(Index h) const
  {
    if(!m_.is_border(h) || !m_.is_face(m_.face(h))) return false;
    return !s_.curves[m_.curve(h)].is_frozen() ||
           is_border(opposite(halfedge_of_[h], mesh_), mesh_); // else a face outside the region
  }

  void remove_old_edges_and_vertices()
  {
    old_edges_.for_each([&](Index i, Index u, const auto& e) {
      const bool twice = u > e.target && old_halfedge(e.target, u) != null();
      if(!keep_[i] && !twice) remove_edge(edge(e.halfedge, mesh_), mesh_);
    });
    for(Index v = 0; v < Index(in_.points.size()); ++v)
      if(!is_vertex(v)) remove_vertex(old_.vertices[v], mesh_);
  }

  QuadMesh& mesh_;
  VertexPointMap vpm_;
  EdgeConstrainedMap ecm_;
  const Input_mesh& in_;
  const Mesh_descriptors<QuadMesh>& old_;
  Adaptation_state& s_;
  const Quad_complex& m_;
  std::vector<Node> nodes_; // of the state, after make_vertices()
  std::vector<char> changed_, keep_;
  std::vector<halfedge_descriptor> halfedge_of_;
  std::vector<vertex_descriptor> vertex_of_;
  std::vector<face_descriptor> old_faces_;
  Old_halfedges<halfedge_descriptor> old_edges_;
  std::vector<std::pair<Index, halfedge_descriptor>> border_after_, border_before_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MESH_EXPORT_H
