// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_REFINEMENT_PROGRESS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_REFINEMENT_PROGRESS_H

#include <CGAL/Quad_mesh_adaptation/internal/Mesh_keeper.h>
#include <CGAL/Quad_mesh_adaptation/internal/size_guarantee.h>

#include <optional>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Faces that are lacking about those too large, as many as these ask for by their area: halving
// edges lowers that however large they are.
inline double faces_lacking(const Adaptation_state& s)
{
  double sum = 0;
  for(Index f : faces_to_press(s)) {
    const double r = s.size_ratio(f);
    sum += r * r - 1;
  }
  return sum;
}

// Where faces lie folded over each other, each pass of refinement leaves about as much too large as
// there was, and more faces.  So after three in a row that did not pay for their faces it ends, and
// the mesh goes back to the last one that did.  A few passes are usual, and few faces left too
// large are for those who come later, so that neither of these is judged.
class Refinement_progress
{
public:
  explicit Refinement_progress(Adaptation_state& s) : s_(s) {}

  // Before each pass: were the last ones in vain?
  bool is_stuck()
  {
    constexpr int usual_passes = 4, most_in_vain = 3;
    constexpr double few = 0.01; // of the faces
    if(passes_++ < usual_passes) return false;
    const double lacking = faces_lacking(s_), faces = double(s_.mesh.number_of_faces());
    if(lacking < few * faces) {
      best_.reset();
      return false;
    }
    if(best_ && !has_paid(lacking, faces)) return ++in_vain_ == most_in_vain;
    best_.emplace(s_);
    lacking_ = lacking;
    in_vain_ = 0;
    return false;
  }

  void go_back()
  {
    if(best_) best_->restore();
  }

private:
  bool has_paid(double lacking, double faces) const
  {
    constexpr double share = 0.25, by_each_face = 0.5;
    const double gain = lacking_ - lacking, more = faces - double(best_->number_of_faces());
    return gain >= share * lacking_ || (gain > 0 && gain >= by_each_face * more);
  }

  Adaptation_state& s_;
  std::optional<Mesh_keeper> best_;
  double lacking_ = 0; // in that
  int passes_ = 0, in_vain_ = 0;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_REFINEMENT_PROGRESS_H
