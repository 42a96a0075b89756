// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ROW_INSERTION_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ROW_INSERTION_H

#include <CGAL/Quad_mesh_adaptation/internal/Chord.h>
#include <CGAL/Quad_mesh_adaptation/internal/Phase_scope.h>
#include <CGAL/Quad_mesh_adaptation/internal/faults.h>
#include <CGAL/Quad_mesh_adaptation/internal/large_mesh.h>
#include <CGAL/Quad_mesh_adaptation/internal/nodes_around.h>
#include <CGAL/Quad_mesh_adaptation/internal/smoothing.h>
#include <CGAL/Quad_mesh_adaptation/internal/split_templates.h>
#include <CGAL/Quad_mesh_adaptation/internal/total_energy.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Refinement of regular parts by less than halving: here and there a whole chord is split along its
// length into two rows, which makes no irregular node, and smoothing spreads what that gains over
// the rows on both sides.  Only chords that are too wide by much the same all along are split;
// where the size varies along them that is the work of the templates.
class Row_insertion
{
public:
  explicit Row_insertion(Adaptation_state& s) : s_(s) {}

  // One batch of chords, as many as their width asks for, evenly spread; keeps it only if the
  // energy falls.  Returns the number of faces added.
  std::size_t batch()
  {
    const std::vector<char> split = marks();
    if(std::find(split.begin(), split.end(), 1) == split.end()) return 0;
    const Quad_complex before = s_.mesh;
    const auto operations = s_.operations;
    const double energy = total_energy(s_);
    Split_templates(s_, split)();
    s_.disturb_all();
    spread();
    if(total_energy(s_) < energy)
      return std::size_t(s_.mesh.number_of_faces() - before.number_of_faces());
    s_.mesh = before;
    s_.operations = operations;
    s_.forget_faces();
    s_.disturb_all();
    return 0;
  }

private:
  // Smooths; in a large mesh not to the last, since other rows and the templates follow.
  void spread()
  {
    const Short_smoothing coarse(s_);
    smooth(s_, 20);
  }

  static constexpr double most_uneven = 0.15; // standard deviation of the width along a chord

  static constexpr double nearly_twice = 1.9; // wider rows are all halved by the templates

  struct Candidate
  {
    double width; // over the wanted size, mean
    Index h;
  };

  // Per half-edge, whether its edge is split.
  std::vector<char> marks() const
  {
    const Quad_complex& m = s_.mesh;
    std::vector<char> split(4 * std::size_t(m.face_end()), 0), used(m.vertex_end(), 0);
    for(const Candidate& c : candidates()) {
      const Chord chord = chord_through(m, c.h);
      const auto is_used = [&](Index h) { return used[m.origin(h)] || used[m.target(h)]; };
      if(std::any_of(chord.rungs.begin(), chord.rungs.end(), is_used)) continue;
      for(Index h : chord.rungs) {
        split[h] = 1;
        if(m.opposite(h) >= 0) split[m.opposite(h)] = 1;
      }
      // one row more for each 1 / (width - 1) rows
      const double rows = (std::min)(1 / (c.width - 1), double(m.face_end()));
      mark_nodes_around(s_.mesh, chord.faces, (std::max)(int(std::lround(rows)) - 2, 0), used);
    }
    return split;
  }

  // The chords worth splitting, the widest first.
  std::vector<Candidate> candidates() const
  {
    std::vector<Candidate> list;
    for_each_chord(s_.mesh, [&](const Chord& c, Index h) {
      const double width = steady_width(c);
      if(width > size_tolerance && width < nearly_twice && are_faces_too_large(c))
        list.push_back({ width, h });
    });
    std::stable_sort(list.begin(), list.end(),
                     [](const Candidate& a, const Candidate& b) { return a.width > b.width; });
    return list;
  }

  // Mean width over the wanted size; 0 where it is uneven, where only a part is too wide, or where
  // it must not change.
  double steady_width(const Chord& c) const
  {
    const Quad_complex& m = s_.mesh;
    double sum = 0, squares = 0, wide = 0;
    for(Index h : c.rungs) {
      if(m.curve(h) >= 0 && s_.curves[m.curve(h)].is_frozen()) return 0;
      const Vertex_record &u = m.vertex(m.origin(h)), &v = m.vertex(m.target(h));
      const double w = 2 * distance(u.p, v.p) / (u.h + v.h);
      sum += w;
      squares += w * w;
      wide += w > size_tolerance;
    }
    const double n = double(c.rungs.size()), mean = sum / n;
    if(wide < 0.9 * n) return 0;
    const double variance = squares / n - mean * mean;
    return variance < most_uneven * most_uneven * mean * mean ? mean : 0;
  }

  bool are_faces_too_large(const Chord& c) const
  {
    double sum = 0;
    for(Index f : c.faces) sum += s_.size_ratio(f);
    return sum > size_tolerance * double(c.faces.size());
  }

  Adaptation_state& s_;
};

// Batches until none pays, or in a large mesh until one adds few faces; returns the number of faces
// added.
inline std::size_t insert_rows(Adaptation_state& s)
{
  constexpr std::size_t few = 100; // one face in so many
  Phase_scope phase(s, "refinement");
  Row_insertion rows(s);
  // rows a little above the limit must go, too: local operations would mend them at a higher price
  const double tolerated = s.energy.tolerated;
  s.energy.tolerated *= 0.97;
  s.forget_energies();
  std::size_t total = 0;
  for(int batch = 0; batch < 12; ++batch) {
    s.check_cancelled();
    const std::size_t added = rows.batch();
    total += added;
    if(added == 0) break;
    if(is_large(s) && few * added < std::size_t(s.mesh.number_of_faces())) break;
  }
  s.energy.tolerated = tolerated;
  s.forget_energies();
  return total;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ROW_INSERTION_H
