// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_TEST_USUAL_MESH_H
#define QUAD_MESH_ADAPTATION_TEST_USUAL_MESH_H

#include "surface_mesh_checks.h"
#include "zoo_mesh.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <functional>

// The types that most tests use.  What they call for these is compiled once, in the library of test
// support: this takes most of their compile time away.
namespace usual_mesh {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Size = std::function<double(const Point&)>;

} // namespace usual_mesh

// These headers declare the instances, and the source file that defines them says so.
#ifndef QUAD_MESH_TEST_INSTANCE
#define QUAD_MESH_TEST_INSTANCE extern template
#endif

namespace zoo_mesh {

QUAD_MESH_TEST_INSTANCE usual_mesh::Mesh make<usual_mesh::Mesh, usual_mesh::Point>(const Shape&);
QUAD_MESH_TEST_INSTANCE Shape shape_of(const usual_mesh::Mesh&);
QUAD_MESH_TEST_INSTANCE bool is_same(const usual_mesh::Mesh&, const usual_mesh::Mesh&);
QUAD_MESH_TEST_INSTANCE void expect_valid(const usual_mesh::Mesh&, const mesh_checks::Facts&, bool);

} // namespace zoo_mesh

namespace mesh_checks {

QUAD_MESH_TEST_INSTANCE Facts facts_of_mesh(const usual_mesh::Mesh&);

} // namespace mesh_checks

namespace usual_mesh {

inline Mesh mesh_of(const shape_zoo::Shape& s) { return zoo_mesh::make<Mesh, Point>(s); }

} // namespace usual_mesh

#endif // QUAD_MESH_ADAPTATION_TEST_USUAL_MESH_H
