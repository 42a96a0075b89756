// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_EXAMPLES_REPORT_JSON_H
#define QUAD_MESH_ADAPTATION_EXAMPLES_REPORT_JSON_H

#include "report_names.h"

#include <CGAL/Quad_mesh_adaptation/Adaptation_report.h>

#include <nlohmann/json.hpp>

#include <string>

/// Counts per bin, the bins named by their limits, and the extremes.
inline nlohmann::ordered_json to_json(const CGAL::Quad_mesh_adaptation::Size_ratio_table& table)
{
  nlohmann::ordered_json faces;
  for(std::size_t bin = 0; bin < table.number_of_bins; ++bin)
    faces[table.titles()[bin]] = table.counts[bin];
  return { { "faces", faces },
           { "percent_not_larger", table.percent_not_larger() },
           { "min", table.min },
           { "mean", table.mean },
           { "max", table.max } };
}

inline nlohmann::ordered_json to_json(const CGAL::Quad_mesh_adaptation::Mesh_measures& m)
{
  nlohmann::ordered_json valence;
  for(const auto& [edges, vertices] : m.interior_valence) valence[std::to_string(edges)] = vertices;
  return {
    { "vertices", m.vertices },
    { "edges", m.edges },
    { "faces", m.faces },
    { "components", m.components },
    { "boundary_edges", m.boundary_edges },
    { "boundary_loops", m.boundary_loops },
    { "euler_characteristic", m.euler_characteristic },
    { "size_ratio", to_json(m.size_ratio) },
    { "strict_size_ratio", to_json(m.strict_size_ratio) },
    { "ideal_number_of_faces", m.ideal_number_of_faces },
    { "efficiency", m.efficiency },
    { "scaled_jacobian",
      { { "min", m.min_scaled_jacobian },
        { "p5", m.p5_scaled_jacobian },
        { "mean", m.mean_scaled_jacobian } } },
    { "angle_degrees", { { "min", m.min_angle }, { "max", m.max_angle } } },
    { "max_warp", m.max_warp },
    { "inverted_faces", m.inverted_faces },
    { "interior_vertices", m.interior_vertices },
    { "interior_valence", valence.is_null() ? nlohmann::ordered_json::object() : valence },
    { "irregular_interior_vertices", m.irregular_interior_vertices },
    { "max_valence", m.max_valence },
    { "max_distance_to_reference", m.max_distance_to_reference },
    { "mesh_to_reference", m.mesh_to_reference },
    { "reference_to_mesh", m.reference_to_mesh },
  };
}

inline nlohmann::ordered_json to_json(const CGAL::Quad_mesh_adaptation::Size_growth& g)
{
  return { { "largest_slope", g.largest_slope },         { "where", g.where },
           { "followed_slope", g.followed_slope },       { "steep_area_share", g.steep_area_share },
           { "steep_faces_share", g.steep_faces_share }, { "steep_faces", g.steep_faces },
           { "largest_jump", g.largest_jump },           { "is_too_steep", g.is_too_steep() } };
}

inline nlohmann::ordered_json to_json(const CGAL::Quad_mesh_adaptation::Poor_face& p)
{
  nlohmann::ordered_json j = { { "face", p.face },
                               { "scaled_jacobian", p.scaled_jacobian },
                               { "limit", name_of(p.limit) } };
  if(p.limit != CGAL::Quad_mesh_adaptation::Shape_limit::feature_angle) return j;
  j["angle"] = p.angle;
  j["vertex"] = p.vertex;
  return j;
}

/// The whole report; numbers that are not finite become null.
inline nlohmann::ordered_json to_json(const CGAL::Quad_mesh_adaptation::Adaptation_report& report)
{
  nlohmann::ordered_json operations = nlohmann::ordered_json::object(),
                         seconds = nlohmann::ordered_json::object();
  for(const auto& operation : report.operations) operations[operation.name] = operation.count;
  for(const auto& phase : report.times) seconds[phase.name] = phase.seconds;
  nlohmann::ordered_json poor = nlohmann::ordered_json::array();
  for(const auto& p : report.poor_faces) poor.push_back(to_json(p));
  return { { "status", name_of(report.status) },
           { "reason", name_of(report.reason) },
           { "message", report.message },
           { "entity", report.entity },
           { "place", report.place ? nlohmann::ordered_json(*report.place) : nullptr },
           { "expected_number_of_faces", report.expected_number_of_faces },
           { "advice", report.advice },
           { "size_growth", to_json(report.size_growth) },
           { "iterations", report.iterations },
           { "before", to_json(report.before) },
           { "after", to_json(report.after) },
           { "operations", operations },
           { "seconds", seconds },
           { "patches", report.patches },
           { "feature_curves", report.feature_curves },
           { "corners", report.corners },
           { "faces_too_large", report.faces_too_large },
           { "faces_too_far", report.faces_too_far },
           { "poor_faces", poor } };
}

#endif // QUAD_MESH_ADAPTATION_EXAMPLES_REPORT_JSON_H
