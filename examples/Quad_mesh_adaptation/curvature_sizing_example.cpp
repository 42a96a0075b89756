// Adapts a closed shape to its curvature: so many faces along a full circle, growing slowly.
//   curvature_sizing_example [mesh] [faces in a circle] [output]

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Quad_mesh_adaptation/Curvature_sizing_field.h>
#include <CGAL/Quad_mesh_adaptation/Graded_sizing_field.h>
#include <CGAL/Quad_mesh_adaptation/IO/read_quad_mesh.h>
#include <CGAL/Quad_mesh_adaptation/IO/write_quad_mesh.h>
#include <CGAL/Quad_mesh_adaptation/expected_number_of_faces.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/adapt_quad_mesh.h>

#include <cmath>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

namespace QMA = CGAL::Quad_mesh_adaptation;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int run(int argc, char* argv[])
{
  const std::string file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/spot.off");
  char* end = nullptr;
  const double faces_in_circle = argc > 2 ? std::strtod(argv[2], &end) : 12;
  if(end && (end == argv[2] || *end != 0)) {
    std::cerr << argv[2] << " is no number\n";
    return EXIT_FAILURE;
  }
  const std::string output = argc > 3 ? argv[3] : "curvature.off";

  Mesh mesh;
  const QMA::Read_result read = QMA::read_quad_mesh(file, mesh);
  if(!read.ok()) {
    std::cerr << read.message << '\n';
    return EXIT_FAILURE;
  }
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const double length = std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(),
                                   box.zmax() - box.zmin()); // of its diagonal

  // never finer than 0.4 % of the shape or coarser than 6 %, and growing by 0.3 per unit of length
  const auto by_curvature = QMA::Curvature_sizing_field::elements_per_circle(
      mesh, faces_in_circle, { 0.004 * length, 0.06 * length });
  const QMA::Graded_sizing_field size(mesh, by_curvature, 0.3);

  std::cout << "About " << QMA::expected_number_of_faces(size, mesh) << " faces expected\n";
  const QMA::Adaptation_report report = QMA::adapt_quad_mesh(size, mesh);
  if(!report.has_valid_mesh()) {
    std::cerr << report.message << '\n';
    return EXIT_FAILURE;
  }
  std::cout << report.before.faces << " faces became " << report.after.faces << ", "
            << report.after.strict_size_ratio.percent_not_larger()
            << " % of them within their size, efficiency " << report.after.efficiency << '\n';
  const auto written = QMA::write_quad_mesh(output, mesh);
  if(!written.ok()) std::cerr << written.message << '\n';
  return written.ok() ? EXIT_SUCCESS : EXIT_FAILURE;
}

int main(int argc, char* argv[])
{
  try {
    return run(argc, argv);
  } catch(const std::exception& error) { // such as fewer than 3 faces in a circle
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
