// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FEATURE_MARKING_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FEATURE_MARKING_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/Crease_lookup.h>
#include <CGAL/Quad_mesh_adaptation/internal/Face_parts.h>
#include <CGAL/Quad_mesh_adaptation/internal/Input_mesh.h>
#include <CGAL/Quad_mesh_adaptation/internal/Mesh_triangles.h>
#include <CGAL/Quad_mesh_adaptation/internal/stray_creases.h>
#include <CGAL/Quad_mesh_adaptation/internal/tangled_nodes.h>
#include <CGAL/Quad_mesh_adaptation/internal/turned_faces.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The mesh of a state for `Stray_creases`; features are the edges with a curve number.
struct State_with_creases
{
  Adaptation_state& state;
  const std::vector<Vec>& areas; // of the faces, as vectors

  Index vertex_end() const { return state.mesh.vertex_end(); }
  Index halfedge_end() const { return 4 * state.mesh.face_end(); }
  Index face(Index h) const { return state.mesh.face(h); }
  Index next(Index h) const { return Quad_complex::next(h); }
  Index origin(Index h) const { return state.mesh.origin(h); }
  Index target(Index h) const { return state.mesh.target(h); }
  Index opposite(Index h) const { return state.mesh.opposite(h); }
  Index across(Index h) const { return Quad_complex::next(Quad_complex::next(h)); }
  double turn(Index h) const // none on the border
  {
    const Index o = opposite(h);
    return o < 0 ? 0. : angle_between(areas[face(h)], areas[face(o)]);
  }
  const Vec& point(Index v) const { return state.mesh.point(v); }
  double length(Index h) const { return distance(point(origin(h)), point(target(h))); }
  const Vec& area_vector(Index f) const { return areas[f]; }
  bool is_feature(Index h) const { return state.mesh.curve(h) >= 0; }
  void forget(Index h) { state.mesh.set_curve(h, -1); }
  bool is_held(Index v) const { return state.mesh.vertex(v).frozen; }
};

// Finds the border, creases and what the caller has marked, and the corners where these end, meet
// or turn.
class Feature_marking
{
public:
  // Features turn by more than the angle with cosine `cosine`; none does if detection is off.
  Feature_marking(const Input_mesh& in, double cosine, bool off, Adaptation_state& s)
      : in_(in), s_(s), cos_(cosine), off_(off)
  {
  }

  // Curve 0 on a half-edge says "feature" until curves are traced.  A separate reference knows
  // where creases are: the edges of a coarse mesh of it turn by more than it does.
  void mark_edges(const Triangle_soup* reference)
  {
    Quad_complex& m = s_.mesh;
    for(Index h = 0; h < 4 * m.face_end(); ++h) {
      const Index o = m.opposite(h);
      bool feature = o < 0 || in_.has_constrained(h);
      if(!feature && !in_.patch.empty()) feature = in_.patch[m.face(h)] != in_.patch[m.face(o)];
      if(feature) m.set_curve(h, 0);
    }
    if(off_) return;
    std::optional<Reference_creases> creases;
    std::optional<Crease_lookup> known;
    if(reference) known.emplace(creases.emplace(*reference, cos_, off_));
    std::vector<Vec> areas;
    areas.reserve(m.face_end());
    for(Index f = 0; f < m.face_end(); ++f) areas.push_back(area_vector(s_.corners(f)));
    std::vector<char> detected = detect_creases(areas, known);
    if(detected.empty()) return; // nor is any of these a stray one
    set_curves(detected, -1);
    if(is_in_plane(areas) && is_plane()) return; // its creases are tangles
    const bool may_be_turned = known || are_folds_among(detected, areas);
    if(may_be_turned && turn_back(areas)) detected = detect_creases(areas, known);
    if(detected.empty()) return;
    set_curves(detected, 0);
    State_with_creases surface{ s_, areas };
    Tangled_nodes<State_with_creases>(surface, detected, cos_)();
    s_.creases_taken_back = Stray_creases<State_with_creases>(surface, detected)();
  }

  void mark_corners()
  {
    Quad_complex& m = s_.mesh;
    std::vector<std::pair<Index, Index>> ends; // of features, and their half-edges
    for(Index h = 0; h < 4 * m.face_end(); ++h) {
      if(m.curve(h) < 0 || (m.opposite(h) >= 0 && m.opposite(h) < h)) continue;
      ends.push_back({ m.origin(h), h });
      ends.push_back({ m.target(h), h });
    }
    std::sort(ends.begin(), ends.end());
    auto next = ends.begin();
    std::vector<Index> e;
    for(Index v : m.vertices()) {
      Vertex_record& r = m.vertex(v);
      for(e.clear(); next != ends.end() && next->first == v; ++next) e.push_back(next->second);
      if(e.empty() && !r.frozen) continue;
      r.carrier = e.size() == 2 && !r.frozen && !turns(v, e[0], e[1]) &&
                          in_.has_frozen(e[0]) == in_.has_frozen(e[1]) &&
                          is_constrained(e[0]) == is_constrained(e[1])
                      ? Carrier::curve
                      : Carrier::corner;
    }
  }

