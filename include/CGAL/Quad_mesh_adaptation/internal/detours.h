// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DETOURS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DETOURS_H

#include <CGAL/Quad_mesh_adaptation/internal/Kept_shape.h>
#include <CGAL/Quad_mesh_adaptation/internal/Mesh_keeper.h>
#include <CGAL/Quad_mesh_adaptation/internal/curve_bends.h>
#include <CGAL/Quad_mesh_adaptation/internal/octaves.h>
#include <CGAL/Quad_mesh_adaptation/internal/shape_mending.h>
#include <CGAL/Quad_mesh_adaptation/internal/total_energy.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Faces beyond those of a mesh that fills its sizes well enough.
inline double surplus_faces(const Adaptation_state& s)
{
  constexpr double enough = 0.8; // efficiency
  return double(s.mesh.number_of_faces()) * (std::max)(1 - efficiency(s) / enough, 0.);
}

// What is wrong with a mesh, to be compared with another one for the same sizes.  Operations weigh
// faces against irregular nodes; where there are far too many faces each of these costs two such
// nodes more.
inline double demerits(Adaptation_state& s)
{
  constexpr double price = 10, // of a face too large, or far too small
      of_surplus = 3;
  const double small = fraction_below(s, far_too_small) * double(s.mesh.number_of_faces());
  return energy_and_faults(s) + of_surplus * surplus_faces(s) +
         price * (double(faces_too_large(s).size()) + small);
}

// The same for each face that the sizes ask for.  Meshes within their sizes and without irregular
// nodes come to 1.1 to 1.2.
inline double relative_demerits(Adaptation_state& s)
{
  return demerits(s) / (efficiency(s) * double(s.mesh.number_of_faces()));
}

constexpr double usual_demerits = 1.25; // most meshes come to less
constexpr double clearly_less = 0.98;   // worth preferring

// Halves all faces, until most are clearly smaller than asked.
inline void make_finer(Adaptation_state& s)
{
  constexpr Index many = 20000;
  Curve_bends(s).hold();
  do {
    s.scale_sizes(2);
    halve_all(s);
  } while(fraction_below(s, 0.75) < 0.5 && s.mesh.number_of_faces() < many);
}

// Other ways to the sizes, for where one leads into a dead end.
class Detours
{
public:
  // Before the first run; run(is_given) goes from any mesh to one for the sizes, from the given one
  // in less time.  `finer`: what it makes of the given one for half the sizes, if that is known.
  Detours(Adaptation_state& s, std::function<void(bool)> run, const Mesh_keeper* finer = nullptr)
      : s_(s), run_(std::move(run)), given_(s), finer_(finer), asked_(s),
        is_fine_(fraction_below(s, 0.75) > 0.5), is_frozen_(is_anything_frozen(s))
  {
  }

  // After the first run: the smaller the mesh the more ways are tried, until it cannot come out
  // much better.  By turns from a mesh that is too coarse and from one that is too fine, each time
  // with walks in another order; of 25 ways that were tried out on 900 meshes, no others differ as
  // much.  For a mesh of more faces the first of them only, with detours of its own for the mesh to
  // start from: where that was not worth halving the first time, it mostly is then.  Where it was,
  // or sizes grow too steeply for it, little is to be gained.
  void operator()(bool was_halved)
  {
    constexpr Index enough_faces = 800, many = 40000;
    constexpr int least = 2, most = 6;
    const Index faces = s_.mesh.number_of_faces();
    if(are_sizes_out_of_reach(s_)) return; // by any way
    const bool has_few = faces <= few;
    if(faces > many || (!has_few && (was_halved || !asked_.is_gentle_doubled()))) return;
    const int ways = has_few ? std::clamp(int(enough_faces / faces), least, most) : 1;
    for(int way = 0; way < ways; ++way) {
      const double wrong = relative_demerits(s_);
      if(!(wrong > usual_demerits)) return;
      const Start start = start_of_way(way, faces);
      if(is_promising(start, way, wrong)) try_way(start, way / 2, !has_few);
    }
    if(faces <= several) try_with_dear_faces(faces);
  }

private:
  static constexpr Index few = 2000, several = 150;

