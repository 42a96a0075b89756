// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MESH_IMPORT_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MESH_IMPORT_H

#include <CGAL/Quad_mesh_adaptation/internal/Input_mesh.h>
#include <CGAL/Quad_mesh_adaptation/internal/No_constraints.h>
#include <CGAL/Quad_mesh_adaptation/internal/Patch_numbers.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The caller's descriptors behind the numbers of an Input_mesh.
template <typename QuadMesh>
struct Mesh_descriptors
{
  using Traits = boost::graph_traits<QuadMesh>;
  std::vector<typename Traits::vertex_descriptor> vertices;
  std::vector<typename Traits::halfedge_descriptor> first_halfedge; // of each face, from corner 0
};

// Fills the arrays from the faces of a range of a graph, checking everything that can be checked
// face by face; throws Refused.  The number of an entity in a message is its position in the
// iteration over the mesh.
template <typename QuadMesh, typename VertexPointMap, typename EdgeConstrainedMap,
          typename VertexConstrainedMap,
          typename EdgeFrozenMap =
              No_constraints<typename boost::graph_traits<QuadMesh>::edge_descriptor>,
          typename FacePatchMap =
              One_patch<typename boost::graph_traits<QuadMesh>::face_descriptor>>
class Mesh_import
{
  using Traits = boost::graph_traits<QuadMesh>;
  using vertex_descriptor = typename Traits::vertex_descriptor;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;
  using face_descriptor = typename Traits::face_descriptor;

public:
  using Patch = typename boost::property_traits<FacePatchMap>::value_type;

  Mesh_import(const QuadMesh& mesh, VertexPointMap vpm, EdgeConstrainedMap ecm,
              VertexConstrainedMap vcm, EdgeFrozenMap efm = EdgeFrozenMap(),
              FacePatchMap fpm = FacePatchMap())
      : mesh_(mesh), vpm_(vpm), ecm_(ecm), vcm_(vcm), efm_(efm), fpm_(fpm)
  {
  }

  // The caller's patch behind each number in Input_mesh::patch.
  const std::vector<Patch>& patches() const { return patch_numbers_.patches(); }

  template <typename FaceRange>
  void operator()(const FaceRange& chosen, bool is_region, Input_mesh& in,
                  Mesh_descriptors<QuadMesh>& out)
  {
    number_of_ = get(CGAL::dynamic_vertex_property_t<Index>(), mesh_);
    in_region_ = get(CGAL::dynamic_face_property_t<bool>(), mesh_);
    for(vertex_descriptor v : vertices(mesh_)) put(number_of_, v, -1);
    if(is_region) {
      fan_number_ = get(CGAL::dynamic_halfedge_property_t<Index>(), mesh_);
      for(halfedge_descriptor h : halfedges(mesh_)) put(fan_number_, h, -1);
      for(face_descriptor f : faces(mesh_)) put(in_region_, f, false);
      for(face_descriptor f : chosen) put(in_region_, f, true);
    }
    if(!is_region) {
      in.points.reserve(num_vertices(mesh_));
      out.vertices.reserve(num_vertices(mesh_));
      in.quads.reserve(num_faces(mesh_));
      out.first_halfedge.reserve(num_faces(mesh_));
    }
    long position = 0;
    for(face_descriptor f : faces(mesh_)) {
      if(!is_region || get(in_region_, f)) add_face(f, position, is_region, in, out);
      ++position;
    }
    if(in.quads.empty())
      throw Refused{ Refusal::empty_mesh,
                     is_region ? "the region has no faces" : "the mesh has no faces", -1 };
    complete(in);
  }

private:
  void add_face(face_descriptor f, long position, bool is_region, Input_mesh& in,
                Mesh_descriptors<QuadMesh>& out)
  {
    const halfedge_descriptor h0 = halfedge(f, mesh_);
    int degree = 0;
    for(halfedge_descriptor h : halfedges_around_face(h0, mesh_)) {
      (void)h;
      if(++degree > 4) break;
    }
    if(degree != 4) {
      const std::string size = degree > 4 ? "more than four" : std::to_string(degree);
      throw Refused{ Refusal::not_all_quads,
                     "face " + std::to_string(position) + " has " + size + " vertices, not four",
                     position };
    }
    Quad q;
    halfedge_descriptor h = h0;
    for(int i = 0; i < 4; ++i, h = next(h, mesh_)) {
      q[i] = is_region ? number_in_region(h, in, out) : number(source(h, mesh_), in, out);
      const bool frozen = (is_region && leaves_region(h)) || get(efm_, edge(h, mesh_));
      const std::size_t number = 4 * in.quads.size() + std::size_t(i);
      if(frozen) mark(in.is_frozen, number);
      if(frozen || get(ecm_, edge(h, mesh_))) mark(in.is_constrained, number);
    }
    check_shape(q, position, in);
    in.quads.push_back(q);
    in.patch.push_back(patch_numbers_.number(get(fpm_, f)));
    out.first_halfedge.push_back(h0);
    if(in.is_frozen.size() <= 4 * in.quads.size() - 4) return; // none here
    for(int i = 0; i < 4; ++i) {
      const std::size_t number = 4 * in.quads.size() - 4 + std::size_t(i);
      if(number >= in.is_frozen.size() || !in.is_frozen[number]) continue;
      mark(in.is_frozen_vertex, std::size_t(q[i]));
      mark(in.is_frozen_vertex, std::size_t(q[(i + 1) & 3]));
    }
  }

