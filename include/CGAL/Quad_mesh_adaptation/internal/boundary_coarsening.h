// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_BOUNDARY_COARSENING_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_BOUNDARY_COARSENING_H

#include <CGAL/Quad_mesh_adaptation/internal/Phase_scope.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/chord_collapse.h>
#include <CGAL/Quad_mesh_adaptation/internal/smoothing.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Boundary edge ratio, eq. 2 of the paper: actual over desired length.
inline double edge_ratio(const Adaptation_state& s, Index h)
{
  const Vec &a = s.mesh.point(s.mesh.origin(h)), &b = s.mesh.point(s.mesh.target(h));
  return distance(a, b) / s.size.at(0.5 * (a + b));
}

// Evens out the spacing of the nodes of curve c, in proportion to the size.
inline void smooth_curve(Adaptation_state& s, Index c, int sweeps)
{
  const Quad_complex& m = s.mesh;
  std::vector<std::pair<Index, std::pair<Index, Index>>> nodes; // node, neighbours on the curve
  for(Index h = 0; h < 4 * m.face_end(); ++h) {
    if(!m.is_face(m.face(h)) || !m.is_border(h) || m.curve(h) != c) continue;
    const Index v = m.target(h);
    if(m.vertex(v).carrier == Carrier::curve && !m.vertex(v).frozen)
      nodes.push_back({ v, { m.origin(h), m.target(m.vertex(v).halfedge) } });
  }
  const Feature_curve& curve = s.curves[c];
  for(int sweep = 0; sweep < sweeps; ++sweep)
    for(const auto& n : nodes) {
      Vertex_record& r = s.mesh.vertex(n.first);
      const auto arc_to = [&](Index u) {
        const Vertex_record& o = m.vertex(u);
        return o.carrier == Carrier::curve ? curve.difference(r.param, o.param)
                                           : curve.difference(r.param, curve.nearest(o.p));
      };
      const double a = arc_to(n.second.first), b = arc_to(n.second.second);
      if(!(a * b < 0)) continue; // ambiguous on a very short curve
      const double wa = 1 / s.size.at(r.p + 0.5 * (m.point(n.second.first) - r.p));
      const double wb = 1 / s.size.at(r.p + 0.5 * (m.point(n.second.second) - r.p));
      r.param += 0.5 * (wa * a + wb * b) / (std::max)(wa, wb);
      s.place(r);
    }
  s.forget_energies();
}

// A chord whose end edges are too short, and stay short enough when their neighbours take over
// half of each; the worst of the two ratios, or 2 where it is not to be removed.
inline double removal_rank(const Adaptation_state& s, const Chord& c)
{
  if(c.is_closed) return 2;
  const Quad_complex& m = s.mesh;
  double worst = 0;
  for(Index h : { c.rungs.front(), c.rungs.back() }) {
    const double r = edge_ratio(s, h);
    const Index after = m.vertex(m.target(h)).halfedge;
    worst = (std::max)(worst, r);
    if(m.is_border(after) && edge_ratio(s, after) + 0.5 * r > 1) return 2;
  }
  return worst < 0.75 ? worst : 2;
}

// Boundary coarsening, step 2 of section 3.3: dual chords that end in boundary edges too short
// for their size are removed, the shortest first, then each coarsened curve is smoothed.
// Returns the number of chords removed.
inline std::size_t coarsen_boundary(Adaptation_state& s)
{
  Phase_scope phase(s, "boundary coarsening");
  Cavity cavity(s);
  std::size_t removed = 0;
  std::vector<char> touched(s.curves.size(), 0);
  for(bool again = true; again;) {
    again = false;
    s.check_cancelled();
    std::vector<std::pair<double, Index>> candidates;
    for(Index h = 0; h < 4 * s.mesh.face_end(); ++h)
      if(s.mesh.is_face(s.mesh.face(h)) && s.mesh.is_border(h) && edge_ratio(s, h) < 0.75)
        candidates.push_back({ edge_ratio(s, h), h });
    std::stable_sort(candidates.begin(), candidates.end());
    for(const auto& candidate : candidates) {
      const Index h = candidate.second;
      if(!s.mesh.is_face(s.mesh.face(h)) || !s.mesh.is_border(h)) continue;
      const Chord c = chord_through(s.mesh, h);
      if(removal_rank(s, c) >= 1 || !is_chord_collapse_allowed(s, c)) continue;
      const Index curves[2] = { s.mesh.curve(c.rungs.front()), s.mesh.curve(c.rungs.back()) };
      describe_chord_collapse(s, c, cavity);
      if(!cavity.close() || cavity.worst_after() < (std::min)(0.2, cavity.worst_before())) continue;
      cavity.commit();
      s.count("chord collapse");
      ++removed;
      for(Index k : curves) {
        touched[k] = 1;
        smooth_curve(s, k, 3);
      }
      again = true;
    }
  }
  for(std::size_t k = 0; k < touched.size(); ++k)
    if(touched[k]) smooth_curve(s, Index(k), 10);
  if(removed > 0) smooth(s, 5);
  return removed;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_BOUNDARY_COARSENING_H
