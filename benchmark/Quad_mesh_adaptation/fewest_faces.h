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
#include <vector>

namespace quality {

/// What the features of an input ask for.
struct Fewest_faces
{
  std::size_t faces = 0, patches = 0;
};

/// A patch is what lies between features; cut out, it has Euler characteristic x, and any mesh of
/// F quads on it with b edges around and i nodes inside has F = i + b / 2 - x.  So F is no less
/// than b / 2 - x, with the least b that the features allow: one edge from corner to corner, three
/// around a closed curve without corners.  Features are kept by all meshes that are compared.
///
/// A plane quad has no more area than the square of its mean edge; so where the size is the same
/// everywhere and a patch is flat between straight features, which all meshes fill, its area asks
/// for faces as well.
class Patch_counting
{
public:
  using Index = CGAL::Quad_mesh_adaptation::internal::Index;
  using Vec = CGAL::Quad_mesh_adaptation::internal::Vec;
  using Face_arrays = CGAL::Quad_mesh_adaptation::internal::Face_arrays;

  /// `is_feature`: by half-edge; two features that turn by more than the angle with cosine
  /// `cosine` meet in a corner.  `size`: infinite if it is not the same everywhere.
  Patch_counting(const Face_arrays& mesh, const std::vector<char>& is_feature, double cosine,
                 double size)
      : mesh_(mesh), is_feature_(is_feature), size_(size), patch_of_(patches_of_faces()),
        is_corner_(corners(cosine)), is_bend_(corners(1 - hair))
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
      long fewest = (std::max)(1L, (least_around + 1) / 2 - euler);
      if(p.is_plane())
        fewest = (std::max)(fewest, long(std::ceil(p.area / (size_ * size_) - hair)));
      sum.faces += std::size_t(fewest);
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
    long bends = 0;             ///< of edges around, other than corners
    double area = 0;            ///< sum over faces
    Vec area_vector = Vec(0, 0, 0);

    bool is_plane() const
    {
      return bends == 0 && area * area * (1 - hair) < area_vector * area_vector;
    }
  };

  static constexpr double hair = 1e-9;

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
    for(Index f = 0; f < mesh_.number_of_faces(); ++f) {
      Patch& p = patches[patch_of_[f]];
      const Vec a = mesh_.area_vector(f);
      ++p.faces;
      p.area += std::sqrt(a * a);
      p.area_vector = p.area_vector + a;
    }
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
        p.bends += is_bend_[mesh_.origin[h]] && !is_corner_[mesh_.origin[h]];
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
  const double size_;
  const std::vector<Index> patch_of_;           // by face: the number of its first one
  const std::vector<char> is_corner_, is_bend_; // by node
};

/// With features as they are detected by default; with a separate reference, which knows where
/// creases are, the border alone.
template <typename Mesh>
Fewest_faces fewest_faces(const Mesh& input, bool border_only, double size)
{
  namespace internal = CGAL::Quad_mesh_adaptation::internal;
  const double cosine = std::cos(50 * std::acos(-1.) / 180);
  const internal::Face_arrays arrays =
      internal::face_arrays(input, CGAL::parameters::all_default(), "fewest_faces");
  return Patch_counting(arrays, internal::feature_edges(arrays, border_only ? -2. : cosine), cosine,
                        size)();
}

} // namespace quality

#endif // QUAD_MESH_ADAPTATION_BENCHMARK_FEWEST_FACES_H
