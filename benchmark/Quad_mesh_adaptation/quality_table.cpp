// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// quality_table OUTPUT.md [--long] [--only TEXT]
// Adapts the cases of the paper, and other meshes to uniform sizes, with both schedules, and writes
// what came out as a table in Markdown.  The file is complete after every row.

#include "quality_cases.h"

#include <CGAL/Quad_mesh_adaptation/measure_quad_mesh.h>
#include <CGAL/adapt_quad_mesh.h>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <fstream>
#include <iostream>
#include <string>

namespace QMA = CGAL::Quad_mesh_adaptation;
using quality::Case;

template <class... Values>
std::string formatted(const char* format, Values... values)
{
  char text[200];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

double irregular_percent(const QMA::Mesh_measures& m)
{
  return m.interior_vertices
             ? 100. * double(m.irregular_interior_vertices) / double(m.interior_vertices)
             : 0.;
}

std::string valence_range(const QMA::Mesh_measures& m)
{
  std::size_t low = 0, high = 0;
  for(const auto& [valence, count] : m.interior_valence) {
    if(count == 0) continue;
    if(low == 0) low = valence;
    high = valence;
  }
  return low == 0 ? "-" : std::to_string(low) + "-" + std::to_string(high);
}

// The goals that the adapted mesh misses, by their figures.
std::string missed_goals(const Case& c, const QMA::Adaptation_report& report)
{
  const QMA::Mesh_measures &m = report.after, &before = report.before;
  const quality::Goals g = c.goals(m.faces);
  const double jacobian =
      g.is_relative ? (std::min)(g.scaled_jacobian, before.min_scaled_jacobian) : g.scaled_jacobian;
  const double irregular = g.irregular + (g.is_relative ? irregular_percent(before) : 0.);
  std::string missed;
  const auto miss = [&](bool is_missed, const std::string& text) {
    if(is_missed) missed += (missed.empty() ? "" : ", ") + text;
  };
  miss(m.strict_size_ratio.percent_not_larger() < 100, "size");
  miss(m.efficiency < g.efficiency, formatted("efficiency %.2f", g.efficiency));
  miss(m.size_ratio.percent(0) > g.below_half, formatted("< 0.5: %.1f %%", g.below_half));
  miss(m.min_scaled_jacobian < jacobian - 1e-9, formatted("Jacobian %.2f", jacobian));
  std::size_t other_valence = 0, other_before = 0;
  for(const auto& [valence, count] : m.interior_valence)
    if(valence < 3 || valence > 5) other_valence += count;
  for(const auto& [valence, count] : before.interior_valence)
    if(valence < 3 || valence > 5) other_before += count;
  miss(other_valence > 0, other_before > 0
                              ? formatted("valence (%zu, input %zu)", other_valence, other_before)
                              : formatted("valence (%zu)", other_valence));
  miss(irregular_percent(m) > irregular, formatted("irregular %.0f %%", irregular));
  return missed.empty() ? "none" : missed;
}

std::string row(const Case& c, QMA::Schedule schedule)
{
  const bool is_default = schedule == QMA::Schedule::progressive;
  const std::string head = "| " + c.name + " | " + (is_default ? "default" : "paper") + " | ";
  quality::Mesh mesh = c.initial;
  const std::clock_t start = std::clock(); // of the process: other jobs do not count
  const QMA::Adaptation_report report =
      c.reference ? QMA::adapt_quad_mesh(
                        c.size, mesh, QMA::schedule(schedule, QMA::reference_surface(*c.reference)))
                  : QMA::adapt_quad_mesh(c.size, mesh, QMA::schedule(schedule));
  const double microseconds = 1e6 * double(std::clock() - start) / CLOCKS_PER_SEC;
  if(!report.has_valid_mesh()) return head + "refused: " + report.message + " |||||||||| |\n";
  const QMA::Mesh_measures& m = report.after;
  return head +
         formatted("%zu | %.2f | %.3f | %.3f | %.2f | %.3f | %s | %.1f | %.0f | ", m.faces,
                   m.strict_size_ratio.percent_not_larger(), m.strict_size_ratio.max, m.efficiency,
                   m.size_ratio.percent(0), m.min_scaled_jacobian, valence_range(m).c_str(),
                   irregular_percent(m), microseconds / double(m.faces)) +
         (is_default ? missed_goals(c, report) : "") + " |\n";
}

// What the paper prints of a case; it counts faces by the size at their centre only.
std::string papers_row(const Case& c, double ideal_number_of_faces)
{
  QMA::Size_ratio_table t;
  t.counts = *c.paper_counts;
  const std::string efficiency =
      c.has_papers_size ? formatted("%.3f", ideal_number_of_faces / double(t.total())) : "";
  return "| " + c.name + " | *as published* | " +
         formatted("%zu | %.2f (f_s) | %s | %s | %.2f | | up to 6 | | | |\n", t.total(),
                   t.percent_not_larger(),
                   t.counts[7] > 0   ? "> 1.5"
                   : t.counts[5] > 0 ? "> 1.1"
                                     : "> 1.0",
                   efficiency.c_str(), t.percent(0));
}

const char* const heading =
    "# Quality of adapted meshes\n\n"
    "Written by `scripts/quality_table.sh`. f_s is a face's mean edge length over the size at\n"
    "its centre, f_strict over the smaller of that and the inverse root mean square of the size\n"
    "at the 2 x 2 Gauss points. Efficiency is the integral of 1/h^2 over the surface, over the\n"
    "number of faces. *Default* and *paper* are the two schedules of this package, *as published*\n"
    "the figures of Anderson, Benzley and Owen (2009) on their own meshes, where the efficiency\n"
    "is that for the same size function. With k the initial mesh is k times finer and the sizes\n"
    "k times smaller. The last column names the goals that the default schedule misses, with the\n"
    "goal. Times are of the processor, in microseconds for each face of the result, and for all\n"
    "of a call: preparing the reference surface and measuring the result are included.\n\n"
    "| case | schedule | faces | % f_strict <= 1 | max f_strict | efficiency | % f_s < 0.5 | "
    "min scaled Jacobian | inner valence | % irregular inner vertices | us / face | missed |\n"
    "| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | --- |\n";

void write_table(const std::string& file, const std::string& folder, bool is_long,
                 const std::string& only)
{
  std::ofstream out(file);
  if(!(out << heading << std::flush)) throw std::runtime_error(file + " cannot be written");
  for(const Case& c : quality::all_cases(folder, is_long)) {
    if(c.name.find(only) == std::string::npos) continue;
    for(QMA::Schedule schedule : { QMA::Schedule::progressive, QMA::Schedule::paper }) {
      const std::string text = row(c, schedule);
      std::cout << text << std::flush;
      out << text << std::flush;
    }
    if(!c.paper_counts) continue;
    const double ideal =
        QMA::measure_quad_mesh(c.initial, c.size).ideal_number_of_faces; // coarse: about right
    out << papers_row(c, ideal) << std::flush;
  }
}

int main(int argc, char** argv)
{
  CLI::App app("Measures adapted meshes and writes a table in Markdown.");
  std::string file, folder = QUAD_MESH_DATA_DIR "/meshes", only;
  bool is_long = false;
  app.add_option("OUTPUT", file, "The table (.md)")->required();
  app.add_flag("--long", is_long, "Also the cases of 1e5 faces and more");
  app.add_option("--only", only, "Only the cases whose name holds this");
  CLI11_PARSE(app, argc, argv);
  try {
    write_table(file, folder, is_long, only);
  } catch(const std::exception& error) {
    std::cerr << "quality_table: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
