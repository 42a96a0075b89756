// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISTANCE_CLIMB_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISTANCE_CLIMB_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// What lies between sample points: looked at where it may matter, or not.
enum class Between_samples
{
  climbed,
  left_out
};

// Between its samples a face is farther off than at them where it spans edges of the surface that
// it is measured against.  So that is looked for from the farthest sample on, in ever smaller
// steps; but only where it may matter, by what has been gained before.
class Distance_climb
{
public:
  using Place = std::array<double, 2>; // within a face or a triangle

  // `of_each`: what matters is known of each face, not only the largest of all.
  Distance_climb(Between_samples between, bool of_each)
      : is_any_(between == Between_samples::climbed), least_(of_each ? 1.25 : 1.02),
        most_(of_each ? 2 : 1.25)
  {
  }

  bool is_any() const { return is_any_; }

  // How many times as far as at its samples a face may be, most likely.
  double likely_gain() const
  {
    if(!is_any_) return 1;
    return climbs_ < enough_climbs ? most_ : std::clamp(1 + 1.5 * (gain_ - 1), least_, most_);
  }

  // The farthest place from `at` on, where it is `d`.  `moves`: unit steps; `off(place, d)`: the
  // distance there, where it is more than d; negative outside.
  template <std::size_t n, typename Off>
  Place operator()(Place at, double d, double step, const std::array<Place, n>& moves,
                   const Off& off)
  {
    constexpr int halvings = 4, most_moves = 4; // of each length
    const double before = d;
    for(int i = 0; i < halvings; ++i, step /= 2)
      for(int k = 0; k < most_moves; ++k) {
        const Place from = at;
        for(const Place& m : moves) {
          const Place to{ from[0] + step * m[0], from[1] + step * m[1] };
          const double there = off(to, d);
          if(!(there > d)) continue;
          at = to;
          d = there;
        }
        if(at == from) break;
      }
    ++climbs_;
    if(before > 0) gain_ = (std::max)(gain_, d / before);
    return at;
  }

private:
  static constexpr std::size_t enough_climbs = 64; // to know what is gained

  bool is_any_;
  double least_, most_, gain_ = 1; // bounds for what is taken into account
  std::size_t climbs_ = 0;
};

// The farthest of some samples, where it is, and from which triangle on it was looked for.
struct Farthest_sample
{
  void note(double d, const Distance_climb::Place& where, Index from)
  {
    if(!(d > distance)) return;
    distance = d;
    place = where;
    hint = from;
  }

  double distance = -1;
  Distance_climb::Place place{};
  Index hint = -1;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DISTANCE_CLIMB_H
