// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_TEST_SURFACE_MESH_CHECKS_H
#define QUAD_MESH_ADAPTATION_TEST_SURFACE_MESH_CHECKS_H

#include "mesh_checks.h"

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace mesh_checks {

// The independent judge, on any face graph with an internal point map.
template <typename QuadMesh>
Facts facts_of_mesh(const QuadMesh& mesh)
{
  std::vector<Vec> points;
  std::vector<Quad> quads;
  std::map<typename boost::graph_traits<QuadMesh>::vertex_descriptor, Index> number;
  for(auto f : faces(mesh)) {
    Quad q = {};
    int k = 0;
    for(auto v : vertices_around_face(halfedge(f, mesh), mesh)) {
      const auto known = number.emplace(v, Index(points.size()));
      if(known.second) {
        const auto& p = get(CGAL::vertex_point, mesh, v);
        points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
      }
      if(k < 4) q[k] = known.first->second;
      ++k;
    }
    if(k != 4) {
      Facts bad;
      bad.problem = "a face has " + std::to_string(k) + " vertices";
      return bad;
    }
    quads.push_back(q);
  }
  return facts_of(points, quads);
}

} // namespace mesh_checks

#endif // QUAD_MESH_ADAPTATION_TEST_SURFACE_MESH_CHECKS_H