  // Faces that lie upside down in tangles, after edges are marked.
  const std::vector<Index>& turned() const { return turned_; }

private:
  // By half-edge, empty if there are none.
  std::vector<char> detect_creases(const std::vector<Vec>& areas,
                                   const std::optional<Crease_lookup>& known) const
  {
    const Quad_complex& m = s_.mesh;
    std::vector<double> norms;
    norms.reserve(areas.size());
    for(const Vec& a : areas) norms.push_back(norm(a));
    std::vector<char> detected;
    for(Index h = 0; h < 4 * m.face_end(); ++h) {
      const Index o = m.opposite(h);
      if(m.curve(h) >= 0 || o < h) continue;
      const Index f = m.face(h), g = m.face(o);
      if(!(areas[f] * areas[g] < cos_ * norms[f] * norms[g])) continue;
      if(known && !known->runs_along(m.point(m.origin(h)), m.point(m.target(h)))) continue;
      detected.resize(4 * std::size_t(m.face_end()), 0);
      detected[h] = detected[o] = 1;
    }
    return detected;
  }

  // Is any of these edges one that faces turned over have about them?  All are detected, unless
  // features turn by still more.
  bool are_folds_among(const std::vector<char>& detected, const std::vector<Vec>& areas) const
  {
    if(cos_ <= Turned_faces::back) return true;
    for(Index h = 0; h < Index(detected.size()); ++h)
      if(detected[h] &&
         Turned_faces::is_fold(areas[s_.mesh.face(h)], areas[s_.mesh.face(s_.mesh.opposite(h))]))
        return true;
    return false;
  }

  // Turns the areas of faces that lie upside down in tangles; are there any?
  bool turn_back(std::vector<Vec>& areas)
  {
    const Turned_faces turned(s_.mesh, areas);
    if(!turned.is_any()) return false;
    for(Index f = 0; f < s_.mesh.face_end(); ++f)
      if(turned.has(f)) turned_.push_back(f);
    for(Index f : turned_) areas[f] = -areas[f];
    return true;
  }

  void set_curves(const std::vector<char>& where, Index c)
  {
    for(Index h = 0; h < 4 * s_.mesh.face_end(); ++h)
      if(where[h]) s_.mesh.set_curve(h, c);
  }

  // Do all points lie in a plane?
  bool is_in_plane(const std::vector<Vec>& areas) const
  {
    constexpr double tolerance = 1e-9;
    const std::vector<Quad>& quads = in_.quads;
    const Vec origin = in_.points[quads[0][0]];
    Vec normal(0, 0, 0);
    double size = 0;
    for(const Vec& a : areas) normal = normal + a;
    for(const Quad& q : quads) size = (std::max)(size, distance(in_.points[q[0]], origin));
    normal = normalized(normal);
    return std::all_of(quads.begin(), quads.end(), [&](const Quad& q) {
      return std::all_of(q.begin(), q.end(), [&](Index v) {
        return std::abs((in_.points[v] - origin) * normal) <= tolerance * size;
      });
    });
  }

  // Is it one that the surface takes for a plane, parted by the features that are marked?
  bool is_plane()
  {
    Quad_complex& m = s_.mesh;
    const Face_parts parts(m, [&m](Index h) { return m.curve(h) < 0; });
    for(Index f = 0; f < m.face_end(); ++f) m.set_patch(f, parts.of(f));
    return Mesh_triangles(m).surface(true, Normals::none).is_planar();
  }

  bool is_constrained(Index h) const
  {
    const Index o = s_.mesh.opposite(h);
    return in_.has_constrained(h) || (o >= 0 && in_.has_constrained(o));
  }

  bool turns(Index v, Index g, Index h) const
  {
    const Quad_complex& m = s_.mesh;
    const auto other = [&](Index e) { return m.origin(e) == v ? m.target(e) : m.origin(e); };
    const Vec a = m.point(v) - m.point(other(g)), b = m.point(other(h)) - m.point(v);
    const double c = off_ ? -0.5 : cos_; // a fold back is a corner in any case
    return a * b < c * norm(a) * norm(b);
  }

  const Input_mesh& in_;
  Adaptation_state& s_;
  double cos_;
  bool off_;
  std::vector<Index> turned_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FEATURE_MARKING_H
