// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FROZEN_EDGES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FROZEN_EDGES_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/Box_tree.h>
#include <CGAL/Quad_mesh_adaptation/internal/Input_mesh.h>
#include <CGAL/Quad_mesh_adaptation/internal/number_text.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Where edges must stay that are clearly longer than the sizes beside them, faces of these sizes
// would be slivers along the edges.  So the sizes of the state are raised there: at a frozen edge
// they are a share of its length, what a face of a good shape has on it, and from there they fall
// as steeply as quads can follow.
class Frozen_edges
{
public:
  // The sizes of the state are those raised ones, until they are put back.
  Frozen_edges(Adaptation_state& s, const Input_mesh& in) : s_(s), given_(s.size)
  {
    find_long_edges(in);
    if(!is_any()) return;
    tree_.emplace(Index(edges_.size()), Corners_of{ edges_ });
    s.size = Size_sampler(
        [this](const Vec& p) { return (std::max)(given_.unscaled(p), least_at(p)); }, 0);
    s.size.sampling = given_.sampling;
    s.size.scale_by(given_.scale());
    s.renew_sizes();
  }
  Frozen_edges(const Frozen_edges&) = delete; // the sizes refer to it
  Frozen_edges& operator=(const Frozen_edges&) = delete;

  bool is_any() const { return !edges_.empty(); }

  void put_sizes_back()
  {
    if(!is_any()) return;
    const double scale = s_.size.scale();
    s_.size = given_;
    s_.size.scale_by(scale);
    s_.renew_sizes();
  }

  // What the caller should know of it, nothing if there are none.
  std::string advice() const
  {
    if(!is_any()) return std::string();
    const std::size_t n = edges_.size();
    return std::to_string(n) + (n == 1 ? " edge that must stay is" : " edges that must stay are") +
           " up to " + rounded_text(longest_) + " times as long as the size beside " +
           (n == 1 ? "it" : "them") +
           ": faces near there are larger than asked, so that they keep a good shape";
  }

private:
  static constexpr double share = 0.7; // of the edge, mean edge of a face on it
  static constexpr double slope = 0.75;
  // Times the size: a face within its size that narrows from an edge of 1.8 to one of 0.8 has
  // angles of 45 degrees, from an edge of 2 it has no height.
  static constexpr double harmless = 1.8;

  struct Edge
  {
    Vec a, b;
    double length;
  };

  struct Corners_of
  {
    const std::vector<Edge>& edges;

    std::array<Vec, 3> operator()(Index e) const { return { edges[e].a, edges[e].b, edges[e].b }; }
  };

  // Between vertices of the input, each edge once.
  static std::vector<std::array<Index, 2>> all_frozen(const Input_mesh& in)
  {
    std::vector<std::array<Index, 2>> all;
    if(in.is_frozen.empty()) return all;
    for(std::size_t f = 0; f < in.quads.size(); ++f)
      for(std::size_t i = 0; i < 4; ++i) {
        if(!in.has_frozen(Index(4 * f + i))) continue;
        const Index u = in.quads[f][i], v = in.quads[f][(i + 1) & 3];
        all.push_back({ (std::min)(u, v), (std::max)(u, v) });
      }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  double least_size_along(const Vec& a, const Vec& b) const
  {
    constexpr int parts = 4;
    double least = given_.unscaled(a);
    for(int i = 1; i <= parts; ++i)
      least = (std::min)(least, given_.unscaled(a + (double(i) / parts) * (b - a)));
    return least;
  }

  void find_long_edges(const Input_mesh& in)
  {
    for(const std::array<Index, 2>& e : all_frozen(in)) {
      const Vec &a = in.points[e[0]], &b = in.points[e[1]];
      const double length = distance(a, b), least = least_size_along(a, b);
      if(!(length > harmless * least)) continue;
      edges_.push_back({ a, b, length });
      reach_ = (std::max)(reach_, share * length / slope);
      longest_ = (std::max)(longest_, length / least);
    }
  }

  // The size that the nearest of the edges leaves.
  double least_at(const Vec& p) const
  {
    const Box_tree::Nearest near = tree_->nearest(
        p, Corners_of{ edges_ }, [](Index) { return true; }, reach_);
    if(near.triangle < 0) return 0;
    return share * edges_[near.triangle].length - slope * distance(p, near.point);
  }

  Adaptation_state& s_;
  const Size_sampler given_;
  std::vector<Edge> edges_;
  std::optional<Box_tree> tree_;
  double reach_ = 0, longest_ = 0; // times the size
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FROZEN_EDGES_H
