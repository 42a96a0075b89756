// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// No node changes to a wrong sheet, and features stay, whether a mesh is refined or coarsened.

#include "support/more_shapes.h"
#include "support/usual_calls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace {

namespace QMA = CGAL::Quad_mesh_adaptation;
using more_shapes::Index;
using more_shapes::Quad;
using more_shapes::Shape;
using more_shapes::Vec;
using usual_mesh::Mesh;
using usual_mesh::Point;

struct Adapted
{
  Shape shape;
  QMA::Adaptation_report report;
};

template <typename Size, typename NP = CGAL::parameters::Default_named_parameters>
Adapted adapt(const Shape& s, const Size& size, const NP& np = CGAL::parameters::default_values())
{
  Mesh mesh = zoo_mesh::make<Mesh, Point>(s);
  const mesh_checks::Facts before = mesh_checks::facts_of(s.points, s.quads);
  Adapted a;
  a.report = QMA::adapt_quad_mesh(size, mesh, np);
  EXPECT_TRUE(a.report.has_valid_mesh()) << s.name << ": " << a.report.message;
  mesh.collect_garbage();
  zoo_mesh::expect_valid(mesh, before);
  a.shape = zoo_mesh::shape_of(mesh);
  return a;
}

// For each vertex the lowest vertex of its component.
std::vector<Index> components(const Shape& s)
{
  std::vector<Index> root(s.points.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](Index v) {
    while(root[v] != v) v = root[v] = root[root[v]];
    return v;
  };
  for(const Quad& q : s.quads)
    for(int i = 1; i < 4; ++i) {
      const Index a = find(q[0]), b = find(q[i]);
      root[(std::max)(a, b)] = (std::min)(a, b);
    }
  for(Index v = 0; v < Index(root.size()); ++v) root[v] = find(v);
  return root;
}

Vec normal_of(const Shape& s, const Quad& q)
{
  return CGAL::cross_product(s.points[q[2]] - s.points[q[0]], s.points[q[3]] - s.points[q[1]]);
}

Vec centre_of(const Shape& s, const Quad& q)
{
  return 0.25 * (s.points[q[0]] + s.points[q[1]] + s.points[q[2]] + s.points[q[3]]);
}

bool is_whole(double x) { return std::abs(x - std::round(x)) < 1e-12; }

// The edges across which the surface turns by more than 45 degrees.
std::vector<std::pair<Index, Index>> creases(const Shape& s)
{
  std::map<std::pair<Index, Index>, std::vector<Vec>> beside;
  for(const Quad& q : s.quads) {
    const Vec n = normal_of(s, q) / std::sqrt(normal_of(s, q).squared_length());
    for(int i = 0; i < 4; ++i) beside[std::minmax(q[i], q[(i + 1) % 4])].push_back(n);
  }
  std::vector<std::pair<Index, Index>> list;
  for(const auto& [e, n] : beside)
    if(n.size() == 2 && n[0] * n[1] < 0.7) list.push_back(e);
  return list;
}

double crease_length(const Shape& s)
{
  double sum = 0;
  for(const auto& [a, b] : creases(s))
    sum += std::sqrt((s.points[a] - s.points[b]).squared_length());
  return sum;
}

double volume(const Shape& s)
{
  double sum = 0;
  for(const Quad& q : s.quads) {
    const Vec &a = s.points[q[0]], &b = s.points[q[1]], &c = s.points[q[2]], &d = s.points[q[3]];
    sum += (CGAL::cross_product(a, b) * c + CGAL::cross_product(a, c) * d) / 6;
  }
  return sum;
}

double area(const Shape& s)
{
  double sum = 0;
  for(const Quad& q : s.quads) sum += 0.5 * std::sqrt(normal_of(s, q).squared_length());
  return sum;
}

} // namespace

