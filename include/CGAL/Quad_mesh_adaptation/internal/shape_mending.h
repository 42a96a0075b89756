// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SHAPE_MENDING_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SHAPE_MENDING_H

#include <CGAL/Quad_mesh_adaptation/internal/Mesh_keeper.h>
#include <CGAL/Quad_mesh_adaptation/internal/nodes_around.h>
#include <CGAL/Quad_mesh_adaptation/internal/size_guarantee.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

inline double known_quality(const Adaptation_state& s, Index f)
{
  if(!s.qualities.is_known(f))
    s.qualities.set(f, float(s.face_quality(s.corners(f), s.reference_normal(f))),
                    s.mesh.face_end());
  return s.qualities[f];
}

// Faces below `least`, and those about crowded nodes, where the mesh is worked on.
inline std::vector<Index> faces_to_mend(const Adaptation_state& s, double least)
{
  const Quad_complex& m = s.mesh;
  const auto crowded = [&](Index v) { return is_crowded(s, v); };
  const auto worked_on = [&](Index v) { return s.is_to_work_on(v); };
  std::vector<Index> list;
  for(Index f = 0; f < m.face_end(); ++f) {
    if(!m.is_face(f)) continue;
    const Quad q = m.quad(f);
    if(!std::all_of(q.begin(), q.end(), worked_on)) continue;
    if(known_quality(s, f) < least || std::any_of(q.begin(), q.end(), crowded)) list.push_back(f);
  }
  return list;
}

constexpr double shape_floor = 0.58; // of the quality of faces

// What a face lacks of the floor; a face that is nearly or wholly useless counts as several poor
// ones.
inline double shape_fault(const Adaptation_state& s, Index f)
{
  constexpr double useless = 0.15, times = 10;
  const double quality = known_quality(s, f);
  return (std::max)(shape_floor - quality, 0.) + times * (std::max)(useless - quality, 0.);
}

// How much is wrong: what faces lack of the floor, and faces too many at nodes.
inline double shape_faults(const Adaptation_state& s)
{
  const Quad_complex& m = s.mesh;
  double faults = 0;
  for(Index f = 0; f < m.face_end(); ++f)
    if(m.is_face(f)) faults += shape_fault(s, f);
  for(Index v = 0; v < m.vertex_end(); ++v)
    if(m.is_vertex(v) && is_crowded(s, v))
      faults += s.images_at(m.vertex(v)) * m.vertex(v).faces - 5;
  return faults;
}

// Splits for more freedom may leave more wrong than there was; then they are taken back.
class Mending_splits
{
public:
  explicit Mending_splits(Adaptation_state& s) : s_(s) {}

  void operator()()
  {
    if(!before_) {
      before_.emplace(s_);
      faults_ = shape_faults(s_);
    }
    std::vector<Index> faces = faces_to_mend(s_, worth_more_faces);
    const auto beyond_help = [this](Index f) { return is_beyond_help(s_, f); };
    faces.erase(std::remove_if(faces.begin(), faces.end(), beyond_help), faces.end());
    split_too_large(s_, faces);
  }

  void take_back_unless_better()
  {
    if(before_ && shape_faults(s_) >= faults_) before_->restore();
  }

private:
  static constexpr double worth_more_faces = 0.55; // quality below which faces are

  Adaptation_state& s_;
  std::optional<Mesh_keeper> before_; // the first
  double faults_ = 0;
};

// The faces below the floor get what the energy of the whole mesh did not grant them: about them
// shape weighs more from round to round, faces may be added, and no operation or move leaves a face
// above its size that was not.
inline void mend_shapes(Adaptation_state& s, const Improvement_options& o, int max_rounds)
{
  if(faces_to_mend(s, shape_floor).empty()) return;
  Phase_scope phase(s, "clean-up");
  const Smoothing_weights gentle = s.smoothing;
  const Energy_weights energy = s.energy;
  Improvement_options mending = o;
  mending.keep_within_size = true;
  mending.corner = true;
  mending.valence_gain = -1e9; // swaps for the sake of shapes, too
  s.smoothing.keep_within_size = true;
  Mending_splits split(s);
  Touched_nodes touched(s);
  for(int round = 0; round < max_rounds; ++round) {
    const std::vector<Index> bad = faces_to_mend(s, shape_floor);
    if(bad.empty()) break;
    s.check_cancelled();
    touched.add(bad);
    s.energy.shape = (std::min)(2 * s.energy.shape, 16 * energy.shape);
    s.energy.valence = (std::min)(2 * s.energy.valence, 4 * energy.valence);
    s.smoothing.size *= 0.5;
    s.forget_energies();
    if(round % 4 == 3) split();
    smooth_near(s, faces_to_mend(s, shape_floor));
    mending.tolerance = round % 3 == 1 ? 1.5 : 0; // to get past what keeps it bad
    s.stirred = nodes_around(s.mesh, faces_to_mend(s, shape_floor), 2);
    const std::size_t done = Local_improvement(s, mending).passes(3);
    smooth_near(s, faces_to_mend(s, shape_floor));
    if(done == 0 && round > 3) break;
  }
  s.smoothing = gentle;
  s.energy = energy;
  s.forget_energies();
  settle(s, o, 2, touched);
  split.take_back_unless_better();
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SHAPE_MENDING_H
