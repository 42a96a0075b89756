// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_PARTS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_PARTS_H

#include <CGAL/Quad_mesh_adaptation/internal/Quad_topology.h>

#include <algorithm>
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
    for(Index f = 0; f < m.face_end(); ++f) {
      if(!m.is_face(f)) continue;
      Index label = -1;
      for(Index h = 4 * f; h < 4 * f + 4; ++h) {
        const Index o = m.opposite(h), g = o < 0 ? f : m.face(o);
        if(g < f && is_link(h)) label = label < 0 ? root(label_[g]) : united(label, label_[g]);
      }
      if(label < 0) {
        label = Index(parent_.size());
        parent_.push_back(label);
      }
      label_[f] = label;
    }
    number_parts();
  }

  std::size_t size() const { return size_; }
  Index of(Index f) const { return number_[label_[f]]; }

private:
  Index root(Index label)
  {
    while(parent_[label] != label) label = parent_[label] = parent_[parent_[label]];
    return label;
  }

  // Roots have the smallest numbers of their parts, so that they come first.
  Index united(Index root_of_one, Index other)
  {
    other = root(other);
    const Index low = (std::min)(root_of_one, other);
    parent_[(std::max)(root_of_one, other)] = low;
    return low;
  }

  void number_parts()
  {
    number_.resize(parent_.size());
    for(Index label = 0; label < Index(parent_.size()); ++label)
      number_[label] = parent_[label] == label ? Index(size_++) : number_[root(label)];
  }

  std::vector<Index> label_;           // by face
  std::vector<Index> parent_, number_; // by label
  std::size_t size_ = 0;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_PARTS_H
