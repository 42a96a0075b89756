// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_BENCHMARK_FEWEST_FACES_H
#define QUAD_MESH_ADAPTATION_BENCHMARK_FEWEST_FACES_H

#include <CGAL/Quad_mesh_adaptation/internal/Disjoint_sets.h>
#include <CGAL/Quad_mesh_adaptation/internal/feature_edges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace quality {

/// What the features of an input alone ask for, whatever the sizes.
struct Fewest_faces
{
  std::size_t faces = 0, patches = 0;
};

/// A patch is what lies between features; cut out, it has Euler characteristic x, and any mesh of
/// F quads on it with b edges around and i nodes inside has F = i + b / 2 - x.  So F is no less
/// than b / 2 - x, with the least b that the features allow: one edge from corner to corner, three
/// around a closed curve without corners.  Features are kept by all meshes that are compared.
class Patch_counting
{
public:
  using Index = CGAL::Quad_mesh_adaptation::internal::Index;
  using Face_arrays = CGAL::Quad_mesh_adaptation::internal::Face_arrays;

  /// `is_feature`: by half-edge; two features that turn by more than the angle with cosine
  /// `cosine` meet in a corner.
  Patch_counting(const Face_arrays& mesh, const std::vector<char>& is_feature, double cosine)
      : mesh_(mesh), is_feature_(is_feature), patch_of_(patches_of_faces()),
        is_corner_(corners(cosine))
  {
  }

  Fewest_faces operator()() const
  {
    std::map<Index, Patch> patches;
    count_faces_and_nodes(patches);
    count_around(patches);
    Fewest_faces sum;
    for(const auto& [first, p] : patches) {
      const long euler = p.nodes_inside + p.edges_around / 2 - p.faces;
      const long least_around = p.starts_at_corners + 3 * p.smooth_loops;
      sum.faces += std::size_t((std::max)(1L, (least_around + 1) / 2 - euler));
    }
    sum.patches = patches.size();
    return sum;
  }

private:
  struct Patch
  {
    long faces = 0, nodes_inside = 0, edges_around = 0;
    long starts_at_corners = 0; ///< of edges around: there is a curve from each
    long smooth_loops = 0;      ///< closed curves without a corner
  };

  std::vector<Index> patches_of_faces() const
  {
    CGAL::Quad_mesh_adaptation::internal::Disjoint_sets sets(mesh_.number_of_faces());
    for(Index h = 0; h < mesh_.number_of_halfedges(); ++h)
      if(!is_feature_[h]) sets.unite(mesh_.face[h], mesh_.face[mesh_.opposite[h]]);
    std::vector<Index> patch_of;
    for(Index f = 0; f < mesh_.number_of_faces(); ++f) patch_of.push_back(sets.find(f));
    return patch_of;
  }

  /// Nodes where features end, meet or turn.
  std::vector<char> corners(double cosine) const
  {
    std::vector<std::vector<Index>> neighbours(mesh_.points.size()); // along features
    for(Index h = 0; h < mesh_.number_of_halfedges(); ++h) {
      if(!is_feature_[h] || mesh_.opposite[h] > h) continue;
      const Index a = mesh_.origin[h], b = mesh_.origin[mesh_.next(h)];
      neighbours[a].push_back(b);
      neighbours[b].push_back(a);
    }
    std::vector<char> is_corner;
    for(std::size_t v = 0; v < neighbours.size(); ++v) {
      const std::vector<Index>& n = neighbours[v];
      bool is_one = n.size() == 1 || n.size() > 2;
      if(n.size() == 2) {
        const auto a = mesh_.points[v] - mesh_.points[n[0]],
                   b = mesh_.points[n[1]] - mesh_.points[v];
        is_one = a * b < cosine * std::sqrt((a * a) * (b * b));
      }
      is_corner.push_back(is_one);
    }
    return is_corner;
  }

  void count_faces_and_nodes(std::map<Index, Patch>& patches) const
  {
    for(Index p : patch_of_) ++patches[p].faces;
    std::vector<Index> inside(mesh_.points.size(), -1); // the patch
    for(Index h = 0; h < mesh_.number_of_halfedges(); ++h)
      inside[mesh_.origin[h]] = patch_of_[mesh_.face[h]];
    for(Index h = 0; h < mesh_.number_of_halfedges(); ++h)
      if(is_feature_[h]) inside[mesh_.origin[h]] = inside[mesh_.origin[mesh_.next(h)]] = -1;
    for(Index p : inside)
      if(p >= 0) ++patches[p].nodes_inside;
  }

  void count_around(std::map<Index, Patch>& patches) const
  {
    std::vector<char> seen(is_feature_.size(), 0);
    for(Index first = 0; first < mesh_.number_of_halfedges(); ++first) {
      if(!is_feature_[first] || seen[first]) continue;
      Patch& p = patches[patch_of_[mesh_.face[first]]];
      long starts = 0;
      for(Index h = first; !seen[h]; h = next_around(h)) {
        seen[h] = 1;
        ++p.edges_around;
        starts += is_corner_[mesh_.origin[h]];
      }
      p.starts_at_corners += starts;
      p.smooth_loops += starts == 0;
    }
  }

  Index next_around(Index h) const
  {
    for(h = mesh_.next(h); !is_feature_[h];) h = mesh_.next(mesh_.opposite[h]);
    return h;
  }

  const Face_arrays& mesh_;
  const std::vector<char>& is_feature_; // by half-edge
  const std::vector<Index> patch_of_;   // by face: the number of its first one
  const std::vector<char> is_corner_;   // by node
};

/// With features as they are detected by default; with a separate reference, which knows where
/// creases are, the border alone.
template <typename Mesh>
Fewest_faces fewest_faces(const Mesh& input, bool border_only)
{
  namespace internal = CGAL::Quad_mesh_adaptation::internal;
  const double cosine = std::cos(50 * std::acos(-1.) / 180);
  const internal::Face_arrays arrays =
      internal::face_arrays(input, CGAL::parameters::all_default(), "fewest_faces");
  return Patch_counting(arrays, internal::feature_edges(arrays, border_only ? -2. : cosine),
                        cosine)();
}

} // namespace quality

#endif // QUAD_MESH_ADAPTATION_BENCHMARK_FEWEST_FACES_H
