// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SIZE_GUARANTEE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SIZE_GUARANTEE_H

#include <CGAL/Quad_mesh_adaptation/internal/Mesh_keeper.h>
#include <CGAL/Quad_mesh_adaptation/internal/clean_up.h>
#include <CGAL/Quad_mesh_adaptation/internal/faults.h>
#include <CGAL/Quad_mesh_adaptation/internal/large_mesh.h>
#include <CGAL/Quad_mesh_adaptation/internal/nodes_around.h>
#include <CGAL/Quad_mesh_adaptation/internal/refinement.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The faces too large that pressure may bring down: pressing on the others only spoils them.
inline std::vector<Index> faces_to_press(const Adaptation_state& s)
{
  std::vector<Index> list;
  for(Index f : faces_too_large(s))
    if(!is_beyond_help(s, f)) list.push_back(f);
  return list;
}

// The longer pair of opposite edges of a face.
inline std::vector<Index> longer_edges(const Adaptation_state& s, Index f)
{
  const Quad_complex& m = s.mesh;
  const auto length = [&](int i) {
    return distance(m.point(m.origin(4 * f + i)), m.point(m.target(4 * f + i)));
  };
  const Index first = 4 * f + (length(0) + length(2) >= length(1) + length(3) ? 0 : 1);
  return { first, first + 2 };
}

inline std::vector<Index> shorter_edges(const Adaptation_state& s, Index f)
{
  const Index other = longer_edges(s, f).front() == 4 * f ? 4 * f + 1 : 4 * f;
  return { other, other + 2 };
}

inline std::vector<Index> all_edges(const Adaptation_state&, Index f)
{
  return { 4 * f, 4 * f + 1, 4 * f + 2, 4 * f + 3 };
}

using Edges_of_face = std::vector<Index> (*)(const Adaptation_state&, Index);

// The last resort: faces still too large get the pair of edges that is longest split, or those that
// `edges_to_cut` names, wherever the T-join then leads the splits, within `rings` rings of faces.
inline std::size_t split_within(Adaptation_state& s, const std::vector<Index>& faces, int rings,
                                Edges_of_face edges_to_cut)
{
  Marking_options o;
  o.threshold = 1.4; // others only where they are far too long
  o.bend = 0.1;
  const Quad_complex& m = s.mesh;
  const std::vector<char> near = nodes_around(s.mesh, faces, rings);
  std::vector<double> wish(4 * std::size_t(m.face_end()), std::numeric_limits<double>::infinity());
  const auto low = [&](Index h) {
    const Index opposite = m.opposite(h);
    return opposite >= 0 && opposite < h ? opposite : h;
  };
  for(Index h : m.halfedges())
    if(near[m.origin(h)] && near[m.target(h)] && low(h) == h) wish[h] = split_wish(s, o, h);
  for(Index f : faces)
    for(Index h : edges_to_cut(s, f))
      if(std::isfinite(wish[low(h)])) wish[low(h)] = -20;
  const std::vector<char> split = even_marks(m, wish, o.bend);
  wish = std::vector<double>(); // its memory is needed for the splits
  return split.empty() ? 0 : Split_templates(s, split)();
}

// In the whole mesh only where the neighbourhood is too small for it.
inline std::size_t split_too_large(Adaptation_state& s, const std::vector<Index>& faces,
                                   Edges_of_face edges_to_cut = longer_edges)
{
  const std::size_t cut = split_within(s, faces, 12, edges_to_cut);
  return cut > 0 ? cut : split_within(s, faces, s.mesh.face_end(), edges_to_cut);
}

// Smoothing about some faces, and nowhere else unless it spreads from there.
inline void smooth_near(Adaptation_state& s, const std::vector<Index>& faces, int rings = 3)
{
  s.restless = nodes_around(s.mesh, faces, rings);
  smooth(s, 6);
}

// Presses on the faces that are too large, and on nothing else: smoothing with a hinge on the
// size, and local operations under a heavier weight for oversize, about them and two rings
// around.  No operation may leave a face above its size that was not.
inline void press_down(Adaptation_state& s, const Improvement_options& o,
                       const std::vector<Index>& large, int rings)
{
  smooth_near(s, large, rings);
  const std::vector<Index> left = faces_to_press(s);
  if(left.empty()) return;
  s.stirred = nodes_around(s.mesh, left, 2);
  Local_improvement(s, o).passes(4);
  smooth_near(s, faces_to_press(s), rings);
}

// The nodes about faces that were worked on with other weights than the rest.
class Touched_nodes
{
public:
  explicit Touched_nodes(Adaptation_state& s) : s_(s), touched_(s.mesh.vertex_end(), 0) {}

  void add(const std::vector<Index>& faces)
  {
    constexpr int reach = 6; // rings
    const std::vector<char> near = nodes_around(s_.mesh, faces, reach);
    touched_.resize(near.size(), 1);
    for(std::size_t v = 0; v < near.size(); ++v) touched_[v] = char(touched_[v] | near[v]);
  }

