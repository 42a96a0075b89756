// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SVG_CANVAS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SVG_CANVAS_H

#include <CGAL/Quad_mesh_adaptation/internal/picture_view.h>

#include <charconv>
#include <cmath>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

struct Picture_point
{
  double x = 0, y = 0; // pixels, y down
};

// Where a panel lies in the picture and how it maps the view's plane to it.
struct Panel_frame
{
  double left = 0, top = 0, width = 0, height = 0; // of the drawing, in pixels
  double low_x = 0, high_y = 0;                    // the drawing's upper left corner in the view
  double scale = 1;                                // pixels per unit of length

  Picture_point place(const Picture_view& view, const Vec& p) const
  {
    return { left + scale * (dot(p, view.right) - low_x),
             top + scale * (high_y - dot(p, view.up)) };
  }
};

inline void append_pixels(std::string& text, double value)
{
  const double rounded = std::round(100 * value) / 100;
  char digits[40];
  text.append(digits,
              std::to_chars(digits, digits + sizeof digits, rounded == 0 ? 0. : rounded).ptr);
}

inline std::string pixels(double value)
{
  std::string text;
  append_pixels(text, value);
  return text;
}

// A closed polygon as part of the data of an SVG path, in steps from corner to corner: short.
inline void append_polygon(std::string& path, const std::vector<Picture_point>& points)
{
  const auto on_grid = [](double value) { return std::round(100 * value) / 100; };
  Picture_point last;
  for(std::size_t i = 0; i < points.size(); ++i) {
    const Picture_point p = { on_grid(points[i].x), on_grid(points[i].y) };
    path += i == 0 ? 'M' : i == 1 ? 'l' : ' ';
    append_pixels(path, p.x - last.x);
    path += ' ';
    append_pixels(path, p.y - last.y);
    last = p;
  }
  path += 'z';
}

inline std::string escaped(const std::string& text)
{
  std::string result;
  for(const char c : text) {
    if(c == '&')
      result += "&amp;";
    else if(c == '<')
      result += "&lt;";
    else if(c == '>')
      result += "&gt;";
    else if(static_cast<unsigned char>(c) >= 32)
      result += c;
  }
  return result;
}

inline std::string svg_text(double x, double y, const char* css_class, const std::string& text)
{
  return "<text x=\"" + pixels(x) + "\" y=\"" + pixels(y) + "\" class=\"" + css_class + "\">" +
         escaped(text) + "</text>\n";
}

// With a comma between thousands.
inline std::string grouped(std::size_t number)
{
  std::string text = std::to_string(number);
  for(std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, ",");
  return text;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SVG_CANVAS_H