  // Lists of marks stay empty, or short, where there are none.
  static void mark(std::vector<char>& list, std::size_t number)
  {
    if(number >= list.size()) list.resize(number + 1, 0);
    list[number] = 1;
  }

  void complete(Input_mesh& in) const
  {
    for(std::vector<char>* list : { &in.is_frozen, &in.is_constrained })
      if(!list->empty()) list->resize(4 * in.quads.size(), 0);
    if(!in.is_frozen_vertex.empty()) in.is_frozen_vertex.resize(in.points.size(), 0);
    if(patches().size() == 1) in.patch = std::vector<Index>();
  }

  // Where parts of the region meet in a vertex only, each part has its own number for it: the
  // vertex stays as it is, and the parts know nothing of each other.
  Index number_in_region(halfedge_descriptor h, Input_mesh& in, Mesh_descriptors<QuadMesh>& out)
  {
    const halfedge_descriptor first =
        end_of_fan(h, [&](halfedge_descriptor g) { return opposite(prev(g, mesh_), mesh_); });
    const halfedge_descriptor last =
        end_of_fan(h, [&](halfedge_descriptor g) { return next(opposite(g, mesh_), mesh_); });
    const vertex_descriptor v = source(h, mesh_);
    const halfedge_descriptor null = Traits::null_halfedge();
    if(first == null || (!leaves_region(prev(first, mesh_)) && !leaves_region(last)))
      return number(v, in, out); // all of it, or from border to border of the mesh
    if(get(fan_number_, first) < 0) {
      put(number_of_, v, -1);
      put(fan_number_, first, number(v, in, out));
    }
    return get(fan_number_, first);
  }

  // The last half-edge about source(h) with a face of the region, turning by `turn`; null if the
  // turn is full.
  template <typename Turn>
  halfedge_descriptor end_of_fan(halfedge_descriptor h, const Turn& turn) const
  {
    const auto in_region = [&](halfedge_descriptor g) {
      return !is_border(g, mesh_) && get(in_region_, face(g, mesh_));
    };
    halfedge_descriptor end = h;
    for(halfedge_descriptor g = turn(h); in_region(g); g = turn(g)) {
      if(g == h) return Traits::null_halfedge();
      end = g;
    }
    return end;
  }

  bool leaves_region(halfedge_descriptor h) const
  {
    const halfedge_descriptor o = opposite(h, mesh_);
    return !is_border(o, mesh_) && !get(in_region_, face(o, mesh_));
  }

