// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_QUICK_CLOSE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_QUICK_CLOSE_H

#include <CGAL/Quad_mesh_adaptation/internal/changed_face_quality.h>
#include <CGAL/Quad_mesh_adaptation/internal/merged_position.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Closes a face without relaxing anything, in place: the two ends of a diagonal become one node in
// the middle.  One of the other corners may have three faces; it is a doublet then, and the two
// faces about it become one.  Faces, nodes and edges of curves are not touched, but for faces
// beside them that get a new corner.  For where a search by Cavity would take too long.
class Quick_close
{
public:
  // No face about the new node may be longer than `limit` sizes, nor, away from curves, worse than
  // `least`.
  Quick_close(Adaptation_state& s, double limit, double least) : s_(s), limit_(limit), least_(least)
  {
  }

  // May the ends of the diagonal from the origin of h become one, as far as counts of faces tell?
  // The change of the sum of squares of what nodes have too many or too few goes to `squares`.
  bool is_candidate(Index h, int& squares) const
  {
    constexpr int most = 6;
    const Quad_complex& m = s_.mesh;
    const Index a = m.origin(h), b = m.target(h), c = m.target(m.next(h)), d = m.origin(m.prev(h));
    if(!is_free(a) || !is_free(c) || !may_lose(b) || !may_lose(d)) return false;
    const bool lost_b = is_lost(b), lost_d = is_lost(d);
    const int merged = m.vertex(a).faces + m.vertex(c).faces - 2 - (lost_b || lost_d ? 1 : 0);
    const int least = (std::min)(3, (std::max)(m.vertex(a).faces, m.vertex(c).faces)); // doublets
    if(merged > most || merged < least || (lost_b && lost_d)) return false;
    const auto square = [&](Index v, int faces) {
      const int more = faces - m.vertex(v).ideal_faces;
      return more * more;
    };
    squares = square(a, merged);
    for(Index v : { a, b, c, d }) squares -= square(v, m.vertex(v).faces);
    if(!lost_b) squares += square(b, m.vertex(b).faces - 1);
    if(!lost_d) squares += square(d, m.vertex(d).faces - 1);
    return true;
  }

  // Closes the face of h along the diagonal from its origin if the outcome is a mesh and well
  // shaped; h is a candidate.
  bool operator()(Index h)
  {
    look_at(h);
    if(!is_simple() || (lost_ >= 0 && !is_fusible())) return false;
    guess_merged();
    if(!is_within_limit() || (leave_middle() && !is_within_limit())) return false;
    if(!is_well_shaped() || !place_merged()) return false;
    commit();
    if(lost_ >= 0) fuse();
    return true;
  }

private:
  bool is_free(Index v) const
  {
    const Vertex_record& r = s_.mesh.vertex(v);
    return r.carrier == Carrier::surface && !r.frozen && s_.is_to_work_on(v);
  }

  bool is_lost(Index v) const { return s_.mesh.vertex(v).faces == 3 && is_free(v); }

  bool may_lose(Index v) const
  {
    const Vertex_record& r = s_.mesh.vertex(v);
    if(r.carrier == Carrier::surface) return r.faces > 3 || is_lost(v);
    return r.faces > (std::max)(int(r.ideal_faces), 1);
  }

  void look_at(Index h)
  {
    const Quad_complex& m = s_.mesh;
    const Index n = m.next(h), nn = m.next(n), p = m.prev(h);
    h_ = h;
    a_ = m.origin(h);
    b_ = m.target(h);
    c_ = m.origin(nn);
    d_ = m.origin(p);
    lost_ = is_lost(b_) ? b_ : is_lost(d_) ? d_ : Index(-1);
    if(lost_ < 0) return;
    from_lost_ = m.opposite(lost_ == b_ ? h : nn);
    to_lost_ = m.opposite(lost_ == b_ ? n : p);
    far_ = m.origin(m.prev(from_lost_));
  }

  // Do the two nodes share no neighbours but the two other corners?  Gathers the faces about them.
  bool is_simple()
  {
    const Quad_complex& m = s_.mesh;
    m.outgoing(a_, star_);
    m.outgoing(c_, about_c_);
    neighbours_.clear();
    for(Index g : star_) neighbours_.push_back(m.target(g));
    for(Index g : about_c_) {
      const Index v = m.target(g);
      if(v == a_) return false;
      if(v != b_ && v != d_ &&
         std::find(neighbours_.begin(), neighbours_.end(), v) != neighbours_.end())
        return false;
    }
    star_.insert(star_.end(), about_c_.begin(), about_c_.end());
    return true;
  }

  bool is_fusible() const
  {
    const Quad_complex& m = s_.mesh;
    return m.vertex(far_).faces > 3 && may_lose(far_) &&
           m.target(m.next(from_lost_)) != m.origin(m.prev(to_lost_));
  }

  // In the middle, not on the surface yet.
  void guess_merged()
  {
    const Vertex_record &a = s_.mesh.vertex(a_), &c = s_.mesh.vertex(c_);
    merged_ = a;
    merged_.p = 0.5 * (a.p + c.p);
    merged_.normal = normalized(a.normal + c.normal);
    merged_.h = 0.5 * (a.h + c.h);
    merged_.floor = 0.5 * (a.floor + c.floor);
    merged_.faces = a.faces + c.faces - 2;
  }

