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

// All faces are of one patch.
template <typename Key>
struct One_patch
{
  using key_type = Key;
  using value_type = int;
  using reference = int;
  using category = boost::read_write_property_map_tag;

  friend int get(const One_patch&, const Key&) { return 0; }
  friend void put(const One_patch&, const Key&, int) {}
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_NO_CONSTRAINTS_H
