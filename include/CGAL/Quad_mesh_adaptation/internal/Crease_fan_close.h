// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CREASE_FAN_CLOSE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CREASE_FAN_CLOSE_H

#include <CGAL/Quad_mesh_adaptation/internal/changed_face_quality.h>
#include <CGAL/Quad_mesh_adaptation/internal/closed_curves.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Closes a face (v, a, b, c) whose sides a b and b c lie on a crease, in place and without relaxing
// anything: a and c become one with b.  Of the two faces across the crease, (b, a, p, s) and
// (c, b, s, q), one is made.  So v and s have a face less, a look at neither of them is taken, and
// two fans that meet along the crease with their spokes by turns, as those of a sphere of kites,
// are thinned at the same time.
class Crease_fan_close
{
public:
  // No face about the crease may become worse than `least`, nor than any was.
  Crease_fan_close(Adaptation_state& s, double least) : s_(s), least_(least) {}

  // Closes the face of h, a half-edge from a to b, if the outcome is a mesh and well shaped.
  bool operator()(Index h)
  {
    if(!look_at(h) || !are_on_one_curve() || !is_simple() || !is_well_shaped()) return false;
    Closed_curve_check closed_curves(s_);
    closed_curves.add(s_.mesh.curve(h), { a_, b_, c_ });
    if(!closed_curves()) return false;
    commit();
    return true;
  }

private:
  // Names what takes part; false if b has not one face on this side and two on the other.
  bool look_at(Index h)
  {
    const Quad_complex& m = s_.mesh;
    to_b_ = h;
    a_ = m.origin(h);
    b_ = m.target(h);
    c_ = m.target(m.next(h));
    if(m.vertex(b_).faces != 3 || m.is_border_vertex(b_)) return false;
    if(m.is_border_vertex(a_) || m.is_border_vertex(c_)) return false;
    from_b_ = m.opposite(h);
    into_b_ = m.opposite(m.next(h));
    spoke_ = m.prev(from_b_); // from s to b
    return m.opposite(spoke_) == m.next(into_b_) && m.curve(spoke_) < 0;
  }

  bool are_on_one_curve() const
  {
    const Quad_complex& m = s_.mesh;
    const Index curve = m.curve(to_b_), next = m.next(to_b_);
    if(curve < 0 || m.curve(next) != curve || s_.curves[curve].is_frozen()) return false;
    if(m.curve(m.next(next)) >= 0 || m.curve(m.prev(to_b_)) >= 0) return false;
    for(Index v : { a_, b_, c_ }) {
      const Vertex_record& r = m.vertex(v);
      if(r.carrier != Carrier::curve || r.frozen || !s_.is_to_work_on(v)) return false;
    }
    return true;
  }

  // Have a and c no neighbours in common but v and b, and not s?  Gathers the faces about them.
  bool is_simple()
  {
    constexpr int most = 6;
    const Quad_complex& m = s_.mesh;
    m.outgoing(a_, star_);
    m.outgoing(c_, about_c_);
    if(int(star_.size() + about_c_.size()) - 3 > most) return false;
    const Index v = m.origin(m.prev(to_b_)), s = m.origin(spoke_);
    const Index p = m.target(m.next(from_b_)), q = m.origin(m.prev(into_b_));
    std::vector<Index> neighbours;
    for(Index g : star_) neighbours.push_back(m.target(g));
    for(Index g : about_c_) {
      const Index u = m.target(g);
      if(u != v && u != b_) neighbours.push_back(u);
    }
    std::sort(neighbours.begin(), neighbours.end());
    star_.insert(star_.end(), about_c_.begin(), about_c_.end());
    return p != q && m.vertex(s).faces > 3 &&
           std::adjacent_find(neighbours.begin(), neighbours.end()) == neighbours.end() &&
           !std::binary_search(neighbours.begin(), neighbours.end(), s);
  }

  Quad joined() const
  {
    const Quad_complex& m = s_.mesh;
    return { b_, m.target(m.next(from_b_)), m.origin(spoke_), m.origin(m.prev(into_b_)) };
  }

  bool is_well_shaped() const
  {
    const Quad_complex& m = s_.mesh;
    const auto node = [&](Index v) -> const Vertex_record& {
      return m.vertex(v == a_ || v == c_ ? b_ : v);
    };
    double before = 1, after = changed_face_quality(joined(), node);
    for(Index g : star_) {
      const Index f = m.face(g);
      before = (std::min)(before, s_.face_quality(s_.corners(f), s_.reference_normal(f)));
      if(f != m.face(to_b_) && f != m.face(from_b_) && f != m.face(into_b_))
        after = (std::min)(after, changed_face_quality(m.quad(f), node));
    }
    return after >= (std::min)(least_, before);
  }

  void commit()
  {
    Quad_complex& m = s_.mesh;
    const Index to_v = m.next(m.next(to_b_)), from_v = m.prev(to_b_);
    const Index v = m.origin(from_v), s = m.origin(spoke_), q = m.origin(m.prev(into_b_));
    const Index from_s = m.next(m.next(into_b_)), from_q = m.prev(into_b_);
    for(Index g : star_) m.set_origin(g, b_);
    m.set_origin(from_b_, q); // the face of it is the one that is made
    m.replace(from_q, from_b_);
    m.replace(from_s, spoke_);
    m.vertex(b_).faces = Index(star_.size()) - 3;
    m.vertex(b_).halfedge = m.next(from_b_);
    if(m.vertex(q).halfedge == from_q) m.vertex(q).halfedge = from_b_;
    m.lose_face(s, from_s, spoke_);
    m.lose_face(v, from_v, m.opposite(to_v));
    m.set_opposites(m.opposite(from_v), m.opposite(to_v));
    m.remove_face(m.face(to_b_));
    m.remove_face(m.face(into_b_));
    m.remove_vertex(a_);
    m.remove_vertex(c_);
    s_.disturb(b_);
  }

  Adaptation_state& s_;
  double least_;
  Index a_ = -1, b_ = -1, c_ = -1;    // of the face, along the crease
  Index to_b_ = -1;                   // from a, in the face
  Index from_b_ = -1, into_b_ = -1;   // across the crease, to a and from c
  Index spoke_ = -1;                  // there, from s to b
  std::vector<Index> star_, about_c_; // half-edges from a and c
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CREASE_FAN_CLOSE_H
