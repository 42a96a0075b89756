// Coarsens a mesh and refines the coarse one again, on the surface of the first: the shape comes
// back as far as the coarse mesh still covers it.
//   reference_surface_example [directory]

#include <CGAL/Quad_mesh_adaptation/IO/read_quad_mesh.h>
#include <CGAL/Quad_mesh_adaptation/IO/write_quad_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/adapt_quad_mesh.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace QMA = CGAL::Quad_mesh_adaptation;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

bool show(const char* title, const QMA::Adaptation_report& r)
{
  std::cout << title << ": " << r.after.faces << " faces, off the reference by "
            << r.after.mesh_to_reference << ", the reference off them by "
            << r.after.reference_to_mesh << ' ' << r.message << '\n';
  return r.has_valid_mesh();
}

bool write(const std::string& file, Mesh& mesh)
{
  mesh.collect_garbage();
  const auto written = QMA::write_quad_mesh(file, mesh);
  if(!written.ok()) std::cerr << written.message << '\n';
  return written.ok();
}

int main(int argc, char* argv[])
{
  const std::string directory = argc > 1 ? argv[1] : ".";
  Mesh original;
  const QMA::Read_result read =
      QMA::read_quad_mesh(CGAL::data_file_path("meshes/spot.off"), original);
  if(!read.ok()) {
    std::cerr << read.message << '\n';
    return EXIT_FAILURE;
  }

  Mesh mesh = original;
  // coarse faces turn more at an edge than a crease would: none is one
  const auto on_original = QMA::reference_surface(original, QMA::feature_angle(180));
  bool ok = show("coarse", QMA::adapt_quad_mesh(0.07, mesh, on_original));
  ok = ok && write(directory + "/spot_coarse.vtk", mesh);

  ok = ok && show("fine again", QMA::adapt_quad_mesh(0.04, mesh, on_original));
  ok = ok && write(directory + "/spot_fine.vtk", mesh);

  // about this far from the cow, with as few faces as that takes
  ok = ok &&
       show("within 0.02", QMA::adapt_quad_mesh(0.3, mesh, QMA::max_distance(0.02, on_original)));
  ok = ok && write(directory + "/spot_within.vtk", mesh);
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
