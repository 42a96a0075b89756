// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ROW_TRADES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ROW_TRADES_H

#include <CGAL/Quad_mesh_adaptation/internal/Cavity.h>
#include <CGAL/Quad_mesh_adaptation/internal/Chord.h>
#include <CGAL/Quad_mesh_adaptation/internal/Kept_shape.h>
#include <CGAL/Quad_mesh_adaptation/internal/Mesh_keeper.h>
#include <CGAL/Quad_mesh_adaptation/internal/detours.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/chord_collapse.h>
#include <CGAL/Quad_mesh_adaptation/internal/progressive_run.h>
#include <CGAL/Quad_mesh_adaptation/internal/smoothing.h>
#include <CGAL/Quad_mesh_adaptation/internal/split_templates.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// One row out and a shorter one in: 3 x 3 faces become 2 x 4.  Each of both alone leaves faces too
// large or adds some, so that no search by energy takes the first step.
class Row_trades
{
public:
  Row_trades(Adaptation_state& s, const Improvement_options& clean) : s_(s), clean_(clean) {}

  // As long as one helps and work is left.
  void operator()()
  {
    while(relative_demerits(s_) > usual_demerits && is_any_good()) {
    }
  }

private:
  // Tries all until one helps.
  bool is_any_good()
  {
    const double least = clearly_less * demerits(s_);
    const Index faces = s_.mesh.number_of_faces();
    if(!kept_) kept_.emplace(s_);
    for(const Chord& c : chords()) { // they stay the same while the mesh is restored
      Mesh_keeper before(s_);
      if(take_out(c) && is_better_with_another(faces, least)) return true;
      before.restore();
      if(work_left_ < 0) return false;
    }
    return false;
  }

  // After a row has gone: another one in, with less faces than there were.
  bool is_better_with_another(Index faces, double least)
  {
    for(const Chord& c : chords()) {
      if(work_left_ < 0) return false;
      if(s_.mesh.number_of_faces() + Index(c.faces.size()) >= faces) continue;
      Mesh_keeper before(s_);
      if(put_in(c) && are_sizes_met() && demerits(s_) < least && kept_->accepts(s_)) return true;
      before.restore();
    }
    return false;
  }

  std::vector<Chord> chords() const
  {
    std::vector<Chord> list;
    for_each_chord(s_.mesh, [&](const Chord& c, Index) { list.push_back(c); });
    return list;
  }

  bool take_out(const Chord& c)
  {
    if(!is_chord_collapse_allowed(s_, c)) return false;
    Cavity cavity(s_);
    describe_chord_collapse(s_, c, cavity);
    if(!cavity.close()) return false;
    cavity.commit();
    s_.count("chord collapse");
    return true;
  }

  bool put_in(const Chord& c)
  {
    const Quad_complex& m = s_.mesh;
    std::vector<char> split(4 * std::size_t(m.face_end()), 0);
    for(Index h : c.rungs) {
      if(m.curve(h) >= 0 && s_.curves[m.curve(h)].is_frozen()) return false;
      split[h] = 1;
      if(m.opposite(h) >= 0) split[m.opposite(h)] = 1;
    }
    Split_templates(s_, split)();
    s_.disturb_all();
    return true;
  }

  // The most of what a trial takes, unless it is a good one.
  bool are_sizes_met()
  {
    s_.check_cancelled();
    work_left_ -= double(s_.mesh.number_of_faces());
    {
      const Pressing within_sizes(s_.smoothing);
      smooth(s_, 20);
    }
    if(faces_too_large(s_).size() > few) return false;
    polish(s_, clean_, 2, 0);
    return faces_too_large(s_).empty();
  }

  static constexpr std::size_t few = 2; // for clean-up to see to

  Adaptation_state& s_;
  const Improvement_options clean_;
  std::optional<Kept_shape> kept_; // by all trades so far
  double work_left_ = 5000;        // faces in all trials
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ROW_TRADES_H
