// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SHAPE_MENDING_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SHAPE_MENDING_H

#include <CGAL/Quad_mesh_adaptation/internal/Mesh_keeper.h>
#include <CGAL/Quad_mesh_adaptation/internal/Places_in_vain.h>
#include <CGAL/Quad_mesh_adaptation/internal/nodes_around.h>
#include <CGAL/Quad_mesh_adaptation/internal/poor_shapes.h>
#include <CGAL/Quad_mesh_adaptation/internal/size_guarantee.h>
#include <CGAL/Quad_mesh_adaptation/internal/total_energy.h>

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
  std::vector<Index> list;
  for(Index f : m.faces()) {
    if(!s.is_face_to_work_on(f)) continue;
    const Quad q = m.quad(f);
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
  for(Index f : m.faces()) faults += shape_fault(s, f);
  for(Index v : m.vertices())
    if(is_crowded(s, v)) faults += s.images_at(m.vertex(v)) * m.vertex(v).faces - 5;
  return faults;
}

// What a mesh is judged by where shapes are mended at the price of faces: a face a tenth below the
// floor may cost two irregular nodes and two faces.
inline double energy_and_faults(Adaptation_state& s, double more_faults = 0)
{
  constexpr double price = 80;
  return total_energy(s) + price * (shape_faults(s) + more_faults);
}

// Splits for more freedom about poor faces, all at once.  Where features stand close they lead to
// ever more faces that are as poor, so each time all goes back unless they have paid for their
// faces.
class Mending_splits
{
public:
  // `usual`: the weights of the energy that meshes are judged by.  `about`: only faces with such a
  // node are split, all if there are none.
  Mending_splits(Adaptation_state& s, const Energy_weights& usual, const std::vector<char>& about)
      : s_(s), usual_(usual), about_(about)
  {
  }

  // false: the mesh is as it was.
  bool operator()()
  {
    const bool was_split = take_back_unless_better();
    if(in_vain_) return was_split;
    const std::vector<Index> faces = faces_worth_more();
    if(faces.empty() || are_too_many(faces)) return was_split;
    before_.emplace(s_);
    judged_ = judge();
    split_too_large(s_, faces);
    return true;
  }

  // Returns whether there was anything to take back.
  bool take_back_unless_better()
  {
    if(!before_) return false;
    in_vain_ = judge() >= judged_;
    if(in_vain_) before_->restore();
    before_.reset();
    return true;
  }

private:
  // Those that neither features nor edges that must not change keep as they are.
  std::vector<Index> faces_worth_more() const
  {
    constexpr double worth_it = 0.55; // quality
    std::vector<Index> faces = faces_to_mend(s_, worth_it);
    leave_only_about(s_, about_, faces);
    const auto stays = [&](Index f) {
      return is_beyond_help(s_, f) || (known_quality(s_, f) < worth_it &&
                                       shape_limit(s_, f, worth_it).limit != Shape_limit::none);
    };
    faces.erase(std::remove_if(faces.begin(), faces.end(), stays), faces.end());
    return faces;
  }

  // Where most of a mesh is poor, more faces are as poor.
  bool are_too_many(const std::vector<Index>& faces) const
  {
    constexpr std::size_t few = 200, share = 3;
    return faces.size() > few && share * faces.size() > std::size_t(s_.mesh.number_of_faces());
  }

  double judge()
  {
    const Energy_weights mending = s_.energy;
    s_.energy = usual_;
    s_.forget_energies();
    const double sum = energy_and_faults(s_);
    s_.energy = mending;
    s_.forget_energies();
    return sum;
  }

  Adaptation_state& s_;
  const Energy_weights usual_;
  const std::vector<char>& about_;
  std::optional<Mesh_keeper> before_; // the last splits
  double judged_ = 0;                 // then
  bool in_vain_ = false;
};

// Rounds of mending end where most of what is poor stays as it is: over a cycle of them, what is
// wrong with many faces has hardly become less.
class Mending_progress
{
public:
  // After each round, with the faces that were poor before it.
  bool is_stuck(const Adaptation_state& s, std::size_t poor)
  {
    constexpr std::size_t cycle = 3, many = 100;
    constexpr double hardly = 0.99;
    faults_.push_back(shape_faults(s));
    return poor > many && faults_.size() > cycle &&
           faults_.back() > hardly * faults_[faults_.size() - 1 - cycle];
  }

  // What was wrong before can not be compared.
  void begin_again() { faults_.clear(); }

private:
  std::vector<double> faults_;
};

// The faces below the floor get what the energy of the whole mesh did not grant them: about them
// shape weighs more from round to round, faces may be added, and no operation or move leaves a face
// above its size that was not.  Those that `in_vain` remembers are left alone, and those left are
// remembered by it.
inline void mend_shapes(Adaptation_state& s, const Improvement_options& o, int max_rounds,
                        Places_in_vain& in_vain)
{
  const std::vector<char> about = in_vain.changed_nodes(s);
  const auto poor = [&] {
    std::vector<Index> list = faces_to_mend(s, shape_floor);
    leave_only_about(s, about, list);
    return list;
  };
  if(poor().empty()) return;
  Phase_scope phase(s, "clean-up");
  const Smoothing_weights gentle = s.smoothing;
  const Energy_weights energy = s.energy;
  Improvement_options mending = o;
  mending.keep_within_size = true;
  mending.corner = true;
  mending.valence_gain = -1e9; // swaps for the sake of shapes, too
  s.smoothing.keep_within_size = true;
  Mending_splits split(s, energy, about);
  Mending_progress progress;
  Touched_nodes touched(s);
  for(int round = 0; round < max_rounds; ++round) {
    const std::vector<Index> bad = poor();
    if(bad.empty()) break;
    s.check_cancelled();
    touched.add(bad);
    s.energy.shape = (std::min)(2 * s.energy.shape, 16 * energy.shape);
    s.energy.valence = (std::min)(2 * s.energy.valence, 4 * energy.valence);
    s.smoothing.size *= 0.5;
    s.forget_energies();
    if(round % 4 == 3 && round + 1 < max_rounds && split()) progress.begin_again();
    smooth_near(s, poor());
    mending.tolerance = round % 3 == 1 ? 1.5 : 0; // to get past what keeps it bad
    s.stirred = nodes_around(s.mesh, poor(), 2);
    const std::size_t done = Local_improvement(s, mending).passes(3);
    smooth_near(s, poor());
    if((done == 0 && round > 3) || progress.is_stuck(s, bad.size())) break;
  }
  split.take_back_unless_better();
  s.smoothing = gentle;
  s.energy = energy;
  s.forget_energies();
  settle(s, o, 2, touched);
  in_vain.remember(s, faces_to_mend(s, shape_floor));
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SHAPE_MENDING_H
