// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_EXAMPLES_MESH_BUILDER_H
#define QUAD_MESH_ADAPTATION_EXAMPLES_MESH_BUILDER_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <initializer_list>
#include <stdexcept>
#include <vector>

namespace paper_cases {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;

/// Puts a mesh together from numbered vertices; a face that the mesh cannot take is an error of
/// the generator and throws `std::logic_error`.
class Mesh_builder
{
public:
  Vertex vertex(double x, double y, double z) { return mesh.add_vertex(Point(x, y, z)); }

  void face(std::initializer_list<Vertex> corners)
  {
    if(mesh.add_face(std::vector<Vertex>(corners)) == Mesh::null_face())
      throw std::logic_error("a generated face does not fit the mesh");
  }

  Mesh mesh;
};

} // namespace paper_cases

#endif // QUAD_MESH_ADAPTATION_EXAMPLES_MESH_BUILDER_H
