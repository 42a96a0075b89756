// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// speed OUTPUT_FOLDER [--large] [--only TEXT ...] [--runs N] [options of Google Benchmark]
// Times the public calls and their peers at 1e3 to 1e5 faces (--large: to 1e7), and writes speed.md
// and its plots.  Peaks of memory are those of further processes, which run
//   speed --memory TASK

#include "speed/Results.h"
#include "speed/Speed_report.h"
#include "speed/our_tasks.h"
#include "speed/peer_tasks.h"
#include "speed/plots.h"

#include <benchmark/benchmark.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace speed;

std::vector<Shape> all_shapes()
{
  return { plate(), nosecone(), spot(QUAD_MESH_DATA_DIR "/meshes") };
}

std::vector<Task> all_tasks(const std::vector<Shape>& shapes, int highest,
                            const std::string& scratch)
{
  std::vector<Task> tasks;
  for(int level = 3; level <= highest; ++level)
    for(const Shape& s : shapes) {
      const double faces = std::pow(10., level);
      std::vector<Use_of_symmetry> uses = { Use_of_symmetry::as_by_default };
      if(s.is_symmetric) uses.push_back(Use_of_symmetry::none);
      const bool is_refined = faces > 2 * s.coarse_faces;
      for(const Use_of_symmetry use : uses) {
        tasks.push_back(adapt_task(s, level, use));
#ifdef CGAL_LINKED_WITH_TBB
        tasks.push_back(threads_task(s, level, use, 2));
#endif
        if(is_refined) tasks.push_back(refine_task(s, level, use));
      }
      tasks.push_back(isotropic_task(s, level, false));
      if(is_refined) tasks.push_back(isotropic_task(s, level, true));
      if(faces > 0.5 * s.coarse_faces) {
        tasks.push_back(coarsen_task("coarsen", s, level, 4));
        tasks.push_back(coarsen_task("coarsen 100", s, level, 10));
      }
      if(level >= 4)
        for(Task& t : small_change_tasks(s, level)) tasks.push_back(std::move(t));
    }
  // Blossom takes more than linear time: at 1e6 an hour would not do
  if(has_gmsh(scratch))
    for(int level = 3; level <= (std::min)(highest, 5); ++level)
      tasks.push_back(gmsh_task(shapes.front(), level, scratch));
  return tasks;
}

// The peak of memory of one call, in bytes above the mesh itself, for the parent to read.
void print_memory(const Task& task)
{
  // one removed flag each; a vertex has a point and a half-edge, a half-edge four numbers, a face
  // one; two edges and a vertex for each face
  constexpr double bytes_per_face = (24 + 4 + 1) + 2 * (2 * 16 + 1) + (4 + 1);
  const auto call = task.prepare();
  reset_memory_peak();
  const double before = memory("VmRSS");
  const Outcome o = call();
  const double grown = bytes_per_face * (std::max)(0., o.faces_out - o.faces_in);
  std::cout << memory("VmHWM") - before - grown << '\n';
}

double measured_memory(const Task& task, const std::string& scratch)
{
  const std::string file = scratch + "/memory.log";
  const Child_result child = run_child({ "/proc/self/exe", "--memory", task.name() }, file);
  double bytes = 0;
  if(child.exit_code != 0 || !(std::ifstream(file) >> bytes))
    throw std::runtime_error("no memory of " + task.name() + " was measured");
  return bytes;
}

// One run, in the terms of Google Benchmark.
void run(benchmark::State& state, const Task& task, Results& results)
{
  for(auto _ : state) {
    try {
      const Outcome o = task.prepare()();
      results.of(task).runs.push_back(o);
      state.SetIterationTime(o.cpu);
      state.counters["faces"] = o.faces_out;
      state.counters["us/face"] = 1e6 * o.cpu / o.faces_out;
    } catch(const std::exception& error) {
      state.SkipWithError(error.what());
      break;
    }
  }
}

