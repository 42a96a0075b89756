// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_EXAMPLES_PRINT_REPORT_H
#define QUAD_MESH_ADAPTATION_EXAMPLES_PRINT_REPORT_H

#include "report_names.h"

#include <CGAL/Quad_mesh_adaptation/Adaptation_report.h>

#include <cstdio>
#include <map>
#include <ostream>
#include <string>
#include <utility>

namespace report_printing {

using CGAL::Quad_mesh_adaptation::Adaptation_report;
using CGAL::Quad_mesh_adaptation::Mesh_measures;
using CGAL::Quad_mesh_adaptation::Size_ratio_table;

template <class... T>
std::string format(const char* pattern, T... values)
{
  char text[160];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

// The paper's Tables 1-3: bins up to 1 to the left, above 1 to the right, their sums below.
inline void print_size_ratios(std::ostream& out, const Size_ratio_table& table)
{
  const char* head = "  %-10s %9s %9s";
  out << "Size ratio f_s\n"
      << format(head, "", "faces", "percent") << "  |" << format(head, "", "faces", "percent")
      << '\n';
  const auto cell = [](const char* title, std::size_t faces, double percent) {
    return format("  %-10s %9zu %8.1f%%", title, faces, percent);
  };
  for(std::size_t i = 0; i < 4; ++i)
    out << cell(table.titles()[i], table.counts[i], table.percent(i)) << "  |"
        << cell(table.titles()[i + 4], table.counts[i + 4], table.percent(i + 4)) << '\n';
  const std::size_t larger = table.total() - table.not_larger();
  out << cell("", table.not_larger(), table.percent_not_larger()) << "  |"
      << cell("", larger, table.total() ? 100 - table.percent_not_larger() : 0) << '\n';
}

inline void print_row(std::ostream& out, const char* title, double before, double after,
                      const char* pattern)
{
  out << format("  %-30s %12s %12s\n", title, format(pattern, before).c_str(),
                format(pattern, after).c_str());
}

inline void print_measures(std::ostream& out, const Mesh_measures& a, const Mesh_measures& b)
{
  const auto row = [&](const char* title, double before, double after, const char* pattern) {
    print_row(out, title, before, after, pattern);
  };
  out << format("  %-30s %12s %12s\n", "", "before", "after");
  row("faces", double(a.faces), double(b.faces), "%.0f");
  row("vertices", double(a.vertices), double(b.vertices), "%.0f");
  row("faces not larger than asked", a.size_ratio.percent_not_larger(),
      b.size_ratio.percent_not_larger(), "%.1f%%");
  row("largest size ratio", a.size_ratio.max, b.size_ratio.max, "%.3f");
  row("largest strict size ratio", a.strict_size_ratio.max, b.strict_size_ratio.max, "%.3f");
  row("ideal number of faces", a.ideal_number_of_faces, b.ideal_number_of_faces, "%.0f");
  row("efficiency", a.efficiency, b.efficiency, "%.3f");
  row("scaled Jacobian, smallest", a.min_scaled_jacobian, b.min_scaled_jacobian, "%.3f");
  row("scaled Jacobian, mean", a.mean_scaled_jacobian, b.mean_scaled_jacobian, "%.3f");
  row("smallest angle, degrees", a.min_angle, b.min_angle, "%.1f");
  row("largest angle, degrees", a.max_angle, b.max_angle, "%.1f");
  row("largest warp", a.max_warp, b.max_warp, "%.3f");
  row("inverted faces", double(a.inverted_faces), double(b.inverted_faces), "%.0f");
  row("vertices off the reference", a.max_distance_to_reference, b.max_distance_to_reference,
      "%.2g");
  row("faces off the reference", a.mesh_to_reference, b.mesh_to_reference, "%.2g");
  row("reference off the faces", a.reference_to_mesh, b.reference_to_mesh, "%.2g");
}

// Interior vertices by their number of edges, before and after.
inline void print_valences(std::ostream& out, const Mesh_measures& a, const Mesh_measures& b)
{
  auto all = a.interior_valence;
  all.insert(b.interior_valence.begin(), b.interior_valence.end());
  const auto count = [](const Mesh_measures& m, std::size_t valence) {
    const auto it = m.interior_valence.find(valence);
    return it == m.interior_valence.end() ? 0. : double(it->second);
  };
  for(const auto& entry : all) {
    const std::string title = "interior vertices, valence " + std::to_string(entry.first);
    print_row(out, title.c_str(), count(a, entry.first), count(b, entry.first), "%.0f");
  }
}

// How many faces have a poor shape, and what forbids a better one.
inline void print_poor_faces(std::ostream& out, const Adaptation_report& report)
{
  using CGAL::Quad_mesh_adaptation::Shape_limit;
  if(report.poor_faces.empty()) return;
  std::map<Shape_limit, std::size_t> count;
  for(const auto& p : report.poor_faces) ++count[p.limit];
  out << format("Faces with a scaled Jacobian below %.2f: ",
                CGAL::Quad_mesh_adaptation::Poor_face::floor)
      << report.poor_faces.size();
  const std::pair<Shape_limit, const char*> reasons[] = {
    { Shape_limit::feature_angle, "where features meet at a small angle" },
    { Shape_limit::held_nodes, "between nodes that must not move" },
    { Shape_limit::curved_surface, "where the surface turns by more than 60 degrees" }
  };
  for(const auto& reason : reasons)
    if(count[reason.first] > 0) out << ", " << count[reason.first] << ' ' << reason.second;
  out << '\n';
}

inline void print_times(std::ostream& out, const Adaptation_report& report)
{
  double total = 0;
  for(const auto& phase : report.times) total += phase.seconds;
  out << "Time " << format("%.2f s", total);
  const char* separator = ": ";
  for(const auto& phase : report.times) {
    out << separator << phase.name << ' ' << format("%.2f s", phase.seconds);
    separator = ", ";
  }
  out << '\n';
}

} // namespace report_printing

/// Prints what a person wants to know of an adaptation: the paper's table of size ratios,
/// efficiency, quality and valences before and after, the time of each phase, and how it ended.
inline void print_report(std::ostream& out,
                         const CGAL::Quad_mesh_adaptation::Adaptation_report& report)
{
  using namespace report_printing;
  if(report.has_valid_mesh()) {
    print_size_ratios(out, report.after.size_ratio);
    out << '\n';
    print_measures(out, report.before, report.after);
    print_valences(out, report.before, report.after);
    out << '\n';
    print_poor_faces(out, report);
    print_times(out, report);
  }
  for(const std::string& sentence : report.advice) out << "Note: " << sentence << '\n';
  out << "Result " << name_of(report.status) << ", " << report.iterations
      << (report.iterations == 1 ? " pass" : " passes") << " of refinement";
  if(!report.message.empty()) out << ": " << report.message;
  out << '\n';
}

#endif // QUAD_MESH_ADAPTATION_EXAMPLES_PRINT_REPORT_H
