// A user's own surface: the torus as a function, adapted from a coarse mesh of it.
//   projector_example [directory]

#include <CGAL/Quad_mesh_adaptation/IO/write_quad_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/adapt_quad_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>

namespace QMA = CGAL::Quad_mesh_adaptation;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;

// Nearest point of the torus of radii 2 and 0.7 about the z-axis, and the normal there.
std::pair<Point, Vector> project(const Point& p)
{
  const double r = std::hypot(p.x(), p.y());
  const Point centre(2 * p.x() / r, 2 * p.y() / r, 0); // of the tube
  const Vector normal = (p - centre) / std::sqrt((p - centre).squared_length());
  return { centre + 0.7 * normal, normal };
}

int main(int argc, char* argv[])
{
  const std::string directory = argc > 1 ? argv[1] : ".";
  Mesh mesh;
  const int around = 12, tube = 6;
  const double pi = std::acos(-1.);
  for(int i = 0; i < around; ++i)
    for(int j = 0; j < tube; ++j) {
      const double a = 2 * pi * i / around, b = 2 * pi * j / tube, r = 2 + 0.7 * std::cos(b);
      mesh.add_vertex(Point(r * std::cos(a), r * std::sin(a), 0.7 * std::sin(b)));
    }
  const auto vertex = [&](int i, int j) {
    return Mesh::Vertex_index((i % around) * tube + j % tube);
  };
  for(int i = 0; i < around; ++i)
    for(int j = 0; j < tube; ++j)
      mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));

  const auto size = [](const Point& p) { return 0.12 + 0.06 * (p.x() + 2.7); };
  // the tube of the coarse mesh turns by 60 degrees at its edges: no features
  const QMA::Adaptation_report report =
      QMA::adapt_quad_mesh(size, mesh, QMA::projector(project, QMA::feature_angle(180)));
  if(!report.has_valid_mesh()) {
    std::cerr << report.message << '\n';
    return EXIT_FAILURE;
  }
  double off = 0;
  for(auto v : mesh.vertices())
    off = (std::max)(
        off, std::sqrt(CGAL::squared_distance(mesh.point(v), project(mesh.point(v)).first)));
  std::cout << report.before.faces << " faces -> " << report.after.faces
            << ", smallest scaled Jacobian " << report.after.min_scaled_jacobian
            << "\nvertices off the torus by at most " << off << ", faces by "
            << report.after.mesh_to_reference << '\n';
  const auto written = QMA::write_quad_mesh(directory + "/torus.vtk", mesh);
  if(!written.ok()) std::cerr << written.message << '\n';
  return written.ok() ? EXIT_SUCCESS : EXIT_FAILURE;
}
