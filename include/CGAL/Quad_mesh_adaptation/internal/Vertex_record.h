// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_VERTEX_RECORD_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_VERTEX_RECORD_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <cstdint>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// What a node may move on.
enum class Carrier : std::uint8_t
{
  surface,
  curve,
  corner
};

struct Vertex_record
{
  Vec p = Vec(0, 0, 0);
  Vec normal = Vec(0, 0, 0);    // of the reference surface; zero on curves of a curved surface
  double param = 0;             // arc length on its curve
  double h = 0;                 // wanted edge length here
  double floor = 0;             // under-resolved places pursue this size for the moment
  Index halfedge = -1;          // outgoing; on the border the one without opposite; -1: deleted
  Index curve = -1;             // where carrier == curve
  Index hint = -1;              // triangle of the reference surface
  Index faces = 0;              // number of incident faces
  std::int16_t ideal_faces = 4; // as the angle of the surface around it asks for
  std::int16_t images = 1;      // of a corner: how many images of its faces will meet in it
  Carrier carrier = Carrier::surface;
  bool frozen = false; // neither moved nor removed; on curves for a while, see curve_bends.h
};

// Frozen vertices of the caller are corners.
inline bool is_held_at_bend(const Vertex_record& r)
{
  return r.frozen && r.carrier == Carrier::curve;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_VERTEX_RECORD_H
