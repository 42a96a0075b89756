// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ADAPT_MIRRORED_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ADAPT_MIRRORED_H

#include <CGAL/Quad_mesh_adaptation/internal/Mirror_part.h>
#include <CGAL/Quad_mesh_adaptation/internal/Mirror_unfolding.h>
#include <CGAL/Quad_mesh_adaptation/internal/mirror_planes.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The observers of the whole are told of the whole: what happens to a part happens to all images.
inline void observe_part(const Adaptation_state& whole, std::size_t images, Adaptation_state& part)
{
  part.size = whole.size;
  part.energy = whole.energy;
  part.smoothing = whole.smoothing;
  part.report_progress = whole.report_progress;
  part.start_phase = whole.start_phase;
  part.end_phase = [told = whole.end_phase, images](const char* name, std::size_t faces) {
    told(name, images * faces);
  };
}

// What the part has to know of its images: how many of them meet at its nodes.
inline void set_images(const Mirror_part::Cut& cut, const Input_mesh& in,
                       const std::vector<Mirror_plane>& planes, const Adaptation_state& whole,
                       Adaptation_state& part)
{
  for(std::size_t c = 0; c < part.curves.size(); ++c)
    if(cut.plane[c] >= 0) part.curves[c].images = 2;
  for(Index v = 0; v < Index(in.points.size()); ++v) {
    Vertex_record& r = part.mesh.vertex(v);
    r.frozen = whole.mesh.vertex(v).frozen; // a corner now, which is enough to hold it
    for(const Mirror_plane& p : planes)
      if(p.has_vertex(v)) r.images = std::int16_t(2 * r.images);
  }
}

// Adapts one part and completes the whole by its images.  Returns the plane to blame where they do
// not make a valid mesh of the same sizes, and leaves the state alone; -1 after success.
template <typename Build, typename Algorithm>
int adapt_part(const Input_mesh& in, const std::vector<Mirror_plane>& planes, double limit,
               const Build& build, const Algorithm& algorithm, Adaptation_state& whole)
{
  const int last = int(planes.size()) - 1;
  const std::size_t images = std::size_t(1) << planes.size();
  const Mirror_part origin(in, whole, planes);
  Adaptation_state part;
  observe_part(whole, images, part);
  try {
    build(origin.in, part);
  } catch(const Refused&) {
    return last;
  }
  Mirror_part::Cut cut = origin.cut_of(part, whole, planes);
  if(!cut.is_known) return last;
  set_images(cut, in, planes, whole, part);
  algorithm(part);
  Mirror_unfolding unfold(in, whole, part, origin, std::move(cut), planes);
  const int blamed = unfold(limit);
  if(blamed >= 0) return blamed;
  whole.mesh = std::move(unfold.mesh());
  whole.curves = std::move(unfold.curves());
  whole.given_patch = std::move(part.given_patch);
  whole.reference_patch.assign(whole.given_patch.size(), -1);
  whole.iterations += part.iterations;
  for(const auto& o : part.operations) whole.count(o.first, images * o.second);
  whole.forget_faces();
  whole.disturb_all();
  return -1;
}

// Runs `algorithm` on a part of a symmetric input only and mirrors what comes out, so that the
// result is as symmetric as the input.  `whole` is the state of the input, not adapted yet;
// `build(part_of_input, state)` builds that of a part; `limit` is the largest size ratio allowed;
// `ideal_faces` what the sizes ask for.  False, with the state as it was, if there is no plane to
// mirror in.
template <typename Build, typename Algorithm>
bool adapt_mirrored(const Input_mesh& in, double limit, double ideal_faces, const Build& build,
                    const Algorithm& algorithm, Adaptation_state& whole)
{
  // each plane costs up to a row of faces along it: no part is to have fewer faces than this
  constexpr double fewest_faces = 4;
  std::vector<Mirror_plane> planes = mirror_planes(in, whole);
  while(!planes.empty() && std::ldexp(fewest_faces, int(planes.size())) > ideal_faces)
    planes.pop_back();
  while(!planes.empty()) {
    const int blamed = adapt_part(in, planes, limit, build, algorithm, whole);
    if(blamed < 0) return true;
    planes.erase(planes.begin() + blamed);
  }
  return false;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ADAPT_MIRRORED_H
