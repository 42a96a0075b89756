// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FILE_NAMES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FILE_NAMES_H

#include <filesystem>
#include <string>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// In lower case, without the dot; empty when there is none.
inline std::string extension_of(const std::string& file)
{
  std::string extension = std::filesystem::path(file).extension().string();
  if(!extension.empty()) extension.erase(0, 1);
  for(char& c : extension)
    if(c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FILE_NAMES_H
