// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// quality_table OUTPUT.md [--long | --huge] [--only TEXT] [--pictures FOLDER]
// Adapts the cases of the paper, and other meshes to uniform sizes, with both schedules, and writes
// what came out as a table in Markdown.  The file is complete after every row.

#include "fewest_faces.h"
#include "quality_cases.h"
#include "table_text.h"

#include <CGAL/Quad_mesh_adaptation/IO/File_transaction.h>
#include <CGAL/Quad_mesh_adaptation/IO/write_picture.h>
#include <CGAL/adapt_quad_mesh.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <fstream>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace QMA = CGAL::Quad_mesh_adaptation;
using quality::Case;

using quality::formatted;
using quality::irregular_percent;

// What is known to keep a mesh from a goal; it is missed all the same.
std::string efficiency_limit(const Case& c, const QMA::Adaptation_report& report, double goal)
{
  const double ideal = report.after.ideal_number_of_faces, whole = std::ceil(ideal);
  if(ideal < goal * whole) return formatted(" (%.2f at most, in whole faces)", ideal / whole);
  const double size = c.kind == quality::Kind::uniform ? c.size(quality::Point(0, 0, 0))
                                                       : std::numeric_limits<double>::infinity();
  const quality::Fewest_faces fewest =
      quality::fewest_faces(c.initial, c.reference.has_value(), size);
  const bool are_those_kept = fewest.patches == report.patches; // else features are others
  return are_those_kept && ideal < goal * double(fewest.faces)
             ? formatted(" (%.2f at most: %zu faces for its %zu patches)",
                         ideal / double(fewest.faces), fewest.faces, fewest.patches)
             : "";
}

