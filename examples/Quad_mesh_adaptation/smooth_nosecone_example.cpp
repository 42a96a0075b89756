// The paper's nosecone from its coarse mesh alone: with facets, and with the smooth surface through
// its vertices.
//   smooth_nosecone_example [directory]

#include "support/nosecone.h"

#include <CGAL/Quad_mesh_adaptation/IO/write_quad_mesh.h>
#include <CGAL/adapt_quad_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace QMA = CGAL::Quad_mesh_adaptation;
using paper_cases::Mesh;
using paper_cases::Point;

// Largest distance of a vertex to the paraboloid z = r^2 / 4, to first order.
double off_paraboloid(const Mesh& mesh)
{
  double worst = 0;
  for(auto v : mesh.vertices()) {
    const Point& p = mesh.point(v);
    const double r2 = p.x() * p.x() + p.y() * p.y();
    worst = (std::max)(worst, std::abs(p.z() - r2 / 4) / std::sqrt(1 + r2 / 4));
  }
  return worst;
}

int main(int argc, char* argv[])
{
  const std::string directory = argc > 1 ? argv[1] : ".";
  const auto size = [](const Point& p) { return 0.1 + 2.9 * p.z() / 16; };
  double off[2];
  for(const bool smooth : { false, true }) {
    Mesh mesh = paper_cases::nosecone_mesh(1);
    const QMA::Adaptation_report report =
        QMA::adapt_quad_mesh(size, mesh, QMA::smooth_reference(smooth));
    if(!report.has_valid_mesh()) {
      std::cerr << report.message << '\n';
      return EXIT_FAILURE;
    }
    mesh.collect_garbage();
    off[smooth] = off_paraboloid(mesh);
    std::cout << (smooth ? "smooth: " : "facets: ") << report.before.faces << " faces -> "
              << report.after.faces << ", vertices off the paraboloid by " << off[smooth] << '\n';
    const std::string file = directory + (smooth ? "/nosecone_smooth.vtk" : "/nosecone_facets.vtk");
    const auto written = QMA::write_quad_mesh(file, mesh);
    if(!written.ok()) {
      std::cerr << written.message << '\n';
      return EXIT_FAILURE;
    }
  }
  std::cout << "nearer by a factor of " << off[0] / off[1] << '\n';
  return off[0] > 10 * off[1] ? EXIT_SUCCESS : EXIT_FAILURE;
}
