// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What is kept of every shape, finer and coarser: corners to the last bit, curves on their
// polylines with their length where they are refined, nodes on the sheet of their patch, neighbours
// of patches, topology.  Found without the package, but for the numbers of
// patches, which it must hand on.

#include "support/feature_checks.h"
#include "support/more_shapes.h"
#include "support/usual_calls.h"
#include "support/usual_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace {

namespace QMA = CGAL::Quad_mesh_adaptation;
using shape_zoo::Index;
using shape_zoo::Shape;
using shape_zoo::Vec;
using usual_mesh::Mesh;
using usual_mesh::Point;
using usual_mesh::read_shape;

// Side of a cone cut off at both ends, with flat ends.
Shape cone(Index n)
{
  Shape s = more_shapes::closed_cylinder(n);
  for(Vec& p : s.points) p = Vec((1 - 0.4 * p.z()) * p.x(), (1 - 0.4 * p.z()) * p.y(), p.z());
  s.name = "cone";
  return s;
}

Shape box()
{
  return shape_zoo::voxels("box", { 6, 4, 3 }, [](Index, Index, Index) { return true; });
}

struct Marked
{
  Shape shape;
  std::vector<int> patch;
};

Marked adapt(const Shape& s, const std::vector<int>& patch, double factor)
{
  Mesh mesh = zoo_mesh::make<Mesh, Point>(s);
  auto map = mesh.add_property_map<Mesh::Face_index, int>("f:patch", -1).first;
  std::size_t i = 0;
  for(auto f : mesh.faces()) map[f] = patch[i++];
  const mesh_checks::Facts before = mesh_checks::facts_of(s.points, s.quads);
  const QMA::Adaptation_report report = QMA::adapt_quad_mesh(factor * zoo_mesh::mean_edge(s), mesh,
                                                             CGAL::parameters::face_patch_map(map));
  EXPECT_TRUE(report.has_valid_mesh()) << report.message;
  mesh.collect_garbage();
  zoo_mesh::expect_valid(mesh, before);
  Marked m;
  m.shape = zoo_mesh::shape_of(mesh);
  for(auto f : mesh.faces()) m.patch.push_back(map[f]);
  return m;
}

// Curves may lose edges only where these are shorter than asked, and length only with them.
void expect_lengths_kept(const feature_checks::Features& given,
                         const feature_checks::Features& found, double size)
{
  for(const auto& [patches, before] : given.seams) {
    SCOPED_TRACE("between patches " + std::to_string(patches.first) + " and " +
                 std::to_string(patches.second));
    const feature_checks::Seam after = found.seams.at(patches);
    if(before.length >= size * double(before.edges)) {
      EXPECT_GE(after.edges, before.edges);
    }
    EXPECT_GE(after.length, (after.edges >= before.edges ? 0.999 : 0.93) * before.length);
  }
}

void expect_kept(const Shape& s, double factor)
{
  SCOPED_TRACE(s.name + ", " + std::to_string(factor));
  const std::vector<int> patch = feature_checks::patches(s, 40);
  const feature_checks::Features given = feature_checks::features(s, patch);
  const Marked m = adapt(s, patch, factor);
  const feature_checks::Features found = feature_checks::features(m.shape, m.patch);
  EXPECT_EQ(found.neighbours, given.neighbours);
  EXPECT_LE(feature_checks::nodes_off_curves(m.shape, found, s, given),
            1e-9 * feature_checks::size_of(s));
  EXPECT_LE(feature_checks::nodes_off_patches(m.shape, m.patch, s, patch),
            1e-9 * feature_checks::size_of(s));
  for(Index v : given.corners)
    EXPECT_EQ(std::count(m.shape.points.begin(), m.shape.points.end(), s.points[v]), 1);
  EXPECT_EQ(found.corners.size(), given.corners.size());
  EXPECT_LE(found.length, (1 + 1e-9) * given.length);
  if(factor < 1) expect_lengths_kept(given, found, factor * zoo_mesh::mean_edge(s));
}

} // namespace

TEST(Features_kept, OnEveryShape)
{
  std::vector<Shape> shapes = shape_zoo::all();
  for(const Shape& s : { box(), more_shapes::bracket(), more_shapes::closed_cylinder(4), cone(4),
                         more_shapes::two_sheets(0.08), more_shapes::thin_box(0.08),
                         more_shapes::two_spheres(6, 0.02), more_shapes::ridge(3) })
    shapes.push_back(s);
  for(const Shape& s : shapes)
    for(double factor : { 0.5, 0.75, 0.9, 2., 4. }) expect_kept(s, factor);
}

TEST(Features_kept, OnMeshesByOthers)
{
  for(const char* name : { "box_cylinder", "cylinder_hex", "icf", "pawn",
                           "rotated_ellipse_with_subregions", "spot", "star" }) {
    const Shape s = read_shape(name);
    for(double factor : { 0.7, 0.85, 2. }) expect_kept(s, factor);
  }
  const Shape body = read_shape("makehuman_body");
  for(double factor : { 2., 4. }) expect_kept(body, factor);
}

// Where features leave no room for faces as large as asked for, the report says so.
TEST(Features_kept, ThoseThatHoldFacesSmallAreTold)
{
  const auto advice = [](const Shape& s, double factor) {
    Mesh mesh = zoo_mesh::make<Mesh, Point>(s);
    std::string text;
    for(const std::string& a : QMA::adapt_quad_mesh(factor * zoo_mesh::mean_edge(s), mesh).advice)
      text += a;
    return text;
  };
  const std::string told = advice(read_shape("box_cylinder"), 4);
  EXPECT_NE(told.find("are smaller than half their size"), std::string::npos) << told;
  EXPECT_NE(told.find("larger feature angle"), std::string::npos) << told;
  EXPECT_EQ(advice(read_shape("box_cylinder"), 0.5), "");
  EXPECT_EQ(advice(box(), 0.7), "");
}
