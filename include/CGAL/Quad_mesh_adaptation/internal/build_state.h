// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_BUILD_STATE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_BUILD_STATE_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/Input_mesh.h>
#include <CGAL/Quad_mesh_adaptation/internal/reference_curves.h>
#include <CGAL/Quad_mesh_adaptation/parameters.h>

#include <cmath>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

struct Feature_options
{
  double feature_angle = default_feature_angle; // degrees
};

// Finds border, creases, corners and curves of the input and puts every node on its carrier.
class State_builder
{
public:
  State_builder(const Input_mesh& in, const Feature_options& o, Adaptation_state& s)
      : in_(in), s_(s), cos_(std::cos(o.feature_angle * pi / 180)), off_(o.feature_angle >= 180)
  {
  }

  void operator()(const Triangle_soup* reference)
  {
    make_complex();
    mark_features();
    mark_corners();
    make_surface(reference);
    trace_curves();
    if(reference) move_border_to(*reference);
    place_nodes();
    set_ideal_valences();
  }

private:
  static constexpr double pi = 3.14159265358979323846;

  void make_complex()
  {
    Quad_complex& m = s_.mesh;
    for(std::size_t v = 0; v < in_.points.size(); ++v) {
      Vertex_record r;
      r.p = in_.points[v];
      r.halfedge = 0;
      r.frozen = !in_.is_frozen_vertex.empty() && in_.is_frozen_vertex[v];
      m.add_vertex(r);
    }
    m.protect_vertices_below(Index(in_.points.size()));
    for(const Quad& q : in_.quads) m.add_face(q, 0);
    Index bad = -1;
    if(!m.link(&bad))
      throw Refused{
        Refusal::non_manifold,
        "starts an edge of more than two faces, or of two faces of opposite orientation", -1,
        m.origin(bad)
      };
    check_umbrellas();
  }

  void check_umbrellas() const
  {
    const Quad_complex& m = s_.mesh;
    std::vector<Index> out;
    for(Index v = 0; v < m.vertex_end(); ++v) {
      if(!m.is_vertex(v)) continue;
      m.outgoing(v, out);
      if(int(out.size()) != m.vertex(v).faces)
        throw Refused{ Refusal::non_manifold, "joins parts of the mesh that share no edge there",
                       -1, v };
    }
  }

  // Temporarily, curve 0 on a half-edge says "feature".
  void mark_features()
  {
    Quad_complex& m = s_.mesh;
    for(Index h = 0; h < 4 * m.face_end(); ++h) {
      const Index o = m.opposite(h);
      bool feature = o < 0 || (!in_.is_constrained.empty() && in_.is_constrained[h]);
      if(!feature && o > h && !off_) {
        const Vec a = area_vector(s_.corners(m.face(h))), b = area_vector(s_.corners(m.face(o)));
        feature = a * b < cos_ * norm(a) * norm(b);
      }
      if(feature) m.set_curve(h, 0);
    }
  }

  void mark_corners()
  {
    Quad_complex& m = s_.mesh;
    std::vector<std::vector<Index>> ends(m.vertex_end()); // feature half-edges by end
    for(Index h = 0; h < 4 * m.face_end(); ++h) {
      if(m.curve(h) < 0 || (m.opposite(h) >= 0 && m.opposite(h) < h)) continue;
      ends[m.origin(h)].push_back(h);
      ends[m.target(h)].push_back(h);
    }
    for(Index v = 0; v < m.vertex_end(); ++v) {
      Vertex_record& r = m.vertex(v);
      if(!m.is_vertex(v)) continue;
      const auto& e = ends[v];
      if(e.empty() && !r.frozen) continue;
      r.carrier = e.size() == 2 && !r.frozen && !turns(v, e[0], e[1]) &&
                          is_frozen(e[0]) == is_frozen(e[1]) &&
                          is_constrained(e[0]) == is_constrained(e[1])
                      ? Carrier::curve
                      : Carrier::corner;
    }
  }

  bool is_frozen(Index h) const { return !in_.is_frozen.empty() && in_.is_frozen[h]; }

  bool is_constrained(Index h) const
  {
    const Index o = s_.mesh.opposite(h);
    return !in_.is_constrained.empty() &&
           (in_.is_constrained[h] || (o >= 0 && in_.is_constrained[o]));
  }

  bool turns(Index v, Index g, Index h) const
  {
    const Quad_complex& m = s_.mesh;
    const auto other = [&](Index e) { return m.origin(e) == v ? m.target(e) : m.origin(e); };
    const Vec a = m.point(v) - m.point(other(g)), b = m.point(other(h)) - m.point(v);
    const double c = off_ ? -0.5 : cos_; // a fold back is a corner in any case
    return a * b < c * norm(a) * norm(b);
  }

  void make_surface(const Triangle_soup* reference)
  {
    if(reference) {
      s_.surface = Reference_surface(reference->points, reference->triangles);
      return;
    }
    Triangle_soup soup;
    soup.points = in_.points;
    for(const Quad& q : in_.quads) append_quad(soup, q);
    for(std::size_t f = 0; f < in_.quads.size(); ++f)
      for(Index v : in_.quads[f]) s_.mesh.vertex(v).hint = Index(2 * f); // a triangle next to it
    s_.surface = Reference_surface(std::move(soup.points), std::move(soup.triangles));
  }

