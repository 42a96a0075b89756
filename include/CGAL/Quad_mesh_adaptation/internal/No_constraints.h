// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_NO_CONSTRAINTS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_NO_CONSTRAINTS_H

#include <boost/property_map/property_map.hpp>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Nothing is constrained, and being told so is ignored.
template <typename Key>
struct No_constraints
{
  using key_type = Key;
  using value_type = bool;
  using reference = bool;
  using category = boost::read_write_property_map_tag;

  friend bool get(const No_constraints&, const Key&) { return false; }
  friend void put(const No_constraints&, const Key&, bool) {}
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_NO_CONSTRAINTS_H
