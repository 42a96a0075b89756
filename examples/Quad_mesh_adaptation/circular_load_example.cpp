// The paper's flat plate under a circular load: Figures 6 to 9 and Table 1.
//   circular_load_example [directory] [--schedule default|paper] [--k N]

#include "support/Example_options.h"
#include "support/show_case.h"

#include <CGAL/adapt_quad_mesh.h>

#include <cstdlib>

namespace QMA = CGAL::Quad_mesh_adaptation;

int main(int argc, char* argv[])
{
  Example_options options(
      "The paper's flat plate under a circular load: Figures 6 to 9 and Table 1.");
  if(!options.parse(argc, argv)) return options.exit_code;

  const paper_cases::Paper_case c = paper_cases::circular_load(options.k);
  paper_cases::Mesh mesh = c.initial;
  const QMA::Adaptation_report report = QMA::adapt_quad_mesh(
      c.size, mesh, QMA::schedule(options.schedule, QMA::reference_surface(c.reference)));

  if(!paper_cases::print_case(c, report, options.k)) return EXIT_FAILURE;
  return paper_cases::write_case(c, mesh, c.size, options.directory) ? EXIT_SUCCESS : EXIT_FAILURE;
}
