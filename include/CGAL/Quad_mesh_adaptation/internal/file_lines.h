// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FILE_LINES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FILE_LINES_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>
#include <CGAL/Quad_mesh_adaptation/internal/text_scanner.h>

#include <cstddef>
#include <string>

// Why not CGAL's own polygon soup readers: on malformed bytes they are undefined (a negative
// colour index or a missing colour reads out of bounds, a face degree is allocated unseen), they
// turn "nan" into a plain failure, and they cannot say which line is wrong.

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

inline std::string at_line(std::size_t line) { return " in line " + std::to_string(line); }

// The three coordinates at the front of a line.
inline bool read_coordinates(Word_scanner& words, Vec& point)
{
  double c[3];
  for(double& value : c)
    if(!to_number(words.next(), value)) return false;
  point = Vec(c[0], c[1], c[2]);
  return true;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FILE_LINES_H
