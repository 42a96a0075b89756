// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SPATIAL_ORDER_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SPATIAL_ORDER_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/boxes.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Numbers points of a box so that those of a cell, of any of the halvings of the box, follow each
// other (Morton's order).
class Cell_number
{
public:
  explicit Cell_number(const Quad_complex& m)
  {
    Box box;
    for(Index v : m.vertices()) box.add(m.point(v));
    low_ = box.low;
    const double longest = box.longest_side();
    scale_ = longest > 0 ? cells / longest : 0.;
  }

  std::uint64_t operator()(const Vec& p) const
  {
    const Vec at = scale_ * (p - low_);
    return spread(at.x()) | spread(at.y()) << 1 | spread(at.z()) << 2;
  }

private:
  static constexpr double cells = (1 << 20) - 1; // along the longest side

  // Two free bits before each.
  static std::uint64_t spread(double x)
  {
    std::uint64_t n = std::uint64_t((std::min)((std::max)(x, 0.), cells));
    n = (n | n << 32) & 0x001f00000000ffffull;
    n = (n | n << 16) & 0x001f0000ff0000ffull;
    n = (n | n << 8) & 0x100f00f00f00f00full;
    n = (n | n << 4) & 0x10c30c30c30c30c3ull;
    return (n | n << 2) & 0x1249249249249249ull;
  }

  Vec low_ = Vec(0, 0, 0);
  double scale_ = 0;
};

// The place of each face in a walk that comes to a face soon after one beside it.
inline std::vector<std::uint64_t> breadth_first_places(const Quad_complex& m)
{
  std::vector<std::uint64_t> place(m.face_end(), 0); // from 1; 0: not reached
  std::vector<Index> order;
  order.reserve(m.number_of_faces());
  const auto reach = [&](Index f) {
    if(place[f] > 0) return;
    order.push_back(f);
    place[f] = order.size();
  };
  for(Index start : m.faces()) {
    std::size_t next = order.size();
    for(reach(start); next < order.size(); ++next)
      for(Index h = 4 * order[next]; h < 4 * order[next] + 4; ++h)
        if(m.opposite(h) >= 0) reach(m.face(m.opposite(h)));
  }
  return place;
}

// May face f be one of the input?  Its nodes are.
inline bool is_of_input(const Quad_complex& m, Index f)
{
  const Quad q = m.quad(f);
  return std::all_of(q.begin(), q.end(), [&m](Index v) { return m.is_protected(v); });
}

// All faces, those near each other mostly close to each other; but those that may be of the input
// keep their numbers where no face is deleted.  A mesh that fits in a cache takes the order that is
// best for sweeps.
inline std::vector<Index> spatial_order(const Quad_complex& m)
{
  constexpr Index small = 5000;
  const Cell_number cell(m);
  std::vector<std::uint64_t> places;
  if(m.number_of_faces() < small) places = breadth_first_places(m);
  std::vector<std::pair<std::uint64_t, Index>> keys;
  keys.reserve(m.number_of_faces());
  std::vector<Index> order(m.number_of_faces(), -1);
  for(Index f : m.faces()) {
    const Quad q = m.quad(f);
    if(f < Index(order.size()) && is_of_input(m, f))
      order[f] = f;
    else
      keys.emplace_back(places.empty() ? cell(0.5 * (m.point(q[0]) + m.point(q[2]))) : places[f],
                        f);
  }
  std::sort(keys.begin(), keys.end());
  auto next = keys.begin();
  for(Index& f : order)
    if(f < 0) f = (next++)->second;
  return order;
}

// Numbers faces and nodes anew, so that neighbours are near each other in memory: sweeps over a
// large mesh take half the time.  All nodes are to be looked at again then.
inline void renumber_by_place(Adaptation_state& s)
{
  const std::vector<Index> order = spatial_order(s.mesh);
  s.mesh.renumber(order);
  s.renumber_faces(order);
  s.disturb_all();
  s.stir_all();
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SPATIAL_ORDER_H
