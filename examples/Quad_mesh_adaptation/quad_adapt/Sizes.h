// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_ADAPT_SIZES_H
#define QUAD_ADAPT_SIZES_H

#include "Options.h"
#include "Size_expression.h"
#include "refuse.h"

#include <CGAL/Quad_mesh_adaptation/Curvature_sizing_field.h>
#include <CGAL/Quad_mesh_adaptation/Error_sizing_field.h>
#include <CGAL/Quad_mesh_adaptation/Graded_sizing_field.h>
#include <CGAL/Quad_mesh_adaptation/IO/Mesh_fields.h>
#include <CGAL/Quad_mesh_adaptation/IO/read_nodal_sizes.h>
#include <CGAL/Quad_mesh_adaptation/Proximity_sizing_field.h>
#include <CGAL/Quad_mesh_adaptation/combined_sizing_fields.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>

namespace QMA = CGAL::Quad_mesh_adaptation;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Size_function = std::function<double(const Point&)>;

/// Of all sizes the smallest counts.
template <class Sizing>
void add_size(const Sizing& more, Size_function& size)
{
  size = size ? Size_function(QMA::Minimum_sizing_field(size, more)) : Size_function(more);
}

inline int read_number(const Options& options, Size_function& size)
{
  const std::string& text = *options.size;
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if(text.find_first_not_of(" \t") == std::string::npos || *end != 0)
    return refuse("--size: \"" + text + "\" is not a number", exit_wrong_usage);
  if(!(value > 0) || !std::isfinite(value))
    return refuse(options, "--size: ", QMA::Refusal::invalid_size,
                  text + " is not a positive finite length");
  size = [value](const Point&) { return value; };
  return 0;
}

/// The sizes that do not depend on the mesh.  0, or the exit code after having said why.
inline int read_given_sizes(const Options& options, Size_function& size)
{
  if(options.size) {
    const int exit_code = read_number(options, size);
    if(exit_code != 0) return exit_code;
  }
  if(options.size_function) {
    Size_expression expression;
    std::string message;
    if(!expression.parse(*options.size_function, message))
      return refuse("--size-function: " + message + "; see quad_adapt --help", exit_wrong_usage);
    size = expression;
  }
  if(options.background.empty()) return 0;
  std::optional<QMA::Nodal_sizing_field> field;
  const QMA::Read_result result = QMA::read_nodal_sizes(options.background, field);
  if(!result.ok()) return refuse(options, "--background: ", result);
  add_size(*field, size);
  return 0;
}

inline QMA::Size_range range_of(const Options& options)
{
  QMA::Size_range range;
  if(options.smallest_size) range.smallest = *options.smallest_size;
  if(options.largest_size) range.largest = *options.largest_size;
  return range;
}

inline QMA::Error_target target_of(const Options& options)
{
  if(options.error_target) return QMA::Error_target::error(*options.error_target);
  if(options.error_reduction) return QMA::Error_target::reduction(*options.error_reduction);
  return QMA::Error_target::number_of_faces(*options.error_faces);
}

/// Adds the sizes that follow from error indicators in the file of the mesh, which must be as it
/// was read.  0, or the exit code after having said why.
inline int add_sizes_of_error(const Options& options, const Mesh& mesh,
                              const QMA::Mesh_fields& fields, Size_function& size)
{
  if(!options.error_property) return 0;
  const auto* of_faces = QMA::Mesh_fields::find(fields.face, *options.error_property);
  const auto* of_vertices = QMA::Mesh_fields::find(fields.vertex, *options.error_property);
  QMA::Error_sizing_options how;
  how.order = options.error_order;
  how.range = range_of(options);
  const auto value_in = [](const QMA::Scalar_field& field) {
    return [&field](std::size_t i) { return field.values[i]; };
  };
  try {
    if(of_faces)
      add_size(QMA::Error_sizing_field(
                   mesh, boost::make_function_property_map<Mesh::Face_index>(value_in(*of_faces)),
                   target_of(options), how),
               size);
    else if(of_vertices)
      add_size(QMA::Error_sizing_field(
                   mesh,
                   boost::make_function_property_map<Mesh::Vertex_index>(value_in(*of_vertices)),
                   target_of(options), how),
               size);
    else
      return refuse(options, "--error: ", QMA::Refusal::invalid_parameter,
                    options.input + " has no property \"" + *options.error_property +
                        "\" at its faces or vertices");
  } catch(const std::invalid_argument& error) {
    return refuse(options, "--error: ", QMA::Refusal::invalid_parameter, error.what());
  }
  return 0;
}

/// Adds the sizes that follow from the shape of the surface, and brings all within the bounds.
/// `is_kept`: edges that are creases whatever their angle.
inline void add_sizes_of_surface(const Options& options, const Mesh& surface,
                                 const std::function<bool(Mesh::Edge_index)>& is_kept,
                                 Size_function& size)
{
  const QMA::Size_range range = range_of(options);
  const auto creases = CGAL::parameters::edge_is_constrained_map(
      boost::make_function_property_map<Mesh::Edge_index>(is_kept));
  const auto parameters =
      QMA::smooth_reference(options.is_smooth, QMA::feature_angle(options.feature_angle, creases));
  if(options.elements_per_circle)
    add_size(QMA::Curvature_sizing_field::elements_per_circle(surface, *options.elements_per_circle,
                                                              range, parameters),
             size);
  if(options.chord_error)
    add_size(
        QMA::Curvature_sizing_field::chord_error(surface, *options.chord_error, range, parameters),
        size);
  if(options.elements_across)
    add_size(QMA::Proximity_sizing_field(surface, *options.elements_across, range), size);
  if(options.smallest_size || options.largest_size) size = QMA::Clamped_sizing_field(size, range);
}

/// Bounds the growth of the size over the mesh, and says where that lowers it.
inline void limit_growth(const Options& options, const Mesh& mesh, Size_function& size)
{
  const QMA::Graded_sizing_field graded(mesh, size, *options.gradation);
  if(!options.is_quiet && graded.lowered_share() > 0)
    std::cerr << "quad_adapt: note: the size grows by more than " << *options.gradation
              << " per unit of length, it is lowered on "
              << std::max(1., std::round(100 * graded.lowered_share())) << " % of the surface\n";
  if(!options.is_quiet && !graded.is_resolved())
    std::cerr << "quad_adapt: note: the growth of the size is bounded with "
              << graded.number_of_samples() << " samples only, up to " << graded.largest_spacing()
              << " sizes apart\n";
  size = graded;
}

#endif // QUAD_ADAPT_SIZES_H
