// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_ADAPT_OPTIONS_H
#define QUAD_ADAPT_OPTIONS_H

#include <CGAL/Quad_mesh_adaptation/parameters.h>

#include <cstddef>
#include <optional>
#include <string>

/// What the program is asked to do.
struct Options
{
  std::string input, output;
  std::optional<std::string> size, size_function; // at most one of the two is given
  std::optional<double> elements_per_circle, chord_error, elements_across;
  std::string background;                    // mesh with sizes at its vertices
  std::optional<std::string> error_property; // of the input: error indicators
  // one of these where that is given
  std::optional<double> error_target, error_reduction, error_faces;
  double error_order = 1;
  std::optional<double> smallest_size, largest_size;
  std::optional<double> gradation; // largest slope of the size
  std::string reference, report, picture;
  std::string schedule = "default", aim = "not-larger";
  std::optional<std::string> region; // expression that is not zero where faces may change
  bool ignores_sets = false;         // patches, marked edges and fixed vertices of the input
  bool is_border_frozen = false, may_lose_symmetry = false, is_quick = false;
  double feature_angle = CGAL::Quad_mesh_adaptation::default_feature_angle;
  bool is_smooth = false;
  std::optional<double> max_distance;
  std::size_t max_iterations = CGAL::Quad_mesh_adaptation::default_number_of_iterations;
  unsigned threads = 0; // 0: as many as there are
  bool is_quiet = false;
};

/// What the program's exit code says.
enum Exit_code
{
  exit_sizes_met = 0,
  exit_refused = 1,
  exit_wrong_usage = 2,
  exit_sizes_not_met = 3,
  exit_interrupted = 130
};

#endif // QUAD_ADAPT_OPTIONS_H
