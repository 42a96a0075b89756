// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_ADAPT_ADAPT_H
#define QUAD_ADAPT_ADAPT_H

#include "Mesh_sets.h"
#include "Options.h"
#include "Progress.h"
#include "Size_expression.h"
#include "Sizes.h"
#include "Thread_limit.h"

#include <CGAL/Quad_mesh_adaptation/expected_number_of_faces.h>
#include <CGAL/adapt_quad_mesh.h>

#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

/// The faces that may change; none where no region is asked for.  0, or the exit code after having
/// said why.
inline int choose_region(const Options& options, const Mesh& mesh,
                         std::vector<Mesh::Face_index>& region)
{
  if(!options.region) return 0;
  Size_expression inside;
  std::string message;
  if(!inside.parse(*options.region, message))
    return refuse("--region: " + message + "; see quad_adapt --help", exit_wrong_usage);
  for(Mesh::Face_index f : mesh.faces()) {
    double x = 0, y = 0, z = 0;
    for(Mesh::Vertex_index v : vertices_around_face(mesh.halfedge(f), mesh)) {
      const Point& p = mesh.point(v);
      x += p.x() / 4, y += p.y() / 4, z += p.z() / 4;
    }
    const double value = inside(Point(x, y, z));
    if(value != 0 && !std::isnan(value)) region.push_back(f);
  }
  if(!region.empty()) return 0;
  return refuse(options, "--region: ", QMA::Refusal::invalid_parameter,
                "no face has its centre there");
}

/// How far faces may be from the surface.  The smooth surface through the vertices of a mesh that
/// turns by much from face to face bends more than the sizes of --chord-error account for: the
/// bound is for the error itself then, unless sizes are kept from following.
inline double distance_allowed(const Options& options)
{
  constexpr double about = 1.1; // of the error asked for
  if(options.max_distance) return *options.max_distance;
  if(!options.is_smooth || !options.chord_error || options.smallest_size)
    return std::numeric_limits<double>::infinity();
  return about * *options.chord_error;
}

/// The number of faces that come out, `by_formula` unless single rows count, which no formula
/// foretells: so few faces are made for trial, unless that takes seconds, since the mesh has many
/// or `bounds_distance`.
template <class Parameters>
double foretold_faces(double by_formula, bool bounds_distance,
                      const std::vector<Mesh::Face_index>& region, const Size_function& size,
                      const Mesh& mesh, const Parameters& parameters)
{
  constexpr double most_tried = 300, most_given = 1000;
  const std::size_t given = region.empty() ? mesh.number_of_faces() : region.size();
  if(by_formula > most_tried || double(given) > most_given || bounds_distance) return by_formula;
  return region.empty() ? QMA::expected_number_of_faces(size, mesh, parameters)
                        : QMA::expected_number_of_faces(region, size, mesh, parameters);
}

/// One call of the library from here on: no region means all faces.  Tells how many faces to expect
/// before the work is done, if anybody asks for it.
template <class Parameters>
QMA::Adaptation_report adapt(const Options& options, const std::vector<Mesh::Face_index>& region,
                             const Size_function& size, Mesh& mesh, Progress& progress,
                             const Parameters& parameters)
{
  double expected = 0; // is not foretold
  progress.when_foretold([&](double by_formula) {
    if(options.is_quiet && options.report.empty()) return;
    expected = foretold_faces(by_formula, std::isfinite(distance_allowed(options)), region, size,
                              mesh, parameters);
    if(options.is_quiet) return;
    progress.clear();
    std::cout << "Faces expected beforehand " << std::llround(expected) << std::endl;
  });
  QMA::Adaptation_report report = region.empty()
                                      ? QMA::adapt_quad_mesh(size, mesh, parameters)
                                      : QMA::adapt_quad_mesh(region, size, mesh, parameters);
  if(expected > 0) report.expected_number_of_faces = expected;
  return report;
}

inline QMA::Adaptation_report adapt(const Options& options, const Size_function& size, Mesh& mesh,
                                    const Mesh_sets& sets, const Mesh& reference,
                                    const std::vector<Mesh::Face_index>& region)
{
  const Thread_limit threads(options.threads);
  Progress progress(options.is_quiet);
  const std::function<bool(double)> callback = [&](double done) { return progress.advance(done); };
  const auto is_frozen = [&](Mesh::Edge_index e) {
    return options.is_border_frozen && mesh.is_border(e);
  };
  const auto course = CGAL::parameters::visitor(std::ref(progress))
                          .callback(callback)
                          .number_of_iterations(options.max_iterations)
                          .face_patch_map(sets.patches())
                          .edge_is_constrained_map(sets.marked_edges())
                          .vertex_is_constrained_map(sets.fixed_vertices());
  const auto constraints = QMA::edge_is_frozen_map(
      boost::make_function_property_map<Mesh::Edge_index>(is_frozen),
      QMA::feature_angle(options.feature_angle,
                         QMA::concurrency(CGAL::Parallel_if_available_tag(), course)));
  const auto geometry = QMA::smooth_reference(
      options.is_smooth, QMA::max_distance(distance_allowed(options), constraints));
  const bool is_paper = options.schedule == "paper", is_nearest = options.aim == "nearest";
  const auto parameters =
      QMA::schedule(is_paper ? QMA::Schedule::paper : QMA::Schedule::progressive,
                    QMA::aim(is_nearest ? QMA::Aim::nearest : QMA::Aim::not_larger,
                             QMA::effort(options.is_quick ? QMA::Effort::quick : QMA::Effort::full,
                                         QMA::symmetry(!options.may_lose_symmetry, geometry))));
  if(options.reference.empty()) return adapt(options, region, size, mesh, progress, parameters);
  return adapt(options, region, size, mesh, progress,
               QMA::reference_surface(reference, parameters));
}

#endif // QUAD_ADAPT_ADAPT_H
