// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "state_fixture.h"

#include <CGAL/Quad_mesh_adaptation/internal/core_calls.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace state_fixture {

core::Input_mesh input_of(const Shape& shape, const Options& o)
{
  core::Input_mesh in;
  in.points = shape.points;
  in.quads = shape.quads;
  in.is_frozen_vertex.assign(shape.points.size(), 0);
  for(Index v : o.frozen_vertices) in.is_frozen_vertex[v] = 1;
  for(const auto& q : shape.quads)
    for(int i = 0; i < 4; ++i) {
      const std::pair<Index, Index> e = std::minmax(q[i], q[(i + 1) % 4]);
      const bool frozen = o.frozen.count(e) != 0;
      in.is_frozen.push_back(frozen);
      in.is_constrained.push_back(frozen || o.constrained.count(e) != 0);
      if(frozen) in.is_frozen_vertex[e.first] = in.is_frozen_vertex[e.second] = 1;
    }
  return in;
}

Adaptation_state make_state(const Shape& shape, const Options& o)
{
  Adaptation_state s;
  const double edge = zoo_mesh::mean_edge(shape);
  s.size = o.size ? core::Size_sampler(o.size, 0)
                  : core::Size_sampler([edge](const Vec&) { return edge; }, edge);
  core::Feature_options features;
  features.feature_angle = o.feature_angle;
  const core::Input_mesh in = input_of(shape, o);
  core::build_state(in, features, core::Geometry_options(), s);
  return s;
}

std::size_t irregular_nodes(const Adaptation_state& s)
{
  std::size_t count = 0;
  for(Index v : s.mesh.vertices())
    if(!s.mesh.is_border_vertex(v) && s.mesh.vertex(v).faces != 4) ++count;
  return count;
}

Options with_crease(const Shape& shape)
{
  // every edge whose ends both lie in the plane through the middle of the shape
  Vec low = shape.points[0], high = low;
  for(const Vec& p : shape.points) {
    low = Vec((std::min)(low.x(), p.x()), 0, 0);
    high = Vec((std::max)(high.x(), p.x()), 0, 0);
  }
  const double x = 0.5 * (low.x() + high.x());
  Options o;
  for(const auto& q : shape.quads)
    for(int i = 0; i < 4; ++i) {
      const Index u = q[i], v = q[(i + 1) % 4];
      if(std::abs(shape.points[u].x() - x) < 1e-9 && std::abs(shape.points[v].x() - x) < 1e-9)
        o.constrained.insert(std::minmax(u, v));
    }
  return o;
}

namespace {

Options with_frozen_border(const Shape& shape)
{
  std::set<std::pair<Index, Index>> once;
  for(const auto& q : shape.quads)
    for(int i = 0; i < 4; ++i) {
      const std::pair<Index, Index> e = std::minmax(q[i], q[(i + 1) % 4]);
      if(!once.insert(e).second) once.erase(e);
    }
  Options o;
  for(const auto& e : once) // half of the border, the other half stays free
    if(shape.points[e.first].x() + shape.points[e.second].x() <
       2 * shape.points[once.begin()->first].x() + 5)
      o.frozen.insert(e);
  o.frozen_vertices.insert(shape.quads[shape.quads.size() / 2][0]);
  return o;
}

} // namespace

std::vector<Named_state> all_states()
{
  std::vector<Named_state> list;
  for(const Shape& s : shape_zoo::all()) list.push_back({ s.name, make_state(s) });
  Options smooth;
  smooth.feature_angle = 180;
  for(const Shape& s :
      { shape_zoo::plate(), shape_zoo::cube(), shape_zoo::open_cylinder(), shape_zoo::l_shape() })
    list.push_back({ s.name + " without corners", make_state(s, smooth) });
  for(const Shape& s :
      { shape_zoo::plate(), shape_zoo::torus(), shape_zoo::open_cylinder(), shape_zoo::sphere() })
    list.push_back({ s.name + " with crease", make_state(s, with_crease(s)) });
  for(const Shape& s : { shape_zoo::plate(), shape_zoo::annulus(), shape_zoo::irregular() })
    list.push_back({ s.name + " partly frozen", make_state(s, with_frozen_border(s)) });
  return list;
}

} // namespace state_fixture
