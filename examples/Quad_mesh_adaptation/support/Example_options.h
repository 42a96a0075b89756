// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_EXAMPLES_EXAMPLE_OPTIONS_H
#define QUAD_MESH_ADAPTATION_EXAMPLES_EXAMPLE_OPTIONS_H

#include <CGAL/Quad_mesh_adaptation/parameters.h>

#include <CLI/CLI.hpp>

#include <map>
#include <string>

/// The command line that the programs of the paper's cases share; a program may add options to
/// `app` before it calls `parse()`.
struct Example_options
{
  using Schedule = CGAL::Quad_mesh_adaptation::Schedule;

  explicit Example_options(const std::string& description) : app(description)
  {
    const std::map<std::string, Schedule> schedules = { { "default", Schedule::progressive },
                                                        { "paper", Schedule::paper } };
    app.add_option("directory", directory, "Where to write the meshes and pictures")
        ->check(CLI::ExistingDirectory);
    app.add_option("--schedule", schedule, "default, or paper: step by step as published")
        ->transform(CLI::CheckedTransformer(schedules));
    app.add_option("--k", k, "Initial mesh k times finer, sizes k times smaller")
        ->check(CLI::Range(1, 100));
  }

  /// False when the program is to end with `exit_code`: after --help or a wrong command line.
  bool parse(int argc, char** argv)
  {
    try {
      app.parse(argc, argv);
      return true;
    } catch(const CLI::ParseError& e) {
      exit_code = app.exit(e);
      return false;
    }
  }

  CLI::App app;
  std::string directory = ".";
  Schedule schedule = Schedule::progressive;
  int k = 1;
  int exit_code = 0;
};

#endif // QUAD_MESH_ADAPTATION_EXAMPLES_EXAMPLE_OPTIONS_H
