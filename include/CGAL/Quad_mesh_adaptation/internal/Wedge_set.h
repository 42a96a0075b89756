// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_WEDGE_SET_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_WEDGE_SET_H

#include <CGAL/Quad_mesh_adaptation/internal/Merged_nodes.h>
#include <CGAL/Quad_mesh_adaptation/internal/huge_nodes.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/chord_collapse.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// A choice of wedges that can go at the same time.  A wedge is a face at a node of huge valence,
// with the two rows of faces that lead from its outer edges to the border, or to one face at
// another such node.  It closes onto its middle: the ends of the edges that it crosses become one,
// the node has a face less, and no node becomes irregular.
class Wedge_set
{
public:
  static constexpr const char* operation = "wedge collapse";

  explicit Wedge_set(const Adaptation_state& s)
      : s_(s), wedge_of_face_(s.mesh.face_end(), -1), wedge_of_node_(s.mesh.vertex_end(), -1),
        spoke_of_(s.mesh.face_end(), -1)
  {
  }

  std::size_t number_of_chosen() const { return chosen_; }

  // Wedges narrower than `widest` sizes everywhere that share no node, about every other one.
  void choose_narrow(double widest)
  {
    const Quad_complex& m = s_.mesh;
    for(Index v : huge_nodes(m))
      for(Index spoke : m.outgoing(v))
        if(has_room(spoke)) consider(spoke, widest);
  }

  // Is face f of a wedge that is chosen?
  bool removes(Index f) const
  {
    return wedge_of_face_[f] >= 0 && wedges_[wedge_of_face_[f]].is_chosen;
  }

  // The other one of the edges of a face of a wedge that become one: at a huge node its two spokes.
  Index across(Index h) const
  {
    const Index spoke = spoke_of_[Quad_complex::face(h)];
    if(spoke < 0) return Quad_complex::next(Quad_complex::next(h));
    return h == spoke ? Quad_complex::prev(h) : Quad_complex::next(h);
  }

  template <typename Visit>
  void for_each_chosen_rung(const Visit& visit) const
  {
    for(const Wedge& w : wedges_)
      if(w.is_chosen)
        for(std::size_t i = w.first; i < w.first + w.number; ++i) visit(all_rungs_[i]);
  }

  // Leaves out the wedge of which node v is.
  void leave_out_about(Index v)
  {
    const Index w = wedge_of_node_[v];
    if(w < 0 || !wedges_[w].is_chosen) return;
    wedges_[w].is_chosen = false;
    --chosen_;
  }

  // Would an edge of face f be longer than `limit` sizes, and than it is?  The face may be, for its
  // spokes are long where they lead far.
  bool is_too_long(Index f, const Merged_nodes& nodes, double limit) const
  {
    constexpr double rounding = 1.1;
    const Quad_complex& m = s_.mesh;
    for(Index h = 4 * f; h < 4 * f + 4; ++h) {
      const Index u = m.origin(h), v = m.target(h);
      const Vertex_record &a = nodes.node(u), &b = nodes.node(v);
      const double length = distance(a.p, b.p);
      if(length > limit * 0.5 * (a.h + b.h) && length > rounding * distance(m.point(u), m.point(v)))
        return true;
    }
    return false;
  }

private:
  struct Wedge
  {
    std::size_t first, number; // of the rungs
    bool is_chosen;
  };

  // Is nothing at the outer corners of the face of a spoke taken, nor huge itself?
  bool has_room(Index spoke) const
  {
    Index h = spoke;
    for(int i = 0; i < 3; ++i) {
      h = Quad_complex::next(h);
      const Index v = s_.mesh.origin(h);
      if(wedge_of_node_[v] >= 0 || is_huge(s_.mesh, v)) return false;
    }
    return true;
  }

  void consider(Index spoke, double widest)
  {
    rungs_.clear();
    faces_.clear();
    spokes_.assign(1, spoke);
    if(trace() && is_narrow(widest) && may_go())
      keep();
    else
      for(Index f : faces_) wedge_of_face_[f] = -1;
  }

  void keep()
  {
    const Index number = Index(wedges_.size());
    wedges_.push_back({ all_rungs_.size(), rungs_.size(), true });
    ++chosen_;
    all_rungs_.insert(all_rungs_.end(), rungs_.begin(), rungs_.end());
    for(Index h : rungs_)
      wedge_of_node_[s_.mesh.origin(h)] = wedge_of_node_[s_.mesh.target(h)] = number;
    for(Index spoke : spokes_) spoke_of_[Quad_complex::face(spoke)] = spoke;
  }

  // --- the way of a wedge

  // Follows both rows from the face of the spoke; true if they end on the border or in one face.
  bool trace()
  {
    const Index outer = Quad_complex::next(spokes_[0]);
    Index ends[2];
    if(!take(Quad_complex::face(outer)) || !follow(outer, ends[0]) ||
       !follow(Quad_complex::next(outer), ends[1]))
      return false;
    if(ends[0] < 0 || ends[1] < 0) return ends[0] == ends[1];
    const bool in_order = Quad_complex::next(ends[0]) == ends[1];
    if(!in_order && Quad_complex::next(ends[1]) != ends[0]) return false;
    spokes_.push_back(Quad_complex::prev(ends[in_order ? 0 : 1]));
    return take(Quad_complex::face(ends[0]));
  }

