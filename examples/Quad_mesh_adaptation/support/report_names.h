// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_EXAMPLES_REPORT_NAMES_H
#define QUAD_MESH_ADAPTATION_EXAMPLES_REPORT_NAMES_H

#include <CGAL/Quad_mesh_adaptation/Adaptation_report.h>

/// The name of a status, as in the source.
inline const char* name_of(CGAL::Quad_mesh_adaptation::Adaptation_status status)
{
  using CGAL::Quad_mesh_adaptation::Adaptation_status;
  switch(status) {
  case Adaptation_status::sizes_met:
    return "sizes_met";
  case Adaptation_status::sizes_not_met:
    return "sizes_not_met";
  case Adaptation_status::input_refused:
    return "input_refused";
  case Adaptation_status::sizes_refused:
    return "sizes_refused";
  case Adaptation_status::cancelled:
    return "cancelled";
  }
  return "unknown";
}

/// The name of a reason to refuse, as in the source.
inline const char* name_of(CGAL::Quad_mesh_adaptation::Refusal reason)
{
  using CGAL::Quad_mesh_adaptation::Refusal;
  switch(reason) {
  case Refusal::none:
    return "none";
  case Refusal::empty_mesh:
    return "empty_mesh";
  case Refusal::not_all_quads:
    return "not_all_quads";
  case Refusal::non_manifold:
    return "non_manifold";
  case Refusal::non_orientable:
    return "non_orientable";
  case Refusal::degenerate_face:
    return "degenerate_face";
  case Refusal::non_finite_coordinate:
    return "non_finite_coordinate";
  case Refusal::invalid_size:
    return "invalid_size";
  case Refusal::invalid_parameter:
    return "invalid_parameter";
  case Refusal::unreadable_file:
    return "unreadable_file";
  case Refusal::unwritable_file:
    return "unwritable_file";
  }
  return "unknown";
}

/// The name of what keeps a face from a better shape, as in the source.
inline const char* name_of(CGAL::Quad_mesh_adaptation::Shape_limit limit)
{
  using CGAL::Quad_mesh_adaptation::Shape_limit;
  switch(limit) {
  case Shape_limit::none:
    return "none";
  case Shape_limit::feature_angle:
    return "feature_angle";
  case Shape_limit::held_nodes:
    return "held_nodes";
  case Shape_limit::curved_surface:
    return "curved_surface";
  }
  return "unknown";
}

#endif // QUAD_MESH_ADAPTATION_EXAMPLES_REPORT_NAMES_H
