// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TURNED_FACES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TURNED_FACES_H

#include <CGAL/Quad_mesh_adaptation/internal/Face_parts.h>
#include <CGAL/Quad_mesh_adaptation/internal/Quad_complex.h>
#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Where nodes of a curved surface have slid over others, few faces lie upside down on those around
// them: parts of the mesh with folds all around, where the surface turns back on itself.  Sheets
// that are meant to be folded have many faces on both sides of a fold, or a border; fins hang
// together with what they stand on.
class Turned_faces
{
public:
  // `areas`: the area vectors of the faces.  Folds are no features that are marked.
  Turned_faces(const Quad_complex& m, const std::vector<Vec>& areas)
      : m_(m), areas_(areas), parts_(m, [this](Index h) { return !is_fold(h); })
  {
    if(parts_.size() < 2) return;
    measure_parts();
    spread();
  }

  static constexpr double back = -0.5; // cosine of 120 degrees

  // Between faces of these areas.
  static bool is_fold(const Vec& a, const Vec& b)
  {
    const double product = a * b;
    return product < 0 && product * product > back * back * (a * a) * (b * b);
  }

  bool is_any() const { return is_any_; }
  // Is face f one of them?
  bool has(Index f) const { return is_any_ && part_[parts_.of(f)].is_turned; }

private:
  struct Part
  {
    std::size_t faces = 0;
    double area = 0;
    bool has_border = false, is_turned = false;
    Index sheet = -1; // the large part that it lies on, maybe itself
  };

  bool is_fold(Index h) const
  {
    return m_.curve(h) < 0 && is_fold(areas_[m_.face(h)], areas_[m_.face(m_.opposite(h))]);
  }

  void measure_parts()
  {
    constexpr std::size_t few = 12; // faces
    part_.resize(parts_.size());
    for(Index f : m_.faces()) {
      Part& part = part_[parts_.of(f)];
      ++part.faces;
      part.area += norm(areas_[f]);
      for(Index h = 4 * f; h < 4 * f + 4; ++h) part.has_border |= m_.opposite(h) < 0;
    }
    for(std::size_t k = 0; k < part_.size(); ++k)
      if(part_[k].faces > few || part_[k].has_border) part_[k].sheet = Index(k);
  }

  // From the large parts across folds: what lies beyond one is turned, beyond two it is not.
  void spread()
  {
    for(bool found = true; found;) {
      found = false;
      for(Index h : m_.halfedges()) {
        if(m_.opposite(h) < 0 || !is_fold(h)) continue;
        const Part& here = part_[parts_.of(m_.face(h))];
        Part& there = part_[parts_.of(m_.face(m_.opposite(h)))];
        if(here.sheet < 0 || there.sheet >= 0 || !is_small_on(there, here.sheet)) continue;
        there.sheet = here.sheet;
        there.is_turned = !here.is_turned;
        is_any_ = is_any_ || there.is_turned;
        found = true;
      }
    }
  }

  bool is_small_on(const Part& part, Index sheet) const
  {
    constexpr double small = 0.1;
    return part.area < small * part_[sheet].area;
  }

  const Quad_complex& m_;
  const std::vector<Vec>& areas_;
  Face_parts parts_;
  std::vector<Part> part_;
  bool is_any_ = false;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TURNED_FACES_H