  // The row beyond the edge of h up to the border, where `end` is -1, or to a face at a huge node.
  // False where it runs into itself or into another wedge, or between two curves.
  bool follow(Index h, Index& end)
  {
    const Quad_complex& m = s_.mesh;
    for(;;) {
      rungs_.push_back(h);
      end = m.opposite(h);
      if(end < 0 || is_at_huge_node(m.face(end))) return true;
      if(!take(m.face(end)) || have_both_curves(m.next(end), m.prev(end))) return false;
      h = m.next(m.next(end));
    }
  }

  bool take(Index f)
  {
    if(wedge_of_face_[f] >= 0) return false;
    wedge_of_face_[f] = Index(wedges_.size());
    faces_.push_back(f);
    return true;
  }

  bool is_at_huge_node(Index f) const
  {
    const Quad q = s_.mesh.quad(f);
    return std::any_of(q.begin(), q.end(), [this](Index v) { return is_huge(s_.mesh, v); });
  }

  bool have_both_curves(Index h, Index g) const
  {
    return s_.mesh.curve(h) >= 0 && s_.mesh.curve(g) >= 0;
  }

  // --- may it go?

  bool is_narrow(double widest) const
  {
    return std::all_of(rungs_.begin(), rungs_.end(), [&](Index h) {
      const Vertex_record &u = s_.mesh.vertex(s_.mesh.origin(h)),
                          &v = s_.mesh.vertex(s_.mesh.target(h));
      return distance(u.p, v.p) < widest * 0.5 * (u.h + v.h);
    });
  }

  bool may_go()
  {
    for(Index h : spokes_)
      if(have_both_curves(h, Quad_complex::prev(h))) return false;
    ends_.clear();
    for(Index h : rungs_) {
      if(!is_rung_collapsible(s_, h)) return false;
      for(Index v : { s_.mesh.origin(h), s_.mesh.target(h) }) {
        if(wedge_of_node_[v] >= 0 || !s_.is_to_work_on(v)) return false;
        ends_.push_back({ v, h });
      }
    }
    std::sort(ends_.begin(), ends_.end());
    for(std::size_t i = 0, end = 0; i < ends_.size(); i = end) {
      for(end = i; end < ends_.size() && ends_[end].first == ends_[i].first; ++end) {
      }
      if(end - i > 2 || (end - i == 2 && !may_become_one(ends_[i].second, ends_[i + 1].second)))
        return false;
    }
    return true;
  }

  // May the three nodes of two rungs that meet become one?  Those of curves only along curves, and
  // one corner; no others may meet them, nor may a face that stays have two of them.
  bool may_become_one(Index h, Index g) const
  {
    const Quad_complex& m = s_.mesh;
    const Index u[4] = { m.origin(h), m.target(h), m.origin(g), m.target(g) };
    int held = 0, corners = 0, ends = 0;
    for(int i = 0; i < 4; ++i) {
      const bool is_middle = u[i] == u[(i + 2) & 3] || u[i] == u[3 - i];
      if(is_middle && i > 1) continue; // once
      held += carrier_rank(m.vertex(u[i])) > 0 ? 1 : 0;
      corners += carrier_rank(m.vertex(u[i])) > 1 ? 1 : 0;
      if(is_middle) continue;
      ++ends;
      if(rungs_at(u[i]) != 1 || shares_a_face(u[i], u)) return false;
    }
    const int edges = (m.curve(h) >= 0 ? 1 : 0) + (m.curve(g) >= 0 ? 1 : 0);
    return ends == 2 && corners <= 1 && (held <= 1 || edges == held - 1);
  }

  std::ptrdiff_t rungs_at(Index v) const
  {
    const auto before = [](const auto& a, const auto& b) { return a.first < b.first; };
    const auto range =
        std::equal_range(ends_.begin(), ends_.end(), std::make_pair(v, Index(0)), before);
    return range.second - range.first;
  }

  // Has a face at v that stays another one of the nodes?
  bool shares_a_face(Index v, const Index (&nodes)[4]) const
  {
    const Quad_complex& m = s_.mesh;
    for(Index h : m.outgoing(v))
      if(wedge_of_face_[m.face(h)] < 0)
        for(Index u : m.quad(m.face(h)))
          if(u != v && std::find(nodes, nodes + 4, u) != nodes + 4) return true;
    return false;
  }

  const Adaptation_state& s_;
  std::vector<Wedge> wedges_;
  std::vector<Index> all_rungs_;
  std::vector<Index> wedge_of_face_, wedge_of_node_; // -1: none
  std::vector<Index> spoke_of_; // the first one of a face of a wedge at a huge node
  std::size_t chosen_ = 0;
  std::vector<Index> rungs_, faces_, spokes_; // of the wedge that is looked at
  std::vector<std::pair<Index, Index>> ends_; // of its rungs
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_WEDGE_SET_H