  void trace_curves()
  {
    Quad_complex& m = s_.mesh;
    std::vector<Index> number(4 * std::size_t(m.face_end()), -2); // -2: feature, not traced yet
    for(int round = 0; round < 2; ++round)                        // from corners, then the loops
      for(Index h = 0; h < 4 * m.face_end(); ++h) {
        if(m.curve(h) < 0 || number[h] != -2) continue;
        if(round == 0) {
          const bool a = m.vertex(m.origin(h)).carrier == Carrier::corner;
          const bool b = m.vertex(m.target(h)).carrier == Carrier::corner;
          if(a)
            trace(h, m.origin(h), number);
          else if(b)
            trace(h, m.target(h), number);
        } else {
          trace(h, m.origin(h), number);
        }
      }
    for(Index h = 0; h < 4 * m.face_end(); ++h)
      if(m.curve(h) >= 0) m.set_curve(h, number[h]);
  }

  // Follows the curve of h from vertex "from" to its end.
  void trace(Index h, Index from, std::vector<Index>& number)
  {
    Quad_complex& m = s_.mesh;
    const Index id = Index(s_.curves.size());
    const Index start = h;
    const bool border = m.is_border(h), frozen = is_frozen(h);
    std::vector<Vec> points = { m.point(from) };
    std::vector<Index> path = { from };
    Index v = from;
    while(h >= 0 && number[h] == -2) {
      number[h] = id;
      if(m.opposite(h) >= 0) number[m.opposite(h)] = id;
      const bool forward = m.origin(h) == v;
      v = forward ? m.target(h) : m.origin(h);
      points.push_back(m.point(v));
      path.push_back(v);
      if(m.vertex(v).carrier == Carrier::corner) break;
      h = next_feature(v, h);
    }
    const bool closed = v == from && m.vertex(from).carrier != Carrier::corner;
    Feature_curve c(points, closed, border, frozen);
    c.constrained = is_constrained(start);
    if(!closed) {
      c.first_corner = from;
      c.last_corner = v;
    }
    for(std::size_t i = 0; i + (closed ? 1 : 0) < path.size(); ++i) {
      Vertex_record& r = m.vertex(path[i]);
      if(r.carrier != Carrier::curve) continue;
      r.curve = id;
      r.param = c.arcs()[i];
    }
    s_.curves.push_back(std::move(c));
  }

  // The other feature edge at curve node v, as a half-edge in whichever direction has a face.
  Index next_feature(Index v, Index h) const
  {
    const Quad_complex& m = s_.mesh;
    const Index o = m.opposite(h);
    std::vector<Index> out;
    m.outgoing(v, out);
    for(Index g : out)
      if(m.curve(g) >= 0 && g != h && g != o) return g;
    const Index last = m.prev(out.back());
    return m.is_border(last) && last != h ? last : Index(-1);
  }

  void move_border_to(const Triangle_soup& reference)
  {
    const std::vector<Feature_curve> loops = border_loops(reference);
    if(loops.empty()) return;
    for(Feature_curve& c : s_.curves)
      if(c.is_border() && !c.is_frozen()) c = curve_on_reference(c, loops);
    for(Index v = 0; v < s_.mesh.vertex_end(); ++v) {
      Vertex_record& r = s_.mesh.vertex(v);
      if(s_.mesh.is_vertex(v) && r.carrier == Carrier::curve)
        r.param = s_.curves[r.curve].nearest(r.p);
    }
    for(const Feature_curve& c : s_.curves) {
      if(c.is_closed() || !c.is_border() || c.is_frozen()) continue;
      Vertex_record &a = s_.mesh.vertex(c.first_corner), &b = s_.mesh.vertex(c.last_corner);
      if(!a.frozen) a.p = c.points().front();
      if(!b.frozen) b.p = c.points().back();
    }
  }

  void place_nodes()
  {
    Quad_complex& m = s_.mesh;
    for(Index v = 0; v < m.vertex_end(); ++v) {
      if(!m.is_vertex(v)) continue;
      Vertex_record& r = m.vertex(v);
      const Vec given = r.p;
      s_.place(r);
      // where the surface is the input itself, nodes are on it already: keep their last bit
      if((r.p - given).squared_length() < 1e-24 * (given * given)) r.p = given;
      if(r.frozen) r.p = given;
      if(s_.surface.is_planar()) r.normal = s_.surface.normal(0);
    }
  }

  void set_ideal_valences()
  {
    Quad_complex& m = s_.mesh;
    std::vector<Index> out;
    for(Index v = 0; v < m.vertex_end(); ++v) {
      if(!m.is_vertex(v)) continue;
      Vertex_record& r = m.vertex(v);
      const bool border = m.is_border_vertex(v);
      r.ideal_faces = border ? 2 : 4;
      if(r.carrier != Carrier::corner) continue;
      double angle = 0;
      m.outgoing(v, out);
      for(Index h : out) angle += corner_angle(h);
      r.ideal_faces = std::int16_t((std::max)(1L, std::lround(angle / (pi / 2))));
    }
  }

  double corner_angle(Index h) const
  {
    const Quad_complex& m = s_.mesh;
    const Vec p = m.point(m.origin(h));
    const Vec a = m.point(m.target(h)) - p, b = m.point(m.origin(m.prev(h))) - p;
    const double angle = std::atan2(norm(cross(a, b)), a * b);
    const bool reflex = cross(a, b) * area_vector(s_.corners(m.face(h))) < 0;
    return reflex ? 2 * pi - angle : angle;
  }

  const Input_mesh& in_;
  Adaptation_state& s_;
  double cos_;
  bool off_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_BUILD_STATE_H
