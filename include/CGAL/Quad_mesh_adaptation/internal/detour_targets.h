// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DETOUR_TARGETS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DETOUR_TARGETS_H

#include <CGAL/Quad_mesh_adaptation/Poor_face.h>
#include <CGAL/Quad_mesh_adaptation/internal/faults.h>
#include <CGAL/Quad_mesh_adaptation/internal/poor_shapes.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Faces about which detours have been tried, by their numbers then.
class Tried_faces
{
public:
  void add(const Adaptation_state& s, Index f)
  {
    tried_.resize(s.mesh.face_end(), 0);
    tried_[f] = 1;
  }

  bool contains(Index f) const { return f < Index(tried_.size()) && tried_[f]; }

private:
  std::vector<char> tried_;
};

// What detours are for: the face that is worst and has not been tried yet, and whether there still
// is anything to be done about a face.
struct Detour_target
{
  Index (*worst)(const Adaptation_state& s, const Tried_faces& tried); // -1: none
  bool (*is_left)(const Adaptation_state& s, Index f);
};

// The face of the least value below `bound`, of those that `is_meant` accepts; -1: none.
template <typename Value, typename Meant>
Index least_face(const Adaptation_state& s, const Tried_faces& tried, double bound,
                 const Value& value, const Meant& is_meant)
{
  Index least = -1;
  for(Index f : s.mesh.faces()) {
    if(tried.contains(f)) continue;
    const double x = value(f);
    if(x >= bound || !s.is_face_to_work_on(f) || !is_meant(f)) continue;
    bound = x;
    least = f;
  }
  return least;
}

// Below the floor of shapes that is promised.
inline Index worst_unexcused(const Adaptation_state& s, const Tried_faces& tried)
{
  return least_face(
      s, tried, Poor_face::floor, [&](Index f) { return scaled_jacobian(s.corners(f)); },
      [&](Index f) { return is_poorer_than_need_be(s, f); });
}

// About a node with too many faces, of which none has been tried.
inline Index worst_about_crowds(const Adaptation_state& s, const Tried_faces& tried)
{
  Index worst = -1;
  double least = 2;
  std::vector<Index> out;
  for(Index v : s.mesh.vertices()) {
    if(faces_too_many(s, v) == 0) continue;
    s.mesh.outgoing(v, out);
    const auto is_tried = [&](Index h) { return tried.contains(s.mesh.face(h)); };
    if(std::any_of(out.begin(), out.end(), is_tried)) continue;
    for(Index h : out) {
      const Index f = s.mesh.face(h);
      const double jacobian = scaled_jacobian(s.corners(f));
      if(jacobian >= least || !s.is_face_to_work_on(f)) continue;
      least = jacobian;
      worst = f;
    }
  }
  return worst;
}

inline Detour_target unexcused_faces() { return { worst_unexcused, is_poorer_than_need_be }; }

// The same, and faces about crowded nodes after them.
inline Detour_target unexcused_and_crowded_faces()
{
  const auto worst = [](const Adaptation_state& s, const Tried_faces& tried) {
    const Index f = worst_unexcused(s, tried);
    return f >= 0 ? f : worst_about_crowds(s, tried);
  };
  const auto is_left = [](const Adaptation_state& s, Index f) {
    const Quad q = s.mesh.quad(f);
    return is_poorer_than_need_be(s, f) ||
           std::any_of(q.begin(), q.end(), [&](Index v) { return faces_too_many(s, v) > 0; });
  };
  return { worst, is_left };
}

inline Detour_target far_too_small_faces()
{
  const auto worst = [](const Adaptation_state& s, const Tried_faces& tried) {
    return least_face(
        s, tried, far_too_small, [&](Index f) { return s.size_ratio(f); },
        [](Index) { return true; });
  };
  const auto is_left = [](const Adaptation_state& s, Index f) {
    return s.size_ratio(f) < far_too_small;
  };
  return { worst, is_left };
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DETOUR_TARGETS_H
