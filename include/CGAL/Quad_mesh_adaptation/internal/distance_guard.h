// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISTANCE_GUARD_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISTANCE_GUARD_H

// Where the caller has set a largest distance to the reference, no operation and no move takes a
// face beyond it that was not.  Judged at a few points, since it is asked again and again;
// Distance_measure has the last word.

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

inline bool is_distance_limited(const Adaptation_state& s) { return std::isfinite(s.max_distance); }

// From the centre and the middles of the edges of a face to the surface, looked for from triangle
// `hint` on.
inline double distance_of_face(const Adaptation_state& s, const Corners& p, Index hint)
{
  if(s.surface.is_planar()) return 0;
  const auto off = [&](const Vec& q) { return distance(q, s.surface.project(q, hint)); };
  double largest = off(face_centre(p));
  for(int i = 0; i < 4; ++i) largest = (std::max)(largest, off(0.5 * (p[i] + p[(i + 1) & 3])));
  return largest;
}

// Where node r with vertex v (-1: a new one) lies on a curve: is that known?
inline bool arc_on_curve(const Adaptation_state& s, Index curve, const Vertex_record& r, Index v,
                         double& arc)
{
  const Feature_curve& c = s.curves[curve];
  arc = r.carrier == Carrier::curve ? r.param : v == c.first_corner ? 0. : c.length();
  if(r.carrier == Carrier::curve) return r.curve == curve;
  return c.first_corner != c.last_corner && (v == c.first_corner || v == c.last_corner);
}

// From the points of a curve between two nodes to the straight edge between them.
inline double distance_of_edge(const Adaptation_state& s, Index curve, const Vertex_record& a,
                               Index va, const Vertex_record& b, Index vb)
{
  const Feature_curve& c = s.curves[curve];
  double from, to, largest = 0;
  if(!arc_on_curve(s, curve, a, va, from) || !arc_on_curve(s, curve, b, vb, to)) return 0;
  const Vec e = b.p - a.p;
  const double way = c.difference(from, to);
  for(double part : { 0.25, 0.5, 0.75 }) {
    Vec p = c.point(from + part * way);
    if(s.curve_lift && !c.is_frozen()) p = s.curve_lift(p);
    const double t = e * e > 0 ? std::clamp((p - a.p) * e / (e * e), 0., 1.) : 0.;
    largest = (std::max)(largest, distance(p, a.p + t * e));
  }
  return largest;
}

// At half-edge h of the mesh: of a curve, or of the middle from the surface.
inline double distance_of_edge(const Adaptation_state& s, Index h)
{
  const Quad_complex& m = s.mesh;
  const Index a = m.origin(h), b = m.target(h);
  if(m.curve(h) >= 0) return distance_of_edge(s, m.curve(h), m.vertex(a), a, m.vertex(b), b);
  Index hint = s.triangle_near(m.face(h), m.point(a));
  const Vec middle = 0.5 * (m.point(a) + m.point(b));
  return distance(middle, s.surface.project(middle, hint));
}

// Are the middle of face f and those of its edges at half-edge h and the one before it no farther
// from the reference than allowed?
inline bool is_within_bound(const Adaptation_state& s, Index h)
{
  const Quad_complex& m = s.mesh;
  const Index f = m.face(h);
  const Corners p = s.corners(f);
  Index hint = s.triangle_near(f, p[h & 3]);
  if(!s.surface.is_planar() && !s.surface.is_within(face_centre(p), s.max_distance, hint))
    return false;
  for(Index g : { h, m.prev(h) }) {
    const Index a = m.origin(g), b = m.target(g);
    const Vec middle = 0.5 * (m.point(a) + m.point(b));
    if(m.curve(g) >= 0
           ? distance_of_edge(s, m.curve(g), m.vertex(a), a, m.vertex(b), b) > s.max_distance
           : !s.surface.is_within(middle, s.max_distance, hint))
      return false;
  }
  return true;
}

// All of these about vertex v, all that a move of v changes.
inline bool is_within_bound_about(const Adaptation_state& s, Index v)
{
  for(Index h : s.mesh.outgoing(v))
    if(!is_within_bound(s, h)) return false;
  return true;
}

// The largest distance of face f of the mesh.
inline double distance_of(const Adaptation_state& s, Index f)
{
  const Quad_complex& m = s.mesh;
  double largest = distance_of_face(s, s.corners(f), s.triangle_near(f, m.point(m.quad(f)[0])));
  for(Index h = 4 * f; h < 4 * f + 4; ++h)
    if(m.curve(h) >= 0)
      largest =
          (std::max)(largest, distance_of_edge(s, m.curve(h), m.vertex(m.origin(h)), m.origin(h),
                                               m.vertex(m.target(h)), m.target(h)));
  return largest;
}

// The largest of these about vertex v.
inline double distance_about(const Adaptation_state& s, Index v)
{
  double largest = 0;
  for(Index h : s.mesh.outgoing(v)) largest = (std::max)(largest, distance_of(s, s.mesh.face(h)));
  return largest;
}

// Has the move of vertex v from `old` taken a face farther off than allowed and than any was?
inline bool leaves_reference(Adaptation_state& s, Index v, const Vertex_record& old)
{
  if(!is_distance_limited(s) || is_within_bound_about(s, v)) return false;
  const double now = distance_about(s, v);
  if(now <= s.max_distance) return false;
  Vertex_record& r = s.mesh.vertex(v);
  const Vertex_record moved = r;
  r = old;
  const double before = distance_about(s, v);
  r = moved;
  return now > before;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISTANCE_GUARD_H
