// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PLACES_IN_VAIN_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PLACES_IN_VAIN_H

#include <CGAL/Quad_mesh_adaptation/internal/Known_faces.h>
#include <CGAL/Quad_mesh_adaptation/internal/nodes_around.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The faces that a last resort has left poor where these are many, with those about them.  As long
// as all of these are as they were the same would be done about them in vain again; with few of
// them a second try costs little, and may help.
class Places_in_vain
{
public:
  void remember(const Adaptation_state& s, const std::vector<Index>& poor)
  {
    faces_ = Known_faces();
    if(poor.size() <= many) return;
    const std::vector<char> near = nodes_around(s.mesh, poor, reach);
    faces_.remember(s, [&](Index f) {
      const Quad q = s.mesh.quad(f);
      return std::any_of(q.begin(), q.end(), [&](Index v) { return near[v]; });
    });
  }

  // Marks the nodes of places that have changed since, and of all that are not remembered; none if
  // these are all.
  std::vector<char> changed_nodes(const Adaptation_state& s) const
  {
    if(faces_.is_empty()) return {};
    return nodes_around(s.mesh, faces_.changed(s), reach);
  }

private:
  static constexpr int reach = 2; // rings
  static constexpr std::size_t many = 100;

  Known_faces faces_;
};

// Is a node of face f among those, or new since?
inline bool is_about(const Adaptation_state& s, Index f, const std::vector<char>& nodes)
{
  const Quad q = s.mesh.quad(f);
  return nodes.empty() || std::any_of(q.begin(), q.end(), [&](Index v) {
           return v >= Index(nodes.size()) || nodes[v];
         });
}

inline void leave_only_about(const Adaptation_state& s, const std::vector<char>& nodes,
                             std::vector<Index>& faces)
{
  faces.erase(
      std::remove_if(faces.begin(), faces.end(), [&](Index f) { return !is_about(s, f, nodes); }),
      faces.end());
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PLACES_IN_VAIN_H
