// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_PARTS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_PARTS_H

#include <CGAL/Quad_mesh_adaptation/internal/Disjoint_sets.h>
#include <CGAL/Quad_mesh_adaptation/internal/Quad_topology.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The connected parts of a mesh, numbered by their first faces.  One sweep gives each face the
// label of a neighbour before it; the few labels that meet are united, which takes a fraction of
// the time of following links from face to face.
class Face_parts
{
public:
  // `is_link(h)`: do the two faces at this inner edge belong together?
  template <typename Is_link>
  Face_parts(const Quad_topology& m, const Is_link& is_link) : label_(m.face_end(), -1)
  {
    for(Index f : m.faces()) {
      Index label = -1;
      for(Index h = 4 * f; h < 4 * f + 4; ++h) {
        const Index o = m.opposite(h), g = o < 0 ? f : m.face(o);
        if(!(g < f && label_[g] != label && is_link(h))) continue;
        if(label >= 0) labels_.unite(label, label_[g]);
        label = labels_.find(label_[g]);
      }
      label_[f] = label < 0 ? labels_.add() : label;
    }
    number_parts();
  }

  std::size_t size() const { return size_; }
  Index of(Index f) const { return number_[label_[f]]; }

private:
  // A part has the smallest of its labels, which comes first.
  void number_parts()
  {
    number_.resize(labels_.size());
    for(Index label = 0; label < Index(labels_.size()); ++label) {
      const Index first = labels_.find(label);
      number_[label] = first == label ? Index(size_++) : number_[first];
    }
  }

  std::vector<Index> label_; // by face
  Disjoint_sets labels_;
  std::vector<Index> number_; // by label
  std::size_t size_ = 0;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_PARTS_H
