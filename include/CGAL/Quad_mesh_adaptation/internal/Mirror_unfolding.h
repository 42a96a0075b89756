// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MIRROR_UNFOLDING_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MIRROR_UNFOLDING_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/Input_mesh.h>
#include <CGAL/Quad_mesh_adaptation/internal/Mirror_assembly.h>
#include <CGAL/Quad_mesh_adaptation/internal/Mirror_part.h>
#include <CGAL/Quad_mesh_adaptation/internal/Mirror_plane.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Completes an adapted part by its images, plane by plane from the last to the first.  What was a
// vertex, an edge or a face of the input has its number again, and the image of what is still as
// in the input is what was there on the other side.
class Mirror_unfolding
{
public:
  // `whole` is the state of the input, not adapted, `part` the adapted state of the part, which is
  // not needed any more after this.
  Mirror_unfolding(const Input_mesh& in, const Adaptation_state& whole,
                   const Adaptation_state& part, const Mirror_part& origin, Mirror_part::Cut cut,
                   const std::vector<Mirror_plane>& planes)
      : in_(in), whole_(whole), planes_(planes), curves_(part.curves), cut_(std::move(cut))
  {
    const Quad_complex& m = part.mesh;
    std::size_t live = 0;
    for(Index v = 0; v < m.vertex_end(); ++v) live += m.is_vertex(v);
    vertices_.reserve(std::size_t(m.vertex_end()) + (live << planes.size()) - live);
    faces_.reserve(std::size_t(m.number_of_faces()) << planes.size());
    for(Index v = 0; v < m.vertex_end(); ++v) vertices_.push_back(m.vertex(v));
    for(Vertex_record& r : vertices_) // the first triangle of its face in the whole
      if(r.hint >= 0 && std::size_t(r.hint / 2) < origin.face.size())
        r.hint = 2 * origin.face[r.hint / 2] + r.hint % 2;
    for(Index f : m.faces()) {
      Mirrored_face face;
      face.v = m.quad(f);
      for(int i = 0; i < 4; ++i) face.curve[i] = m.curve(4 * f + i);
      face.patch = m.patch(f);
      face.slot = f < Index(origin.face.size()) ? origin.face[f] : Index(-1);
      faces_.push_back(face);
    }
  }

  // The plane to blame if the images do not fit together or, against `limit`, their sizes are not
  // the same; -1 if all is well.
  int operator()(double limit)
  {
    touched_.assign(vertices_.size(), 0);
    for(int i = int(planes_.size()) - 1; i >= 0; --i)
      if(!add_images(i, limit)) return i;
    return Mirror_assembly(in_, whole_, vertices_, faces_, touched_, int(planes_.size()), mesh_)();
  }

  // Only after success.
  Quad_complex& mesh() { return mesh_; }
  std::vector<Feature_curve>& curves() { return curves_; }

private:
  bool add_images(int i, double limit)
  {
    const Mirror_plane& plane = planes_[i];
    settle_on(i);
    image_.assign(vertices_.size(), -1);
    const std::size_t n = faces_.size(), old_curves = curves_.size();
    curve_image_.assign(old_curves, -1);
    for(std::size_t f = 0; f < n; ++f) {
      const Mirrored_face face = faces_[f];
      Mirrored_face other;
      for(int k = 0; k < 4; ++k) {
        const Index c = face.curve[(3 - k) & 3];
        other.v[k] = image_of(face.v[(4 - k) & 3], plane, i);
        other.curve[k] = c < 0 ? c : curve_image_of(c, plane, i);
      }
      other.patch = face.patch;
      if(face.slot >= 0) {
        other.slot = plane.face_partner[face.slot];
        turn_as_in_input(other);
      }
      faces_.push_back(other);
      if(!has_same_size(face, other, limit)) return false;
    }
    for(std::size_t c = 0; c < old_curves; ++c) end_curve_image(Index(c));
    dissolve_cut(i);
    return true;
  }

  // Which nodes lie on plane i is told by the edges along it.
  void settle_on(int i)
  {
    touched_.resize(vertices_.size(), 0);
    for(const Mirrored_face& f : faces_)
      for(int k = 0; k < 4; ++k)
        if(f.curve[k] >= 0 && cut_.plane[f.curve[k]] == i)
          touched_[f.v[k]] |= 1 << i, touched_[f.v[(k + 1) & 3]] |= 1 << i;
    for(Index v = 0; v < Index(vertices_.size()); ++v)
      if(is_on(v, i) && !is_as_given(v)) vertices_[v].p = planes_[i].project(vertices_[v].p);
  }

  bool is_on(Index v, int i) const { return (touched_[v] >> i) & 1; }

  bool is_given(Index v) const { return v < Index(in_.points.size()); }
  bool is_as_given(Index v) const { return is_given(v) && vertices_[v].p == in_.points[v]; }

