// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_BENCHMARK_TABLE_TEXT_H
#define QUAD_MESH_ADAPTATION_BENCHMARK_TABLE_TEXT_H

#include <CGAL/Quad_mesh_adaptation/Mesh_measures.h>

#include <cstddef>
#include <cstdio>
#include <string>

// Figures of a mesh as text for tables.
namespace quality {

template <class... Values>
std::string formatted(const char* format, Values... values)
{
  char text[200];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

/// Irregular among the inner vertices.
inline double irregular_percent(const CGAL::Quad_mesh_adaptation::Mesh_measures& m)
{
  return m.interior_vertices
             ? 100. * double(m.irregular_interior_vertices) / double(m.interior_vertices)
             : 0.;
}

/// Least and largest valence of inner vertices, "-" if there are none.
inline std::string valence_range(const CGAL::Quad_mesh_adaptation::Mesh_measures& m)
{
  std::size_t low = 0, high = 0;
  for(const auto& [valence, count] : m.interior_valence) {
    if(count == 0) continue;
    if(low == 0) low = valence;
    high = valence;
  }
  return low == 0 ? "-" : std::to_string(low) + "-" + std::to_string(high);
}

} // namespace quality

#endif // QUAD_MESH_ADAPTATION_BENCHMARK_TABLE_TEXT_H
