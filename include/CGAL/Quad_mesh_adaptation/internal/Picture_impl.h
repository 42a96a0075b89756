// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PICTURE_IMPL_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PICTURE_IMPL_H

#include <CGAL/Quad_mesh_adaptation/IO/write_picture.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

namespace CGAL {
namespace Quad_mesh_adaptation {

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL internal::Picture_view Picture::view() const
{
  const auto vec = [](const std::array<double, 3>& a) { return internal::Vec(a[0], a[1], a[2]); };
  const internal::Polygon_soup& first = panels_.front().soup;
  if(!(internal::norm(vec(options_.to_eye)) > 0)) return internal::default_view(first);
  internal::Picture_view view = internal::view_from(vec(options_.to_eye), vec(options_.up));
  const internal::Vec normal = internal::plane_normal(first);
  view.is_planar = std::abs(internal::dot(normal, view.to_eye)) > 1 - 1e-9;
  return view;
}

// The drawing of the first panel: large enough for all meshes.
CGAL_QUAD_MESH_ADAPTATION_CORE_CALL internal::Panel_frame
Picture::frame(const internal::Picture_view& view) const
{
  const double infinite = std::numeric_limits<double>::infinity();
  double low_x = infinite, high_x = -infinite, low_y = infinite, high_y = -infinite;
  for(const Panel& panel : panels_)
    for(const internal::Vec& p : panel.soup.points) {
      const double x = internal::dot(p, view.right), y = internal::dot(p, view.up);
      low_x = (std::min)(low_x, x);
      high_x = (std::max)(high_x, x);
      low_y = (std::min)(low_y, y);
      high_y = (std::max)(high_y, y);
    }
  internal::Panel_frame frame;
  if(!(low_x <= high_x)) return frame; // all meshes are empty
  const double tiny = 1e-12 * (high_x - low_x + high_y - low_y);
  frame.scale = (std::min)(options_.panel_width / (std::max)(high_x - low_x, tiny),
                           options_.panel_height / (std::max)(high_y - low_y, tiny));
  frame.width = frame.scale * (high_x - low_x);
  frame.height = frame.scale * (high_y - low_y);
  frame.low_x = low_x;
  frame.high_y = high_y;
  return frame;
}

// Over all sizing functions, at the vertices and face centres of all meshes.
CGAL_QUAD_MESH_ADAPTATION_CORE_CALL internal::Size_scale Picture::size_scale() const
{
  double low = std::numeric_limits<double>::infinity(), high = 0;
  const auto widen = [&](double size) {
    if(!(size > 0) || !std::isfinite(size)) return;
    low = (std::min)(low, size);
    high = (std::max)(high, size);
  };
  bool any = false;
  for(const Panel& sizes : panels_) {
    if(!sizes.size) continue;
    any = true;
    for(const Panel& panel : panels_) {
      for(const internal::Vec& p : panel.soup.points) widen(sizes.size(p));
      for(const auto& face : panel.soup.faces)
        widen(sizes.size(internal::centre_of_face(panel.soup, face)));
    }
  }
  if(!any)
    for(const Panel& panel : panels_)
      for(const auto& face : panel.soup.faces) widen(internal::size_of_face(panel.soup, face));
  return low <= high ? internal::Size_scale(low, high) : internal::Size_scale();
}

CGAL_QUAD_MESH_ADAPTATION_CORE_CALL std::string Picture::svg() const
{
  if(panels_.empty()) return "<svg xmlns=\"http://www.w3.org/2000/svg\"/>\n";
  constexpr double margin = 24, title_height = 34, note_height = 34, bar_width = 68;
  const internal::Picture_view view = this->view();
  const internal::Size_scale scale = size_scale();
  internal::Panel_frame frame = this->frame(view);
  // titles need room also over a narrow mesh
  const double panel_width = (std::max)(frame.width, 130.);
  frame.top = title_height;

  std::string content;
  double x = margin;
  for(const Panel& panel : panels_) {
    frame.left = x + (panel_width - frame.width) / 2;
    const double middle = x + panel_width / 2, below = frame.top + frame.height + 22;
    content += internal::svg_text(middle, 20, "title", panel.title);
    if(panel.size) {
      content += internal::size_panel(panel.soup, panel.size, scale, view, frame) +
                 internal::colour_bar(scale, x + panel_width + 14, frame.top, frame.height);
    } else {
      const std::size_t n = panel.soup.faces.size();
      content += internal::mesh_panel(panel.soup, view, frame, scale) +
                 internal::svg_text(
                     middle, below, "note",
                     internal::grouped(n) + (n == 1 ? " face" : " faces") +
                         (n > internal::max_faces_with_edges ? ", colour is face size" : ""));
    }
    x += panel_width + margin + (panel.size ? bar_width : 0);
  }
  const std::string width = internal::pixels(x),
                    height = internal::pixels(frame.top + frame.height + note_height);
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
         "\" viewBox=\"0 0 " + width + ' ' + height + "\">\n" + internal::svg_definitions() +
         "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n" + content + "</svg>\n";
}

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PICTURE_IMPL_H
