// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FAN_THINNING_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FAN_THINNING_H

#include <CGAL/Quad_mesh_adaptation/internal/Crease_fan_close.h>
#include <CGAL/Quad_mesh_adaptation/internal/Fan_turning.h>
#include <CGAL/Quad_mesh_adaptation/internal/Mesh_keeper.h>
#include <CGAL/Quad_mesh_adaptation/internal/Phase_scope.h>
#include <CGAL/Quad_mesh_adaptation/internal/Quick_close.h>
#include <CGAL/Quad_mesh_adaptation/internal/Wedge_set.h>
#include <CGAL/Quad_mesh_adaptation/internal/chord_thinning.h>
#include <CGAL/Quad_mesh_adaptation/internal/distance_guard.h>
#include <CGAL/Quad_mesh_adaptation/internal/total_energy.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Closes every other face about nodes of huge valence along the diagonal that they are not on, as
// far as `limit` sizes; for where wedges run astray or are wide enough farther out.
class Fan_closing
{
public:
  Fan_closing(Adaptation_state& s, double limit, double least)
      : s_(s), limit_(limit), close_(s, (std::numeric_limits<double>::infinity)(), least),
        close_at_crease_(s, least)
  {
  }

  // About the nodes given; returns how many.
  std::size_t operator()(const std::vector<Index>& nodes)
  {
    used_.assign(s_.mesh.vertex_end(), 0);
    std::size_t closed = 0;
    for(Index v : nodes) {
      s_.mesh.outgoing(v, out_);
      for(Index spoke : out_)
        if(s_.mesh.origin(spoke) == v && try_face(Quad_complex::next(spoke))) ++closed;
    }
    if(closed > 0) s_.forget_faces();
    s_.count("face close", closed);
    return closed;
  }

private:
  // Along the diagonal from the origin of h; the nodes about it wait for the next turn then.
  bool try_face(Index h)
  {
    const Quad_complex& m = s_.mesh;
    const Index a = m.origin(h), b = m.target(h), c = m.target(m.next(h));
    if(used_[a] || used_[b] || used_[c] || is_huge(m, a) || is_huge(m, c)) return false;
    const double width = distance(m.point(a), m.point(c));
    if(2 * width > limit_ * 0.5 * (m.vertex(a).h + m.vertex(c).h)) return false; // as it will be
    int squares;
    if(!(close_.is_candidate(h, squares) && close_(h)) && !close_at_crease_(h)) return false;
    used_[a] = used_[c] = 1;
    used_[b] = !is_huge(m, b); // which may be the centre of a fan opposite
    return true;
  }

  Adaptation_state& s_;
  double limit_;
  Quick_close close_;
  Crease_fan_close close_at_crease_;
  std::vector<char> used_;
  std::vector<Index> out_;
};

// By wedges between fans of which some had to be turned to fit the others; if that takes out no
// face they stay as they were.
inline void thin_turned_fans(Adaptation_state& s, const std::vector<Index>& nodes, double limit,
                             double least)
{
  if(nodes.empty()) return;
  Mesh_keeper mesh(s);
  if(Fan_turning(s)(nodes) > 0 && Row_thinning<Wedge_set>(s, limit, least)() == 0) mesh.restore();
}

// One round, by wedges where that halves the nodes or nearly; returns the number of faces removed.
inline std::size_t thin_fans_once(Adaptation_state& s, double limit, double least)
{
  constexpr double nearly = 0.75;
  const Index before = s.mesh.number_of_faces();
  std::vector<std::pair<Index, int>> given;
  for(Index v : huge_nodes(s.mesh)) given.push_back({ v, s.mesh.vertex(v).faces });
  const auto left = [&] {
    std::vector<Index> nodes;
    for(const auto& g : given)
      if(is_huge(s.mesh, g.first) && s.mesh.vertex(g.first).faces > nearly * g.second)
        nodes.push_back(g.first);
    return nodes;
  };
  Row_thinning<Wedge_set>(s, limit, least)();
  thin_turned_fans(s, left(), limit, least);
  Fan_closing(s, limit, least)(left());
  return std::size_t(before - s.mesh.number_of_faces());
}

// Of the faces to the reference, where that is limited; else 0.
inline double largest_distance_if_limited(const Adaptation_state& s)
{
  double largest = 0;
  if(!is_distance_limited(s)) return largest;
  for(Index f : s.mesh.faces()) largest = (std::max)(largest, distance_of(s, f));
  return largest;
}

// Takes faces out about nodes that have so many that each operation there would look at hundreds,
// about half of them in each round, as long as the edges opposite stay clearly shorter than wanted.
// As with any operation the energy falls each time, and no face leaves the surface.
inline void thin_fans(Adaptation_state& s)
{
  constexpr double limit = 0.7, least = 0.3;
  constexpr int most_rounds = 20;
  if(huge_nodes(s.mesh).empty()) return;
  Phase_scope phase(s, "coarsening");
  double energy = total_energy(s);
  const double allowed = (std::max)(largest_distance_if_limited(s), s.max_distance);
  for(int round = 0; round < most_rounds; ++round) {
    s.check_cancelled();
    Mesh_keeper mesh(s);
    if(thin_fans_once(s, limit, least) == 0) break;
    const double now = total_energy(s);
    if(!(now < energy - s.energy.min_gain) || largest_distance_if_limited(s) > allowed) {
      mesh.restore();
      break;
    }
    energy = now;
  }
  s.disturb_all();
  s.stir_all();
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FAN_THINNING_H
