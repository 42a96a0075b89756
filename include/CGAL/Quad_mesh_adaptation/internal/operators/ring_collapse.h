// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_RING_COLLAPSE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_RING_COLLAPSE_H

#include <CGAL/Quad_mesh_adaptation/internal/Chord.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/chord_collapse.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// A ring of faces about a block of faces: the faces that share a node with the block.  Its rungs
// are the edges that leave the block.  About a block at the border it is a half-ring, which
// starts and ends on the border.
struct Ring
{
  std::vector<Index> block, faces;
  std::vector<Index> rungs;        // half-edges that start at a node of the block
  std::vector<Index> border_rungs; // the same where only the opposite direction has a face
};

inline Ring ring_about(const Quad_complex& m, const std::vector<Index>& block)
{
  Ring ring;
  ring.block = block;
  std::sort(ring.block.begin(), ring.block.end());
  const auto in_block = [&](Index f) {
    return std::binary_search(ring.block.begin(), ring.block.end(), f);
  };
  std::vector<Index> nodes, out;
  for(Index f : block)
    for(Index v : m.quad(f)) nodes.push_back(v);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  for(Index v : nodes) {
    m.outgoing(v, out);
    for(Index h : out) {
      if(!in_block(m.face(h))) ring.faces.push_back(m.face(h));
      const Index o = m.opposite(h);
      if(!in_block(m.face(h)) && (o < 0 || !in_block(m.face(o)))) ring.rungs.push_back(h);
    }
    const Index last = m.prev(out.back());
    if(m.is_border(last) && !in_block(m.face(last))) ring.border_rungs.push_back(last);
  }
  std::sort(ring.faces.begin(), ring.faces.end());
  ring.faces.erase(std::unique(ring.faces.begin(), ring.faces.end()), ring.faces.end());
  return ring;
}

// The merges of a ring collapse: (outer node, block node); empty if two rungs share an outer node
// or the carriers forbid one.
inline std::vector<Node_merge> ring_merges(const Adaptation_state& s, const Ring& ring)
{
  const Quad_complex& m = s.mesh;
  std::vector<Node_merge> merges;
  std::vector<Index> outer;
  Closed_curve_check closed_curves(s);
  const auto add = [&](Index h, Index inside, Index outside) {
    if(!is_rung_collapsible(s, h)) return false;
    const bool keep_outer = carrier_rank(m.vertex(outside)) > carrier_rank(m.vertex(inside));
    merges.push_back({ keep_outer ? inside : outside, keep_outer ? outside : inside });
    outer.push_back(outside);
    closed_curves.add(m.curve(h), { inside, outside });
    return true;
  };
  for(Index h : ring.rungs)
    if(!add(h, m.origin(h), m.target(h))) return {};
  for(Index h : ring.border_rungs)
    if(!add(h, m.target(h), m.origin(h))) return {};
  if(!closed_curves()) return {};
  std::sort(outer.begin(), outer.end());
  if(std::adjacent_find(outer.begin(), outer.end()) != outer.end()) return {};
  // a block node may lose to one outer node only, and then takes in no other
  std::vector<Index> losers;
  for(const Node_merge& g : merges) losers.push_back(g.loser);
  std::sort(losers.begin(), losers.end());
  if(std::adjacent_find(losers.begin(), losers.end()) != losers.end()) return {};
  for(const Node_merge& g : merges)
    if(std::binary_search(losers.begin(), losers.end(), g.winner)) return {};
  return merges;
}

// Ring collapse: every outer node of a rung merges with its node of the block, the faces of the
// ring disappear.  F - k for a ring of k faces.
inline bool is_ring_collapse_allowed(const Adaptation_state& s, const Ring& ring)
{
  return !ring.faces.empty() &&
         Index(ring.faces.size() + ring.block.size()) < s.mesh.number_of_faces() &&
         !ring_merges(s, ring).empty();
}

inline void describe_ring_collapse(Adaptation_state& s, const Ring& ring, Cavity& cavity)
{
  const Quad_complex& m = s.mesh;
  const std::vector<Node_merge> merges = ring_merges(s, ring);
  cavity.clear();
  describe_merge(s, merges, ring.faces, cavity);
  for(const Node_merge& g : merges) {
    Vertex_record& w = cavity.nodes[cavity.node(g.winner)];
    if(w.carrier != Carrier::surface || w.frozen) continue;
    w.p = 0.5 * (w.p + m.point(g.loser));
    s.place(w);
  }
}

// Faces in a row along the chord of h, as long as `inside` holds, at most `longest`, the face of
// h first.
template <typename Inside>
std::vector<Index> row_of_faces(const Quad_complex& m, Index h, std::size_t longest,
                                const Inside& inside)
{
  std::vector<Index> row;
  for(Index g = h; row.size() < longest;) {
    const Index f = m.face(g);
    if(!inside(f) || std::find(row.begin(), row.end(), f) != row.end()) break;
    row.push_back(f);
    const Index o = m.opposite(m.next(m.next(g)));
    if(o < 0) break;
    g = o;
  }
  return row;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_RING_COLLAPSE_H
