// The paper's plate with a hole in tension: Figures 11 to 13, Tables 3 and 4.
//   plate_with_hole_example [directory] [--schedule default|paper] [--k N] [--error SHARE]
//                           [--formula]
// Solves on the initial mesh, estimates the error, adapts to the sizes that follow from it, and
// solves again.  With --formula the sizes are a closed form of the distance to the hole.

#include "support/Example_options.h"
#include "support/plate_analysis.h"

#include <CGAL/adapt_quad_mesh.h>

#include <cstdlib>

namespace QMA = CGAL::Quad_mesh_adaptation;

int main(int argc, char* argv[])
{
  Example_options options("The paper's plate with a hole: Figures 11 to 13, Tables 3 and 4.");
  double error = 0.01;
  bool by_formula = false;
  options.add("--error", error, 1e-4, 0.5,
              "Error wanted, as a share of the energy norm, for k = 1");
  options.add_flag("--formula", by_formula, "Sizes by a formula, not from the analysis");
  if(!options.parse(argc, argv)) return options.exit_code;

  paper_cases::Paper_case c = paper_cases::plate_with_hole(options.k);
  const auto on_initial = paper_cases::analyse(c.initial);
  if(!by_formula) {
    c.size = paper_cases::sizes_from_analysis(c.initial, on_initial, error / options.k, options.k);
    c.size_text = "from the error estimate";
    c.has_papers_size = false;
  }
  paper_cases::Mesh mesh = c.initial;
  const QMA::Adaptation_report report = QMA::adapt_quad_mesh(
      c.size, mesh, QMA::schedule(options.schedule, QMA::reference_surface(c.reference)));
  if(!paper_cases::print_case(c, report, options.k)) return EXIT_FAILURE;

  const auto on_medium = paper_cases::analyse(paper_cases::quarter_plate_mesh(4 * options.k));
  const auto on_fine = paper_cases::analyse(paper_cases::quarter_plate_mesh(8 * options.k));
  const auto on_adapted = paper_cases::analyse(mesh);
  paper_cases::print_analyses({ { "coarse", on_initial },
                                { "medium", on_medium },
                                { "fine", on_fine },
                                { "adapted", on_adapted } });
  paper_cases::print_stress_concentration(on_medium, on_fine, on_adapted);
  const bool ok = paper_cases::write_case(c, mesh, c.size, options.directory) &&
                  paper_cases::write_analysis(c.initial, on_initial, mesh, on_adapted,
                                              options.directory + "/" + c.name);
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
