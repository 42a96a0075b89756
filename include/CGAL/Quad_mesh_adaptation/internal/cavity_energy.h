// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CAVITY_ENERGY_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CAVITY_ENERGY_H

// Part of Cavity.h: what a replacement is worth.

#include <CGAL/Quad_mesh_adaptation/internal/Cavity.h>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

inline void Cavity::measure_before()
{
  energy_before_ = 0;
  for(Index f : old_faces) energy_before_ += s_.cached_energy(f) + s_.coverage.cost(f);
  for(std::size_t n = 0; n < nodes.size(); ++n)
    if(ids[n] >= 0)
      energy_before_ += s_.valence_energy(s_.mesh.vertex(ids[n]).faces, nodes[n]) +
                        side_energy(s_, side_difference(s_, ids[n]));
}

inline double Cavity::valences_after() const
{
  double e = 0;
  for(int n = 0; n < int(nodes.size()); ++n) {
    if(new_corners_[n] == 0) continue;
    e += s_.valence_energy(total_corners_[n], nodes[n]);
    if(is_on_crease(s_, nodes[n])) e += side_energy(s_, side_difference_after(n));
  }
  return e;
}

inline int Cavity::side_difference_after(int n) const
{
  const Quad_complex& m = s_.mesh;
  Side_count sides;
  for(int i = first_corner(n); i < corner_end_[n]; ++i)
    sides.add(m.patch(quads[corner_list_[i] >> 2].parent));
  if(ids[n] < 0) return sides.difference();
  for(Index h : m.outgoing(ids[n]))
    if(!has_old_face(m.face(h))) sides.add(m.patch(m.face(h)));
  return sides.difference();
}

// Each quad wants the size of the face it comes from, for its sum of sizes at the nodes.
inline void Cavity::set_factors()
{
  factors_.resize(quads.size());
  for(std::size_t k = 0; k < quads.size(); ++k)
    factors_[k] = quads[k].parent >= 0 ? s_.size_factor(quads[k].parent) : 0.25;
}

inline void Cavity::find_sizes()
{
  sizes_.resize(quads.size());
  for(std::size_t k = 0; k < quads.size(); ++k) sizes_[k] = s_.size.at_face(corners_of(quads[k]));
}

inline double Cavity::energy_after()
{
  double e = valences_after();
  find_sizes();
  for(std::size_t k = 0; k < quads.size(); ++k) {
    const Cavity_quad& q = quads[k];
    e += s_.face_energy_for(corners_of(q), reference_of(q), (std::max)(sizes_[k], floor_of(q)));
  }
  for_each_witness([&](Index, int, double cost) { e += cost; });
  return e;
}

// Calls visit(witness, quad, cost) for the witnesses of the old faces, with the quad that covers
// each best of those that share a node with its old face.
template <typename Visit>
void Cavity::for_each_witness(const Visit& visit)
{
  if(s_.coverage.is_empty()) return;
  for(Index f : old_faces) {
    near_.clear();
    s_.coverage.for_each(f, [&](Index w, const Witness& witness) {
      if(near_.empty()) gather_near(f);
      const std::pair<double, std::size_t> best = near_covers_.best_cover(witness);
      visit(w, near_[best.second], best.first);
    });
  }
}

inline void Cavity::gather_near(Index f)
{
  near_covers_.clear();
  for(Index v : s_.mesh.quad(f)) {
    const int n = local_of_[v];
    for(int i = first_corner(n); i < corner_end_[n]; ++i) near_.push_back(corner_list_[i] >> 2);
  }
  if(near_.empty())
    for(int k = 0; k < int(quads.size()); ++k) near_.push_back(k);
  std::sort(near_.begin(), near_.end());
  near_.erase(std::unique(near_.begin(), near_.end()), near_.end());
  for(int k : near_) near_covers_.add(corners_of(quads[k]));
}

