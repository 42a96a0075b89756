// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_RING_COARSENING_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_RING_COARSENING_H

#include <CGAL/Quad_mesh_adaptation/internal/clean_up.h>
#include <CGAL/Quad_mesh_adaptation/internal/operators/ring_collapse.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Ring coarsening inside a region (Dewey's AQCRC as the paper uses it): rings that lie in the
// region are collapsed, long ones first, until the region has as many faces as its sizes ask for.
class Ring_coarsening
{
public:
  // region: per face.  longest: faces in the row that a ring goes about.
  Ring_coarsening(Adaptation_state& s, const std::vector<char>& region, std::size_t longest)
      : s_(s), region_(region), longest_(longest), cavity_(s)
  {
  }

  // One batch of rings that do not touch each other; returns the number of faces removed.
  std::size_t batch()
  {
    const Quad_complex& m = s_.mesh;
    used_.assign(m.vertex_end(), 0);
    double wanted = 0;
    std::size_t count = 0;
    std::vector<std::pair<double, Index>> order;
    for(Index f = 0; f < m.face_end(); ++f) {
      if(!in_region(f)) continue;
      const double r = s_.size_ratio(f);
      wanted += r * r;
      ++count;
      order.push_back({ r, f });
    }
    std::stable_sort(order.begin(), order.end());
    std::size_t removed = 0;
    for(const auto& o : order) {
      if(double(count - removed) <= wanted) break;
      s_.check_cancelled();
      if(in_region(o.second)) removed += collapse_about(o.second, count - removed, wanted);
    }
    return removed;
  }

private:
  bool in_region(Index f) const
  {
    return f < Index(region_.size()) && region_[f] && s_.mesh.is_face(f);
  }

  // The longest legal ring about a row that starts at face f, in either direction.
  std::size_t collapse_about(Index f, std::size_t count, double wanted)
  {
    std::vector<Index> rows[2];
    for(int i = 0; i < 2; ++i)
      rows[i] = row_of_faces(s_.mesh, 4 * f + i, longest_, [&](Index g) { return in_region(g); });
    if(rows[1].size() > rows[0].size()) std::swap(rows[0], rows[1]);
    for(const std::vector<Index>& row : rows)
      for(std::size_t n = row.size(); n >= 1; n = n / 2) {
        const Ring ring = ring_about(s_.mesh, { row.begin(), row.begin() + std::ptrdiff_t(n) });
        if(double(count - (std::min)(count, ring.faces.size())) < 0.9 * wanted) continue;
        if(try_ring(ring)) return ring.faces.size();
      }
    return 0;
  }

  bool try_ring(const Ring& ring)
  {
    for(Index f : ring.faces) {
      if(!in_region(f)) return false;
      for(Index v : s_.mesh.quad(f))
        if(used_[v]) return false;
    }
    if(!is_ring_collapse_allowed(s_, ring)) return false;
    describe_ring_collapse(s_, ring, cavity_);
    if(!cavity_.close()) return false;
    cavity_.relax(4);
    if(cavity_.worst_after() < (std::min)(0.25, cavity_.worst_before())) return false;
    std::vector<Index> touched;
    cavity_.commit(&touched);
    s_.count(ring.border_rungs.empty() ? "ring collapse" : "half-ring collapse");
    for(Index v : touched) used_[v] = 1;
    return true;
  }

  Adaptation_state& s_;
  const std::vector<char>& region_;
  std::size_t longest_;
  Cavity cavity_;
  std::vector<char> used_;
};

// Faces that form no contiguous region with others are not coarsened.
inline std::vector<char> faces_to_coarsen(const Adaptation_state& s, double threshold)
{
  std::vector<char> region(s.mesh.face_end(), 0);
  for(Index f = 0; f < s.mesh.face_end(); ++f)
    region[f] = s.mesh.is_face(f) && s.size_ratio(f) < threshold;
  return region;
}

// Interior coarsening, step 3 of section 3.3, with the clean-up inside.  Returns faces removed.
inline std::size_t coarsen_by_rings(Adaptation_state& s, double threshold,
                                    const Improvement_options& clean)
{
  std::size_t total = 0;
  {
    Phase_scope phase(s, "coarsening");
    for(int batch = 0; batch < 20; ++batch) {
      const std::vector<char> region = faces_to_coarsen(s, threshold);
      Ring_coarsening rings(s, region, 16);
      const std::size_t removed = rings.batch();
      total += removed;
      if(removed == 0) break;
      smooth(s, 3);
    }
  }
  if(total > 0) clean_up(s, clean, 4, 3);
  return total;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_RING_COARSENING_H
