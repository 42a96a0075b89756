// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// ablation OUTPUT.md [--only TEXT]
// Runs the default schedule with each of its ingredients left out in turn, and writes what came out
// as a table in Markdown.  The file is complete after every row.

#include "quality_cases.h"
#include "table_text.h"

#include <CGAL/Quad_mesh_adaptation/internal/progressive_schedule.h>
#include <CGAL/Quad_mesh_adaptation/internal/run_on_mesh.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <fstream>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace QMA = CGAL::Quad_mesh_adaptation;
namespace core = QMA::internal;
using quality::Case;
using quality::formatted;

/// The full schedule, or what is taken from it.
struct Variant
{
  std::string name;
  std::function<void(core::Adaptation_state&, core::Schedule_ingredients&)> change;
};

std::vector<Variant> variants()
{
  using State = core::Adaptation_state;
  using Ingredients = core::Schedule_ingredients;
  const auto without = [](bool Ingredients::*ingredient) {
    return [ingredient](State&, Ingredients& use) { use.*ingredient = false; };
  };
  return {
    { "nothing (the full schedule)", [](State&, Ingredients&) {} },
    { "coarsening before refinement", without(&Ingredients::coarsening) },
    { "edge marking: faces cut in four instead", without(&Ingredients::edge_marking) },
    { "octaves: the last sizes from the start", without(&Ingredients::octaves) },
    { "progressive sizes", without(&Ingredients::progressive_sizes) },
    { "sizes in smoothing", without(&Ingredients::size_aware) },
    { "local operations", without(&Ingredients::local_operations) },
    { "annealing", without(&Ingredients::annealing) },
    { "last resorts", without(&Ingredients::last_resorts) },
    { "weight of valences", [](State& s, Ingredients&) { s.energy.valence = 0; } },
    { "sizes at Gauss points",
      [](State& s, Ingredients&) { s.size.sampling = core::Size_sampling::centre; } },
    { "all but halving of edges and smoothing",
      [](State&, Ingredients& use) {
        use.coarsening = use.progressive_sizes = use.size_aware = false;
        use.local_operations = use.annealing = use.last_resorts = false;
      } },
  };
}

struct Outcome
{
  QMA::Adaptation_report report;
  double seconds = 0; // of the schedule alone, of the processor
};

template <class NamedParameters>
Outcome adapt(const Case& c, const Variant& variant, const NamedParameters& np)
{
  constexpr std::size_t most_passes = 40;
  Outcome result;
  quality::Mesh mesh = c.initial;
  const auto algorithm = [&](core::Adaptation_state& s, const core::Prepared_run&) {
    core::Schedule_ingredients use;
    variant.change(s, use);
    const std::clock_t start = std::clock();
    core::progressive_schedule(s, most_passes, use);
    result.seconds += double(std::clock() - start) / CLOCKS_PER_SEC;
  };
  result.report =
      core::run_on_mesh(faces(mesh), false, c.size, mesh, np, core::Call_kind(), algorithm);
  return result;
}

Outcome adapt(const Case& c, const Variant& variant)
{
  return c.reference ? adapt(c, variant, QMA::reference_surface(*c.reference))
                     : adapt(c, variant, CGAL::parameters::default_values());
}

std::string row(const Variant& variant, const Outcome& o, double full_seconds)
{
  if(!o.report.has_valid_mesh())
    return "| " + variant.name + " | refused: " + o.report.message + " |||||||||\n";
  const QMA::Mesh_measures& m = o.report.after;
  return "| " + variant.name + " | " +
         formatted("%zu | %.2f | %.3f | %.3f | %.3f | %.1f | %s | %.2f |\n", m.faces,
                   m.strict_size_ratio.percent_not_larger(), m.strict_size_ratio.max, m.efficiency,
                   m.min_scaled_jacobian, quality::irregular_percent(m),
                   quality::valence_range(m).c_str(), o.seconds / full_seconds);
}

const char* const heading =
    "# What each ingredient of the default schedule is worth\n\n"
    "Written by `scripts/quality_table.sh --ablation`. In each row, one "
    "ingredient is left out and\n"
    "all else is as it was; columns and cases are those of quality.md. "
    "Times are of the processor,\n"
    "for the schedule alone, over that of the full schedule. Two things remain where their\n"
    "ingredient is left out: without sizes in smoothing the last rounds still press on faces that\n"
    "are too large, and without the weight of valences no operation makes a valence above five.\n";

const char* const columns =
    "| left out | faces | % f_strict <= 1 | max f_strict | efficiency | min scaled Jacobian | "
    "% irregular inner vertices | inner valence | time |\n"
    "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n";

std::vector<Case> chosen_cases(const std::string& folder, const std::string& only)
{
  const std::vector<std::string> names = {
    "circular_load, k = 1", "circular_load, sizes / 4",
    "nosecone, k = 1",      "plate_with_hole, k = 1",
    "icf, 1/4 of its size", "rotated_ellipse_with_subregions, 4 x its size"
  };
  std::vector<Case> cases;
  for(Case& c : quality::all_cases(folder, quality::Extent::usual))
    if(std::find(names.begin(), names.end(), c.name) != names.end() &&
       c.name.find(only) != std::string::npos)
      cases.push_back(std::move(c));
  return cases;
}

void write_table(const std::string& file, const std::vector<Case>& cases)
{
  std::ofstream out(file);
  if(!(out << heading)) throw std::runtime_error(file + " cannot be written");
  for(const Case& c : cases) {
    out << "\n## " << c.name << "\n\n" << columns;
    std::cout << c.name << '\n';
    double full_seconds = 0;
    for(const Variant& variant : variants()) {
      const Outcome o = adapt(c, variant);
      if(full_seconds == 0) full_seconds = (std::max)(o.seconds, 1e-6);
      const std::string text = row(variant, o, full_seconds);
      std::cout << text << std::flush;
      out << text << std::flush;
    }
  }
}

int main(int argc, char** argv)
{
  CLI::App app("Leaves out the ingredients of the default schedule one by one.");
  std::string file, folder = QUAD_MESH_DATA_DIR "/meshes", only;
  app.add_option("OUTPUT", file, "The table (.md)")->required();
  app.add_option("--only", only, "Only the cases whose name holds this");
  CLI11_PARSE(app, argc, argv);
  try {
    write_table(file, chosen_cases(folder, only));
  } catch(const std::exception& error) {
    std::cerr << "ablation: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
