// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_TEST_SYMMETRY_FIXTURE_H
#define QUAD_MESH_ADAPTATION_TEST_SYMMETRY_FIXTURE_H

#include "state_fixture.h"
#include "usual_calls.h"

#include <cstddef>
#include <functional>
#include <tuple>

// Symmetric shapes, and what to ask of the meshes made from them.
namespace symmetry_fixture {

namespace QMA = CGAL::Quad_mesh_adaptation;
using shape_zoo::Shape;
using shape_zoo::Vec;
using usual_mesh::Mesh;
using usual_mesh::Point;
using usual_mesh::Size;

std::tuple<double, double, double> key(const Vec& p);

Shape moved(Shape s, const std::function<Vec(const Vec&)>& f);

Shape centred(const Shape& s);

/// A cap like a nosecone: the rim is a square, so that its planes cut no face.
Shape cap();

/// Vertices without a partner to the last bit in the plane through the origin across an axis.
std::size_t unmatched(const Mesh& mesh, int axis);

/// Faces without a partner of opposite orientation, with vertices matched to 1e-7.
std::size_t unmatched_faces(const Mesh& mesh, const Vec& normal);

struct Outcome
{
  Mesh mesh;
  QMA::Adaptation_report report;
};

Outcome adapt(const Shape& shape, const Size& size, bool keep = true);

Size uniform(double h);

/// How many mirror planes are found.
std::size_t planes_of(const Shape& shape, const state_fixture::Options& o = {});

Vec turned(const Vec& p);

/// Creases and corners of the input are still there.
void expect_features(const Shape& shape, const Mesh& mesh);

} // namespace symmetry_fixture

#endif // QUAD_MESH_ADAPTATION_TEST_SYMMETRY_FIXTURE_H
