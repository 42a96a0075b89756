// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHORD_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHORD_H

#include <CGAL/Quad_mesh_adaptation/internal/Quad_complex.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// A chord: quads joined through opposite edges, from border to border or closed.
struct Chord
{
  std::vector<Index> rungs; // half-edges crossed, each with the face it enters on its left; the
                            // last rung of an open chord is the half-edge of its last face that
                            // lies on the border
  std::vector<Index> faces;
  bool is_closed = false;
};

// The chord through the edge of h.
inline Chord chord_through(const Quad_complex& m, Index h)
{
  const auto across = [](Index g) { return Quad_complex::next(Quad_complex::next(g)); };
  Index first = h; // go back to an end
  while(m.opposite(first) >= 0) {
    first = across(m.opposite(first));
    if(first == h) break;
  }
  Chord c;
  c.is_closed = m.opposite(first) >= 0;
  for(Index g = first;;) {
    c.rungs.push_back(g);
    c.faces.push_back(m.face(g));
    const Index exit = across(g), o = m.opposite(exit);
    if(o < 0) {
      c.rungs.push_back(exit);
      break;
    }
    if(o == first) break;
    g = o;
  }
  return c;
}

// Calls visit(chord, h) for all chords in the order of their first half-edges h.
template <typename Visit>
void for_each_chord(const Quad_complex& m, const Visit& visit)
{
  std::vector<char> seen(4 * std::size_t(m.face_end()), 0);
  for(Index h : m.halfedges()) {
    if(seen[h]) continue;
    const Chord c = chord_through(m, h);
    for(Index g : c.rungs) {
      seen[g] = 1;
      if(m.opposite(g) >= 0) seen[m.opposite(g)] = 1;
    }
    visit(c, h);
  }
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHORD_H
