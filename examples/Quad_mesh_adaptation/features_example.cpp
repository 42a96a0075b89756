// Keeps the edges, rims and patches of a part: a box with a round hole.
//   features_example [directory]

#include <CGAL/Quad_mesh_adaptation/IO/read_quad_mesh.h>
#include <CGAL/Quad_mesh_adaptation/IO/write_quad_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/adapt_quad_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <map>
#include <string>

namespace QMA = CGAL::Quad_mesh_adaptation;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

int main(int argc, char* argv[])
{
  const std::string directory = argc > 1 ? argv[1] : ".";
  Mesh mesh;
  const QMA::Read_result read =
      QMA::read_quad_mesh(CGAL::data_file_path("meshes/box_cylinder.off"), mesh);
  if(!read.ok()) {
    std::cerr << read.message << '\n';
    return EXIT_FAILURE;
  }

  // Patch 1 is one half of the part, 0 the other: the seam between them is kept like an edge, and
  // the numbers come back on the new faces.  Edges that turn by 40 degrees need no mark.
  auto patch = mesh.add_property_map<Mesh::Face_index, int>("f:patch", 0).first;
  double low = 0, high = 0;
  for(auto v : mesh.vertices()) {
    low = (std::min)(low, mesh.point(v).x());
    high = (std::max)(high, mesh.point(v).x());
  }
  for(auto f : mesh.faces()) {
    double x = 0;
    for(auto v : vertices_around_face(mesh.halfedge(f), mesh)) x += mesh.point(v).x() / 4;
    patch[f] = x > 0.5 * (low + high) ? 1 : 0;
  }

  for(const double size : { 0.02, 0.15 }) { // refined first, then far coarser than it was
    const QMA::Adaptation_report report = QMA::adapt_quad_mesh(
        size * (high - low), mesh, QMA::feature_angle(40, CGAL::parameters::face_patch_map(patch)));
    if(!report.has_valid_mesh()) {
      std::cerr << report.message << '\n';
      return EXIT_FAILURE;
    }
    mesh.collect_garbage();
    std::map<int, int> faces_of;
    for(auto f : mesh.faces()) ++faces_of[patch[f]];
    std::cout << report.after.faces << " faces (" << faces_of[0] << " + " << faces_of[1] << "), "
              << report.patches << " patches, " << report.feature_curves << " curves, "
              << report.corners << " corners; faces to input " << report.after.mesh_to_reference
              << ", input to faces " << report.after.reference_to_mesh << '\n';
  }
  const auto written = QMA::write_quad_mesh(directory + "/part.vtk", mesh);
  if(!written.ok()) std::cerr << written.message << '\n';
  return written.ok() ? EXIT_SUCCESS : EXIT_FAILURE;
}