// The same with sizes interpolated between the nodes, by the factor of the face each quad comes
// from: cheap, and near enough to tell hopeless from promising.
inline double Cavity::estimate_after()
{
  double e = valences_after();
  for(std::size_t k = 0; k < quads.size(); ++k) {
    const Cavity_quad& q = quads[k];
    const double sizes = nodes[q.v[0]].h + nodes[q.v[1]].h + nodes[q.v[2]].h + nodes[q.v[3]].h;
    e += s_.face_energy_for(corners_of(q), reference_of(q),
                            (std::max)(factors_[k] * sizes, floor_of(q)));
  }
  return e;
}

inline double Cavity::worst_before() const
{
  double worst = 1;
  for(Index f : old_faces)
    worst = (std::min)(worst, s_.face_quality(s_.corners(f), s_.reference_normal(f)));
  return worst;
}

inline double Cavity::worst_after() const
{
  if(!curves_in_order()) return -2; // below any face
  double worst = 1;
  for(const Cavity_quad& q : quads)
    worst = (std::min)(worst, s_.face_quality(corners_of(q), reference_of(q)));
  return worst;
}

inline bool Cavity::keeps_shape(double least) const
{
  const double before = worst_before();
  return worst_after() >= (std::min)(least, before) &&
         (before >= least || keeps_surface_covered()) && keeps_distance();
}

inline bool Cavity::keeps_distance() const
{
  if(!is_distance_limited(s_) || is_within_bound_after()) return true;
  const double after = distance_after();
  if(after <= s_.max_distance) return true;
  double before = 0;
  for(Index f : old_faces) before = (std::max)(before, distance_of(s_, f));
  return after <= before;
}

// At the middles of the quads and of the edges between them.
inline bool Cavity::is_within_bound_after() const
{
  const double bound = s_.max_distance;
  for(const Cavity_quad& q : quads) {
    const Corners p = corners_of(q);
    Index hint = hint_for(q);
    if(!s_.surface.is_planar() && !s_.surface.is_within(face_centre(p), bound, hint)) return false;
    for(int i = 0; i < 4; ++i) {
      const int a = q.v[i], b = q.v[(i + 1) & 3];
      if(q.curve[i] >= 0) {
        if(distance_of_edge(s_, q.curve[i], nodes[a], ids[a], nodes[b], ids[b]) > bound)
          return false;
      } else if(a < b && !s_.surface.is_within(0.5 * (nodes[a].p + nodes[b].p), bound, hint)) {
        return false; // edges inside have a quad on either side
      }
    }
  }
  return true;
}

// A triangle of the surface near a quad.
inline Index Cavity::hint_for(const Cavity_quad& q) const
{
  for(int v : q.v)
    if(nodes[v].carrier == Carrier::surface && nodes[v].hint >= 0) return nodes[v].hint;
  return s_.triangle_near(q.parent, nodes[q.v[0]].p);
}

inline double Cavity::distance_after() const
{
  double largest = 0;
  for(const Cavity_quad& q : quads) {
    const Corners p = corners_of(q);
    const Index hint = hint_for(q);
    largest = (std::max)(largest, distance_of_face(s_, p, hint));
    for(int i = 0; i < 4; ++i) {
      const int a = q.v[i], b = q.v[(i + 1) & 3];
      if(q.curve[i] >= 0)
        largest = (std::max)(largest,
                             distance_of_edge(s_, q.curve[i], nodes[a], ids[a], nodes[b], ids[b]));
    }
  }
  return largest;
}

// Where faces turned away from the surface already, pulling the rim of a thin wall inward makes
// faces go without making others larger or worse.  That looks like a gain as long as nobody asks
// whether the surface is still covered: by the area of the faces as far as they face the way it
// does.
inline bool Cavity::keeps_surface_covered() const
{
  double before = 0, after = 0, least = 1;
  const auto covering = [&](const Corners& p, const Facing& reference) {
    const Vec a = area_vector(p);
    const double cosine = reference.mean_cosine(normalized(a));
    least = (std::min)(least, following(cosine));
    return norm(a) * (std::max)(cosine, 0.);
  };
  for(Index f : old_faces) before += covering(s_.corners(f), s_.reference_normal(f));
  if(least > 0.2) return true;
  for(const Cavity_quad& q : quads) after += covering(corners_of(q), reference_of(q));
  return after > 0.95 * before;
}