  Index image_of(Index v, const Mirror_plane& plane, int i)
  {
    if(is_on(v, i)) return v;
    if(image_[v] >= 0) return image_[v];
    const Index partner = is_given(v) ? plane.other(v) : Index(-1);
    Vertex_record r = vertices_[v];
    r.p = partner >= 0 && is_as_given(v) ? in_.points[partner] : plane.reflect(r.p);
    r.normal = plane.reflect_direction(r.normal);
    if(r.curve >= 0) r.curve = curve_image_of(r.curve, plane, i);
    if(r.hint >= 0 && std::size_t(r.hint / 2) < plane.face_partner.size())
      r.hint = 2 * plane.face_partner[r.hint / 2] + r.hint % 2;
    if(partner >= 0) {
      vertices_[partner] = r;
      touched_[partner] = touched_[v];
      return image_[v] = partner;
    }
    vertices_.push_back(r);
    touched_.push_back(touched_[v]);
    image_.push_back(-1);
    return image_[v] = Index(vertices_.size()) - 1;
  }

  Index curve_image_of(Index c, const Mirror_plane& plane, int i)
  {
    if(cut_.plane[c] == i) return c; // both sides share it
    if(curve_image_[c] >= 0) return curve_image_[c];
    const Feature_curve& from = curves_[c];
    std::vector<Vec> points;
    for(const Vec& p : from.points()) points.push_back(plane.reflect(p));
    Feature_curve to(std::move(points), from.is_closed(), from.is_border(), from.is_frozen());
    to.constrained = from.constrained;
    curves_.push_back(std::move(to));
    cut_.plane.push_back(cut_.plane[c]);
    cut_.is_feature.push_back(cut_.is_feature[c]);
    return curve_image_[c] = Index(curves_.size()) - 1;
  }

  // The corners that the image of a curve runs between.
  void end_curve_image(Index c)
  {
    const Index to = curve_image_[c];
    if(to < 0) return;
    const auto end = [this](Index v) { return v >= 0 && image_[v] >= 0 ? image_[v] : v; };
    curves_[to].first_corner = end(curves_[c].first_corner);
    curves_[to].last_corner = end(curves_[c].last_corner);
  }

  // The edges along plane i become edges inside the surface, unless a feature runs there.
  void dissolve_cut(int i)
  {
    for(Mirrored_face& f : faces_)
      for(Index& c : f.curve)
        if(c >= 0 && cut_.plane[c] == i && !cut_.is_feature[c]) c = -1;
    for(std::size_t c = 0; c < curves_.size(); ++c) {
      if(cut_.plane[c] != i || !cut_.is_feature[c]) continue;
      Feature_curve inner(curves_[c].points(), curves_[c].is_closed(), false, false);
      inner.constrained = curves_[c].constrained;
      inner.first_corner = curves_[c].first_corner;
      inner.last_corner = curves_[c].last_corner;
      curves_[c] = std::move(inner);
    }
    for(Index v = 0; v < Index(vertices_.size()); ++v) {
      Vertex_record& r = vertices_[v];
      if(!is_on(v, i)) continue;
      r.ideal_faces = std::int16_t(2 * r.ideal_faces);
      r.images = 1;
      if(is_given(v)) r.frozen = whole_.mesh.vertex(v).frozen;
      const bool was_corner = r.carrier == Carrier::corner && is_given(v) &&
                              whole_.mesh.vertex(v).carrier == Carrier::surface;
      const bool was_curve =
          r.carrier == Carrier::curve && cut_.plane[r.curve] == i && !cut_.is_feature[r.curve];
      if(!was_corner && !was_curve) continue;
      r.carrier = Carrier::surface;
      r.curve = -1;
      r.hint = -1;
    }
  }

  // A face that is one of the input again starts at the same corner.
  void turn_as_in_input(Mirrored_face& f) const
  {
    for(int k = 0; k < 4 && f.v[0] != in_.quads[f.slot][0]; ++k) {
      std::rotate(f.v.begin(), f.v.begin() + 1, f.v.end());
      std::rotate(f.curve.begin(), f.curve.begin() + 1, f.curve.end());
    }
  }

  Corners corners(const Mirrored_face& f) const
  {
    return { vertices_[f.v[0]].p, vertices_[f.v[1]].p, vertices_[f.v[2]].p, vertices_[f.v[3]].p };
  }

  // The sizes were compared at the vertices, edges and faces of the input only; here they are at
  // the faces that came out.
  bool has_same_size(const Mirrored_face& a, const Mirrored_face& b, double limit) const
  {
    if(whole_.size.is_constant()) return true;
    const Corners p = corners(a), q = corners(b);
    const double h = whole_.size.at_face(p), g = whole_.size.at_face(q);
    if(!(std::abs(h - g) <= 1e-6 * h)) return false;
    const double bound = limit / whole_.size.scale();
    return mean_edge_length(p) / h > bound || !(mean_edge_length(q) / g > bound);
  }

  const Input_mesh& in_;
  const Adaptation_state& whole_;
  const std::vector<Mirror_plane>& planes_;
  std::vector<Vertex_record> vertices_;
  std::vector<unsigned char> touched_; // bit i: the vertex lies on plane i
  std::vector<Mirrored_face> faces_;
  std::vector<Feature_curve> curves_;
  Mirror_part::Cut cut_;
  std::vector<Index> image_, curve_image_;
  Quad_complex mesh_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MIRROR_UNFOLDING_H
