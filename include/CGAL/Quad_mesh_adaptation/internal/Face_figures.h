// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_FIGURES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_FIGURES_H

#include <CGAL/Quad_mesh_adaptation/internal/Input_mesh.h>
#include <CGAL/Quad_mesh_adaptation/internal/Quad_complex.h>
#include <CGAL/Quad_mesh_adaptation/internal/ideal_count.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <optional>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// What is measured of one face.
struct Face_figures
{
  double jacobian = 0, ratio_at_centre = -1;
  Integral_and_error asked = {}; // by the sizes, in faces; zero if nobody wants to know

  bool is_known() const { return ratio_at_centre >= 0; }
};

// The face that is farthest from a reference surface.
struct Farthest_face
{
  Index face;
  double distance;
};

// The figures of all faces of a mesh, in their order.  Those of the faces of an input are kept, to
// be used again for the ones that are left as they were: a small change leaves most of them.
class Figures_of_faces
{
public:
  Figures_of_faces() = default;
  explicit Figures_of_faces(const Input_mesh& in) : in_(&in), of_input_(in.quads.size()) {}

  // From now on they are those of so many faces, of which nothing is known.
  void look_at(std::size_t faces)
  {
    face_.resize(faces);
    std::iota(face_.begin(), face_.end(), 0);
    place_.resize(faces);
    for(std::size_t k = 0; k < faces; ++k) place_[k] = -1 - Index(k);
    of_others_.assign(faces, Face_figures());
  }

  // From now on they are those of this mesh.
  void look_at(const Quad_complex& m)
  {
    find_nodes_left(m);
    face_.clear();
    place_.clear();
    face_.reserve(m.number_of_faces());
    place_.reserve(m.number_of_faces());
    Index others = 0;
    for(Index f : m.faces()) {
      face_.push_back(f);
      place_.push_back(is_left(m, f) ? f : -1 - others++);
    }
    of_others_.assign(others, Face_figures());
    if(!std::all_of(extremes_.begin(), extremes_.end(), [&](Index f) { return is_left(m, f); }))
      extremes_.clear();
  }

  std::size_t size() const { return place_.size(); }
  Index face(std::size_t k) const { return face_[k]; } // its number in the mesh
  Face_figures& operator[](std::size_t k)
  {
    return place_[k] >= 0 ? of_input_[place_[k]] : of_others_[-1 - place_[k]];
  }
  const Face_figures& operator[](std::size_t k) const
  {
    return place_[k] >= 0 ? of_input_[place_[k]] : of_others_[-1 - place_[k]];
  }

  // Has face k been measured before?
  bool is_known(std::size_t k) const { return (*this)[k].is_known(); }

  // Must face k be looked at, known or not, to find the extreme angles and the largest warp of all?
  // Only a few are, unless one of them has gone.
  bool may_be_extreme(std::size_t k) const
  {
    return extremes_.empty() ||
           std::find(extremes_.begin(), extremes_.end(), place_[k]) != extremes_.end();
  }
  // Faces that together have these.
  void set_extremes(const std::vector<std::size_t>& faces)
  {
    extremes_.clear();
    for(std::size_t k : faces)
      if(place_[k] < 0) return; // its figures will not be kept
    for(std::size_t k : faces) extremes_.push_back(place_[k]);
  }

  // Of the faces of the input, by their numbers.
  std::optional<Farthest_face> farthest;

private:
  void find_nodes_left(const Quad_complex& m)
  {
    is_node_left_.assign(in_ ? m.vertex_end() : 0, 0);
    for(std::size_t v = 0; v < is_node_left_.size() && v < in_->points.size(); ++v)
      is_node_left_[v] = m.is_vertex(Index(v)) && m.point(Index(v)) == in_->points[v];
  }

  // Is face f of the mesh still that of the input?
  bool is_left(const Quad_complex& m, Index f) const
  {
    if(!in_ || std::size_t(f) >= in_->quads.size() || f >= m.face_end() || !m.is_face(f))
      return false;
    const Quad q = m.quad(f);
    return q == in_->quads[f] &&
           std::all_of(q.begin(), q.end(), [&](Index v) { return is_node_left_[v]; });
  }

  const Input_mesh* in_ = nullptr;
  std::vector<char> is_node_left_;
  std::vector<Face_figures> of_input_, of_others_;
  std::vector<Index> face_;
  std::vector<Index> place_;    // of face k among those of the input, or below zero among others
  std::vector<Index> extremes_; // by face of the input
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_FIGURES_H
