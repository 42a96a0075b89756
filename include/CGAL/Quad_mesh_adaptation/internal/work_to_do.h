// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_WORK_TO_DO_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_WORK_TO_DO_H

#include <CGAL/Quad_mesh_adaptation/internal/nodes_around.h>
#include <CGAL/Quad_mesh_adaptation/internal/size_guarantee.h>
#include <CGAL/Quad_mesh_adaptation/internal/total_energy.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

inline bool has_good_valence(const Vertex_record& r)
{
  return r.carrier != Carrier::surface || (r.faces >= 3 && r.faces <= 5);
}

// Is face f within its size, with shape and valences as the default schedule leaves them?
inline bool is_good(const Adaptation_state& s, Index f)
{
  if(s.size_ratio(f) > size_tolerance) return false;
  if(is_jacobian_below(s.corners(f), s.smoothing.min_corner)) return false;
  const Quad q = s.mesh.quad(f);
  return std::all_of(q.begin(), q.end(),
                     [&](Index v) { return has_good_valence(s.mesh.vertex(v)); });
}

inline bool is_good(const Adaptation_state& s)
{
  for(Index f : s.mesh.faces())
    if(!is_good(s, f)) return false;
  return true;
}

// For some faces the mean of a value over the faces about their corners; right where all of these
// are among the given ones, which are in order.
inline void average_over_neighbours(const Adaptation_state& s, const std::vector<Index>& faces,
                                    std::vector<float>& value)
{
  std::vector<float> sum(s.mesh.vertex_end(), 0);
  for(Index f : faces)
    for(Index v : s.mesh.quad(f)) sum[v] += value[f] / float(s.mesh.vertex(v).faces);
  for(Index f : faces) {
    const Quad q = s.mesh.quad(f);
    value[f] = 0.25f * (sum[q[0]] + sum[q[1]] + sum[q[2]] + sum[q[3]]);
  }
}

// Of the faces of which `square` is below `limit`, those in connected places that could do with so
// many fewer that it matters for the whole: adaptation leaves small places with a few too many, and
// to work on all of those again would cost more than a small change does.
inline std::vector<char> places_that_matter(const Quad_complex& m, const std::vector<float>& square,
                                            float limit)
{
  const double least = double(m.number_of_faces()) / 10000;
  std::vector<char> result(m.face_end(), 0);
  std::vector<Index> place;
  for(Index first : m.faces()) {
    if(result[first] || !(square[first] < limit)) continue;
    place.assign(1, first);
    result[first] = 1;
    double spare = 0;
    for(std::size_t i = 0; i < place.size(); ++i) {
      spare += 1 - double(square[place[i]]);
      for(Index h = 4 * place[i]; h < 4 * place[i] + 4; ++h) {
        const Index o = m.opposite(h);
        if(o < 0 || result[m.face(o)] || !(square[m.face(o)] < limit)) continue;
        result[m.face(o)] = 1;
        place.push_back(m.face(o));
      }
    }
    if(spare >= least) continue;
    for(Index f : place) result[f] = 2; // seen, but left alone
  }
  for(char& c : result) c = c == 1;
  return result;
}

inline std::vector<Index> faces_with_marked_nodes(const Quad_complex& m,
                                                  const std::vector<char>& marked)
{
  std::vector<Index> list;
  for(Index f : m.faces()) {
    const Quad q = m.quad(f);
    if(std::any_of(q.begin(), q.end(), [&](Index v) { return marked[v]; })) list.push_back(f);
  }
  return list;
}

// Faces among which there are clearly more than the sizes ask for, by the mean over those about the
// corners of those about its corners: such a mean lies two rings from a face that is small itself
// at most, and with one more ring all that it needs is at hand.
inline std::vector<char> faces_among_too_many(const Adaptation_state& s)
{
  constexpr float too_many = 0.45f, margin = 1e-3f;
  const Quad_complex& m = s.mesh;
  std::vector<float> square(m.face_end(), 0);
  std::vector<Index> small;
  for(Index f : m.faces()) {
    const double r = s.size_ratio(f);
    square[f] = float((std::min)(r * r, 1.));
    if(square[f] < too_many + margin) small.push_back(f);
  }
  const std::vector<Index> near = faces_with_marked_nodes(m, nodes_around(m, small, 3));
  for(int time = 0; time < 2; ++time) average_over_neighbours(s, near, square);
  const std::vector<char> is_right = nodes_around(m, small, 1);
  std::vector<float> mean(m.face_end(), 1);
  for(Index f : near) {
    const Quad q = m.quad(f);
    if(std::any_of(q.begin(), q.end(), [&](Index v) { return is_right[v]; })) mean[f] = square[f];
  }
  return places_that_matter(m, mean, too_many);
}

