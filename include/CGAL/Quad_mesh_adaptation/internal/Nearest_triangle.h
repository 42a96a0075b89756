// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_NEAREST_TRIANGLE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_NEAREST_TRIANGLE_H

#include <CGAL/Quad_mesh_adaptation/internal/Value_tree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The nearest triangle to a point.  Going down a tree from its root takes most of the time, for
// each step has to wait for the one before.  So the box of all is divided into cells; each cell
// near the triangles knows the few nodes of the tree below which all lie that can be nearest to a
// point in it, and the search begins at all of them.  Elsewhere it begins at the root.
class Nearest_triangle
{
public:
  // Precondition: there is at least one triangle.
  explicit Nearest_triangle(std::vector<Valued_triangle> triangles) : tree_(std::move(triangles))
  {
    choose_cells();
    std::size_t k = 0;
    const double edge = 1 / (per_unit_ * tree_.inverse());
    for(double x = 0; x < cells_[0]; ++x)
      for(double y = 0; y < cells_[1]; ++y)
        for(double z = 0; z < cells_[2]; ++z)
          fill(cell_[k++], tree_.origin() + edge * Vec(x, y, z), edge);
  }

  // Its number is -1 where a coordinate is not finite.
  Value_tree::Search operator()(const Vec& p) const
  {
    Value_tree::Search s(tree_, p, (std::numeric_limits<double>::infinity)());
    constexpr double far = 1e15;
    if(!(std::abs(s.q.x()) < far && std::abs(s.q.y()) < far && std::abs(s.q.z()) < far))
      tree_.search_all(s);
    else if(const Cell* cell = cell_at(s.q))
      search_from(*cell, s);
    else
      tree_.search_in(Value_tree::everything, s);
    return s;
  }

  const Valued_triangle& operator[](Index t) const { return tree_.triangles()[t]; }

private:
  static constexpr std::size_t most_nodes = 16; // of a cell

  struct Cell // its nodes, all of one level
  {
    std::uint32_t first = 0;
    std::uint16_t number = 0, level = 0; // number 0: not near the triangles
  };

  const Cell* cell_at(const Vec& q) const
  {
    std::size_t k = 0;
    for(int i = 0; i < 3; ++i) {
      const double x = per_unit_ * q[i] + 0.5;
      if(!(x >= 0 && x < cells_[i])) return nullptr;
      k = k * std::size_t(cells_[i]) + std::size_t(x);
    }
    return cell_[k].number > 0 ? &cell_[k] : nullptr;
  }

  // All boxes first, none of which has to wait for another; then from the nearest one.
  void search_from(const Cell& cell, Value_tree::Search& s) const
  {
    float d[4 * most_nodes];
    const std::uint32_t* const node = &nodes_[cell.first];
    Four_floats least((std::numeric_limits<float>::max)());
    for(std::size_t i = 0; i < cell.number; ++i) {
      const Four_floats distances2 = tree_.squared_distances(cell.level, node[i], s);
      distances2.store(d + 4 * i);
      least = smaller(least, distances2);
    }
    float least_of[4];
    least.store(least_of);
    const float first = (std::min)({ least_of[0], least_of[1], least_of[2], least_of[3] });
    const std::size_t nearest = std::size_t(std::find(d, d + 4 * cell.number, first) - d);
    const auto search_below = [&](std::size_t i) {
      tree_.search_in(
          Value_tree::part(d[i], cell.level + 1u, 4 * node[i / 4] + std::uint32_t(i % 4)), s);
    };
    search_below(nearest);
    for(std::size_t i = 0; i < cell.number; ++i) {
      unsigned near = not_above(Four_floats(d + 4 * i), Four_floats(s.bound));
      for(std::size_t k = 4 * i; near != 0; near >>= 1, ++k)
        if((near & 1u) && k != nearest && d[k] <= s.bound) search_below(k);
    }
  }

  // Cubes, at most two for each triangle, the outer ones half outside.
  void choose_cells()
  {
    const double most = 2 * double(tree_.triangles().size());
    const auto number = [&](double per_unit) {
      std::array<double, 3> n;
      for(int i = 0; i < 3; ++i)
        n[i] = std::floor(per_unit * tree_.inverse() * tree_.extent()[i]) + 2;
      return n;
    };
    for(double finer = 1;; finer *= 1.1) {
      const std::array<double, 3> n = number(finer);
      if(finer > 1 && !(n[0] * n[1] * n[2] <= most)) break;
      per_unit_ = finer;
      cells_ = n;
    }
    cell_.resize(std::size_t(cells_[0] * cells_[1] * cells_[2]));
  }

  // From a point of a cell to its nearest triangle it is at most as far as half a diagonal and from
  // the centre to its own nearest one; and so from the centre at most a diagonal farther than that.
  void fill(Cell& cell, const Vec& centre, double edge)
  {
    const double half_diagonal = 0.8661 * edge;
    Value_tree::Search at_centre(tree_, centre, 1.3 * half_diagonal);
    tree_.search_in(Value_tree::everything, at_centre);
    if(at_centre.triangle < 0) return;
    const Value_tree::Search all(tree_, centre, std::sqrt(at_centre.least) + 2 * half_diagonal);
    std::vector<std::uint32_t> nodes = { 0 }, below;
    while(cell.level < tree_.last_level()) {
      below.clear();
      for(std::uint32_t n : nodes) {
        const unsigned near =
            not_above(tree_.squared_distances(cell.level, n, all), Four_floats(all.bound));
        for(std::uint32_t i = 0; i < 4; ++i)
          if((near >> i) & 1u) below.push_back(4 * n + i);
      }
      if(below.size() > most_nodes) break;
      nodes.swap(below);
      ++cell.level;
    }
    cell.first = std::uint32_t(nodes_.size());
    cell.number = std::uint16_t(nodes.size());
    nodes_.insert(nodes_.end(), nodes.begin(), nodes.end());
  }

  Value_tree tree_;
  double per_unit_ = 1; // cells
  std::array<double, 3> cells_ = {};
  std::vector<Cell> cell_;
  std::vector<std::uint32_t> nodes_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_NEAREST_TRIANGLE_H
