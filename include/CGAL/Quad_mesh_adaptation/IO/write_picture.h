// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_IO_WRITE_PICTURE_H
#define CGAL_QUAD_MESH_ADAPTATION_IO_WRITE_PICTURE_H

#include <CGAL/Quad_mesh_adaptation/IO/File_transaction.h>
#include <CGAL/Quad_mesh_adaptation/internal/file_names.h>
#include <CGAL/Quad_mesh_adaptation/internal/size_at.h>
#include <CGAL/Quad_mesh_adaptation/internal/svg_panels.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {

/// How a picture looks.
struct Picture_options
{
  double panel_width = 400;  ///< of each drawing, in pixels
  double panel_height = 440; ///< at most, in pixels; lower when the mesh is wide
  /// Direction from the mesh to the eye; zero chooses: along the normal of a flat mesh, else three
  /// quarters from above or below, whichever shows more of the outer side.
  std::array<double, 3> to_eye = { { 0, 0, 0 } };
  /// Direction that is up in the picture, when `to_eye` is given.
  std::array<double, 3> up = { { 0, 0, 1 } };
};

/// A picture of meshes and sizing functions in panels side by side, all seen from the same
/// direction and in the same scale, as scalable vector graphics (SVG).
///
/// Surfaces that are not flat are shaded and painted from back to front, which is right for faces
/// that are small against the surface.  Edges are left out of meshes of more than 80 000 faces;
/// their faces show their size by colour instead.
class Picture
{
public:
  explicit Picture(const Picture_options& options = {}) : options_(options) {}

  /// Adds a panel with the faces of a mesh; below it the number of faces.
  template <class QuadMesh>
  void add_mesh(const QuadMesh& mesh, const std::string& title)
  {
    panels_.push_back({ title, internal::soup_of_mesh(mesh), {} });
  }

  /// Adds a panel with a sizing function (any callable from the mesh's points to a length, or a
  /// number) as colour on the faces of a mesh, with a colour bar, logarithmic when the sizes span
  /// more than a factor of ten.
  template <class QuadMesh, class SizingField>
  void add_sizing(const QuadMesh& mesh, const SizingField& sizing, const std::string& title)
  {
    using Point_map = std::decay_t<decltype(get(CGAL::vertex_point, mesh))>;
    using Point = typename boost::property_traits<Point_map>::value_type;
    panels_.push_back(
        { title, internal::soup_of_mesh(mesh), internal::size_function<Point>(sizing) });
  }

  /// The SVG text.  Calls the sizing functions, which must still be there, as must what they throw
  /// be expected.
  std::string svg() const;

private:
  struct Panel
  {
    std::string title;
    internal::Polygon_soup soup;
    internal::Size_function size; // none for meshes
  };

  internal::Picture_view view() const;
  internal::Panel_frame frame(const internal::Picture_view& view) const;
  internal::Size_scale size_scale() const;

  Picture_options options_;
  std::vector<Panel> panels_;
};

inline internal::Picture_view Picture::view() const
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
inline internal::Panel_frame Picture::frame(const internal::Picture_view& view) const
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
inline internal::Size_scale Picture::size_scale() const
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

inline std::string Picture::svg() const
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

/// Whether `write_picture()` knows the format that the extension of `file` names.
inline bool is_picture_format_known(const std::string& file)
{
  return internal::extension_of(file) == "svg";
}

/// The SVG text of the picture that `write_picture()` writes; for a `File_transaction` of several
/// files.
template <class QuadMesh, class SizingField>
std::string picture_file_contents(const QuadMesh& initial, const SizingField& sizing,
                                  const QuadMesh& adapted, const Picture_options& options = {})
{
  Picture picture(options);
  picture.add_mesh(initial, "Initial mesh");
  picture.add_sizing(initial, sizing, "Sizing function");
  picture.add_mesh(adapted, "Adapted mesh");
  return picture.svg();
}

/// Writes an SVG picture of an adaptation: initial mesh, sizing function as colour, adapted mesh,
/// as Figures 6 to 13 of Anderson, Benzley and Owen (2009) show them.  The file appears complete
/// or not at all.
///
/// \param file path of the file, ending in .svg
/// \param initial,adapted models of `FaceListGraph` with an internal `vertex_point` map
/// \param sizing a callable from their points to a length, or a number
/// \return `unwritable_file` with the reason when the file cannot be written
template <class QuadMesh, class SizingField>
Write_result write_picture(const std::string& file, const QuadMesh& initial,
                           const SizingField& sizing, const QuadMesh& adapted,
                           const Picture_options& options = {})
{
  if(!is_picture_format_known(file))
    return { Refusal::unwritable_file, file + ": cannot be written: its name must end in .svg" };
  File_transaction transaction;
  const Write_result result =
      transaction.stage(file, picture_file_contents(initial, sizing, adapted, options));
  return result.ok() ? transaction.commit() : result;
}

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_IO_WRITE_PICTURE_H
