// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FAN_TURNING_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FAN_TURNING_H

#include <CGAL/Quad_mesh_adaptation/internal/changed_face_quality.h>
#include <CGAL/Quad_mesh_adaptation/internal/huge_nodes.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Two fans whose spokes meet the rows between them at different nodes have no wedge: the two rows
// from a face of one end in two faces of the other.  So one of the two is turned by half a face, in
// place: its spokes go to the corners opposite the centre instead.
class Fan_turning
{
public:
  explicit Fan_turning(Adaptation_state& s) : s_(s) {}

  // Turns those of the nodes that do not fit the fans they lead to, unless these have been turned;
  // returns how many.
  std::size_t operator()(const std::vector<Index>& nodes)
  {
    constexpr Index often = 4; // looks at each face
    steps_left_ = often * s_.mesh.number_of_faces();
    std::vector<char> is_turned(s_.mesh.vertex_end(), 0);
    std::size_t turned = 0;
    for(Index v : nodes) {
      const Index other = fan_not_fitted(v);
      if(other < 0 || is_turned[other] || !turn(v)) continue;
      is_turned[v] = 1;
      ++turned;
    }
    if(turned > 0) s_.forget_faces();
    s_.count("vertex rotation", turned);
    return turned;
  }

private:
  // --- which fans

  // The huge node in two neighbouring faces of which the rows end from the faces at v, if there is
  // one for most of them; else -1.
  Index fan_not_fitted(Index v)
  {
    s_.mesh.outgoing(v, spokes_);
    Index other = -1;
    std::size_t count = 0;
    for(Index spoke : spokes_) {
      const Index at = end_beside(Quad_complex::next(spoke));
      if(at < 0 || at == v) continue;
      if(other >= 0 && at != other) return -1;
      other = at;
      ++count;
    }
    return 2 * count > spokes_.size() ? other : Index(-1);
  }

  Index end_beside(Index outer)
  {
    const Quad_complex& m = s_.mesh;
    const Index a = end_of_row(outer), b = a < 0 ? a : end_of_row(m.next(outer));
    if(b < 0) return -1;
    for(const Index h : { a, b }) {
      const Index spoke = m.next(h), back = m.opposite(spoke);
      if(back >= 0 && m.next(back) == (h == a ? b : a) && is_huge(m, m.target(spoke)))
        return m.target(spoke);
    }
    return -1;
  }

  // The row beyond the edge of h up to a face at a huge node; -1 if it does not lead to one.
  Index end_of_row(Index h)
  {
    const Quad_complex& m = s_.mesh;
    for(const Index start = h; steps_left_ > 0; --steps_left_) {
      h = m.opposite(h);
      if(h < 0) return -1;
      const Quad q = m.quad(m.face(h));
      if(std::any_of(q.begin(), q.end(), [&](Index v) { return is_huge(m, v); })) return h;
      h = m.next(m.next(h));
      if(h == start) return -1;
    }
    return -1;
  }

  // --- the turn

  struct Outer_edge
  {
    Index opposite, curve;
  };

  bool turn(Index v)
  {
    s_.mesh.outgoing(v, spokes_);
    if(!may_turn(v) || !is_well_shaped(v)) return false;
    Quad_complex& m = s_.mesh;
    const std::size_t n = spokes_.size();
    std::vector<Outer_edge> outer;
    std::vector<Index> rim; // node after the spoke's end, for each, and the end of the next spoke
    for(Index h : spokes_)
      for(const Index g : { m.next(h), m.next(m.next(h)) }) {
        outer.push_back({ m.opposite(g), m.curve(g) });
        rim.push_back(m.target(g));
      }
    for(std::size_t i = 0; i < n; ++i) {
      const Index h = spokes_[i], first = m.next(h), second = m.next(first);
      const std::size_t next = (2 * i + 2) % (2 * n);
      m.set_origin(first, rim[2 * i]);
      m.set_origin(second, rim[2 * i + 1]);
      m.set_origin(m.prev(h), rim[next]);
      set_outer(first, outer[2 * i + 1]);
      set_outer(second, outer[next]);
    }
    for(std::size_t i = 0; i < n; ++i) {
      const Index first = m.next(spokes_[i]), second = m.next(first);
      gain_faces(m.origin(first), first, 1);
      gain_faces(m.origin(second), second, -1);
    }
    s_.disturb(v);
    return true;
  }

  void set_outer(Index h, const Outer_edge& e)
  {
    s_.mesh.set_opposites(h, e.opposite);
    s_.mesh.set_curve(h, e.curve);
  }

  void gain_faces(Index v, Index halfedge, int number)
  {
    Vertex_record& r = s_.mesh.vertex(v);
    r.faces += number;
    r.halfedge = halfedge;
    s_.disturb(v);
  }

  // A fan without curves, all about which is there once and may change; spokes leave no doublet.
  bool may_turn(Index v) const
  {
    const Quad_complex& m = s_.mesh;
    if(m.is_border_vertex(v) || m.vertex(v).carrier != Carrier::surface) return false;
    std::vector<Index> rim;
    for(Index h : spokes_) {
      const Index a = m.target(h), b = m.target(m.next(h));
      if(m.curve(h) >= 0 || m.vertex(a).faces <= 3) return false;
      for(const Index u : { a, b }) {
        if(m.is_border_vertex(u) || !s_.is_to_work_on(u)) return false;
        rim.push_back(u);
      }
      for(const Index g : { m.next(h), m.next(m.next(h)) }) {
        const Quad beyond = m.quad(m.face(m.opposite(g)));
        if(std::find(beyond.begin(), beyond.end(), v) != beyond.end()) return false;
      }
    }
    std::sort(rim.begin(), rim.end());
    return s_.is_to_work_on(v) && std::adjacent_find(rim.begin(), rim.end()) == rim.end();
  }

  // No face of it is folded over then, unless one is now.
  bool is_well_shaped(Index v) const
  {
    const Quad_complex& m = s_.mesh;
    const auto node = [&](Index u) -> const Vertex_record& { return m.vertex(u); };
    double before = 1, after = 1;
    for(std::size_t i = 0; i < spokes_.size(); ++i) {
      const Index h = spokes_[i], g = spokes_[(i + 1) % spokes_.size()];
      const Quad turned = { v, m.target(m.next(h)), m.target(g), m.target(m.next(g)) };
      before = (std::min)(before, changed_face_quality(m.quad(m.face(h)), node));
      after = (std::min)(after, changed_face_quality(turned, node));
    }
    return after >= (std::min)(before, 0.);
  }

  Adaptation_state& s_;
  Index steps_left_ = 0; // so that rows that go a long way do not cost more than all faces
  std::vector<Index> spokes_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FAN_TURNING_H
