// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "places.h"

#include <CGAL/Quad_mesh_adaptation/internal/operators/border_half_ring.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/chord_collapse.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/corner_split.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/crease_collapse.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/edge_swap.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/face_close.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/face_open.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/quad_insertion.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/ring_collapse.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/vertex_rotation.h>

#include <cstddef>
#include <string>
#include <vector>

namespace places {

void add_closes(const Adaptation_state& s, std::vector<Place>& list)
{
  const Quad_complex& m = s.mesh;
  for(Index h : m.halfedges()) {
    if(!core::is_face_close_allowed(s, h)) continue;
    Place p{ "face close at half-edge " + std::to_string(h),
             [h](Adaptation_state& t, Cavity& c) { core::describe_face_close(t, h, c); },
             -1,
             -1,
             0,
             {} };
    p.corners[m.target(h)] = p.corners[m.origin(m.prev(h))] = -1;
    list.push_back(p);
  }
}

void add_opens(const Adaptation_state& s, std::vector<Place>& list)
{
  const Quad_complex& m = s.mesh;
  std::vector<Index> out;
  for(Index v : m.vertices()) {
    m.outgoing(v, out);
    for(std::size_t i = 0; i < out.size(); ++i)
      for(std::size_t j = 0; j < out.size(); ++j) {
        const Index a = out[i], b = out[j];
        if(!core::is_face_open_allowed(s, a, b)) continue;
        const int sector = int((j + out.size() - i) % out.size());
        Place p{ "face open at half-edges " + std::to_string(a) + " " + std::to_string(b),
                 [a, b](Adaptation_state& t, Cavity& c) { core::describe_face_open(t, a, b, c); },
                 1,
                 1,
                 0,
                 {} };
        p.corners[v] = 1 - sector;
        ++p.corners[m.target(a)];
        ++p.corners[m.target(b)];
        list.push_back(p);
      }
  }
}

void add_swaps(const Adaptation_state& s, std::vector<Place>& list)
{
  const Quad_complex& m = s.mesh;
  for(Index h : m.halfedges()) {
    if(m.opposite(h) < h || !core::is_edge_swap_allowed(s, h)) continue;
    const Index o = m.opposite(h);
    for(bool left : { true, false }) {
      Place p{
        std::string(left ? "left" : "right") + " edge swap at half-edge " + std::to_string(h),
        [h, left](Adaptation_state& t, Cavity& c) { core::describe_edge_swap(t, h, left, c); },
        0,
        0,
        0,
        {}
      };
      --p.corners[m.origin(h)];
      --p.corners[m.target(h)];
      ++p.corners[left ? m.target(m.next(h)) : m.origin(m.prev(h))];
      ++p.corners[left ? m.target(m.next(o)) : m.origin(m.prev(o))];
      list.push_back(p);
    }
  }
}

void add_corner_splits(const Adaptation_state& s, std::vector<Place>& list)
{
  const Quad_complex& m = s.mesh;
  for(Index h : m.halfedges()) {
    const core::Corner_split split = core::corner_split_at(m, h);
    if(!core::is_corner_split_allowed(s, split)) continue;
    Place p{ "corner split at half-edge " + std::to_string(h),
             [split](Adaptation_state& t, Cavity& c) { core::describe_corner_split(t, split, c); },
             3,
             3,
             0,
             {} };
    ++p.corners[m.origin(h)];
    --p.corners[m.target(m.next(h))];
    ++p.corners[m.origin(m.prev(split.left))];
    ++p.corners[m.target(m.next(split.right))];
    list.push_back(p);
  }
}

void add_insertions(const Adaptation_state& s, std::vector<Place>& list)
{
  for(Index f = 0; f < s.mesh.face_end(); ++f) {
    if(!core::is_quad_insertion_allowed(s, f)) continue;
    Place p{ "quad insertion in face " + std::to_string(f),
             [f](Adaptation_state& t, Cavity& c) { core::describe_quad_insertion(t, f, c); },
             4,
             4,
             0,
             {} };
    for(Index v : s.mesh.quad(f)) ++p.corners[v];
    list.push_back(p);
  }
}

void add_rotations(const Adaptation_state& s, std::vector<Place>& list)
{
  const Quad_complex& m = s.mesh;
  std::vector<Index> out;
  for(Index v : m.vertices()) {
    if(!core::is_vertex_rotation_allowed(s, v)) continue;
    Place p{ "vertex rotation at " + std::to_string(v),
             [v](Adaptation_state& t, Cavity& c) { core::describe_vertex_rotation(t, v, c); },
             0,
             0,
             0,
             {} };
    m.outgoing(v, out);
    for(Index h : out) {
      --p.corners[m.target(h)];
      ++p.corners[m.target(m.next(h))];
    }
    p.corners[v] = 0;
    list.push_back(p);
  }
}

void add_border_pairs(const Adaptation_state& s, std::vector<Place>& list)
{
  core::Border_pair b;
  for(Index v : s.mesh.vertices()) {
    if(!core::find_border_pair(s.mesh, v, b)) continue;
    const std::string at = " at vertex " + std::to_string(v);
    if(core::is_half_ring_collapse_allowed(s, b))
      list.push_back(
          { "half-ring collapse" + at,
            [b](Adaptation_state& t, Cavity& c) { core::describe_half_ring_collapse(t, b, c); },
            -2,
            -3,
            -2,
            { { b.p, -1 }, { b.q, -1 } } });
    if(core::is_border_split_allowed(s, b))
      list.push_back(
          { "border split" + at,
            [b](Adaptation_state& t, Cavity& c) { core::describe_border_split(t, b, c); },
            4,
            5,
            2,
            { { b.p, 1 }, { b.q, 1 }, { v, 0 }, { b.m, 0 } } });
  }
}

void add_crease_collapses(const Adaptation_state& s, std::vector<Place>& list)
{
  const Quad_complex& m = s.mesh;
  core::Crease_star star;
  for(Index v : m.vertices()) {
    if(!core::find_crease_star(m, v, star)) continue;
    if(!core::is_crease_collapse_allowed(s, star)) continue;
    Place p{ "crease collapse about vertex " + std::to_string(v),
             [star](Adaptation_state& t, Cavity& c) { core::describe_crease_collapse(t, star, c); },
             -2,
             -2,
             0,
             {} };
    for(const std::vector<Index>& side : star.spokes)
      for(std::size_t i = 1; i + 1 < side.size(); ++i) --p.corners[m.target(side[i])];
    list.push_back(p);
  }
}

void add_chords(const Adaptation_state& s, std::vector<Place>& list)
{
  const Quad_complex& m = s.mesh;
  for(Index h : m.halfedges()) {
    const core::Chord chord = core::chord_through(m, h);
    if(chord.rungs.front() != h || !core::is_chord_collapse_allowed(s, chord)) continue;
    const long n = long(chord.faces.size());
    list.push_back(
        { "chord collapse from half-edge " + std::to_string(h),
          [chord](Adaptation_state& t, Cavity& c) { core::describe_chord_collapse(t, chord, c); },
          -n,
          chord.is_closed ? -n : -n - 1,
          chord.is_closed ? 0 : -2,
          {} });
  }
}

namespace {

long rungs_on_border(const Quad_complex& m, const core::Ring& ring)
{
  long n = long(ring.border_rungs.size());
  for(Index h : ring.rungs) n += m.is_border(h);
  return n;
}

} // namespace

void add_rings(const Adaptation_state& s, std::vector<Place>& list)
{
  const Quad_complex& m = s.mesh;
  for(Index h : m.halfedges()) {
    for(std::size_t n : { 1, 2, 4 }) {
      if(n == 1 && (h & 3) != 0) continue;
      const std::vector<Index> block =
          core::row_of_faces(m, h, n, [&](Index f) { return m.is_face(f); });
      if(block.size() != n) continue;
      const core::Ring ring = core::ring_about(m, block);
      if(!core::is_ring_collapse_allowed(s, ring)) continue;
      const long k = long(ring.faces.size());
      const long merges = long(core::ring_merges(s, ring).size());
      list.push_back(
          { "collapse of the ring about " + std::to_string(n) + " faces at half-edge " +
                std::to_string(h),
            [ring](Adaptation_state& t, Cavity& c) { core::describe_ring_collapse(t, ring, c); },
            -k,
            -merges,
            -rungs_on_border(m, ring),
            {} });
    }
  }
}

std::vector<Place> all_places(const Adaptation_state& s)
{
  std::vector<Place> list;
  add_closes(s, list);
  add_opens(s, list);
  add_swaps(s, list);
  add_rotations(s, list);
  add_border_pairs(s, list);
  add_crease_collapses(s, list);
  add_corner_splits(s, list);
  add_insertions(s, list);
  add_chords(s, list);
  add_rings(s, list);
  return list;
}

} // namespace places
