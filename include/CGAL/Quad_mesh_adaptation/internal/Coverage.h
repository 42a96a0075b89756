// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_COVERAGE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_COVERAGE_H

#include <CGAL/Quad_mesh_adaptation/internal/Quad_complex.h>
#include <CGAL/Quad_mesh_adaptation/internal/Size_sampler.h>
#include <CGAL/Quad_mesh_adaptation/internal/Box_tree.h>
#include <CGAL/Quad_mesh_adaptation/internal/Covering_faces.h>
#include <CGAL/Quad_mesh_adaptation/internal/Witness.h>
#include <CGAL/Quad_mesh_adaptation/internal/choose_witnesses.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// What of the reference surface the mesh must not leave behind: witnesses on it, each kept by the
// face that it is nearest to.  Nodes stay on the surface by taking its nearest point, and a face
// that cuts a tip off is content with that; only the tip can tell.  There are none where the
// surface is flat or bends gently against the wanted size.
//
// Lists of witnesses by face follow operations, cuts and moves; after other changes of the whole
// mesh they are lost() and made anew by prepare().
class Coverage
{
public:
  // The largest distance that the caller allows; infinite: none.
  void set_bound(double distance) { bound_ = distance; }
  // Without witnesses from now on.
  void switch_off()
  {
    *this = Coverage(bound_);
    is_off_ = true;
  }
  // The surface or the sizes are others.
  void forget()
  {
    if(!is_off_) *this = Coverage(bound_);
  }
  // Faces are others.
  void lose() { assigned_ = false; }
  // Where the sizes will stay: bends take as much memory as the surface.
  void forget_bends() { bends_ = std::vector<Bend>(); }

  void prepare(const Quad_complex& m, const Reference_surface& surface, const Size_sampler& size,
               const std::vector<Index>& reference_patch)
  {
    if(is_off_ || surface.is_planar() || surface.number_of_triangles() == 0) return;
    if(scale_ != size.scale()) {
      if(bends_.empty()) bends_ = bends_of(surface, size);
      witnesses_ = choose_witnesses(surface, bends_, size.scale(), bound_);
      if(size.scale() < 2 && scale_ > 0) forget_bends(); // as they do mostly then
      scale_ = size.scale();
      assigned_ = false;
      forget_rest();
    }
    if(!assigned_) assign(m, surface, reference_patch);
    assigned_ = true;
  }

  // The same for a part of the mesh, of which `own` consists of the halves, as long as it is there;
  // afterwards all is to be forgotten.
  void prepare_part(const Quad_complex& part, const Reference_surface& own,
                    const Size_sampler& size, const std::vector<Index>& reference_patch)
  {
    if(is_off_) return;
    forget();
    scale_ = size.scale();
    if(!own.is_planar()) witnesses_ = choose_witnesses(own, bends_of(own, size), scale_, bound_);
    assign(part, own, reference_patch);
    assigned_ = true;
  }

  bool is_empty() const { return !assigned_ || witnesses_.empty(); }
  const Witness& operator[](Index w) const { return witnesses_[w]; }

  // Calls visit(number, witness) for those of face f.
  template <typename Visit>
  void for_each(Index f, const Visit& visit) const
  {
    if(!assigned_ || f >= Index(first_.size())) return;
    for(Index w = first_[f]; w >= 0; w = witnesses_[w].next) visit(w, witnesses_[w]);
  }

  double cost(Index f) const
  {
    double sum = 0;
    for_each(f, [&](Index, const Witness& w) { sum += w.cost; });
    return sum;
  }

  // Takes all witnesses of face f and adds them to the list.
  void take(Index f, std::vector<Index>& list)
  {
    if(!assigned_ || f >= Index(first_.size())) return;
    for(Index w = first_[f]; w >= 0; w = witnesses_[w].next) list.push_back(w);
    first_[f] = -1;
  }

  void give(Index w, Index f, double cost)
  {
    fit(f + 1);
    witnesses_[w].cost = cost;
    witnesses_[w].next = first_[f];
    first_[f] = w;
  }

  // Face `order[i]` has number i from now on.
  void renumber(const std::vector<Index>& order)
  {
    if(!assigned_) return;
    std::vector<Index> first(order.size(), -1);
    for(std::size_t i = 0; i < order.size(); ++i)
      if(order[i] < Index(first_.size())) first[i] = first_[order[i]];
    first_.swap(first);
  }

