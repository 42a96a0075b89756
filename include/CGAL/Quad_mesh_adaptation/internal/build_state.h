// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_BUILD_STATE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_BUILD_STATE_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/Curve_tracer.h>
#include <CGAL/Quad_mesh_adaptation/internal/Face_parts.h>
#include <CGAL/Quad_mesh_adaptation/internal/Feature_marking.h>
#include <CGAL/Quad_mesh_adaptation/internal/Input_mesh.h>
#include <CGAL/Quad_mesh_adaptation/internal/Mesh_triangles.h>
#include <CGAL/Quad_mesh_adaptation/internal/Reference_matcher.h>
#include <CGAL/Quad_mesh_adaptation/internal/Smooth_surface.h>
#include <CGAL/Quad_mesh_adaptation/internal/state_options.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Finds border, creases, corners and curves of the input and puts every node on its carrier.
class State_builder
{
public:
  State_builder(const Input_mesh& in, const Feature_options& o, Adaptation_state& s)
      : in_(in), s_(s), cos_(std::cos(o.feature_angle * pi / 180)), off_(o.feature_angle >= 180)
  {
  }

  void operator()(const Geometry_options& geometry = Geometry_options())
  {
    make_complex();
    Feature_marking mark(in_, cos_, off_, s_);
    mark.mark_edges(geometry.reference);
    mark.mark_corners();
    s_.turned_faces = mark.turned().size();
    Curve_tracer tracer(in_, s_, geometry.smooth && !geometry.reference);
    tracer();
    number_patches();
    if(geometry.reference)
      use_reference(*geometry.reference, geometry);
    else
      use_input(tracer.edges(), geometry, mark.turned());
    s_.curve_lift = geometry.curve_lift;
    place_nodes(!geometry.reference);
    set_ideal_valences();
  }

private:
  void make_complex()
  {
    Quad_complex& m = s_.mesh;
    const std::size_t n = in_.quads.size(), few = n / 16; // for small changes to come
    // those of the input keep their places to the end, all others may be new: what is not written
    // to takes no memory, and a list that grows is there twice
    m.reserve(2 * in_.points.size() + few, n + few);
    for(std::size_t v = 0; v < in_.points.size(); ++v) {
      Vertex_record r;
      r.p = in_.points[v];
      r.halfedge = 0;
      r.frozen = !in_.is_frozen_vertex.empty() && in_.is_frozen_vertex[v];
      m.add_vertex(r);
    }
    m.protect_vertices_below(Index(in_.points.size()));
    m.add_faces(in_.quads, 0);
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
    for(Index v : m.vertices()) {
      if(m.outgoing(v).size() != m.vertex(v).faces)
        throw Refused{ Refusal::non_manifold, "joins parts of the mesh that share no edge there",
                       -1, v };
    }
  }

  // Faces that no curve parts are a patch.
  void number_patches()
  {
    Quad_complex& m = s_.mesh;
    const Face_parts parts(m, [&m](Index h) { return m.curve(h) < 0; });
    s_.given_patch.reserve(parts.size());
    for(Index f = 0; f < m.face_end(); ++f) {
      m.set_patch(f, parts.of(f));
      if(std::size_t(m.patch(f)) == s_.given_patch.size())
        s_.given_patch.push_back(in_.patch.empty() ? 0 : in_.patch[f]);
    }
  }

  // `turned`: faces that lie upside down.
  void use_input(const Hermite_edges& edges, const Geometry_options& geometry,
                 const std::vector<Index>& turned)
  {
    // faces have the numbers of the quads still
    s_.surface = Mesh_triangles(s_.mesh).surface(true, seems_adapted() ? Normals::found_anew
                                                                       : Normals::kept);
    const auto hint = [&](Index f) {
      for(Index v : in_.quads[f]) s_.mesh.vertex(v).hint = 2 * f; // a triangle next to it
    };
    std::for_each(turned.begin(), turned.end(), hint);
    for(Index f = 0; f < Index(in_.quads.size()); ++f)
      if(!std::binary_search(turned.begin(), turned.end(), f)) hint(f); // better ones
    s_.reference_patch.resize(s_.given_patch.size());
    for(std::size_t f = 0; f < in_.quads.size(); ++f)
      s_.reference_patch[s_.mesh.patch(Index(f))] = s_.surface.patch(Index(2 * f));
    lift_surface(edges, geometry);
  }

