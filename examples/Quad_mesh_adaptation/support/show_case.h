// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_EXAMPLES_SHOW_CASE_H
#define QUAD_MESH_ADAPTATION_EXAMPLES_SHOW_CASE_H

#include "face_fields.h"
#include "paper_cases.h"
#include "print_report.h"

#include <CGAL/Quad_mesh_adaptation/IO/write_picture.h>
#include <CGAL/Quad_mesh_adaptation/IO/write_quad_mesh.h>

#include <cmath>
#include <cstdio>
#include <iostream>
#include <string>

namespace paper_cases {

/// Prints a line of the program's own; the `printf` format is checked by the compiler.
#define PAPER_CASES_PRINT(...)                                                                     \
  do {                                                                                             \
    char line[200];                                                                                \
    std::snprintf(line, sizeof line, __VA_ARGS__);                                                 \
    std::cout << line << '\n';                                                                     \
  } while(false)

/// The paper's table of size ratios with our figures next to the published ones.
inline void print_paper_table(const Paper_case& c,
                              const CGAL::Quad_mesh_adaptation::Mesh_measures& ours, int k)
{
  using Table = CGAL::Quad_mesh_adaptation::Size_ratio_table;
  Table paper;
  paper.counts = c.paper_counts;
  std::cout << "Size ratio          this mesh              the paper\n";
  for(std::size_t i = 0; i < Table::number_of_bins; ++i)
    PAPER_CASES_PRINT("  %-10s %9zu %7.1f%%   %9zu %7.1f%%", Table::titles()[i],
                      ours.size_ratio.counts[i], ours.size_ratio.percent(i), paper.counts[i],
                      paper.percent(i));
  PAPER_CASES_PRINT("  %-10s %9zu %7.1f%%   %9zu %7.1f%%", "up to 1", ours.size_ratio.not_larger(),
                    ours.size_ratio.percent_not_larger(), paper.not_larger(),
                    paper.percent_not_larger());
  PAPER_CASES_PRINT("  %-10s %9zu            %9zu", "faces", ours.size_ratio.total(),
                    paper.total());
  PAPER_CASES_PRINT("  %-10s %9.3f", "efficiency", ours.efficiency);
  if(c.has_papers_size)
    PAPER_CASES_PRINT("  The paper's efficiency with this size would be %.3f",
                      ours.ideal_number_of_faces / (double(k) * k) / double(paper.total()));
}

/// Prints the outcome of a case; false if there is no mesh to go on with.
inline bool print_case(const Paper_case& c,
                       const CGAL::Quad_mesh_adaptation::Adaptation_report& report, int k)
{
  std::cout << c.name << ", size " << c.size_text << ", k = " << k << "\n\n";
  if(report.has_valid_mesh()) {
    print_paper_table(c, report.after, k);
    std::cout << '\n';
    report_printing::print_measures(std::cout, report.before, report.after);
    report_printing::print_valences(std::cout, report.before, report.after);
    report_printing::print_times(std::cout, report);
  }
  std::cout << "Result " << ::name_of(report.status) << " after " << report.iterations
            << " iterations" << (report.message.empty() ? "" : ": " + report.message) << '\n';
  return report.has_valid_mesh();
}

/// Prints what went wrong with a file, if anything did.
template <class Result>
bool is_written(const Result& result)
{
  if(!result.ok()) std::cerr << result.message << '\n';
  return result.ok();
}

/// Writes the adapted mesh as `<directory>/<name>.off` and, with its size ratios and qualities,
/// `.vtk`, and the picture of the adaptation as `.svg`.
inline bool write_case(const Paper_case& c, const Mesh& adapted, const Sizing& size,
                       const std::string& directory)
{
  namespace QMA = CGAL::Quad_mesh_adaptation;
  const std::string base = directory + "/" + c.name;
  const bool ok = is_written(QMA::write_quad_mesh(base + ".off", adapted)) &&
                  is_written(QMA::write_quad_mesh(base + ".vtk", adapted,
                                                  size_and_quality_fields(adapted, size))) &&
                  is_written(QMA::write_picture(base + ".svg", c.initial, size, adapted));
  if(ok) std::cout << "Written " << base << ".off, .vtk and .svg\n";
  return ok;
}

} // namespace paper_cases

#endif // QUAD_MESH_ADAPTATION_EXAMPLES_SHOW_CASE_H