void write(const std::string& file, const std::string& text)
{
  std::filesystem::create_directories(std::filesystem::path(file).parent_path());
  std::ofstream out(file);
  if(!(out << text << std::flush)) throw std::runtime_error(file + " cannot be written");
}

void measure(const std::vector<Shape>& shapes, const std::vector<Task>& tasks, int most_runs,
             const std::string& folder, const std::string& scratch)
{
  Results results(tasks);
  for(const Task& task : tasks)
    benchmark::RegisterBenchmark(task.name().c_str(),
                                 [&](benchmark::State& state) { run(state, task, results); })
        ->Iterations(1)
        ->Repetitions((std::min)(task.repetitions(), most_runs))
        ->ReportAggregatesOnly(true)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  benchmark::RunSpecifiedBenchmarks();
  std::cout << "Measuring memory ...\n";
  for(const Task& task : tasks)
    if(task.measures_memory && results.of(task).is_done())
      results.of(task).peak = measured_memory(task, scratch);
  std::vector<std::string> names;
  for(const Shape& s : shapes) names.push_back(s.name);
  write(folder + "/speed.md", Speed_report(results, names).text());
  write(folder + "/fig/speed_time.svg", time_plot(results, names).svg());
  write(folder + "/fig/speed_memory.svg", memory_plot(results, names).svg());
}

struct Options
{
  std::string folder, memory_task;
  std::vector<std::string> only;
  int most_runs = 5;
  bool is_large = false;

  bool is_child() const { return !memory_task.empty(); }
  bool wants(const Task& t) const
  {
    if(is_child()) return t.name() == memory_task;
    return only.empty() || std::any_of(only.begin(), only.end(), [&](const std::string& text) {
             return t.name().find(text) != std::string::npos;
           });
  }
};

void describe(CLI::App& app, Options& o)
{
  app.add_option("FOLDER", o.folder, "Where speed.md and fig/speed_*.svg go");
  app.add_flag("--large", o.is_large, "Up to 1e7 faces instead of 1e5");
  app.add_option("--only", o.only, "Only tasks whose name holds this, or one of these")
      ->expected(1)
      ->take_all();
  app.add_option("--runs", o.most_runs, "At most so many runs of a task")
      ->check(CLI::Range(1, 100));
  app.add_option("--memory", o.memory_task, "Print the peak of memory of this task, nothing else");
}

void run(const Options& o)
{
  const std::string scratch = std::filesystem::temp_directory_path().string() +
                              "/quad_mesh_speed_" + std::to_string(getpid());
  std::filesystem::create_directories(scratch);
  const std::vector<Shape> shapes = all_shapes();
  std::vector<Task> tasks = all_tasks(shapes, o.is_large || o.is_child() ? 7 : 5, scratch);
  if(!o.is_child() && !has_gmsh(scratch)) std::cerr << "gmsh is not on the PATH: left out\n";
  tasks.erase(
      std::remove_if(tasks.begin(), tasks.end(), [&](const Task& t) { return !o.wants(t); }),
      tasks.end());
  if(tasks.empty()) throw std::runtime_error("there is no such task");
  if(o.is_child())
    print_memory(tasks.front());
  else if(o.folder.empty())
    throw std::runtime_error("no folder for the report is given");
  else
    measure(shapes, tasks, o.most_runs, o.folder, scratch);
  std::filesystem::remove_all(scratch);
}

int main(int argc, char** argv)
{
  // runs of different tasks take turns, so that a busy machine is so for all of them
  std::vector<char*> arguments(argv, argv + argc);
  std::string interleaved = "--benchmark_enable_random_interleaving=true";
  arguments.insert(arguments.begin() + 1, interleaved.data());
  int count = int(arguments.size());
  arguments.push_back(nullptr);
  benchmark::Initialize(&count, arguments.data());

  CLI::App app("Times adaptation, refinement, coarsening and their peers, and writes a report.");
  Options options;
  describe(app, options);
  CLI11_PARSE(app, count, arguments.data());
  try {
    run(options);
  } catch(const std::exception& error) {
    std::cerr << "speed: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
