// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ADAPT_MIRRORED_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ADAPT_MIRRORED_H

#include <CGAL/Quad_mesh_adaptation/internal/Mirror_goal.h>
#include <CGAL/Quad_mesh_adaptation/internal/Mirror_part.h>
#include <CGAL/Quad_mesh_adaptation/internal/Mirror_unfolding.h>
#include <CGAL/Quad_mesh_adaptation/internal/faults.h>
#include <CGAL/Quad_mesh_adaptation/internal/mirror_planes.h>
#include <CGAL/Quad_mesh_adaptation/internal/poor_shapes.h>

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

// What adaptation changes of a state, to be compared with other outcomes.
struct Outcome
{
  Quad_complex mesh;
  std::vector<Feature_curve> curves;
  std::vector<Index> given_patch, reference_patch;
  std::vector<std::pair<const char*, std::size_t>> operations;
  std::size_t iterations = 0;
  std::size_t faults = 0; // faces too large, but for those held by edges that must not change,
                          // crowded nodes, and faces of poor shape for no good reason

  // Takes the place of what the state has, which is here then.
  void exchange(Adaptation_state& s)
  {
    std::swap(mesh, s.mesh);
    std::swap(curves, s.curves);
    std::swap(given_patch, s.given_patch);
    std::swap(reference_patch, s.reference_patch);
    std::swap(operations, s.operations);
    std::swap(iterations, s.iterations);
    s.forget_faces();
    s.disturb_all();
  }
};

inline std::size_t count_faults(const Adaptation_state& s, double limit)
{
  std::size_t faults = 0;
  for(Index f : s.mesh.faces())
    if(s.size_ratio(f) * s.size.scale() > limit && !is_beyond_help(s, f)) ++faults;
  // in a large mesh a few of these are not worth another solution
  constexpr Index many = 20000;
  if(s.mesh.number_of_faces() > many) return faults;
  for(Index v : s.mesh.vertices())
    if(faces_too_many(s, v) > 0) ++faults;
  for(const Poor_face& p : poor_shapes(s, Poor_face::floor))
    if(p.limit == Shape_limit::none) ++faults;
  return faults;
}

// Adds an outcome to those that are done.
inline void keep(Outcome&& o, const Mirror_goal& goal, Adaptation_state& whole,
                 std::vector<Outcome>& done)
{
  o.exchange(whole);
  const std::size_t faults = goal.counts_faults ? count_faults(whole, goal.limit) : 0;
  o.exchange(whole);
  done.push_back(std::move(o));
  done.back().faults = faults;
}

// The same algorithm on all of the input.
template <typename Algorithm>
void adapt_whole(const Mirror_goal& goal, const Algorithm& algorithm, Adaptation_state& whole,
                 std::vector<Outcome>& done)
{
  Outcome o{ whole.mesh,
             whole.curves,
             whole.given_patch,
             whole.reference_patch,
             whole.operations,
             whole.iterations,
             0 };
  o.exchange(whole);
  algorithm(whole);
  o.exchange(whole);
  keep(std::move(o), goal, whole, done);
}

// Adapts one part and completes the whole by its images.  -1 after success, else the plane to blame
// if they do not make a valid mesh of the same sizes.
template <typename Build, typename Algorithm>
int adapt_part(const Input_mesh& in, const std::vector<Mirror_plane>& planes,
               const Mirror_goal& goal, const Build& build, const Algorithm& algorithm,
               Adaptation_state& whole, std::vector<Outcome>& done)
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
  Outcome o;
  o.given_patch = std::move(part.given_patch);
  o.reference_patch.assign(o.given_patch.size(), -1);
  o.iterations = whole.iterations + part.iterations;
  o.operations = whole.operations;
  for(const auto& n : part.operations) o.operations.emplace_back(n.first, images * n.second);
  part = Adaptation_state(); // its memory is needed elsewhere
  const int blamed = unfold(goal.limit);
  if(blamed >= 0) return blamed;
  o.mesh = std::move(unfold.mesh());
  o.curves = std::move(unfold.curves());
  keep(std::move(o), goal, whole, done);
  return -1;
}

// Of several outcomes the first without more faults than the best and without many more faces.
// Beside edges that must not change a few faces stay too large, more or fewer by chance.
inline Outcome& choose(std::vector<Outcome>& done)
{
  const std::vector<Feature_curve>& curves = done.front().curves;
  const bool held = std::any_of(curves.begin(), curves.end(),
                                [](const Feature_curve& c) { return c.is_frozen(); });
  constexpr double tolerated = 1.06;
  const auto better = [](const Outcome& a, const Outcome& b) {
    return std::make_pair(a.faults, a.mesh.number_of_faces()) <
           std::make_pair(b.faults, b.mesh.number_of_faces());
  };
  const Outcome& best = *std::min_element(done.begin(), done.end(), better);
  return *std::find_if(done.begin(), done.end(), [&](const Outcome& a) {
    const std::size_t spare = held ? std::size_t(a.mesh.number_of_faces()) / 100 : 0;
    return a.faults <= best.faults + spare &&
           a.mesh.number_of_faces() <= tolerated * best.mesh.number_of_faces();
  });
}

// Runs `algorithm` on a part of a symmetric input only and mirrors what comes out, so that the
// result is as symmetric as the input.  A part of few faces may have to round up whole rows of
// them: then fewer planes and none are tried as well, and the symmetry is kept as long as it does
// not cost too many faces.  `whole` is the state of the input, not adapted yet;
// `build(part_of_input, state)` builds that of a part.  False, with the state as it was, if there
// is no plane to mirror in.
template <typename Build, typename Algorithm>
bool adapt_mirrored(const Input_mesh& in, const Mirror_goal& goal, const Build& build,
                    const Algorithm& algorithm, Adaptation_state& whole)
{
  constexpr double many_faces = 250;
  std::vector<Mirror_plane> planes = mirror_planes(in, whole);
  std::vector<Outcome> done;
  while(!planes.empty()) {
    const int blamed = adapt_part(in, planes, goal, build, algorithm, whole, done);
    if(blamed >= 0) {
      planes.erase(planes.begin() + blamed);
      continue;
    }
    const bool few = std::ldexp(many_faces, int(planes.size())) > goal.ideal_faces;
    if(!few && done.back().faults == 0) break;
    planes.pop_back();
  }
  if(done.empty()) return false;
  if(planes.empty()) adapt_whole(goal, algorithm, whole, done);
  choose(done).exchange(whole);
  return true;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ADAPT_MIRRORED_H