TEST(Close_sheets, TwoParallelSheets)
{
  const double gap = 0.08; // a hundredth of their size
  const Shape sheets = more_shapes::two_sheets(gap);
  const usual_mesh::Size graded = [](const Point& p) { return 0.25 + 0.3 * p.x(); };
  for(const Adapted& a : { adapt(sheets, 0.4), adapt(sheets, 3.), adapt(sheets, graded) })
    for(const Quad& q : a.shape.quads) {
      const double z = normal_of(a.shape, q).z() > 0 ? 0 : -gap;
      for(Index v : q) ASSERT_NEAR(a.shape.points[v].z(), z, 1e-12);
    }
}

// The reference lies off the input by more than half the gap: only normals tell the sheets apart.
TEST(Close_sheets, SeparateReferenceNearerToTheOtherSheet)
{
  const double gap = 0.08;
  const Shape shifted = more_shapes::moved(more_shapes::two_sheets(gap), Vec(0, 0, 0.7 * gap));
  const Mesh reference = zoo_mesh::make<Mesh, Point>(more_shapes::two_sheets(gap));
  for(double size : { 0.5, 2.5 }) {
    const Adapted a = adapt(shifted, size, QMA::reference_surface(reference));
    std::size_t inside = 0;
    for(const Quad& q : a.shape.quads) {
      const double z = normal_of(a.shape, q).z() > 0 ? 0 : -gap;
      for(Index v : q) {
        const Vec& p = a.shape.points[v];
        if(!(p.x() > 1e-6 && p.x() < 8 - 1e-6 && p.y() > 1e-6 && p.y() < 8 - 1e-6)) continue;
        ++inside;
        ASSERT_NEAR(p.z(), z, 1e-12);
      }
    }
    EXPECT_GT(inside, 20u);
  }
}

TEST(Close_sheets, TwoSpheresThatNearlyTouch)
{
  const double gap = 0.02;
  const Shape spheres = more_shapes::two_spheres(8, gap);
  const double chord = 0.03; // the facets are that far inside at most
  const auto fine_between = [](const Point& p) { return 0.08 + 0.3 * std::abs(p.x() - 1.01); };
  const auto check = [&](const Adapted& a, double inside) {
    const std::vector<Index> root = components(a.shape);
    for(std::size_t v = 0; v < root.size(); ++v) {
      const bool left = a.shape.points[root[v]].x() < 1 + gap / 2;
      const Vec p = a.shape.points[v] - Vec(left ? 0 : 2 + gap, 0, 0);
      const double r = std::sqrt(p.squared_length());
      ASSERT_TRUE(r < 1 + 2e-3 && r > 1 - inside) << r;
      ASSERT_TRUE(left ? p.x() < 1 + gap / 2 : p.x() > -1 - gap / 2);
    }
  };
  check(adapt(spheres, fine_between), chord);
  check(adapt(spheres, 0.6), chord);
  check(adapt(spheres, fine_between, QMA::smooth_reference(true)), 2e-3);
}

TEST(Close_sheets, ThinBox)
{
  const double thickness = 0.08;
  const Shape box = more_shapes::thin_box(thickness);
  const double edges = crease_length(box);
  const usual_mesh::Size graded = [](const Point& p) { return 0.2 + 0.2 * p.y(); };
  for(const Adapted& a : { adapt(box, graded), adapt(box, 2.) }) {
    EXPECT_EQ(a.report.patches, 6u);
    EXPECT_EQ(a.report.feature_curves, 12u);
    EXPECT_EQ(a.report.corners, 8u);
    EXPECT_NEAR(crease_length(a.shape), edges, 1e-9 * edges);
    EXPECT_NEAR(volume(a.shape), 64 * thickness, 1e-9);
    for(const Quad& q : a.shape.quads) {
      const Vec n = normal_of(a.shape, q);
      if(std::abs(n.z()) < std::abs(n.x()) + std::abs(n.y())) continue;
      for(Index v : q) ASSERT_NEAR(a.shape.points[v].z(), n.z() > 0 ? thickness : 0, 1e-12);
    }
  }
}

