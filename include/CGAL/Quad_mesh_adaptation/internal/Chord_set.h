// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHORD_SET_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHORD_SET_H

#include <CGAL/Quad_mesh_adaptation/internal/Merged_nodes.h>
#include <CGAL/Quad_mesh_adaptation/internal/Walk.h>
#include <CGAL/Quad_mesh_adaptation/internal/changed_face_quality.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/chord_collapse.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// All chords of a mesh, and a choice of them that can be collapsed at the same time: they may cross
// but not touch each other, so that two nodes become one, or the four of a face in which two cross.
class Chord_set
{
public:
  static constexpr const char* operation = "chord collapse";

  explicit Chord_set(const Adaptation_state& s) : s_(s)
  {
    const Quad_complex& m = s.mesh;
    chord_of_.assign(2 * std::size_t(m.face_end()), -1);
    others_.assign(m.vertex_end(), { -1, -1 });
    for(Index f : m.faces())
      for(Index i = 0; i < 2; ++i)
        if(chord_of_[2 * f + i] < 0) add(chord_through(m, 4 * f + i));
  }

  Index size() const { return Index(chords_.size()); }
  bool may_go(Index c) const { return chords_[c].may_go; }
  // Mean length of the rungs in wanted sizes.
  float width(Index c) const { return chords_[c].width; }
  std::size_t number_of_chosen() const { return chosen_; }

  // Is face f of a chord that is chosen?
  bool removes(Index f) const
  {
    return chords_[chord_of_[2 * f]].is_chosen || chords_[chord_of_[2 * f + 1]].is_chosen;
  }

  template <typename Visit>
  void for_each_chosen_rung(const Visit& visit) const
  {
    for(const Record& c : chords_)
      if(c.is_chosen)
        for(std::size_t i = c.first; i < c.first + c.number; ++i) visit(rungs_[i]);
  }

  // An independent set of chords that are narrower than `widest`, the narrowest first.
  void choose_narrow(double widest)
  {
    std::vector<std::pair<float, Index>> list; // rounded: equals are told by the order
    for(Index c = 0; c < size(); ++c)
      if(may_go(c) && width(c) < widest) list.push_back({ width(c), c });
    put_in_order(list, s_.order);
    std::stable_sort(list.begin(), list.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for(const auto& candidate : list) choose(candidate.second);
  }

  // Would face f be longer than `limit` sizes?
  bool is_too_long(Index f, const Merged_nodes& nodes, double limit) const
  {
    const auto node = [&](Index v) -> const Vertex_record& { return nodes.node(v); };
    return is_changed_face_longer(s_.mesh.quad(f), node, limit);
  }

  // The other side of a face of a chosen chord.
  static Index across(Index h) { return Quad_complex::next(Quad_complex::next(h)); }

  // Adds chord c to the choice if it touches none of it.
  void choose(Index c)
  {
    Record& r = chords_[c];
    for(std::size_t i = r.first; i < r.first + r.number; ++i)
      if(!add_rung(rungs_[i])) {
        while(i > r.first) remove_rung(rungs_[--i]);
        return;
      }
    r.is_chosen = true;
    ++chosen_;
  }

  // Leaves out the chords with a rung at node v.
  void leave_out_about(Index v)
  {
    const Quad_complex& m = s_.mesh;
    for(Index h : m.outgoing(v)) {
      leave_out(chord_of_[2 * m.face(h)]);
      leave_out(chord_of_[2 * m.face(h) + 1]);
    }
  }

private:
  struct Record
  {
    std::size_t first, number; // of the rungs
    float width;
    bool may_go, is_chosen;
  };

  void add(const Chord& c)
  {
    const Quad_complex& m = s_.mesh;
    const Index number = size();
    for(std::size_t i = 0; i < c.faces.size(); ++i)
      chord_of_[2 * c.faces[i] + (c.rungs[i] & 1)] = number;
    double width = 0;
    bool may_go = true;
    for(Index h : c.rungs) {
      const Vertex_record &u = m.vertex(m.origin(h)), &v = m.vertex(m.target(h));
      width += 2 * distance(u.p, v.p) / (u.h + v.h);
      may_go = may_go && is_rung_collapsible(s_, h) && s_.is_to_work_on(m.origin(h)) &&
               s_.is_to_work_on(m.target(h));
    }
    width /= double(c.rungs.size());
    chords_.push_back({ rungs_.size(), c.rungs.size(), float(width), may_go, false });
    rungs_.insert(rungs_.end(), c.rungs.begin(), c.rungs.end());
  }

  void leave_out(Index c)
  {
    if(!chords_[c].is_chosen) return;
    chords_[c].is_chosen = false;
    --chosen_;
  }

  // Rungs at a node: none, one, or two of a face in which chosen chords cross.
  bool add_rung(Index h)
  {
    const Quad_complex& m = s_.mesh;
    const Index o = m.opposite(h), u = m.origin(h), v = m.target(h);
    const bool fits = fits_at(u, m.prev(h), o < 0 ? Index(-1) : m.next(o)) &&
                      fits_at(v, m.next(h), o < 0 ? Index(-1) : m.prev(o));
    if(!fits) return false;
    slot(u, -1) = v;
    slot(v, -1) = u;
    return true;
  }

  void remove_rung(Index h)
  {
    const Index u = s_.mesh.origin(h), v = s_.mesh.target(h);
    slot(u, v) = -1;
    slot(v, u) = -1;
  }

  // Side edges g and h at node u of the faces beside a rung: is one of them the other rung there?
  bool fits_at(Index u, Index g, Index h) const
  {
    const std::array<Index, 2>& others = others_[u];
    if(others[0] >= 0 && others[1] >= 0) return false;
    const Index other = (std::max)(others[0], others[1]);
    if(other < 0) return true;
    for(Index side : { g, h })
      if(side >= 0 && other_end(side, u) == other) return may_become_one(s_.mesh.face(side));
    return false;
  }

  Index other_end(Index h, Index u) const
  {
    return s_.mesh.origin(h) == u ? s_.mesh.target(h) : s_.mesh.origin(h);
  }

  // May the four nodes of a face become one?  Those of curves only along curves, and one corner.
  bool may_become_one(Index f) const
  {
    const Quad_complex& m = s_.mesh;
    int held = 0, corners = 0, edges = 0;
    for(Index h = 4 * f; h < 4 * f + 4; ++h) {
      const int here = carrier_rank(m.vertex(m.origin(h)));
      held += here > 0 ? 1 : 0;
      corners += here > 1 ? 1 : 0;
      edges += m.curve(h) >= 0 ? 1 : 0;
    }
    return corners <= 1 && (held <= 1 || edges == held - 1);
  }

  Index& slot(Index u, Index content)
  {
    return others_[u][0] == content ? others_[u][0] : others_[u][1];
  }

  const Adaptation_state& s_;
  std::vector<Record> chords_;
  std::vector<Index> rungs_;                 // of all chords
  std::vector<Index> chord_of_;              // that crosses sides i and i + 2 of face f: 2 f + i
  std::vector<std::array<Index, 2>> others_; // the other ends of chosen rungs at a node
  std::size_t chosen_ = 0;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHORD_SET_H
