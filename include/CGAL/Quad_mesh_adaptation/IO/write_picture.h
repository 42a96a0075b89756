// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_IO_WRITE_PICTURE_H
#define CGAL_QUAD_MESH_ADAPTATION_IO_WRITE_PICTURE_H

#include <CGAL/Quad_mesh_adaptation/IO/File_transaction.h>
#include <CGAL/Quad_mesh_adaptation/internal/compiled_core.h>
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

#ifndef QUAD_MESH_ADAPTATION_COMPILED_CORE
#include <CGAL/Quad_mesh_adaptation/internal/Picture_impl.h>
#endif

#endif // CGAL_QUAD_MESH_ADAPTATION_IO_WRITE_PICTURE_H
