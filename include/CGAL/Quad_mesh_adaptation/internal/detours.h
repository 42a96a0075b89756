// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DETOURS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DETOURS_H

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

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Share of the nodes inside the surface that have not four faces.
inline double irregular_share(const Adaptation_state& s)
{
  const Quad_complex& m = s.mesh;
  std::size_t irregular = 0, all = 0;
  for(Index v = 0; v < m.vertex_end(); ++v) {
    if(!m.is_vertex(v) || m.vertex(v).carrier != Carrier::surface) continue;
    ++all;
    if(m.vertex(v).faces != 4) ++irregular;
  }
  return double(irregular) / double((std::max)(all, std::size_t(1)));
}

// Has the mesh more irregular nodes than most have for sizes that grow as these do?  A regular one
// that is a little too large everywhere gets them where single faces are split in the end.
inline bool is_needlessly_irregular(const Adaptation_state& s)
{
  constexpr double usual = 0.12, by_slope = 0.25;
  const double share = irregular_share(s);
  return share > usual && share > usual + by_slope * Demand(s).slope;
}

// Has the mesh come out clearly worse than most do?
inline bool is_poor(const Adaptation_state& s)
{
  return !faces_too_large(s).empty() || shape_faults(s) > 0.2 || fraction_below(s, 0.5) > 0.03 ||
         efficiency(s) < 0.6 || is_needlessly_irregular(s);
}

// What is wrong with a mesh, to be compared with another one for the same sizes.
inline double demerits(Adaptation_state& s)
{
  const double too_small = fraction_below(s, 0.5) * double(s.mesh.number_of_faces());
  return total_energy(s) + 10 * shape_faults(s) + 10 * double(faces_too_large(s).size()) +
         3 * too_small;
}

// Halves all faces until most are clearly smaller than asked.
inline void make_finer(Adaptation_state& s)
{
  constexpr Index many = 20000;
  Curve_bends(s).hold();
  while(fraction_below(s, 0.75) < 0.5 && s.mesh.number_of_faces() < many) {
    s.scale_sizes(2);
    halve_all(s);
  }
}

// Other ways to the sizes, for where one leads into a dead end.
class Detours
{
public:
  // Before the first run; `run` goes from any mesh to one for the sizes.
  Detours(Adaptation_state& s, std::function<void()> run) : s_(s), run_(std::move(run)), given_(s)
  {
  }

  // From a finer mesh, where not many more faces are wanted than given: thinning finds a way where
  // a few cuts here and there do not.
  void finer()
  {
    constexpr double enough = 0.85, fewer = 0.9, many_more = 6;
    const double growth = double(s_.mesh.number_of_faces()) / given_.number_of_faces();
    if(growth < fewer || growth > many_more || is_anything_frozen(s_)) return;
    if(efficiency(s_) > enough && !is_poor(s_)) return;
    keep_this();
    Mesh_keeper(given_).restore();
    make_finer(s_);
    try_it();
  }

  // Walks in another order.
  void in_order(int order)
  {
    if(!is_poor(s_)) return;
    keep_this();
    Mesh_keeper(given_).restore();
    s_.order = order;
    try_it();
    s_.order = 0;
  }

private:
  void keep_this()
  {
    least_ = clearly * demerits(s_);
    best_.emplace(s_);
  }

  void try_it()
  {
    run_();
    if(demerits(s_) >= least_) best_->restore();
  }

  static constexpr double clearly = 0.95;

  Adaptation_state& s_;
  std::function<void()> run_;
  const Mesh_keeper given_;
  std::optional<Mesh_keeper> best_;
  double least_ = 0;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_DETOURS_H
