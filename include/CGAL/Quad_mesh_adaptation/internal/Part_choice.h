// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PART_CHOICE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PART_CHOICE_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/Curve_bend.h>
#include <CGAL/Quad_mesh_adaptation/internal/nodes_around.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The faces about those to work on, as few as cut no fan of faces in two.
class Part_choice
{
public:
  Part_choice(const Quad_complex& m, const std::vector<Index>& work, int rings = rings_to_work_on)
      : near_(nodes_around(m, work, rings + margin))
  {
    do {
      list_faces(m);
    } while(mend_fans(m));
  }

  const std::vector<Index>& faces() const { return faces_; }
  bool has(Index f) const { return inside_[f]; }

  // Are they few enough for it to be worth while that they are taken out?
  bool is_small(const Quad_complex& m) const
  {
    return 2 * faces_.size() <= std::size_t(m.number_of_faces());
  }

  // May a whole schedule work on them, and is that worth while?  Curves that it looks at from end
  // to end must stay whole: closed ones and those with bends.
  bool is_separable(const Adaptation_state& s) const
  {
    if(!is_small(s.mesh)) return false;
    std::vector<char> is_simple;
    for(const Feature_curve& c : s.curves)
      is_simple.push_back(!c.is_closed() && (c.is_frozen() || bends_of(c).empty()));
    return std::all_of(faces_.begin(), faces_.end(), [&](Index f) {
      for(Index h = 4 * f; h < 4 * f + 4; ++h)
        if(s.mesh.curve(h) >= 0 && !is_simple[s.mesh.curve(h)]) return false;
      return true;
    });
  }

private:
  static constexpr int margin = 5; // rings: operations and moves look at three

  void list_faces(const Quad_complex& m)
  {
    faces_.clear();
    inside_.assign(m.face_end(), 0);
    for(Index f : m.faces()) {
      const Quad q = m.quad(f);
      if(!std::any_of(q.begin(), q.end(), [&](Index v) { return near_[v]; })) continue;
      inside_[f] = 1;
      faces_.push_back(f);
    }
  }

  // Where a node joins two fans of the part all its faces belong to it; is there such a node?
  bool mend_fans(const Quad_complex& m)
  {
    bool found = false;
    for(Index f : faces_)
      for(Index v : m.quad(f))
        if(!near_[v] && number_of_fans(m, v) > 1) {
          near_[v] = 1;
          found = true;
        }
    return found;
  }

  int number_of_fans(const Quad_complex& m, Index v) const
  {
    int starts = 0;
    for(Index h : m.outgoing(v)) // is there none of it clockwise?
      if(has(m.face(h)) && (m.is_border(h) || !has(m.face(m.opposite(h))))) ++starts;
    return starts;
  }

  std::vector<char> near_, inside_; // by node, by face
  std::vector<Index> faces_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PART_CHOICE_H
