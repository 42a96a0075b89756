// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FAULTS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FAULTS_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Largest size ratio that counts as "not larger".
constexpr double size_tolerance = 1 + 1e-9;

constexpr double far_too_small = 0.5; // a size ratio

inline std::vector<Index> faces_too_large(const Adaptation_state& s, double limit = size_tolerance)
{
  std::vector<Index> list;
  for(Index f : s.mesh.faces())
    if(s.size_ratio(f) > limit) list.push_back(f);
  return list;
}

inline double worst_quality(const Adaptation_state& s)
{
  double worst = 1;
  for(Index f : s.mesh.faces())
    worst = (std::min)(worst, s.face_quality(s.corners(f), s.reference_normal(f)));
  return worst;
}

inline double least_scaled_jacobian(const Adaptation_state& s)
{
  double least = 1;
  for(Index f : s.mesh.faces()) least = (std::min)(least, scaled_jacobian(s.corners(f)));
  return least;
}

// Is a face held too large by an edge that must not change?
inline bool is_beyond_help(const Adaptation_state& s, Index f)
{
  for(Index h = 4 * f; h < 4 * f + 4; ++h) {
    const Vertex_record &a = s.mesh.vertex(s.mesh.origin(h)), &b = s.mesh.vertex(s.mesh.target(h));
    const Index c = s.mesh.curve(h);
    // nodes held at bends of a curve do not hold its edges
    const bool both = a.frozen && b.frozen && !is_held_at_bend(a) && !is_held_at_bend(b);
    if(!(c >= 0 && s.curves[c].is_frozen()) && !both) continue;
    if(distance(a.p, b.p) > 1.2 * s.size.at_face(s.corners(f))) return true;
  }
  return false;
}

// Has v more faces than a smooth place should have, all images of a mirror plane counted?
inline bool is_crowded(const Adaptation_state& s, Index v)
{
  const Vertex_record& r = s.mesh.vertex(v);
  const int images = s.images_at(r);
  return images * r.faces > 5 && (r.carrier == Carrier::surface || images > 1) && !r.frozen;
}

// By how many faces does a node inside the whole, on a curve or not, exceed five and what its angle
// asks for?
inline int faces_too_many(const Adaptation_state& s, Index v)
{
  constexpr int allowed = 5;
  const Vertex_record& r = s.mesh.vertex(v);
  const int images = s.images_at(r), faces = images * r.faces;
  if(faces <= allowed || r.frozen || (images == 1 && s.mesh.is_border_vertex(v))) return 0;
  return faces - (std::min)(faces, (std::max)(allowed, images * int(r.ideal_faces)));
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FAULTS_H