std::string shape_limit(const QMA::Adaptation_report& report)
{
  const std::size_t held = std::size_t(
      std::count_if(report.poor_faces.begin(), report.poor_faces.end(),
                    [](const QMA::Poor_face& p) { return p.limit != QMA::Shape_limit::none; }));
  return held > 0 ? formatted(" (%zu of %zu poor faces held by the input)", held,
                              report.poor_faces.size())
                  : "";
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
  miss(m.efficiency < g.efficiency,
       formatted("efficiency %.2f", g.efficiency) + efficiency_limit(c, report, g.efficiency));
  miss(m.size_ratio.percent(0) > g.below_half, formatted("< 0.5: %.1f %%", g.below_half));
  miss(m.min_scaled_jacobian < jacobian - 1e-9,
       formatted("Jacobian %.2f", jacobian) + shape_limit(report));
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

struct Outcome
{
  quality::Mesh mesh;
  QMA::Adaptation_report report;
  double microseconds; // of the process: other jobs do not count
};

Outcome adapt(const Case& c, QMA::Schedule schedule)
{
  Outcome o = { c.initial, {}, 0 };
  const std::clock_t start = std::clock();
  o.report =
      c.reference
          ? QMA::adapt_quad_mesh(c.size, o.mesh,
                                 QMA::schedule(schedule, QMA::reference_surface(*c.reference)))
          : QMA::adapt_quad_mesh(c.size, o.mesh, QMA::schedule(schedule));
  o.microseconds = 1e6 * double(std::clock() - start) / CLOCKS_PER_SEC;
  return o;
}

std::string row(const Case& c, QMA::Schedule schedule, const Outcome& o)
{
  const bool is_default = schedule == QMA::Schedule::progressive;
  const std::string head = "| " + c.name + " | " + (is_default ? "default" : "paper") + " | ";
  if(!o.report.has_valid_mesh()) return head + "refused: " + o.report.message + " |||||||||| |\n";
  const QMA::Mesh_measures& m = o.report.after;
  return head +
         formatted("%zu | %.2f | %.3f | %.3f | %.2f | %.3f | %s | %.1f | %.0f | ", m.faces,
                   m.strict_size_ratio.percent_not_larger(), m.strict_size_ratio.max, m.efficiency,
                   m.size_ratio.percent(0), m.min_scaled_jacobian,
                   quality::valence_range(m).c_str(), irregular_percent(m),
                   o.microseconds / double(m.faces)) +
         (is_default ? missed_goals(c, o.report) : "") + " |\n";
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
    "Written by `scripts/quality_table.sh --long`. f_s is a face's mean edge length over the size "
    "at\n"
    "its centre, f_strict over the smaller of that and the inverse root mean square of the size\n"
    "at the 2 x 2 Gauss points. Efficiency is the integral of 1/h^2 over the surface, over the\n"
    "number of faces. *Default* and *paper* are the two schedules of this package, *as published*\n"
    "the figures of Anderson, Benzley and Owen (2009) on their own meshes, where the efficiency\n"
    "is that for the same size function. With k the initial mesh is k times finer and the sizes\n"
    "k times smaller. The last column names the goals that the default schedule misses, with the\n"
    "goal, and what is known to forbid it; for uniform sizes the goal for irregular vertices\n"
    "comes on top of the input's share, and the Jacobian need not be better than the input's.\n"
    "Where it says so many faces for patches, features ask for these: a patch between features "
    "with\n"
    "Euler characteristic x and b edges around it has b / 2 - x quads or more, at any size, and b "
    "is\n"
    "one from corner to corner and three around a smooth loop at least; a flat patch between "
    "straight\n"
    "features has as many as its area over the square of a uniform size.\n"
    "Times are of the processor, in\n"
    "microseconds for each face of the result, and for all of a call: preparing the reference\n"
    "surface and measuring the result are included. What each ingredient of the default schedule "
    "is\n"
    "worth is in [ablation.md](ablation.md).\n\n"
    "![Circular load, both schedules](fig/schedules_circular_load.png)\n"
    "![Nosecone, both schedules](fig/schedules_nosecone.png)\n"
    "![Plate with a hole, both schedules](fig/schedules_plate_with_hole.png)\n\n"
    "| case | schedule | faces | % f_strict <= 1 | max f_strict | efficiency | % f_s < 0.5 | "
    "min scaled Jacobian | inner valence | % irregular inner vertices | us / face | missed |\n"
    "| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | --- |\n";

struct Options
{
  std::string file, folder = QUAD_MESH_DATA_DIR "/meshes", only, pictures;
  bool is_long = false, is_huge = false;

  quality::Extent extent() const
  {
    return is_huge   ? quality::Extent::huge
           : is_long ? quality::Extent::large
                     : quality::Extent::usual;
  }
};

// The size and what both schedules make of it, side by side.
void write_case_picture(const Case& c, const quality::Mesh& by_default,
                        const quality::Mesh& by_paper, const std::string& folder)
{
  QMA::Picture picture;
  picture.add_sizing(c.initial, c.size, "Size asked for");
  picture.add_mesh(by_default, "Default schedule");
  picture.add_mesh(by_paper, "The paper's schedule");
  QMA::File_transaction files;
  const std::string name = c.name.substr(0, c.name.find(','));
  const auto staged = files.stage(folder + "/schedules_" + name + ".svg", picture.svg());
  if(!staged.ok()) throw std::runtime_error(staged.message);
  const auto written = files.commit();
  if(!written.ok()) throw std::runtime_error(written.message);
}

void write_table(const Options& options)
{
  std::ofstream out(options.file);
  if(!(out << heading << std::flush)) throw std::runtime_error(options.file + " cannot be written");
  for(const Case& c : quality::all_cases(options.folder, options.extent())) {
    if(c.name.find(options.only) == std::string::npos) continue;
    std::vector<quality::Mesh> results;
    double ideal_number_of_faces = 0;
    for(QMA::Schedule schedule : { QMA::Schedule::progressive, QMA::Schedule::paper }) {
      Outcome outcome = adapt(c, schedule);
      const std::string text = row(c, schedule, outcome);
      std::cout << text << std::flush;
      out << text << std::flush;
      results.push_back(std::move(outcome.mesh));
      ideal_number_of_faces = outcome.report.after.ideal_number_of_faces;
    }
    if(!c.paper_counts) continue;
    out << papers_row(c, ideal_number_of_faces) << std::flush;
    if(!options.pictures.empty()) write_case_picture(c, results[0], results[1], options.pictures);
  }
}

int main(int argc, char** argv)
{
  CLI::App app("Measures adapted meshes and writes a table in Markdown.");
  Options options;
  app.add_option("OUTPUT", options.file, "The table (.md)")->required();
  app.add_flag("--long", options.is_long, "Also the cases of 1e5 faces and more");
  app.add_flag("--huge", options.is_huge, "Also that of 1e6 faces");
  app.add_option("--only", options.only, "Only the cases whose name holds this");
  app.add_option("--pictures", options.pictures,
                 "Draw both schedules' meshes of the paper's cases, into this folder")
      ->check(CLI::ExistingDirectory);
  CLI11_PARSE(app, argc, argv);
  try {
    write_table(options);
  } catch(const std::exception& error) {
    std::cerr << "quality_table: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
