// Adapts a mesh to sizes at the vertices of another, coarser one, three times: the sizes stay where
// they are, so that the second and the third time hardly change anything.
//   background_sizes_example [sizes] [output]
// sizes: a PLY file of polygons whose vertices have a property `size`.

#include <CGAL/Quad_mesh_adaptation/IO/read_nodal_sizes.h>
#include <CGAL/Quad_mesh_adaptation/IO/write_quad_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/adapt_quad_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cstdlib>
#include <iostream>
#include <optional>
#include <string>

namespace QMA = CGAL::Quad_mesh_adaptation;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

int main(int argc, char* argv[])
{
  const std::string file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/background_sizes.ply");
  const std::string output = argc > 2 ? argv[2] : "background.off";

  std::optional<QMA::Nodal_sizing_field> size;
  const QMA::Read_result read = QMA::read_nodal_sizes(file, size);
  if(!read.ok()) {
    std::cerr << read.message << '\n';
    return EXIT_FAILURE;
  }

  Mesh mesh; // 16 x 16 faces over [0, 8]^2
  const auto at = [](int i, int j) { return Point(0.5 * i, 0.5 * j, 0); };
  CGAL::make_grid(16, 16, mesh, at);

  for(int round = 1; round <= 3; ++round) {
    const QMA::Adaptation_report report = QMA::adapt_quad_mesh(*size, mesh);
    if(!report.has_valid_mesh()) {
      std::cerr << report.message << '\n';
      return EXIT_FAILURE;
    }
    std::cout << "Round " << round << ": " << report.before.faces << " faces became "
              << report.after.faces << ", the largest " << report.after.strict_size_ratio.max
              << " times its size\n";
  }
  const auto written = QMA::write_quad_mesh(output, mesh);
  if(!written.ok()) std::cerr << written.message << '\n';
  return written.ok() ? EXIT_SUCCESS : EXIT_FAILURE;
}