// Faces about which there is something to do; those, too, that have left the surface (by half a
// size or more from a witness), once coverage is prepared.
inline std::vector<Index> faces_to_work_on(const Adaptation_state& s)
{
  constexpr double left_behind = 5;
  const std::vector<char> too_many = faces_among_too_many(s);
  std::vector<Index> list;
  for(Index f : s.mesh.faces())
    if((too_many[f] || !is_good(s, f) || s.coverage.cost(f) > left_behind) && !is_beyond_help(s, f))
      list.push_back(f);
  return list;
}

// Is there nothing to do?  Faces that are too large are the first to tell.
inline bool is_adapted(const Adaptation_state& s)
{
  for(Index f : s.mesh.faces())
    if(s.size_ratio(f) > size_tolerance && !is_beyond_help(s, f)) return false;
  return !is_too_fine(s) && faces_to_work_on(s).empty();
}

// Is there something to do about few of the faces only?
inline bool is_local(const Adaptation_state& s, const std::vector<Index>& work)
{
  constexpr std::size_t few = 10;      // one face in so many
  constexpr double fine_enough = 0.75; // as is_too_fine() has it: else all faces could be larger
  return !work.empty() && few * work.size() <= std::size_t(s.mesh.number_of_faces()) &&
         mean_square_ratio(s) >= fine_enough;
}

// Is there something to coarsen among these?
inline bool are_many_too_small(const Adaptation_state& s, const std::vector<Index>& work)
{
  constexpr double small = 0.7, few = 0.3;
  const auto below =
      std::count_if(work.begin(), work.end(), [&](Index f) { return s.size_ratio(f) < small; });
  return double(below) > few * double(work.size());
}

// Where that is so all else is left alone, so that a small change costs little.  Tells whether it
// is so.
inline bool stay_near_work(Adaptation_state& s)
{
  if(!s.region.empty()) return true; // it has been found before
  const std::vector<Index> work = faces_to_work_on(s);
  if(!is_local(s, work)) return false;
  s.region = nodes_around(s.mesh, work, rings_to_work_on);
  for(Index v = 0; v < s.mesh.vertex_end(); ++v)
    if(!s.mesh.is_vertex(v)) s.region[v] = 1; // may become a new one
  return true;
}

// The energy of the faces to work on in a good mesh must fall by this share of it for the mesh to
// be changed, and by the other where that leaves faces too large.
constexpr double worth_a_change = 0.08, worth_a_fault = 0.5;

// A mesh that was good may come out no better, because its sizes leave no more to gain; then it is
// left as it was, so that adapting an adapted mesh again changes nothing.
class Good_mesh_keeper
{
public:
  // `work`: the faces to work on, if these are few; else none.
  Good_mesh_keeper(Adaptation_state& s, const std::vector<Index>& work) : s_(s)
  {
    if(!is_good(s)) return;
    mesh_.emplace(s);
    energy_ = at_stake_ = total_energy(s);
    if(work.empty()) return;
    at_stake_ = 0;
    for(Index f : work) at_stake_ += s.cached_energy(f) + s.coverage.cost(f);
  }

  void restore_unless_better()
  {
    if(!mesh_) return;
    const double share = faces_too_large(s_).empty() ? worth_a_change : worth_a_fault;
    if(energy_ - total_energy(s_) < share * at_stake_) mesh_->restore();
  }

private:
  Adaptation_state& s_;
  std::optional<Mesh_keeper> mesh_;
  double energy_ = 0, at_stake_ = 0; // of all faces and nodes, and of those to work on
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_WORK_TO_DO_H