  Index number(vertex_descriptor v, Input_mesh& in, Mesh_descriptors<QuadMesh>& out)
  {
    const Index known = get(number_of_, v);
    if(known >= 0) return known;
    const Vec p = to_vec(get(vpm_, v));
    const Index n = Index(in.points.size());
    if(!is_finite(p)) {
      long position = 0;
      for(vertex_descriptor u : vertices(mesh_)) {
        if(u == v) break;
        ++position;
      }
      throw Refused{ Refusal::non_finite_coordinate,
                     "vertex " + std::to_string(position) + " has a coordinate that is not finite",
                     position };
    }
    put(number_of_, v, n);
    in.points.push_back(p);
    if(get(vcm_, v)) mark(in.is_frozen_vertex, std::size_t(n));
    out.vertices.push_back(v);
    return n;
  }

  static void check_shape(const Quad& q, long position, const Input_mesh& in)
  {
    const auto refuse = [&](const char* why) {
      throw Refused{ Refusal::degenerate_face, "face " + std::to_string(position) + " " + why,
                     position };
    };
    if(q[0] == q[2] || q[1] == q[3]) refuse("uses a vertex twice");
    double longest = 0, shortest = -1; // squared
    for(int i = 0; i < 4; ++i) {
      const double l = (in.points[q[i]] - in.points[q[(i + 1) & 3]]).squared_length();
      longest = (std::max)(longest, l);
      shortest = shortest < 0 ? l : (std::min)(shortest, l);
    }
    if(!(std::sqrt(shortest) > 1e-12 * std::sqrt(longest))) refuse("has an edge of length zero");
    const Vec a = cross(in.points[q[2]] - in.points[q[0]], in.points[q[3]] - in.points[q[1]]);
    if(!(norm(a) > 1e-12 * longest)) refuse("has no area");
  }

  const QuadMesh& mesh_;
  VertexPointMap vpm_;
  EdgeConstrainedMap ecm_;
  VertexConstrainedMap vcm_;
  EdgeFrozenMap efm_;
  FacePatchMap fpm_;
  Patch_numbers<Patch> patch_numbers_;
  typename boost::property_map<QuadMesh, CGAL::dynamic_vertex_property_t<Index>>::const_type
      number_of_;
  typename boost::property_map<QuadMesh, CGAL::dynamic_halfedge_property_t<Index>>::const_type
      fan_number_; // by the first half-edge of a fan
  typename boost::property_map<QuadMesh, CGAL::dynamic_face_property_t<bool>>::const_type
      in_region_;
};

// Triangles of a reference surface: polygons are cut, quads along the flatter diagonal.
template <typename Surface>
Triangle_soup import_reference(const Surface& surface)
{
  Triangle_soup soup;
  auto vpm = get(CGAL::vertex_point, surface);
  auto number = get(CGAL::dynamic_vertex_property_t<Index>(), surface);
  for(auto v : vertices(surface)) {
    put(number, v, Index(soup.points.size()));
    soup.points.push_back(to_vec(get(vpm, v)));
    if(!is_finite(soup.points.back()))
      throw Refused{ Refusal::non_finite_coordinate,
                     "the reference surface has a coordinate that is not finite, at its vertex " +
                         std::to_string(soup.points.size() - 1),
                     long(soup.points.size()) - 1 };
  }
  std::vector<Index> corners;
  for(auto f : faces(surface)) {
    corners.clear();
    for(auto v : vertices_around_face(halfedge(f, surface), surface))
      corners.push_back(get(number, v));
    if(corners.size() == 4)
      append_quad(soup, { corners[0], corners[1], corners[2], corners[3] });
    else
      for(std::size_t i = 1; i + 1 < corners.size(); ++i)
        soup.triangles.push_back({ corners[0], corners[i], corners[i + 1] });
  }
  if(soup.triangles.empty())
    throw Refused{ Refusal::empty_mesh, "the reference surface has no faces", -1 };
  return soup;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MESH_IMPORT_H
