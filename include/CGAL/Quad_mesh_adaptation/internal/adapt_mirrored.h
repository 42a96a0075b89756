// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ADAPT_MIRRORED_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ADAPT_MIRRORED_H

#include <CGAL/Quad_mesh_adaptation/internal/Mirror_part.h>
#include <CGAL/Quad_mesh_adaptation/internal/Mirror_unfolding.h>
#include <CGAL/Quad_mesh_adaptation/internal/faults.h>
#include <CGAL/Quad_mesh_adaptation/internal/mirror_planes.h>

#include <algorithm>
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
  part.copies = images;
  part.workers = whole.workers;
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
    if(cut.plane[c] >= 0) {
      part.curves[c].images = 2;
      part.curves[c].is_cut = !cut.is_feature[c];
    }
  for(Index v = 0; v < Index(in.points.size()); ++v) {
    Vertex_record& r = part.mesh.vertex(v);
    r.frozen = whole.mesh.vertex(v).frozen; // a corner now, which is enough to hold it
    for(const Mirror_plane& p : planes)
      if(p.has_vertex(v)) r.images = std::int16_t(2 * r.images);
  }
}

// An adapted mesh, to be compared with others.
struct Adapted_mesh
{
  Adaptation_state state;
  std::size_t faults = 0; // faces too large, but for those held by edges that must not change, and
                          // crowded nodes
};

inline Adapted_mesh judged(Adaptation_state&& s, double limit)
{
  Adapted_mesh a{ std::move(s), 0 };
  for(Index f = 0; f < a.state.mesh.face_end(); ++f)
    if(a.state.mesh.is_face(f) && a.state.size_ratio(f) * a.state.size.scale() > limit &&
       !is_beyond_help(a.state, f))
      ++a.faults;
  for(Index v = 0; v < a.state.mesh.vertex_end(); ++v)
    if(a.state.mesh.is_vertex(v) && is_crowded(a.state, v)) ++a.faults;
  return a;
}

// Adapts one part and completes the whole by its images.  -1 after success, else the plane to blame
// if they do not make a valid mesh of the same sizes.
template <typename Build, typename Algorithm>
int adapt_part(const Input_mesh& in, const std::vector<Mirror_plane>& planes, double limit,
               const Build& build, const Algorithm& algorithm, const Adaptation_state& whole,
               std::vector<Adapted_mesh>& done)
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
  Adaptation_state s = whole;
  s.mesh = std::move(unfold.mesh());
  s.curves = std::move(unfold.curves());
  s.given_patch = std::move(part.given_patch);
  s.reference_patch.assign(s.given_patch.size(), -1);
  s.iterations += part.iterations;
  for(const auto& o : part.operations) s.count(o.first, images * o.second);
  s.forget_faces();
  s.disturb_all();
  done.push_back(judged(std::move(s), limit));
  return -1;
}

// Of several meshes the first without more faults than the best and without many more faces. Beside
// edges that must not change a few faces stay too large, more or fewer by chance.
inline const Adapted_mesh& choose(const std::vector<Adapted_mesh>& done)
{
  const std::vector<Feature_curve>& curves = done.front().state.curves;
  const bool held = std::any_of(curves.begin(), curves.end(),
                                [](const Feature_curve& c) { return c.is_frozen(); });
  constexpr double tolerated = 1.06;
  const auto better = [](const Adapted_mesh& a, const Adapted_mesh& b) {
    return std::make_pair(a.faults, a.state.mesh.number_of_faces()) <
           std::make_pair(b.faults, b.state.mesh.number_of_faces());
  };
  const Adapted_mesh& best = *std::min_element(done.begin(), done.end(), better);
  return *std::find_if(done.begin(), done.end(), [&](const Adapted_mesh& a) {
    const std::size_t spare = held ? std::size_t(a.state.mesh.number_of_faces()) / 300 : 0;
    return a.faults <= best.faults + spare &&
           a.state.mesh.number_of_faces() <= tolerated * best.state.mesh.number_of_faces();
  });
}

// Runs `algorithm` on a part of a symmetric input only and mirrors what comes out, so that the
// result is as symmetric as the input.  A part of few faces may have to round up whole rows of
// them: then fewer planes and none are tried as well, and the symmetry is kept as long as it does
// not cost too many faces.  `whole` is the state of the input, not adapted yet;
// `build(part_of_input, state)` builds that of a part; `limit` is the largest size ratio allowed;
// `ideal_faces` what the sizes ask for.  False, with the state as it was, if there is no plane to
// mirror in.
template <typename Build, typename Algorithm>
bool adapt_mirrored(const Input_mesh& in, double limit, double ideal_faces, const Build& build,
                    const Algorithm& algorithm, Adaptation_state& whole)
{
  constexpr double many_faces = 250;
  std::vector<Mirror_plane> planes = mirror_planes(in, whole);
  std::vector<Adapted_mesh> done;
  while(!planes.empty()) {
    const int blamed = adapt_part(in, planes, limit, build, algorithm, whole, done);
    if(blamed >= 0) {
      planes.erase(planes.begin() + blamed);
      continue;
    }
    const bool few = std::ldexp(many_faces, int(planes.size())) > ideal_faces;
    if(!few && done.back().faults == 0) break;
    planes.pop_back();
  }
  if(done.empty()) return false;
  if(planes.empty()) {
    Adaptation_state s = whole;
    algorithm(s);
    done.push_back(judged(std::move(s), limit));
  }
  whole = choose(done).state;
  return true;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ADAPT_MIRRORED_H
