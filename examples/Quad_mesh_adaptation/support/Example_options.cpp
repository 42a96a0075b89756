// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Example_options.h"

#include <CLI/CLI.hpp>

#include <map>

Example_options::Example_options(const std::string& description)
    : app_(std::make_unique<CLI::App>(description))
{
  const std::map<std::string, Schedule> schedules = { { "default", Schedule::progressive },
                                                      { "paper", Schedule::paper } };
  app_->add_option("directory", directory, "Where to write the meshes and pictures")
      ->check(CLI::ExistingDirectory);
  app_->add_option("--schedule", schedule, "default, or paper: step by step as published")
      ->transform(CLI::CheckedTransformer(schedules));
  add("--k", k, 1, 100, "Initial mesh k times finer, sizes k times smaller");
}

Example_options::~Example_options() = default;

void Example_options::add(const std::string& name, double& value, double least, double most,
                          const std::string& description)
{
  app_->add_option(name, value, description)->check(CLI::Range(least, most));
}

void Example_options::add(const std::string& name, int& value, int least, int most,
                          const std::string& description)
{
  app_->add_option(name, value, description)->check(CLI::Range(least, most));
}

void Example_options::add_flag(const std::string& name, bool& value, const std::string& description)
{
  app_->add_flag(name, value, description);
}

bool Example_options::parse(int argc, char** argv)
{
  try {
    app_->parse(argc, argv);
    return true;
  } catch(const CLI::ParseError& e) {
    exit_code = app_->exit(e);
    return false;
  }
}