  // Where the surface bends sharply the node has another place; tells whether it has.
  bool leave_middle()
  {
    ends_.assign({ a_, c_ });
    const Vec middle = merged_.p;
    merged_.p = merged_position(s_, ends_);
    return merged_.p != middle;
  }

  // False where the surface is too far away for the checks to hold.
  bool place_merged()
  {
    const Vec guess = merged_.p, along = s_.mesh.point(c_) - s_.mesh.point(a_);
    s_.place(merged_);
    return (merged_.p - guess).squared_length() < 0.1 * along.squared_length();
  }

  // The node as it will be.
  const Vertex_record& node(Index v) const
  {
    return v == a_ || v == c_ ? merged_ : s_.mesh.vertex(v);
  }

  Quad fused() const
  {
    const Quad_complex& m = s_.mesh;
    return { a_, m.target(m.next(from_lost_)), far_, m.origin(m.prev(to_lost_)) };
  }

  // Are they true of all faces about the merged node as they will be?
  template <typename Predicate>
  bool are_all(const Predicate& is_fine) const
  {
    if(lost_ >= 0 && !is_fine(fused())) return false;
    for(Index g : star_) {
      const Index f = s_.mesh.face(g);
      if(f == s_.mesh.face(h_)) continue;
      if(lost_ >= 0 && (f == s_.mesh.face(from_lost_) || f == s_.mesh.face(to_lost_))) continue;
      if(!is_fine(s_.mesh.quad(f))) return false;
    }
    return true;
  }

  // What most trials fail for, and the cheapest to find out.
  bool is_within_limit() const
  {
    const auto node_of = [this](Index v) -> const Vertex_record& { return node(v); };
    return are_all([&](const Quad& q) { return !is_changed_face_longer(q, node_of, limit_); });
  }

  // Are the faces about the merged node as they should be, or at least no worse than they were?
  // What is less good is mended by smoothing where nodes are free, but hardly beside curves.
  bool is_well_shaped() const
  {
    constexpr double least_beside_curves = 0.3;
    const auto node_of = [this](Index v) -> const Vertex_record& { return node(v); };
    return are_all([&](const Quad& q) {
      const auto [p, reference] = changed_face(q, node_of);
      const double least = is_changed_face_held(q, node_of) ? least_beside_curves : least_;
      return has_quality(p, reference, least) ||
             was_any_as_bad(Adaptation_state::face_quality(p, reference));
    });
  }

  // Was the quality of a face about the two nodes no better?
  bool was_any_as_bad(double quality) const
  {
    const double better = (std::max)(std::nextafter(quality, 2.), 0.01);
    return std::any_of(star_.begin(), star_.end(), [&](Index g) {
      const Index f = s_.mesh.face(g);
      const Corners p = s_.corners(f);
      const Facing reference = s_.reference_normal(f);
      return !has_quality(p, reference, better) &&
             Adaptation_state::face_quality(p, reference) <= quality;
    });
  }

  // The face goes; node c becomes node a.
  void commit()
  {
    Quad_complex& m = s_.mesh;
    const Index n = m.next(h_), nn = m.next(n), p = m.prev(h_);
    const Index from_b = m.opposite(h_), to_b = m.opposite(n), from_d = m.opposite(nn),
                to_d = m.opposite(p);
    for(Index g : about_c_) m.set_origin(g, a_);
    m.set_opposites(from_b, to_b);
    m.set_opposites(from_d, to_d);
    merged_.halfedge = to_b;
    m.vertex(a_) = merged_;
    s_.disturb(a_);
    m.lose_face(b_, n, from_b);
    m.lose_face(d_, p, from_d);
    m.remove_face(m.face(h_));
    m.remove_vertex(c_);
  }

  // The faces beside the doublet become one, in the place of the one with the edge from it.
  void fuse()
  {
    Quad_complex& m = s_.mesh;
    const Index first = from_lost_, last = m.prev(first); // the sides that change
    const Index from_far = m.next(m.next(to_lost_)), to_a = m.prev(to_lost_);
    const Index side = m.origin(to_a);
    m.set_origin(first, side);
    m.replace(to_a, first);
    m.replace(from_far, last);
    if(m.vertex(side).halfedge == to_a) m.vertex(side).halfedge = first;
    m.lose_face(far_, from_far, last);
    m.lose_face(a_, to_lost_, m.next(first));
    m.remove_face(m.face(to_lost_));
    m.remove_vertex(lost_);
  }

  Adaptation_state& s_;
  double limit_, least_;
  Index h_ = -1, a_ = -1, b_ = -1, c_ = -1, d_ = -1; // the face
  Index lost_ = -1, from_lost_ = -1, to_lost_ = -1;  // the doublet, half-edges to and from a or c
  Index far_ = -1;                                   // its other neighbour
  std::vector<Index> star_, about_c_, neighbours_;   // half-edges from a and c
  std::vector<Index> ends_;
  Vertex_record merged_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_QUICK_CLOSE_H
