// Adapts a region only: the faces of a plate within a circle; all others keep their descriptors,
// vertices and points.
//   region_example [directory]

#include <CGAL/Quad_mesh_adaptation/IO/write_quad_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/adapt_quad_mesh.h>
#include <CGAL/boost/graph/iterator.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace QMA = CGAL::Quad_mesh_adaptation;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

int main(int argc, char* argv[])
{
  const std::string directory = argc > 1 ? argv[1] : ".";
  Mesh mesh; // a plate of 20 x 20 faces of length 1
  const int n = 20;
  for(int i = 0; i <= n; ++i)
    for(int j = 0; j <= n; ++j) mesh.add_vertex(Point(i, j, 0));
  const auto vertex = [n](int i, int j) { return Mesh::Vertex_index(i * (n + 1) + j); };
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
      mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));

  std::vector<Mesh::Face_index> region, rest;
  for(auto f : mesh.faces()) {
    double x = 0, y = 0;
    for(auto v : vertices_around_face(mesh.halfedge(f), mesh)) {
      x += mesh.point(v).x() / 4;
      y += mesh.point(v).y() / 4;
    }
    (std::hypot(x - 10, y - 10) < 7 ? region : rest).push_back(f);
  }

  // the edges between the region and the rest stay, so the size there is that of the rest
  const auto size = [](const Point& p) { return 0.2 + 0.1 * std::hypot(p.x() - 10, p.y() - 10); };
  const QMA::Adaptation_report report = QMA::adapt_quad_mesh(region, size, mesh);
  if(!report.has_valid_mesh()) {
    std::cerr << report.message << '\n';
    return EXIT_FAILURE;
  }
  std::size_t kept = 0;
  for(auto f : rest) kept += !mesh.is_removed(f);
  mesh.collect_garbage();
  std::cout << region.size() << " faces of the region became "
            << mesh.number_of_faces() - rest.size() << "; of the other " << rest.size() << ", "
            << kept << " were kept\n";
  const auto written = QMA::write_quad_mesh(directory + "/region.vtk", mesh);
  if(!written.ok()) std::cerr << written.message << '\n';
  return written.ok() && kept == rest.size() ? EXIT_SUCCESS : EXIT_FAILURE;
}
