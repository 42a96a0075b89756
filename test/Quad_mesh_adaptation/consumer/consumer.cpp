// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/adapt_quad_mesh.h>

// One square of side 1 asked for edges of 0.25: at least 16 faces.
int main()
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  CGAL::Surface_mesh<Point> mesh;
  const auto a = mesh.add_vertex(Point(0, 0, 0)), b = mesh.add_vertex(Point(1, 0, 0));
  const auto c = mesh.add_vertex(Point(1, 1, 0)), d = mesh.add_vertex(Point(0, 1, 0));
  mesh.add_face(a, b, c, d);
  const auto report = CGAL::Quad_mesh_adaptation::adapt_quad_mesh(0.25, mesh);
  return report.has_valid_mesh() && mesh.number_of_faces() >= 16 ? 0 : 1;
}