// Without features nodes may go round the rim, but not through the wall, and the rim does not slide
// inward until nothing is left of the box.
// The faces on the rim of a thin plate are slivers, longer ones in a coarser mesh; that is no
// reason to leave the mesh as fine as it is.
TEST(Close_sheets, ThinBoxIsThinnedOut)
{
  for(double thickness : { 0.3, 0.08, 0.02 }) {
    const Adapted a = adapt(more_shapes::thin_box(thickness), 2.);
    EXPECT_LE(a.report.after.faces, 80u) << thickness; // of 160; 48 would do
    EXPECT_GT(a.report.after.min_scaled_jacobian, 0.6) << thickness;
  }
}

TEST(Close_sheets, ThinBoxWithoutFeatures)
{
  const Shape box = more_shapes::thin_box(0.08);
  for(double size : { 0.35, 0.6, 1.3 }) {
    const Adapted a = adapt(box, size, QMA::feature_angle(180));
    // sixteen times as long as the wall is thick, faces cut the corners of the outline
    EXPECT_GT(area(a.shape), (size < 1 ? 0.9 : 0.75) * area(box)) << size;
    std::size_t inner = 0;
    for(const Quad& q : a.shape.quads) {
      const Vec c = centre_of(a.shape, q);
      if(c.x() < 2.5 || c.x() > 5.5 || c.y() < 2.5 || c.y() > 5.5) continue;
      const double z = normal_of(a.shape, q).z() > 0 ? 0.08 : 0;
      for(Index v : q) {
        const Vec& p = a.shape.points[v];
        const bool is_inner = p.x() > 1 && p.x() < 7 && p.y() > 1 && p.y() < 7;
        EXPECT_TRUE(!is_inner || std::abs(p.z() - z) < 1e-12) << size;
        inner += is_inner;
      }
    }
    EXPECT_GT(inner, 30u) << size;
  }
}

namespace {

// The ends of creases, sorted: where not two meet, or two that are not in line.
std::vector<Vec> corners_of(const Shape& s)
{
  std::vector<std::vector<Vec>> ways(s.points.size());
  for(const auto& [a, b] : creases(s)) {
    ways[a].push_back(s.points[b] - s.points[a]);
    ways[b].push_back(s.points[a] - s.points[b]);
  }
  std::vector<Vec> list;
  for(std::size_t v = 0; v < ways.size(); ++v) {
    const auto& w = ways[v];
    const bool is_straight =
        w.size() == 2 && CGAL::cross_product(w[0], w[1]).squared_length() <
                             1e-18 * w[0].squared_length() * w[1].squared_length();
    if(!w.empty() && !is_straight) list.push_back(s.points[v]);
  }
  std::sort(list.begin(), list.end(), [](const Vec& a, const Vec& b) {
    return std::make_tuple(a.x(), a.y(), a.z()) < std::make_tuple(b.x(), b.y(), b.z());
  });
  return list;
}

// Refined and coarsened in turn: corners to the last bit, creases in place, volume and area kept.
// All faces of the shape lie in planes of whole numbers.
void go_rounds(const Shape& given, double small, double large)
{
  const double edges = crease_length(given), v0 = volume(given), a0 = area(given);
  const std::vector<Vec> corners = corners_of(given);
  Shape s = given;
  std::size_t curves = 0;
  for(int round = 0; round < zoo_mesh::count("QUAD_MESH_ROUNDS", 10); ++round)
    for(double size : { small, large }) {
      SCOPED_TRACE(given.name + ", round " + std::to_string(round) + ", " + std::to_string(size));
      const Adapted a = adapt(s, size);
      s = a.shape;
      if(curves == 0) curves = a.report.feature_curves;
      EXPECT_EQ(a.report.corners, corners.size());
      EXPECT_EQ(a.report.feature_curves, curves);
      EXPECT_EQ(corners_of(s), corners);
      EXPECT_NEAR(crease_length(s), edges, 1e-9 * edges);
      EXPECT_NEAR(volume(s), v0, 1e-9 * v0);
      EXPECT_NEAR(area(s), a0, 1e-9 * a0);
      EXPECT_LT(a.report.after.mesh_to_reference, 1e-9);
      EXPECT_LT(a.report.after.reference_to_mesh, 1e-9);
      for(const Vec& p : s.points)
        ASSERT_TRUE(is_whole(p.x()) || is_whole(p.y()) || is_whole(p.z()));
    }
}

} // namespace