  // They are worth a visit of smoothing and of operations; so are those that are new since.
  void wake() const
  {
    for(Index v = 0; v < s_.mesh.vertex_end(); ++v) {
      if(v < Index(touched_.size()) && !touched_[v]) continue;
      s_.disturb(v);
      s_.stir(v);
    }
  }

private:
  Adaptation_state& s_;
  std::vector<char> touched_;
};

// What pressure and splits have spoiled is mended without giving up a size that is met: clean-up
// and smoothing that leave no face above its size that was not.
inline void settle(Adaptation_state& s, Improvement_options o, int rounds,
                   const Touched_nodes& touched)
{
  o.keep_within_size = true;
  s.smoothing.keep_within_size = true;
  const Short_smoothing coarse(s);
  touched.wake();
  for(int round = 0; round < rounds; ++round) {
    smooth(s, 4);
    if(Local_improvement(s, o).passes(3) == 0) break;
  }
  smooth(s, 6);
  s.smoothing.keep_within_size = false;
}

// Splits, as the last resort, and a clean-up of what they leave.
inline void split_and_clean(Adaptation_state& s, const Improvement_options& o,
                            const std::vector<Index>& large)
{
  if(split_too_large(s, large) == 0) return;
  smooth(s, 2);
  Improvement_options careful = o;
  careful.keep_within_size = true;
  Local_improvement(s, careful).passes(4);
}

// By how much faces are too large in all, of those that can be helped.
inline double size_excess(const Adaptation_state& s)
{
  double sum = 0;
  for(Index f : faces_to_press(s)) sum += s.size_ratio(f) - 1;
  return sum;
}

// Has all that is done for sizes left much too large?  Then they can not be met.
inline bool are_sizes_out_of_reach(const Adaptation_state& s)
{
  constexpr double few = 0.01; // of the faces
  return size_excess(s) > few * double(s.mesh.number_of_faces());
}

// Splits that help are kept.  Where faces lie folded over each other, or the sizes can not be met
// for another reason, splits only make more faces that are too large; so the second in a row after
// which no fewer are is the last, and the mesh goes back to the best one there was.  They are for
// few faces, and also end where the mesh has grown by half.
class Bounded_splits
{
public:
  explicit Bounded_splits(Adaptation_state& s)
      : s_(s), most_(s.mesh.number_of_faces() + s.mesh.number_of_faces() / 2 + few)
  {
  }

  // false: no more.
  bool operator()(const Improvement_options& o, const std::vector<Index>& large)
  {
    const double excess = size_excess(s_);
    in_vain_ = best_ && excess >= least_ ? in_vain_ + 1 : 0;
    if(in_vain_ == 2 || s_.mesh.number_of_faces() > most_) return false;
    if(in_vain_ == 0) {
      best_.emplace(s_);
      least_ = excess;
    }
    split_and_clean(s_, o, large);
    return true;
  }

  void end()
  {
    if(best_ && size_excess(s_) >= least_) best_->restore();
  }

private:
  static constexpr Index few = 1000; // may be split in any mesh

  Adaptation_state& s_;
  const Index most_; // faces
  std::optional<Mesh_keeper> best_;
  double least_ = 0;
  int in_vain_ = 0;
};

// Until no face is larger than wanted, or `max_rounds`: pressure that grows from round to round,
// splits where that does not help.  Returns the number of faces left too large.
inline void enforce_sizes(Adaptation_state& s, const Improvement_options& o, int max_rounds)
{
  Phase_scope phase(s, "size guarantee");
  const Smoothing_weights gentle = s.smoothing;
  const Energy_weights energy = s.energy;
  Improvement_options pressed = o;
  pressed.min_jacobian = 0.35;
  std::vector<Index> large = faces_to_press(s);
  double weight = 2;
  Bounded_splits split(s);
  Touched_nodes touched(s);
  for(int round = 0; round < max_rounds && !large.empty(); ++round, weight *= 1.7) {
    s.check_cancelled();
    touched.add(large);
    if(round % 4 == 2 && round > 2 && !split(o, large)) break;
    s.smoothing.min_corner = 0.3;
    s.smoothing.hinge = Pressing::hard * (std::min)(weight, 20.);
    s.energy.oversize = energy.oversize * (std::min)(weight, 100.);
    s.forget_energies();
    pressed.keep_within_size = round >= 2;
    press_down(s, pressed, faces_to_press(s), 3 + round);
    s.smoothing = gentle;
    s.energy = energy;
    s.forget_energies();
    large = faces_to_press(s);
  }
  split.end();
  s.smoothing.hinge = Pressing::hard;
  settle(s, o, 3, touched);
  s.smoothing = gentle;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SIZE_GUARANTEE_H
