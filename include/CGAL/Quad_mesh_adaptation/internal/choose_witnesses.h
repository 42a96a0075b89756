// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHOOSE_WITNESSES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHOOSE_WITNESSES_H

#include <CGAL/Quad_mesh_adaptation/internal/Reference_surface.h>
#include <CGAL/Quad_mesh_adaptation/internal/Size_sampler.h>
#include <CGAL/Quad_mesh_adaptation/internal/Witness.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// How a surface bends at one of its vertices.
struct Bend
{
  Vec normal = Vec(0, 0, 0);
  double curvature = 0; // turn per length
  double least = 0;     // turn between the triangles there, which no small size makes less
  double h = 0;         // the size, not scaled
  Index triangle = -1;  // one of those about the vertex; -1: on a sharp edge or the border

  double turn_over(double length) const { return (std::max)(curvature * length, least); }
};

// From the normal at a vertex to that of a triangle there, its centre so far away.  Most add
// nothing to what is known, as a bound tells for the angle, which is dear.
inline void add_turn(const Vec& normal, const Vec& away, Bend& b)
{
  const double cosine = (std::max)(-1., (std::min)(1., b.normal * normal));
  const double y = 1 - cosine, factor = y < 0.5 ? 1 + 0.1 * y : 2.; // angle <= factor * sqrt(2 y)
  const double turn2 = 2 * y * factor * factor, way2 = away.squared_length();
  if(turn2 <= b.curvature * b.curvature * way2 && 4 * turn2 <= b.least * b.least) return;
  const double way = std::sqrt(way2), turn = std::acos(cosine);
  if(!(turn > 1e-6 && way > 0)) return;
  b.curvature = (std::max)(b.curvature, turn / way);
  b.least = (std::max)(b.least, 2 * turn);
}

// Of all vertices; those on curves have none, because curves hold the mesh there.
inline std::vector<Bend> bends_of(const Reference_surface& surface, const Size_sampler& size)
{
  std::vector<Bend> bends(surface.points().size());
  for(Index t = 0; t < Index(surface.number_of_triangles()); ++t)
    for(Index v : surface.triangles()[t]) {
      bends[v].normal = bends[v].normal + surface.normal(t);
      bends[v].triangle = t;
    }
  for(Bend& b : bends) b.normal = normalized(b.normal);
  for(Index t = 0; t < Index(surface.number_of_triangles()); ++t) {
    const std::array<Vec, 3> c = surface.triangle(t);
    const Vec centre = (c[0] + c[1] + c[2]) / 3, normal = surface.normal(t);
    for(int i = 0; i < 3; ++i) add_turn(normal, centre - c[i], bends[surface.triangles()[t][i]]);
  }
  for(Index t = 0; t < Index(surface.number_of_triangles()); ++t)
    for(int i = 0; i < 3; ++i)
      if(surface.neighbour(t, i) < 0)
        bends[surface.triangles()[t][i]].triangle =
            bends[surface.triangles()[t][(i + 1) % 3]].triangle = -1;
  for(std::size_t v = 0; v < bends.size(); ++v)
    if(bends[v].triangle >= 0 && bends[v].curvature > 0)
      bends[v].h = size.unscaled(surface.points()[v]);
  return bends;
}

// The vertices of a reference surface that bear witness, most bent first and none near another.
class Witness_choice
{
public:
  Witness_choice(const Reference_surface& surface, const std::vector<Bend>& bends, double scale,
                 double bound)
      : surface_(surface), bends_(bends), scale_(scale), bound_(bound)
  {
  }

  std::vector<Witness> operator()()
  {
    std::vector<std::pair<double, Index>> order;
    for(Index v = 0; v < Index(bends_.size()); ++v)
      if(is_needed(bends_[v])) order.push_back({ -bends_[v].turn_over(scale_ * bends_[v].h), v });
    std::vector<Witness> chosen;
    if(order.empty()) return chosen;
    std::sort(order.begin(), order.end());
    link();
    near_.assign(bends_.size(), -1);
    covered_.assign(bends_.size(), 0);
    for(const auto& o : order) {
      if(covered_[o.second]) continue;
      chosen.push_back(witness(o.second));
      cover(o.second);
    }
    return chosen;
  }

private:
  static constexpr double spacing = 0.4; // of the wanted size

  // Where a wanted face turns by more than 57 degrees, or leaves the surface by nearly the bound.
  bool is_needed(const Bend& b) const
  {
    const double h = scale_ * b.h, turn = b.turn_over(h);
    return b.h > 0 && (turn > 1 || turn * h > 8 * 0.4 * bound_);
  }

  // Allowed is what a well placed face takes: its sagitta, but next to nothing on a sharp bend,
  // where nodes can sit on the bend itself.
  Witness witness(Index v) const
  {
    const Bend& b = bends_[v];
    const double h = scale_ * b.h, turn = b.turn_over(h);
    Witness w;
    w.p = surface_.lifted(surface_.points()[v], b.triangle);
    w.normal = b.normal;
    w.allowed = 0.15 * h * (std::min)({ 1., turn, (std::max)(2 / turn, 1. / 3) });
    w.allowed = (std::min)(w.allowed, 0.6 * bound_);
    w.inverse_h = 1 / (std::min)(h, 1.5 * bound_);
    w.patch = surface_.patch(b.triangle);
    w.triangle = b.triangle;
    return w;
  }

  // Neighbours of each vertex.
  void link()
  {
    begin_.assign(bends_.size() + 1, 0);
    for(const auto& t : surface_.triangles())
      for(Index v : t) begin_[v + 1] += 2;
    for(std::size_t v = 0; v < bends_.size(); ++v) begin_[v + 1] += begin_[v];
    list_.resize(begin_.back());
    std::vector<Index> next(begin_.begin(), begin_.end() - 1);
    for(const auto& t : surface_.triangles())
      for(int i = 0; i < 3; ++i) {
        list_[next[t[i]]++] = t[(i + 1) % 3];
        list_[next[t[i]]++] = t[(i + 2) % 3];
      }
  }

  // What can be reached from v over vertices near it needs no other witness.
  void cover(Index v)
  {
    const double within = spacing * scale_ * bends_[v].h;
    reached_.assign(1, v);
    near_[v] = v;
    for(std::size_t k = 0; k < reached_.size(); ++k) {
      covered_[reached_[k]] = 1;
      for(Index i = begin_[reached_[k]]; i < begin_[reached_[k] + 1]; ++i) {
        const Index u = list_[i];
        if(near_[u] == v || distance(surface_.points()[u], surface_.points()[v]) > within) continue;
        near_[u] = v;
        reached_.push_back(u);
      }
    }
  }

  const Reference_surface& surface_;
  const std::vector<Bend>& bends_;
  double scale_, bound_;
  std::vector<Index> begin_, list_; // neighbours, by vertex
  std::vector<Index> near_;         // whom a vertex was last reached from
  std::vector<Index> reached_;
  std::vector<char> covered_;
};

inline std::vector<Witness> choose_witnesses(const Reference_surface& surface,
                                             const std::vector<Bend>& bends, double scale,
                                             double bound)
{
  return Witness_choice(surface, bends, scale, bound)();
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CHOOSE_WITNESSES_H
