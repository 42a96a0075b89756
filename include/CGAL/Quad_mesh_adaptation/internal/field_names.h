// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FIELD_NAMES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FIELD_NAMES_H

#include <CGAL/Quad_mesh_adaptation/IO/Mesh_fields.h>

#include <set>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The name, or where that is used already the name with the first number from 2 on that makes it a
// new one; it is used from then on.
inline std::string unused_name(const std::string& name, std::set<std::string>& used)
{
  std::string unused = name;
  for(int i = 2; !used.insert(unused).second; ++i) unused = name + '_' + std::to_string(i);
  return unused;
}

// As all formats allow it.
inline std::string field_name(const Scalar_field& field)
{
  std::string name = field.name.empty() ? "field" : field.name;
  for(char& c : name)
    if(!((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'))) c = '_';
  return name;
}

// Names of all the fields, no two of them the same and none of those used otherwise.
inline std::vector<std::string> field_names(const std::vector<Scalar_field>& fields,
                                            std::set<std::string> used = {})
{
  std::vector<std::string> names;
  for(const Scalar_field& field : fields) names.push_back(unused_name(field_name(field), used));
  return names;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FIELD_NAMES_H
