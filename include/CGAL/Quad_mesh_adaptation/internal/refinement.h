// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_REFINEMENT_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_REFINEMENT_H

#include <CGAL/Quad_mesh_adaptation/internal/edge_marking.h>
#include <CGAL/Quad_mesh_adaptation/internal/faults.h>
#include <CGAL/Quad_mesh_adaptation/internal/split_templates.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Fraction of the faces that are smaller than `ratio` times their size.
inline double fraction_below(const Adaptation_state& s, double ratio)
{
  std::size_t below = 0;
  for(Index f : s.mesh.faces())
    if(s.size_ratio(f) < ratio) ++below;
  return double(below) / double(s.mesh.number_of_faces());
}

// Mean square of the size ratios, those above 1 taken as 1: what share of the faces would do.
inline double mean_square_ratio(const Adaptation_state& s)
{
  double sum = 0;
  for(Index f : s.mesh.faces()) {
    const double r = (std::min)(s.size_ratio(f), 1.);
    sum += r * r;
  }
  return sum / double(s.mesh.number_of_faces());
}

// May whole rows be too many, although no face is far too small?
inline bool may_spare_rows(const Adaptation_state& s) { return mean_square_ratio(s) < 0.88; }

// Are there clearly more faces than the sizes ask for, everywhere a few or many in some place?
inline bool is_too_fine(const Adaptation_state& s)
{
  return mean_square_ratio(s) < 0.75 || fraction_below(s, 0.7) > 0.01;
}

// One conforming pass over the whole mesh: edges are halved where the size asks for it.
// Returns the number of faces cut.
inline std::size_t refine_once(Adaptation_state& s, const Marking_options& o)
{
  s.check_cancelled();
  const bool is_local = !s.region.empty(); // then edges that leave it stay as they are, if possible
  std::vector<double> wish = split_wishes(s, o, is_local);
  if(wish.empty()) return 0;
  std::vector<char> split;
  if(is_local) {
    split = even_marks(s.mesh, wish, o.bend);
    if(split.empty()) wish = split_wishes(s, o, false);
  }
  if(split.empty()) split = even_marks(s.mesh, wish, o.bend);
  wish = std::vector<double>(); // its memory is needed for the splits
  return split.empty() ? 0 : Split_templates(s, split)();
}

// 2-refinement of whole faces: all their edges are split, and the transition templates around
// them follow from the T-join with as few further splits as possible.  Edges of the region are
// never given up, unless no other solution exists.
inline std::size_t refine_faces(Adaptation_state& s, const std::vector<Index>& faces)
{
  const Quad_complex& m = s.mesh;
  std::vector<double> wish(4 * std::size_t(m.face_end()), 1.);
  const auto low = [&](Index h) {
    const Index o = m.opposite(h);
    return o >= 0 && o < h ? o : h;
  };
  for(Index h : m.halfedges())
    if(m.curve(h) >= 0 && s.curves[m.curve(h)].is_frozen())
      wish[low(h)] = std::numeric_limits<double>::infinity();
  for(Index f : faces)
    for(Index h = 4 * f; h < 4 * f + 4; ++h)
      if(std::isfinite(wish[low(h)])) wish[low(h)] = -1000.;
  const std::vector<char> split = even_marks(m, wish, 1e-3);
  wish = std::vector<double>(); // its memory is needed for the splits
  return split.empty() ? 0 : Split_templates(s, split)();
}

// Under-resolved places pursue the size they have now: where a node's edges are longer than
// wanted, its floor is their mean length, so that neither smoothing nor clean-up works against
// the refinement to come.
inline void set_floors(Adaptation_state& s)
{
  Quad_complex& m = s.mesh;
  std::vector<double> sum(m.vertex_end(), 0.);
  std::vector<int> n(m.vertex_end(), 0);
  for(Index h : m.halfedges()) {
    const Index u = m.origin(h), v = m.target(h);
    const double l = distance(m.point(u), m.point(v));
    sum[u] += l;
    sum[v] += l;
    ++n[u];
    ++n[v];
  }
  for(Index v : m.vertices()) m.vertex(v).floor = sum[v] / n[v];
  s.forget_energies();
  s.disturb_all();
}

inline void clear_floors(Adaptation_state& s)
{
  for(Index v = 0; v < s.mesh.vertex_end(); ++v) s.mesh.vertex(v).floor = 0;
  s.forget_energies();
  s.disturb_all();
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_REFINEMENT_H
