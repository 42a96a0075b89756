// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_NUMBER_TEXT_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_NUMBER_TEXT_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <charconv>
#include <cmath>
#include <string>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The shortest text that reads back as the same double, whatever the locale.
inline void append(std::string& text, double value)
{
  if(!std::isfinite(value)) {
    text += std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
    return;
  }
  char digits[40];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

inline std::string number_text(double value)
{
  std::string text;
  append(text, value);
  return text;
}

// For what is told as an estimate.
inline std::string rounded_text(double value, int digits = 6)
{
  if(!std::isfinite(value)) return number_text(value);
  char text[40];
  const auto end =
      std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits);
  return std::string(text, end.ptr);
}

inline std::string point_text(const Vec& p)
{
  return '(' + number_text(p.x()) + ", " + number_text(p.y()) + ", " + number_text(p.z()) + ')';
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_NUMBER_TEXT_H