TEST(Features, RoundsOnABracket)
{
  EXPECT_EQ(corners_of(more_shapes::bracket()).size(), 20u); // 12 of the L, 8 of the hole
  go_rounds(more_shapes::bracket(), 0.7, 1.6);
}

TEST(Features, RoundsOnABox)
{
  const Shape box =
      more_shapes::voxels("box", { 6, 4, 3 }, [](Index, Index, Index) { return true; });
  go_rounds(box, 0.45, 1.9);
}

// A crease that is far below the angle is kept when the caller marks its patches, the patches keep
// their faces, neighbours and area, and the numbers come back on the new faces.
TEST(Features, FacePatches)
{
  const Shape sphere = more_shapes::sphere(6);
  for(double size : { 0.12, 0.6 }) {
    Mesh mesh = zoo_mesh::make<Mesh, Point>(sphere);
    auto patch = mesh.add_property_map<Mesh::Face_index, char>("f:patch", '?').first;
    const auto octant = [&](Mesh::Face_index f) {
      Vec c(0, 0, 0);
      for(auto v : vertices_around_face(mesh.halfedge(f), mesh))
        c = c + (mesh.point(v) - CGAL::ORIGIN);
      return char('A' + (c.x() > 0) + 2 * (c.y() > 0) + 4 * (c.z() > 0));
    };
    for(auto f : mesh.faces()) patch[f] = octant(f);
    const QMA::Adaptation_report report =
        QMA::adapt_quad_mesh(size, mesh, CGAL::parameters::face_patch_map(patch));
    ASSERT_TRUE(report.has_valid_mesh()) << report.message;
    EXPECT_EQ(report.patches, 8u);
    EXPECT_EQ(report.feature_curves, 12u);
    EXPECT_EQ(report.corners, 6u);
    std::map<char, double> areas;
    std::map<std::pair<char, char>, int> borders;
    for(auto f : mesh.faces()) {
      ASSERT_EQ(patch[f], octant(f));
      std::vector<Vec> p;
      for(auto v : vertices_around_face(mesh.halfedge(f), mesh))
        p.push_back(mesh.point(v) - CGAL::ORIGIN);
      areas[patch[f]] +=
          0.5 * std::sqrt(CGAL::cross_product(p[2] - p[0], p[3] - p[1]).squared_length());
      for(auto h : halfedges_around_face(mesh.halfedge(f), mesh)) {
        const auto g = mesh.face(mesh.opposite(h));
        if(patch[g] == patch[f]) continue;
        ++borders[std::minmax(patch[f], patch[g])];
        // between two octants: in a plane of coordinates
        const Vec a = mesh.point(mesh.source(h)) - CGAL::ORIGIN,
                  b = mesh.point(mesh.target(h)) - CGAL::ORIGIN;
        const double off =
            (std::min)({ std::abs(a.x()) + std::abs(b.x()), std::abs(a.y()) + std::abs(b.y()),
                         std::abs(a.z()) + std::abs(b.z()) });
        EXPECT_LT(off, 1e-12);
      }
    }
    EXPECT_EQ(areas.size(), 8u);
    for(const auto& a : areas) EXPECT_NEAR(a.second, areas['A'], 0.05 * areas['A']);
    EXPECT_EQ(borders.size(), 12u);
  }
}
