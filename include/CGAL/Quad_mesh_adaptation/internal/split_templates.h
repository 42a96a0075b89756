// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SPLIT_TEMPLATES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SPLIT_TEMPLATES_H

#include <CGAL/Quad_mesh_adaptation/internal/curve_order.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// A node on the segment between two nodes, at fraction t.
inline Vertex_record node_between(const Vertex_record& a, const Vertex_record& b, double t)
{
  Vertex_record r;
  r.p = a.p + t * (b.p - a.p);
  r.floor = (1 - t) * a.floor + t * b.floor;
  r.halfedge = 0;
  return r;
}

// The same inside face f.
inline Vertex_record inner_node(const Adaptation_state& s, const Vertex_record& a,
                                const Vertex_record& b, double t, Index f)
{
  Vertex_record r = node_between(a, b, t);
  r.hint = s.triangle_near(f, r.p);
  s.place(r);
  return r;
}

// The node that cuts the edge of h in two: the point that halves the integral of ds / h for a size
// that is linear along the edge; on the curve of h if it has one.
inline Vertex_record edge_middle(const Adaptation_state& s, Index h)
{
  const Quad_complex& m = s.mesh;
  const Vertex_record &a = m.vertex(m.origin(h)), &b = m.vertex(m.target(h));
  const double ra = std::sqrt(a.h), rb = std::sqrt(b.h);
  const double t = (std::min)((std::max)(ra / (ra + rb), 0.38), 0.62);
  Vertex_record r = node_between(a, b, t);
  const Index c = m.curve(h);
  if(c >= 0) {
    const Feature_curve& curve = s.curves[c];
    r.carrier = Carrier::curve;
    r.curve = c;
    r.ideal_faces = curve.is_border() ? 2 : 4;
    r.normal = s.surface.is_planar() ? s.surface.normal(0) : Vec(0, 0, 0);
    double sa = 0, sb = 0;
    ends_on_curve(s, h, sa, sb);
    r.param = sa + t * curve.difference(sa, sb);
  } else {
    r.hint = s.triangle_near(m.face(h), r.p);
  }
  s.place(r);
  return r;
}

// Conforming 2-refinement: cuts every marked edge in two and every face by the template of its
// marks: none, 2 opposite (2 quads), 2 adjacent (3 quads), 4 (4 quads).
// Precondition: the marks of every face are one of these.  Faces without marks are not touched.
class Split_templates
{
public:
  Split_templates(Adaptation_state& s, const std::vector<char>& split) : s_(s), split_(split) {}

  // Returns the number of faces that were cut.
  std::size_t operator()()
  {
    Quad_complex& m = s_.mesh;
    const Index faces = m.face_end();
    make_room();
    middle_.assign(4 * std::size_t(faces), -1);
    add_middles();
    std::size_t cut = 0;
    for(Index f = 0; f < faces; ++f)
      if(m.is_face(f) && cut_face(f)) ++cut;
    middle_ = std::vector<Index>(); // links need the memory
    if(cut == 0) return 0;
    m.link();
    for(Index f : children_) look_again(f);
    s_.count("template refinement", cut);
    return cut;
  }

private:
  // Where the mesh grows by much, at once: lists that grow by and by are there twice each time.
  void make_room()
  {
    Quad_complex& m = s_.mesh;
    std::size_t sides = 0, faces = 0, nodes = 0;
    for(Index f : m.faces()) {
      int marks = 0;
      for(Index h = 4 * f; h < 4 * f + 4; ++h)
        if(split_[h]) {
          ++marks;
          sides += m.is_border(h) ? 2 : 1;
        }
      const bool is_opposite = marks == 2 && split_[4 * f] == split_[4 * f + 2];
      faces += marks == 4 ? 3 : is_opposite ? 1 : std::size_t(marks);
      nodes += marks == 4 || (marks == 2 && !is_opposite) ? 1 : 0;
    }
    if(4 * faces < std::size_t(m.number_of_faces())) return;
    nodes += std::size_t(m.vertex_end()) + sides / 2;
    faces += std::size_t(m.face_end());
    m.make_room(nodes, faces);
  }

  // In blocks, each of which is placed side by side before its nodes are added in order.
  void add_middles()
  {
    constexpr std::size_t block = 4096, part = 64;
    const Quad_complex& m = s_.mesh;
    std::vector<Index> edges;
    for(Index h = 0; h < 4 * m.face_end(); ++h) {
      const Index o = m.opposite(h);
      if(m.is_face(m.face(h)) && split_[h] && (o < 0 || o > h)) edges.push_back(h);
      if(edges.size() < block && h + 1 < 4 * m.face_end()) continue;
      std::vector<Vertex_record> nodes(edges.size());
      s_.workers.run((edges.size() + part - 1) / part, [&](std::size_t k) {
        const std::size_t last = (std::min)((k + 1) * part, edges.size());
        for(std::size_t i = k * part; i < last; ++i) nodes[i] = edge_middle(s_, edges[i]);
      });
      for(std::size_t i = 0; i < edges.size(); ++i) add_middle(edges[i], nodes[i]);
      edges.clear();
    }
  }

