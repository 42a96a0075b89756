// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_EXAMPLES_EXAMPLE_OPTIONS_H
#define QUAD_MESH_ADAPTATION_EXAMPLES_EXAMPLE_OPTIONS_H

#include <CGAL/Quad_mesh_adaptation/parameters.h>

#include <memory>
#include <string>

namespace CLI {
class App;
}

/// The command line that the programs of the paper's cases share; a program may add options before
/// it calls `parse()`.  Compiled once: CLI11 is large.
class Example_options
{
public:
  using Schedule = CGAL::Quad_mesh_adaptation::Schedule;

  explicit Example_options(const std::string& description);
  ~Example_options();

  /// Numbers from `least` to `most`.
  void add(const std::string& name, double& value, double least, double most,
           const std::string& description);
  void add(const std::string& name, int& value, int least, int most,
           const std::string& description);
  void add_flag(const std::string& name, bool& value, const std::string& description);

  /// False when the program is to end with `exit_code`: after --help or a wrong command line.
  bool parse(int argc, char** argv);

  std::string directory = ".";
  Schedule schedule = Schedule::progressive;
  int k = 1;
  int exit_code = 0;

private:
  std::unique_ptr<CLI::App> app_;
};

#endif // QUAD_MESH_ADAPTATION_EXAMPLES_EXAMPLE_OPTIONS_H
