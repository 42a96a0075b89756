// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_BENCHMARK_SPEED_REPORT_H
#define QUAD_MESH_ADAPTATION_BENCHMARK_SPEED_REPORT_H

#include "../table_text.h"
#include "Results.h"

#include <CGAL/version.h>

#include <cmath>
#include <ctime>
#include <fstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

// The results as tables in Markdown.
namespace speed {

using quality::formatted;

class Speed_report
{
public:
  Speed_report(const Results& results, std::vector<std::string> shapes)
      : results_(results), shapes_(std::move(shapes))
  {
  }

  std::string text() const
  {
    return heading() + goals() + times() + removed() + peers() + small_changes() + phases() +
           memory();
  }

private:
  static std::string processor()
  {
    std::ifstream in("/proc/cpuinfo");
    for(std::string line; std::getline(in, line);)
      if(line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
    return "unknown processor";
  }

  std::string heading() const
  {
    const std::time_t now = std::time(nullptr);
    char day[20];
    std::strftime(day, sizeof day, "%Y-%m-%d", std::gmtime(&now));
    return "# Speed and memory\n\n"
           "Written by `scripts/speed_report.sh` on " +
           std::string(day) +
           formatted(" (%s, %u processors,\n", processor().c_str(),
                     std::thread::hardware_concurrency()) +
           "g++ " __VERSION__ ", CGAL " CGAL_VERSION_STR
           ", Release). Times are of the processor, for a whole call:\n"
           "copying in, preparing the reference surface, measuring and writing back included.\n"
           "Runs of all tasks are interleaved at random; figures are medians\n(" +
           runs() + ")" + spreads() +
           ".\n\n"
           "*refine* is `refine()` from a coarse mesh, with smoothing; *adapt* is the default\n"
           "`adapt_quad_mesh()` on a mesh of about as many faces as the result has; *coarsen* is\n"
           "`coarsen()` to edges four times as long. Sizes are graded: those of the paper for "
           "plate\n"
           "and nosecone, growing threefold from tail to head for the closed surface `spot`.\n"
           "Coarsening is to a uniform size. Plate and spot are symmetric: a part is adapted and "
           "mirrored,\n"
           "and *whole* is without that; times with 2 threads are those of the clock.\n\n"
           "![Time](fig/speed_time.svg)\n![Memory](fig/speed_memory.svg)\n\n";
  }

  // Of how many runs, by level.
  std::string runs() const
  {
    std::string list;
    for(int level : results_.levels())
      list += (list.empty() ? "of " : ", ") + std::to_string(results_.runs_at(level)) +
              (list.empty() ? " run(s) of each at 1e" : " at 1e") + std::to_string(level);
    return list;
  }

  // Nothing where no task was run twice.
  std::string spreads() const
  {
    const double middle = results_.median_spread(), most = results_.largest_spread();
    return most > 0 ? formatted(", and the runs of a task lie %.0f %% apart in the middle, %.0f %% "
                                "at most",
                                100 * middle, 100 * most)
                    : std::string();
  }

  // A goal with what was measured; empty when it was not measured.
  static std::string goal(const std::string& what, const char* format, double value, double limit)
  {
    if(!(value > 0)) return "";
    return "| " + what + " | " + formatted(format, limit) + " | " + formatted(format, value) +
           (value <= limit ? " | yes |\n" : " | **no** |\n");
  }

  static double per_face(const Result* r) { return r ? r->microseconds_per_face() : 0; }
  static double ratio(const Result* a, const Result* b)
  {
    return a && b ? per_face(a) / per_face(b) : 0;
  }

  std::string goals() const
  {
    std::string s = "## Goals\n\n| | at most | measured | met |\n| --- | ---: | ---: | --- |\n";
    for(int level : { 5, 6 })
      for(const std::string& shape : shapes_) s += goals_of(shape, level);
    for(const std::string& shape : shapes_)
      s += goal(shape + ": adapt, 1e7 over 1e5 faces", "%.2f",
                ratio(results_.find("adapt", shape, 7), results_.find("adapt", shape, 5)), 1.3);
    s += goal("all calls and shapes, bytes per face from 1e5 faces on", "%.0f", most_memory(), 600);
    return s + "\n";
  }

  std::string goals_of(const std::string& shape, int level) const
  {
    const std::string of = shape + " at 1e" + std::to_string(level) + ": ";
    const auto found = [&](const char* what) { return results_.find(what, shape, level); };
    std::string s;
    s += goal(of + "adapt, us per face", "%.1f", per_face(found("adapt")), 25);
    s += goal(of + "adapt with 2 threads, us per face by the clock", "%.1f",
              per_face(found("adapt, 2 threads")), 14);
    s += goal(of + "refine, us per face", "%.1f", per_face(found("refine")), 4);
    s += goal(of + "refine over isotropic_remeshing", "%.2f",
              ratio(found("refine"), found("isotropic_remeshing")), 1);
    s += goal(of + "adapt over isotropic_remeshing from the same mesh", "%.2f",
              ratio(found("adapt"), found("isotropic_remeshing as adapt")), 3);
    s += goal(of + "adapt over Gmsh", "%.2f", ratio(found("adapt"), found("gmsh")), 0.25);
    s += goal(of + "change of 1 %, over from scratch", "%.2f",
              change_over_scratch(found("small change")), 0.1);
    if(const Result* c = found("coarsen 100"))
      s += goal(of + "100 times too fine, us per removed face", "%.1f",
                c->microseconds_per_removed_face(), 10);
    return s;
  }

  double most_memory() const
  {
    double most = 0;
    for(const char* what : { "refine", "adapt", "adapt whole", "coarsen", "coarsen 100" })
      for(const std::string& shape : shapes_)
        for(int level : results_.levels())
          if(const Result* r = results_.find(what, shape, level))
            if(level >= 5) most = (std::max)(most, r->bytes_per_face());
    return most;
  }

  // A row for each task and shape, a column for each level; `cell` gives its text.
  template <typename Cell>
  std::string table(const std::string& title, const std::vector<std::string>& tasks,
                    const Cell& cell) const
  {
    std::string head = "| |", line = "| --- |", rows;
    for(int level : results_.levels()) {
      head += " 1e" + std::to_string(level) + " |";
      line += " ---: |";
    }
    for(const std::string& what : tasks)
      for(const std::string& shape : shapes_) {
        if(!results_.largest(what, shape)) continue;
        rows += "| " + what + ", " + shape + " |";
        for(int level : results_.levels()) {
          const Result* r = results_.find(what, shape, level);
          rows += " " + (r ? cell(*r) : std::string()) + " |";
        }
        rows += "\n";
      }
    return rows.empty() ? "" : "## " + title + "\n\n" + head + "\n" + line + "\n" + rows + "\n";
  }

  std::string times() const
  {
    return table("Microseconds per face of the result, and faces",
                 { "refine", "refine whole", "adapt", "adapt, 2 threads", "adapt whole",
                   "adapt whole, 2 threads" },
                 [](const Result& r) {
                   return formatted("%.1f (%.0f)", r.microseconds_per_face(), r.faces_out());
                 });
  }

  std::string removed() const
  {
    return table("Coarsening: microseconds per removed face, and faces before and after",
                 { "coarsen", "coarsen 100" }, [](const Result& r) {
                   return formatted("%.1f (%.0f, %.0f)", r.microseconds_per_removed_face(),
                                    r.faces_in(), r.faces_out());
                 });
  }

  std::string peers() const
  {
    const auto against = [this](const char* peer, const char* ours) {
      return table(std::string(ours) + " over " + peer + ", time per element, and that of " + peer +
                       " in microseconds",
                   { peer }, [=](const Result& r) {
                     const Result* own = results_.find(ours, r.task->shape, r.task->level);
                     return own ? formatted("%.2f (%.1f)", ratio(own, &r), per_face(&r))
                                : formatted("- (%.1f)", per_face(&r));
                   });
    };
    const std::string s = against("isotropic_remeshing", "refine") +
                          against("isotropic_remeshing as adapt", "adapt") +
                          against("isotropic_remeshing", "adapt") + against("gmsh", "adapt");
    return s.empty()
               ? s
               : s + "`isotropic_remeshing` makes as many triangles, of one size, in three "
                     "iterations: from the same\ncoarse mesh as *refine*, or *as adapt* from the "
                     "fine mesh that is adapted (of `spot` they are the same).\nGmsh runs with one "
                     "thread, Frontal-Delaunay and Blossom, the same size as background\nfield, "
                     "as a process with its reading and writing.\n\n";
  }

  // The same sizes from scratch.
  double change_over_scratch(const Result* change) const
  {
    if(!change) return 0;
    const Task& t = *change->task;
    const Result* scratch = results_.find("small change from scratch", t.shape, t.level);
    return scratch ? change->seconds() / scratch->seconds() : 0;
  }

  std::string small_changes() const
  {
    return table(
        "Half the size on 1 % of the faces of an adapted mesh, over the same from scratch, "
        "and microseconds per face",
        { "small change" }, [this](const Result& r) {
          return formatted("%.2f (%.1f)", change_over_scratch(&r), r.microseconds_per_face());
        });
  }

  std::string phases() const
  {
    std::string s;
    for(const char* what : { "refine", "adapt", "coarsen 100" })
      for(const std::string& shape : shapes_) {
        const Result* r = results_.largest(what, shape);
        if(!r) continue;
        double named = 0;
        s += "| " + r->task->name() + " |";
        for(const auto& [name, microseconds] : r->phases()) {
          named += microseconds;
          s += " " + name + formatted(" %.1f,", microseconds);
        }
        s += formatted(" rest %.1f |\n", (std::max)(0., wall(*r) - named));
      }
    return "## By phase, microseconds of the wall per face of the result\n\n| | |\n| --- | --- "
           "|\n" +
           s + "\n";
  }

  static double wall(const Result& r)
  {
    std::vector<double> seconds;
    for(const Outcome& o : r.runs) seconds.push_back(o.wall);
    return 1e6 * median(seconds) / r.faces_out();
  }

  std::string memory() const
  {
    return table("Peak of memory above the mesh itself, bytes per face of the larger mesh",
                 { "refine", "adapt", "coarsen", "coarsen 100" },
                 [](const Result& r) {
                   return r.peak > 0 ? formatted("%.0f", r.bytes_per_face()) : std::string();
                 }) +
           "Each of these ran in a process of its own. The peak is that of the resident memory "
           "during the\ncall, less what was resident before it, less what the mesh has grown.\n";
  }

  const Results& results_;
  std::vector<std::string> shapes_;
};

} // namespace speed

#endif // QUAD_MESH_ADAPTATION_BENCHMARK_SPEED_REPORT_H