// Nodes next to each other on a curve are in the order they had, new ones between their neighbours.
inline bool Cavity::curves_in_order() const
{
  std::vector<double> side(nodes.size(), 0.); // of a new node: where it sees its first neighbour
  for(int h = 0; h < int(partner_.size()); ++h) {
    const Index curve = quads[h >> 2].curve[h & 3];
    if(curve < 0 || (partner_[h] >= 0 && partner_[h] < h)) continue;
    const int ends[2] = { origin(h), target(h) };
    if(nodes[ends[0]].carrier != Carrier::curve || nodes[ends[1]].carrier != Carrier::curve)
      continue;
    const Feature_curve& c = s_.curves[curve];
    const double u = nodes[ends[0]].param, v = nodes[ends[1]].param;
    if(ids[ends[0]] >= 0 && ids[ends[1]] >= 0) {
      const double u_before = s_.mesh.vertex(ids[ends[0]]).param;
      if(!is_order_kept(c, u_before, s_.mesh.vertex(ids[ends[1]]).param, u, v)) return false;
      continue;
    }
    for(int i = 0; i < 2; ++i) {
      if(ids[ends[i]] >= 0) continue;
      const double d = i == 0 ? c.difference(u, v) : c.difference(v, u);
      if(side[ends[i]] * d > 0) return false;
      side[ends[i]] = d;
    }
  }
  return true;
}

inline double Cavity::largest_before() const
{
  double largest = 0;
  for(Index f : old_faces) largest = (std::max)(largest, s_.size_ratio(f));
  return largest;
}

inline double Cavity::largest_after() const
{
  double largest = 0;
  for(std::size_t k = 0; k < quads.size(); ++k) {
    const Corners p = corners_of(quads[k]);
    largest = (std::max)(largest,
                         mean_edge_length(p) / (sizes_.empty() ? s_.size.at_face(p) : sizes_[k]));
  }
  return largest;
}

inline void Cavity::relax(int sweeps)
{
  sizes_.clear();
  for(int sweep = 0; sweep < sweeps; ++sweep) {
    bool moved = false;
    for(std::size_t n = 0; n < nodes.size(); ++n) {
      if(!is_inner(int(n)) || nodes[n].frozen || nodes[n].carrier == Carrier::corner) continue;
      gather(int(n));
      moved = relax_(nodes[n]) || moved;
    }
    if(!moved) break;
  }
}

inline void Cavity::gather(int n)
{
  std::vector<Star_face>& star = relax_.star();
  star.clear();
  for(int i = first_corner(n); i < corner_end_[n]; ++i) {
    const int h = corner_list_[i];
    const Cavity_quad& q = quads[h >> 2];
    const Vertex_record &x = nodes[n], &a = nodes[q.v[(h + 1) & 3]], &b = nodes[q.v[(h + 2) & 3]],
                        &c = nodes[q.v[(h + 3) & 3]];
    Star_face f;
    f.set_corners(a.p, b.p, c.p);
    f.factor = factors_[h >> 2];
    f.sizes = a.h + b.h + c.h;
    f.reference = Facing();
    for(const Vertex_record* r : { &a, &b, &c }) f.reference.add(r->normal);
    f.floor = floor_of(q);
    f.grad_h = s_.size.is_constant()
                   ? Vec(0, 0, 0)
                   : size_gradient({ x.p, a.p, b.p, c.p }, { x.h, a.h, b.h, c.h });
    star.push_back(f);
  }
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CAVITY_ENERGY_H