  void add_middle(Index h, const Vertex_record& r)
  {
    const Index o = s_.mesh.opposite(h);
    middle_[h] = s_.mesh.add_vertex(r);
    if(o >= 0) middle_[o] = middle_[h];
  }

  bool cut_face(Index f)
  {
    Quad_complex& m = s_.mesh;
    int marks = 0;
    for(int i = 0; i < 4; ++i) marks += split_[4 * f + i] ? 1 : 0;
    if(marks == 0) return false;
    for(int i = 0; i < 4; ++i) {
      corner_[i] = m.origin(4 * f + i);
      mid_[i] = middle_[4 * f + i];
      curve_[i] = m.curve(4 * f + i);
    }
    patch_ = m.patch(f);
    face_ = f;
    fresh_ = false;
    first_child_ = children_.size();
    if(marks == 4)
      cut_in_four();
    else if(split_[4 * f] == split_[4 * f + 2])
      cut_in_two(split_[4 * f] ? 0 : 1);
    else
      for(int i = 0; i < 4; ++i)
        if(split_[4 * f + i] && split_[4 * f + ((i + 3) & 3)]) cut_in_three(i);
    hand_witnesses_on();
    return true;
  }

  // Each witness of the face goes to the child that it is nearest to.
  void hand_witnesses_on()
  {
    witnesses_.clear();
    s_.coverage.take(face_, witnesses_);
    if(witnesses_.empty()) return;
    covers_.clear();
    for(std::size_t i = first_child_; i < children_.size(); ++i)
      covers_.add(s_.corners(children_[i]));
    for(Index w : witnesses_) {
      const std::pair<double, std::size_t> best = covers_.best_cover(s_.coverage[w]);
      s_.coverage.give(w, children_[first_child_ + best.second], best.first);
    }
  }

  void cut_in_four()
  {
    Quad_complex& m = s_.mesh;
    const Index x = m.add_vertex(
        inner_node(s_, m.vertex(mid_[0]), m.vertex(mid_[2]), 0.5,
                   face_)); // of the joined middles, so that both directions follow the size
    for(int i = 0; i < 4; ++i) {
      const int p = (i + 3) & 3;
      add({ corner_[i], mid_[i], x, mid_[p] }, { curve_[i], -1, -1, curve_[p] });
    }
  }

  // Edges i and i + 2 are split.
  void cut_in_two(int i)
  {
    const int j = (i + 1) & 3, k = (i + 2) & 3, l = (i + 3) & 3;
    add({ corner_[i], mid_[i], mid_[k], corner_[l] }, { curve_[i], -1, curve_[k], curve_[l] });
    add({ mid_[i], corner_[j], corner_[k], mid_[k] }, { curve_[i], curve_[j], curve_[k], -1 });
  }

  // The edges at corner i are split.
  void cut_in_three(int i)
  {
    Quad_complex& m = s_.mesh;
    const int j = (i + 1) & 3, k = (i + 2) & 3, l = (i + 3) & 3;
    const Index x =
        m.add_vertex(inner_node(s_, m.vertex(corner_[i]), m.vertex(corner_[k]), 0.45, face_));
    add({ corner_[i], mid_[i], x, mid_[l] }, { curve_[i], -1, -1, curve_[l] });
    add({ mid_[i], corner_[j], corner_[k], x }, { curve_[i], curve_[j], -1, -1 });
    add({ mid_[l], x, corner_[k], corner_[l] }, { -1, -1, curve_[k], curve_[l] });
  }

  // Everything about a new face is new, and what its nodes' neighbours know of them.
  void look_again(Index f)
  {
    s_.face_replaced(f);
    for(Index v : s_.mesh.quad(f)) {
      s_.disturb(v);
      s_.stir(v);
    }
  }

  void add(const Quad& q, const std::array<Index, 4>& curve)
  {
    Quad_complex& m = s_.mesh;
    Index f = face_;
    if(fresh_)
      f = m.add_face(q, patch_);
    else
      m.set_quad(f, q);
    children_.push_back(f);
    fresh_ = true; // the first child keeps the number of its parent
    for(int i = 0; i < 4; ++i) m.set_curve(4 * f + i, curve[i]);
  }

  Adaptation_state& s_;
  const std::vector<char>& split_;
  std::vector<Index> middle_, children_, witnesses_;
  Covering_faces covers_;
  std::size_t first_child_ = 0; // of the face that is cut, among the children
  std::array<Index, 4> corner_, mid_, curve_;
  Index patch_ = 0, face_ = 0;
  bool fresh_ = false;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SPLIT_TEMPLATES_H