  enum class Start
  {
    coarser, // than asked
    finer,   // made from the given mesh
    halved,  // the given mesh, until it is finer
    given
  };

  // A mesh of several faces from one that was too fine is not halved still further first: it is
  // coarsened in two steps.
  Start start_of_way(int way, Index faces) const
  {
    if(way % 2 == 0) return Start::coarser;
    if(faces > several && is_fine_) return Start::finer;
    return is_frozen_ ? Start::given : Start::halved;
  }

  // Coarsening in two steps takes most of the time, and of 24 such ways none was better where less
  // was wrong.  From the given mesh the first run has gone.
  bool is_promising(Start start, int way, double wrong) const
  {
    constexpr double far_off = 4;
    if(start == Start::finer)
      return wrong > far_off || given_.number_of_faces() <= s_.mesh.number_of_faces();
    return start != Start::given || way > 1;
  }

  // Where there are too many faces all the same: operations take irregular nodes into account then
  // to have fewer.
  void try_with_dear_faces(Index faces)
  {
    constexpr double dear = 3;
    for(const int way : { 1, 0 })
      if(surplus_faces(s_) > 0) try_way(start_of_way(way, faces), 0, false, dear);
  }

  // The better of both stays; a face costs `dear` times as much on the way.
  void try_way(Start start, int order, bool with_detours, double dear = 1)
  {
    const double least = clearly_less * demerits(s_);
    if(!kept_) kept_.emplace(s_);
    best_.emplace(s_);
    Mesh_keeper(given_).restore();
    s_.order = order;
    if(start == Start::coarser) start_coarser(with_detours);
    if(start == Start::finer) start_finer();
    if(start == Start::halved) make_finer(s_);
    const double face = s_.energy.face;
    s_.energy.face *= dear;
    s_.forget_energies();
    run_(false);
    s_.energy.face = face;
    s_.forget_energies();
    s_.order = 0;
    // a coarser start leaves nodes beside the bends of curves; they do not always find back
    if(demerits(s_) >= least || misses_sizes() || !kept_->accepts(s_)) best_->restore();
  }

  // From a mesh for twice the sizes: it has too few faces, and none where they do no good.  The
  // best so far is nearer to that than a fine input; others than the first begin from the input
  // nevertheless, to differ more.
  void start_coarser(bool with_detours)
  {
    const bool from_best =
        !with_detours && s_.order == 0 && best_->number_of_faces() < given_.number_of_faces();
    if(from_best) Mesh_keeper(*best_).restore();
    s_.scale_sizes(2);
    std::optional<Detours> detours;
    if(with_detours) detours.emplace(s_, run_, &*best_);
    run_(!from_best);
    if(detours && s_.mesh.number_of_faces() <= few) (*detours)(false);
    s_.scale_sizes(0.5);
  }

  // From a mesh for half the sizes: a good one to coarsen, where the given one is not.
  void start_finer()
  {
    s_.scale_sizes(0.5);
    if(finer_ && s_.order == 0)
      Mesh_keeper(*finer_).restore();
    else
      run_(true);
    s_.scale_sizes(2);
  }

  // Faces that are too large to see a place of small sizes between their samples are no better for
  // being few.
  bool misses_sizes() const
  {
    constexpr double least = 0.7; // surfaces lose some area where faces are large
    return double(s_.mesh.number_of_faces()) < least * asked_.faces;
  }

  Adaptation_state& s_;
  std::function<void(bool)> run_;
  const Mesh_keeper given_, *finer_;
  const Demand asked_;
  const bool is_fine_, is_frozen_; // the given mesh
  std::optional<Mesh_keeper> best_;
  std::optional<Kept_shape> kept_; // by the best so far
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DETOURS_H
