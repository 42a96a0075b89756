// The finite-element loop on the paper's plate with a hole: solve, estimate the error, adapt, three
// times, against uniform refinement.
//   adaptive_loop_example [directory] [--error SHARE] [--rounds N]
// Prints nodes and errors in the energy norm, estimated and against a very fine reference solution,
// and draws them as convergence.svg.  Ends with an error if the loop does not need fewer nodes than
// uniform refinement in every round, or more than a quarter for the error of the finest mesh.

#include "support/Example_options.h"
#include "support/log_plot.h"
#include "support/plate_analysis.h"
#include "support/reference_stress.h"

#include <CGAL/adapt_quad_mesh.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace QMA = CGAL::Quad_mesh_adaptation;

struct Row
{
  std::size_t nodes;
  double estimated, actual;
};

Row print_row(const std::string& name, const paper_cases::Mesh& mesh,
              const paper_cases::Plate::Result& result,
              const plane_stress::Reference_stress& reference)
{
  const plane_stress::Plane_mesh plane = plane_stress::plane_mesh(mesh);
  const Row row = { result.nodes, result.estimate.relative_error(),
                    plane_stress::true_relative_error(plane, paper_cases::Plate().material,
                                                      result.displacement, reference) };
  PAPER_CASES_PRINT("  %-12s %7zu %7zu   %8.3f%% %8.3f%%", name.c_str(), result.nodes, result.faces,
                    100 * row.estimated, 100 * row.actual);
  return row;
}

// Nodes that uniform refinement needs for an error: interpolated between logarithms, continued
// with the slope of the last two.
double nodes_for(const std::vector<Row>& rows, double error)
{
  std::size_t i = 1;
  while(i + 1 < rows.size() && rows[i].actual > error) ++i;
  const double slope = std::log(double(rows[i].nodes) / double(rows[i - 1].nodes)) /
                       std::log(rows[i].actual / rows[i - 1].actual);
  return double(rows[i].nodes) * std::pow(error / rows[i].actual, slope);
}

Log_plot plot_of(const std::vector<Row>& uniform, const std::vector<Row>& adapted)
{
  Log_plot plot;
  plot.title = "Plate with a hole: error in the energy norm";
  plot.x_title = "nodes";
  plot.y_title = "share of the energy norm";
  plot.is_percent = true;
  plot.curves = { { "uniform refinement", "#b03020", {}, {}, false },
                  { "uniform, estimated", "#e0a090", {}, {}, true },
                  { "solve - estimate - adapt", "#2050a0", {}, {}, false },
                  { "adapted, estimated", "#90b0e0", {}, {}, true } };
  for(int i = 0; i < 4; ++i)
    for(const Row& row : i < 2 ? uniform : adapted) {
      plot.curves[i].x.push_back(double(row.nodes));
      plot.curves[i].y.push_back(i % 2 ? row.estimated : row.actual);
    }
  return plot;
}

bool print_verdict(const std::vector<Row>& uniform, const std::vector<Row>& adapted)
{
  bool ok = true;
  for(std::size_t i = 1; i < adapted.size(); ++i) {
    const double share = double(adapted[i].nodes) / nodes_for(uniform, adapted[i].actual);
    PAPER_CASES_PRINT("round %zu has %.2f of the nodes of a uniform mesh with its error", i, share);
    ok = ok && share < 1;
  }
  const Row &fine = uniform.back(), &last = adapted.back();
  PAPER_CASES_PRINT("the last has %.3f of the nodes of the finest uniform mesh, and %.3f of its "
                    "error",
                    double(last.nodes) / double(fine.nodes), last.actual / fine.actual);
  return ok && last.actual <= fine.actual && 4 * last.nodes <= fine.nodes;
}

int main(int argc, char* argv[])
{
  Example_options options("Solve, estimate, adapt on the plate with a hole, against uniform "
                          "refinement.");
  double wanted = 0.0088; // a little below what the finest uniform mesh has
  int rounds = 3;
  options.add("--error", wanted, 1e-3, 0.1, "Error wanted, as a share of the energy norm");
  options.add("--rounds", rounds, 1, 10, "Rounds of solve, estimate, adapt");
  if(!options.parse(argc, argv)) return options.exit_code;

  const paper_cases::Paper_case c = paper_cases::plate_with_hole(options.k);
  const plane_stress::Reference_stress reference(paper_cases::Plate(),
                                                 paper_cases::Quarter_plate::side);
  PAPER_CASES_PRINT("Reference: error %.3f%% before recovery of the stress",
                    100 * reference.relative_error());
  std::cout << "Mesh             nodes   faces   estimated      true error in energy norm\n";
  std::vector<Row> uniform, adapted;
  for(int k : { 1, 2, 4, 8 }) {
    const paper_cases::Mesh mesh = paper_cases::quarter_plate_mesh(k * options.k);
    uniform.push_back(
        print_row("uniform " + std::to_string(k), mesh, paper_cases::analyse(mesh), reference));
  }

  paper_cases::Mesh mesh = c.initial;
  paper_cases::Plate::Result result = paper_cases::analyse(mesh);
  adapted.push_back(print_row("initial", mesh, result, reference));
  const double first = adapted[0].estimated;
  for(int round = 1; round <= rounds; ++round) {
    const double error = first * std::pow(wanted / first, double(round) / rounds);
    const auto size = paper_cases::sizes_from_analysis(mesh, result, error, options.k);
    const QMA::Adaptation_report report = QMA::adapt_quad_mesh(
        size, mesh, QMA::schedule(options.schedule, QMA::reference_surface(c.reference)));
    if(!report.has_valid_mesh()) {
      std::cerr << report.message << '\n';
      return EXIT_FAILURE;
    }
    mesh.collect_garbage();
    result = paper_cases::analyse(mesh);
    adapted.push_back(print_row("round " + std::to_string(round), mesh, result, reference));
  }
  const bool is_better = print_verdict(uniform, adapted);
  QMA::File_transaction files;
  const std::string base = options.directory + "/";
  const bool ok = paper_cases::is_written(
                      files.stage(base + "convergence.svg", plot_of(uniform, adapted).svg())) &&
                  paper_cases::is_written(files.commit()) &&
                  paper_cases::is_written(QMA::write_quad_mesh(base + "adaptive_loop.vtk", mesh));
  return ok && is_better ? EXIT_SUCCESS : EXIT_FAILURE;
}
