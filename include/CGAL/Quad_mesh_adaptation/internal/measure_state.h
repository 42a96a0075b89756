// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_STATE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_STATE_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/Distance_measure.h>
#include <CGAL/Quad_mesh_adaptation/internal/Input_mesh.h>
#include <CGAL/Quad_mesh_adaptation/internal/measure.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

inline std::vector<Triangle> corner_points(const Triangle_soup& soup)
{
  std::vector<Triangle> list;
  list.reserve(soup.triangles.size());
  for(const auto& t : soup.triangles)
    list.push_back({ soup.points[t[0]], soup.points[t[1]], soup.points[t[2]] });
  return list;
}

// As nodes of an input that is its own reference are, so that they lie on it to the last bit.
inline bool is_corner_of_surface(const Adaptation_state& s, const Vertex_record& r)
{
  if(r.carrier != Carrier::surface || r.hint < 0 || s.surface.is_planar() || s.surface.has_lift())
    return false;
  const Triangle t = s.surface.triangle(r.hint);
  return std::find(t.begin(), t.end(), r.p) != t.end();
}

// What is kept of faces of the input is used, and kept if it is not yet.
inline Mesh_measures measure_state(const Adaptation_state& s,
                                   const std::optional<Triangle_soup>& reference,
                                   Kept_sizes* kept = nullptr)
{
  std::vector<Vec> points(s.mesh.vertex_end(), Vec(0, 0, 0));
  std::vector<Quad> quads;
  quads.reserve(s.mesh.number_of_faces());
  if(kept) kept->look_at(s.mesh);
  double far = 0;
  for(Index v = 0; v < s.mesh.vertex_end(); ++v) {
    if(!s.mesh.is_vertex(v)) continue;
    Vertex_record r = s.mesh.vertex(v);
    points[v] = r.p;
    if(is_corner_of_surface(s, r)) continue;
    s.put_on_carrier(r);
    far = (std::max)(far, distance(points[v], r.p));
  }
  for(Index f = 0; f < s.mesh.face_end(); ++f)
    if(s.mesh.is_face(f)) quads.push_back(s.mesh.quad(f));
  const Size_function size = [&s](const Vec& p) { return s.size.unscaled(p); };
  std::vector<double> strict; // they are asked for before and after this, too
  if(s.size.sampling == Size_sampling::strict) {
    strict.reserve(quads.size());
    for(Index f = 0; f < s.mesh.face_end(); ++f)
      if(s.mesh.is_face(f)) strict.push_back(s.size_ratio(f) * s.size.scale());
  }
  std::optional<std::vector<Triangle>> triangles;
  if(reference) triangles = corner_points(*reference);
  Mesh_measures m = measure(points, quads, size, triangles ? &*triangles : nullptr,
                            strict.empty() ? nullptr : &strict, kept, &s.mesh);
  triangles.reset(); // distances need the memory
  points = std::vector<Vec>();
  quads = std::vector<Quad>();
  strict = std::vector<double>();
  m.max_distance_to_reference = far;
  const Distance_measure distances(s);
  m.mesh_to_reference = distances.to_reference();
  m.reference_to_mesh = distances.from_reference();
  return m;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MEASURE_STATE_H
