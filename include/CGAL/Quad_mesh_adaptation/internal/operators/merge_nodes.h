// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MERGE_NODES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MERGE_NODES_H

#include <CGAL/Quad_mesh_adaptation/internal/Cavity.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Two nodes become one: the loser goes, the winner stays.
struct Node_merge
{
  Index loser, winner;
};

// Order of precedence where two nodes merge: corners and frozen nodes, curves, surface.
inline int carrier_rank(const Vertex_record& r)
{
  return r.frozen ? 3 : r.carrier == Carrier::corner ? 2 : r.carrier == Carrier::curve ? 1 : 0;
}

// Describes the cavity in which `merges` are carried out (each loser once, winners never losers)
// and `removed` faces, which the merges flatten, disappear.  Shared core of face close, ring
// collapse and chord collapse; legality in detail is left to Cavity::close().
inline void describe_merge(Adaptation_state& s, const std::vector<Node_merge>& merges,
                           const std::vector<Index>& removed, Cavity& cavity)
{
  const Quad_complex& m = s.mesh;
  for(Index f : removed) cavity.add_old_face(f);
  for(const Node_merge& g : merges) {
    cavity.add_old_star(g.loser);
    cavity.add_old_star(g.winner);
  }
  std::vector<int> image(cavity.nodes.size());
  for(std::size_t i = 0; i < image.size(); ++i) image[i] = int(i);
  for(const Node_merge& g : merges) image[cavity.node(g.loser)] = cavity.node(g.winner);

  // a flattened face hands the curve of one side on to the other side
  struct Zipped
  {
    int low, high;
    Index curve;
  };
  std::vector<Zipped> zipped;
  for(Index f : removed)
    for(Index h = 4 * f; h < 4 * f + 4; ++h) {
      const int u = image[cavity.node(m.origin(h))], v = image[cavity.node(m.target(h))];
      if(u != v && m.curve(h) >= 0)
        zipped.push_back({ (std::min)(u, v), (std::max)(u, v), m.curve(h) });
    }
  std::vector<char> is_removed(cavity.old_faces.size(), 0);
  for(std::size_t i = 0; i < cavity.old_faces.size(); ++i)
    is_removed[i] = i < removed.size(); // they were added first
  const std::vector<Index> faces = cavity.old_faces;
  for(std::size_t i = 0; i < faces.size(); ++i) {
    if(is_removed[i]) continue;
    Cavity_quad q = cavity.copy_of(faces[i]);
    for(int& v : q.v) v = image[v];
    for(int k = 0; k < 4; ++k) {
      const int u = q.v[k], v = q.v[(k + 1) & 3];
      for(const Zipped& z : zipped)
        if(z.low == (std::min)(u, v) && z.high == (std::max)(u, v))
          q.curve[k] = (std::max)(q.curve[k], z.curve);
    }
    cavity.quads.push_back(q);
  }
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MERGE_NODES_H