  void use_reference(const Triangle_soup& reference, const Geometry_options& geometry)
  {
    Quad_complex& m = s_.mesh;
    Reference_matcher match(reference, cos_, off_, s_);
    match();
    s_.surface = Reference_surface(reference.points, reference.triangles, match.sharp());
    if(!s_.surface.is_planar()) match_patches();
    lift_surface(match.edges(), geometry);
    for(Index v : m.vertices()) {
      Vertex_record& r = m.vertex(v);
      if(r.carrier != Carrier::surface || s_.surface.is_planar()) continue;
      Vec n(0, 0, 0);
      for(Index h : m.outgoing(v)) n = n + area_vector(s_.corners(m.face(h)));
      r.hint = s_.surface.find(r.p, s_.reference_patch[m.patch(m.face(r.halfedge))], n);
    }
  }

  // Do most faces of a large input have their size already, by a sample?  Then next to none of the
  // normals of its triangles is asked for twice.
  bool seems_adapted() const
  {
    constexpr std::size_t large = 100000, samples = 1000;
    const std::size_t n = in_.quads.size();
    std::size_t fit = 0;
    for(std::size_t i = 0; n >= large && i < samples; ++i) {
      const Corners p = s_.corners(Index(i * n / samples));
      const double ratio = mean_edge_length(p) / s_.size.at(face_centre(p));
      fit += ratio > 0.5 && ratio < 1.05 ? 1 : 0;
    }
    return 10 * fit >= 9 * samples;
  }

  // A patch of the input lies on the patch of the reference that nearly all its faces are nearest
  // to; where they do not agree, the reference has no such patch.
  void match_patches()
  {
    const Quad_complex& m = s_.mesh;
    std::vector<std::vector<Index>> found(s_.given_patch.size());
    for(Index f = 0; f < m.face_end(); ++f) {
      const Corners p = s_.corners(f);
      const Index t = s_.surface.find(face_centre(p), -1, area_vector(p));
      found[m.patch(f)].push_back(s_.surface.patch(t));
    }
    s_.reference_patch.assign(found.size(), -1);
    for(std::size_t k = 0; k < found.size(); ++k) {
      std::sort(found[k].begin(), found[k].end());
      const std::size_t n = found[k].size();
      const Index middle = found[k][n / 2];
      const auto same = std::equal_range(found[k].begin(), found[k].end(), middle);
      if(10 * std::size_t(same.second - same.first) >= 9 * n) s_.reference_patch[k] = middle;
    }
  }

  void lift_surface(const Hermite_edges& edges, const Geometry_options& geometry)
  {
    const bool project = bool(geometry.projector);
    if(!project && (!geometry.smooth || s_.surface.is_planar())) return;
    const auto smooth = std::make_shared<const Smooth_surface>(s_.surface, edges);
    if(!project)
      s_.surface.set_lift([smooth](const Vec& foot, Index t) { return (*smooth)(foot, t); });
    else
      s_.surface.set_lift([smooth, f = geometry.projector](const Vec& foot, Index t) {
        return checked_projection(f, foot, (*smooth)(foot, t).normal);
      });
  }

  // `is_own`: the surface is the input itself.
  void place_nodes(bool is_own)
  {
    Quad_complex& m = s_.mesh;
    for(Index v : m.vertices()) {
      Vertex_record& r = m.vertex(v);
      const Vec given = r.p;
      if(is_own && s_.is_own_vertex(v) && has_corner(r.hint, v)) {
        r.normal = s_.surface.normal(r.hint);
        r.h = s_.size.at(r.p);
        continue;
      }
      s_.place(r);
      // where the surface is the input itself, nodes are on it already: keep their last bit
      if((r.p - given).squared_length() < 1e-24 * (given * given)) r.p = given;
      if(r.frozen) r.p = given;
      if(s_.surface.is_planar()) r.normal = s_.surface.normal(0);
    }
  }

  bool has_corner(Index triangle, Index v) const
  {
    const std::array<Index, 3>& t = s_.surface.triangles()[triangle];
    return t[0] == v || t[1] == v || t[2] == v;
  }

  void set_ideal_valences()
  {
    Quad_complex& m = s_.mesh;
    for(Index v : m.vertices()) {
      Vertex_record& r = m.vertex(v);
      const bool border = m.is_border_vertex(v);
      r.ideal_faces = border ? 2 : 4;
      if(r.carrier != Carrier::corner) continue;
      double angle = 0;
      for(Index h : m.outgoing(v)) angle += corner_angle(h);
      r.ideal_faces = std::int16_t((std::max)(1L, std::lround(angle / (pi / 2))));
    }
  }

  double corner_angle(Index h) const
  {
    const Quad_complex& m = s_.mesh;
    const Vec p = m.point(m.origin(h));
    const Vec a = m.point(m.target(h)) - p, b = m.point(m.origin(m.prev(h))) - p;
    const double angle = angle_between(a, b);
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
