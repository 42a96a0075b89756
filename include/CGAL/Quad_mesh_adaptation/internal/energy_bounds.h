// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ENERGY_BOUNDS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ENERGY_BOUNDS_H

#include <CGAL/Quad_mesh_adaptation/internal/crease_sides.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// What can be said of the change of energy without describing a cavity, let alone relaxing it.
class Energy_bounds
{
public:
  Energy_bounds(Adaptation_state& s, int max_valence) : s_(s), max_valence_(max_valence) {}

  // Has v more faces than any inner node may have?
  bool is_crowded(Index v) const
  {
    const Vertex_record& r = s_.mesh.vertex(v);
    return s_.images_at(r) * r.faces > max_valence_ && r.faces > r.ideal_faces;
  }

  // Change of the valence term if v gets d more faces; of creases no more than can be.  `relief`:
  // a crowded node gives one of these.
  double valence_change(Index v, int d, bool relief = false) const
  {
    const Vertex_record& r = s_.mesh.vertex(v);
    if(d == -1 && r.faces == 3 && r.carrier == Carrier::surface) // goes as a doublet
      return -s_.valence_energy(3, r) - s_.energy.face - 2 * s_.energy.valence;
    const int images = s_.images_at(r);
    // at a mirror plane six may be a step on the way out of eight
    const int most = images > 1 && relief ? 6 : max_valence_;
    if(d > 0 && (images > 1 || !s_.mesh.is_border_vertex(v)) && images * (r.faces + d) > most)
      return 1e6;
    return s_.valence_energy(r.faces + d, r) - s_.valence_energy(r.faces, r) + side_change(v, d);
  }

  // What the shapes and sizes of the star of v cost above the bare faces.
  double slack(Index v) const
  {
    double sum = 0;
    for(Index h : s_.mesh.outgoing(v)) sum += s_.cached_energy(s_.mesh.face(h)) - s_.energy.face;
    return sum;
  }

  // What the faces about a and c cost at least for being too large once face f between these two
  // is closed: the area stays, in units of the squares wanted there, and one face less shares it.
  // No bound if nodes further out move, too: of the operations that pay by this one in two to six
  // hundred is lost, of the others every third need not be tried.
  double oversize_without(Index f, Index a, Index c) const
  {
    double squares = -squares_in(f); // f is about both
    int faces = -2;
    for(Index v : { a, c })
      for(Index h : s_.mesh.outgoing(v)) {
        squares += squares_in(s_.mesh.face(h));
        ++faces;
      }
    return faces > 0 ? faces * s_.energy.oversize_cost(std::sqrt(squares / faces)) : 0.;
  }

private:
  double side_change(Index v, int d) const
  {
    const int before = std::abs(side_difference(s_, v));
    if(before == 0) return 0.;
    return side_energy(s_, (std::max)(0, before - std::abs(d))) - side_energy(s_, before);
  }

  // The area of face f in units of the square wanted there.
  double squares_in(Index f) const
  {
    double sum = 0;
    for(Index v : s_.mesh.quad(f)) sum += s_.mesh.vertex(v).h;
    const double factor = s_.factors.is_known(f) ? s_.factors[f] : 0.25;
    const double h = (std::max)(factor * sum, s_.face_floor(f));
    return 0.5 * norm(area_vector(s_.corners(f))) / (h * h);
  }

  Adaptation_state& s_;
  int max_valence_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ENERGY_BOUNDS_H
