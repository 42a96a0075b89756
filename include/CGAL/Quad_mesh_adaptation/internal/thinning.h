// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_THINNING_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_THINNING_H

#include <CGAL/Quad_mesh_adaptation/internal/Walk.h>
#include <CGAL/Quad_mesh_adaptation/internal/Quick_close.h>
#include <CGAL/Quad_mesh_adaptation/internal/chord_coarsening.h>
#include <CGAL/Quad_mesh_adaptation/internal/chord_thinning.h>
#include <CGAL/Quad_mesh_adaptation/internal/large_mesh.h>
#include <CGAL/Quad_mesh_adaptation/internal/refinement.h>
#include <CGAL/Quad_mesh_adaptation/internal/spatial_order.h>

#include <algorithm>
#include <cmath>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Thins out a mesh with far too many faces by closing faces, the smallest first.  What it looks
// like in between hardly shows in the end, so no energy is asked for: a face is closed where those
// about the new node are well shaped, follow the surface and stay below a share of their size.
class Face_thinning
{
public:
  // Away from curves no face may become worse than `least`.
  Face_thinning(Adaptation_state& s, double least) : s_(s), least_(least) {}

  // Closes faces as long as none about a new node is longer than `limit` sizes; returns how many.
  std::size_t pass(double limit)
  {
    Quick_close close(s_, limit, least_);
    std::size_t closed = 0, seen = 0;
    for(const auto& candidate : candidates(limit)) {
      if(seen++ % 4096 == 0) s_.check_cancelled();
      if(s_.mesh.is_face(candidate.second) && try_face(close, candidate.second)) ++closed;
    }
    s_.count("face close", closed);
    return closed;
  }

private:
  // By their shorter diagonal in wanted sizes; rounded, so that equals are told by the order.
  std::vector<std::pair<float, Index>> candidates(double limit) const
  {
    const Quad_complex& m = s_.mesh;
    std::vector<std::pair<float, Index>> list;
    for(Index f : m.faces()) {
      const Corners p = s_.corners(f);
      double h = 0;
      for(Index v : m.quad(f)) h += 0.25 * m.vertex(v).h;
      if(mean_edge_length(p) >= limit * h) continue;
      list.push_back({ float((std::min)(distance(p[0], p[2]), distance(p[1], p[3])) / h), f });
    }
    put_in_order(list, s_.order);
    std::stable_sort(list.begin(), list.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    return list;
  }

  // Along the diagonal that is better for the valences, the shorter of equals, else the other.
  bool try_face(Quick_close& close, Index f) const
  {
    const Quad_complex& m = s_.mesh;
    int squares[2];
    const bool may[2] = { close.is_candidate(4 * f, squares[0]),
                          close.is_candidate(4 * f + 1, squares[1]) };
    int first = may[0] ? 0 : 1;
    if(may[0] && may[1]) {
      const Quad q = m.quad(f);
      const double l0 = distance(m.point(q[0]), m.point(q[2])),
                   l1 = distance(m.point(q[1]), m.point(q[3]));
      if(squares[1] < squares[0] || (squares[1] == squares[0] && l1 < l0)) first = 1;
    }
    return (may[first] && close(4 * f + first)) || (may[1 - first] && close(4 * f + 1 - first));
  }

  Adaptation_state& s_;
  double least_;
};

// Four times as many faces as the sizes ask for, or more: what is done now will hardly be seen in
// the end, so that in a large mesh quick work is good enough.
inline bool is_far_too_fine(const Adaptation_state& s)
{
  return is_large(s) && mean_square_ratio(s) < 0.25;
}

// Are there so many edges on curves that these should be thinned along with the faces?
inline bool is_rich_in_curves(const Adaptation_state& s)
{
  constexpr double many = 0.25; // for a face that is wanted
  std::size_t edges = 0;
  for(Index h : s.mesh.halfedges())
    if(s.mesh.curve(h) >= 0 && s.mesh.opposite(h) < h) ++edges;
  return double(edges) > many * mean_square_ratio(s) * double(s.mesh.number_of_faces());
}

// Dozens of times as many: shapes and sizes will be made good by what is done later.
inline bool is_rough_enough(const Adaptation_state& s)
{
  constexpr double dozens = 30;
  return !is_distance_limited(s) && is_far_too_fine(s) && dozens * mean_square_ratio(s) < 1;
}

// How far faces are closed.
struct Thinning_limits
{
  double share;  // of its size, for the largest face
  double least;  // quality away from curves
  bool to_limit; // the last pass is repeated as long as it closes many
};

// Closes faces until those that are left have up to a share of their size, or there are no more
// than `enough`; in steps, so that the mesh stays even.
inline std::size_t thin_by_faces(Adaptation_state& s, const Thinning_limits& o, Index enough)
{
  constexpr double step = 1.4, many = 0.04;
  const double now = std::sqrt(mean_square_ratio(s));
  double limit = o.share;
  while(limit > 1.7 * now) limit /= step;
  s.restless.assign(s.mesh.vertex_end(), 0);
  Face_thinning thinning(s, o.least);
  std::size_t total = 0;
  while(limit < 1.01 * o.share && s.mesh.number_of_faces() > enough) {
    const std::size_t closed = thinning.pass(limit);
    total += closed;
    s.forget_faces();
    smooth_plainly(s);
    const bool is_last = limit * step > 1.01 * o.share;
    const bool again =
        o.to_limit && is_last && double(closed) >= many * double(s.mesh.number_of_faces());
    if(!again) limit *= step;
  }
  return total;
}

// Do chords run straight on, so that taking out one after the other leads far?
inline bool is_regular(const Adaptation_state& s)
{
  constexpr std::size_t few = 50; // one node in so many
  std::size_t nodes = 0, irregular = 0;
  for(Index v : s.mesh.vertices()) {
    if(s.mesh.is_border_vertex(v)) continue;
    ++nodes;
    irregular += s.mesh.vertex(v).faces != 4;
  }
  return few * irregular < nodes;
}

// Thins out a large mesh that is far too fine, quickly, until it is large or too fine by little;
// with rows nearly wide enough left to `look_closer`.  Faces are closed where chords run astray or
// too few can go.  That leaves curves as they are; where much depends on these the search for
// operations has to do it.
//
// With dozens of times as many faces as wanted it goes up to the full size, and worse shapes will
// do: the search for operations would remove the rest at ten times the price.
template <typename Look_closer>
void thin_out(Adaptation_state& s, const Look_closer& look_closer)
{
  const bool is_quick = !is_distance_limited(s) && is_far_too_fine(s),
             is_rough = is_rough_enough(s);
  if(is_quick) {
    const Index before = s.mesh.number_of_faces();
    thin_by_chords(s, 0.7, is_rough ? 0.2 : 0.35, large_part(s));
    s.disturb_all();
    if(s.mesh.number_of_faces() < before) renumber_by_place(s);
  }
  const bool is_rich = is_quick && is_rich_in_curves(s);
  if(!is_quick || is_rich || !is_far_too_fine(s) || is_regular(s)) look_closer();
  if(!is_quick || is_rich || !is_far_too_fine(s)) return;
  const Thinning_limits fine = { 0.7, 0.3, false }, rough = { 1, 0.05, true };
  thin_by_faces(s, is_rough ? rough : fine, large_part(s));
  renumber_by_place(s);
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_THINNING_H
