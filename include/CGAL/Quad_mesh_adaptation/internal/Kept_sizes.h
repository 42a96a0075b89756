// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_KEPT_SIZES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_KEPT_SIZES_H

#include <CGAL/Quad_mesh_adaptation/internal/Input_mesh.h>
#include <CGAL/Quad_mesh_adaptation/internal/Quad_complex.h>
#include <CGAL/Quad_mesh_adaptation/internal/ideal_count.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// What the size says of a face; negative: not known.
struct Face_sizes
{
  std::array<Integral_and_error, 2> halves = { { { -1, 0 }, { -1, 0 } } };
  double ratio_at_centre = -1;
};

// The same for the faces of the input, to be used again for those that are left as they were: a
// small change leaves most of them.
class Kept_sizes
{
public:
  explicit Kept_sizes(const Input_mesh& in) : in_(in), sizes_(in.quads.size()) {}

  // From now on quad k is the face of this mesh with so many before it.
  void look_at(const Quad_complex& m)
  {
    std::vector<char> same(m.vertex_end(), 0);
    for(std::size_t v = 0; v < same.size() && v < in_.points.size(); ++v)
      same[v] = m.is_vertex(Index(v)) && m.point(Index(v)) == in_.points[v];
    place_.clear();
    place_.reserve(m.number_of_faces());
    for(Index f = 0; f < m.face_end(); ++f) {
      if(!m.is_face(f)) continue;
      const Quad q = m.quad(f);
      const bool is_kept = std::size_t(f) < in_.quads.size() && q == in_.quads[f] && same[q[0]] &&
                           same[q[1]] && same[q[2]] && same[q[3]];
      place_.push_back(is_kept ? f : Index(-1));
    }
  }

  // None where quad k is not one of the input.
  Face_sizes* of(std::size_t k) { return place_[k] < 0 ? nullptr : &sizes_[place_[k]]; }

private:
  const Input_mesh& in_;
  std::vector<Face_sizes> sizes_; // by face of the input
  std::vector<Index> place_;      // of each quad among those
};

// Halves of quads with integrals that may be known.
class Kept_halves : public Quad_halves
{
public:
  Kept_halves(const std::vector<Vec>& points, const std::vector<Quad>& quads, Kept_sizes& kept)
      : Quad_halves(points, quads), kept_(kept)
  {
  }

  Integral_and_error integral(std::size_t i, const Size_function& size) const
  {
    Face_sizes* face = kept_.of(i / 2);
    if(!face) return Quad_halves::integral(i, size);
    Integral_and_error& known = face->halves[i % 2];
    if(known.value < 0) known = Quad_halves::integral(i, size);
    return known;
  }

private:
  Kept_sizes& kept_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_KEPT_SIZES_H