  // Only the given faces are there for a while, by their places in the list; witnesses on the
  // others wait.
  void leave_to(const std::vector<Index>& faces)
  {
    if(!assigned_) return;
    of_rest_ = first_;
    renumber(faces);
    for(Index f : faces)
      if(f < Index(of_rest_.size())) of_rest_[f] = -1;
    waits_.assign(witnesses_.size(), 1);
    for(Index first : first_)
      for(Index w = first; w >= 0; w = witnesses_[w].next) waits_[w] = 0;
  }

  // All are there again, those of the list by their numbers in it, or -1 where they are gone.
  void take_back(const std::vector<Index>& faces, Index face_end)
  {
    if(!assigned_ || of_rest_.empty()) return lose();
    of_rest_.resize(face_end, -1);
    for(std::size_t i = 0; i < faces.size() && i < first_.size(); ++i)
      if(faces[i] >= 0) of_rest_[faces[i]] = first_[i];
    first_ = std::move(of_rest_);
    forget_rest();
  }

  // For so many faces.
  void fit(Index faces)
  {
    if(faces > Index(first_.size())) first_.resize(faces, -1);
  }

  Coverage() = default;

private:
  explicit Coverage(double bound) : bound_(bound) {}

  void forget_rest()
  {
    of_rest_ = std::vector<Index>();
    waits_ = std::vector<char>();
  }

  // Where a face is the one that the witness was found on no other is looked for.
  void assign(const Quad_complex& m, const Reference_surface& surface,
              const std::vector<Index>& reference_patch)
  {
    first_.assign(m.face_end(), -1);
    std::vector<Index> lost;
    for(Index w = 0; w < Index(witnesses_.size()); ++w) {
      if(!waits_.empty() && waits_[w]) continue;
      const Index f = witnesses_[w].triangle / 2;
      if(f < m.face_end() && m.is_face(f) && surface.has_halves_of(f, corners(m, f)))
        give(w, m, f);
      else
        lost.push_back(w);
    }
    if(!lost.empty()) find_faces(lost, m, reference_patch);
  }

  // Each goes to the nearest face on its patch that is not turned away.
  void find_faces(const std::vector<Index>& witnesses, const Quad_complex& m,
                  const std::vector<Index>& reference_patch)
  {
    std::vector<Index> face_of;
    face_of.reserve(m.number_of_faces());
    for(Index f : m.faces()) face_of.push_back(f);
    const auto corners_of = [&](Index t) -> std::array<Vec, 3> {
      const Quad q = m.quad(face_of[t / 2]);
      return { m.point(q[0]), m.point(q[1 + t % 2]), m.point(q[2 + t % 2]) };
    };
    const Box_tree tree(2 * Index(face_of.size()), corners_of);
    const auto patch_of = [&](Index f) {
      const Index k = m.patch(f);
      return k < Index(reference_patch.size()) ? reference_patch[k] : Index(-1);
    };
    for(Index w : witnesses) {
      const auto fits = [&](Index t) {
        const Index f = face_of[t / 2], patch = patch_of(f);
        if(patch >= 0 && patch != witnesses_[w].patch) return false;
        const Quad q = m.quad(f);
        const Vec normal =
            normalized(cross(m.point(q[2]) - m.point(q[0]), m.point(q[3]) - m.point(q[1])));
        return !(normal * witnesses_[w].normal < Witness::turned_away);
      };
      const Index t = tree.nearest(witnesses_[w].p, corners_of, fits, 1e150).triangle;
      if(t >= 0) give(w, m, face_of[t / 2]);
    }
  }

  static Corners corners(const Quad_complex& m, Index f)
  {
    const Quad q = m.quad(f);
    return { m.point(q[0]), m.point(q[1]), m.point(q[2]), m.point(q[3]) };
  }

  void give(Index w, const Quad_complex& m, Index f)
  {
    give(w, f, witnesses_[w].cost_at(witnesses_[w].distance_to(corners(m, f))));
  }

  double bound_ = (std::numeric_limits<double>::infinity)();
  double scale_ = 0;        // of the sizes that the witnesses are for
  std::vector<Bend> bends_; // of the surface, by vertex
  std::vector<Witness> witnesses_;
  std::vector<Index> first_;   // of each face
  std::vector<Index> of_rest_; // the same while only a part of the faces is there
  std::vector<char> waits_;    // is a witness on none of these?
  bool assigned_ = false, is_off_ = false;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_COVERAGE_H
