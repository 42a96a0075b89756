// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quad_mesh_adaptation/IO/write_picture.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

namespace {

using namespace CGAL::Quad_mesh_adaptation;
using internal::Vec;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

template <class Place>
Mesh grid(std::size_t n, std::size_t m, const Place& place)
{
  Mesh mesh;
  CGAL::make_grid(n, m, mesh, [&](std::size_t i, std::size_t j) {
    return place(double(i) / double(n), double(j) / double(m));
  });
  return mesh;
}
Mesh plate(std::size_t n)
{
  return grid(n, n, [](double u, double v) { return Point(u, v, 0); });
}
Mesh cube(bool is_inside_out = false)
{
  Mesh mesh;
  const double c[8][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 },
                           { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
  std::vector<Mesh::Vertex_index> v;
  for(const auto& p : c) v.push_back(mesh.add_vertex(Point(p[0], p[1], p[2])));
  for(const auto& f : { std::array<int, 4>{ 0, 3, 2, 1 },
                        { 4, 5, 6, 7 },
                        { 0, 1, 5, 4 },
                        { 1, 2, 6, 5 },
                        { 2, 3, 7, 6 },
                        { 3, 0, 4, 7 } })
    mesh.add_face(v[f[0]], v[f[is_inside_out ? 3 : 1]], v[f[2]], v[f[is_inside_out ? 1 : 3]]);
  return mesh;
}

std::size_t count(const std::string& text, const std::string& part)
{
  std::size_t n = 0;
  for(std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(Picture, HasPanelsTitlesAndCounts)
{
  const auto size = [](const Point& p) { return 0.05 + p.x(); };
  const std::string svg = picture_file_contents(plate(2), size, plate(40));
  for(const char* text :
      { ">Initial mesh<", ">Sizing function<", ">Adapted mesh<", ">4 faces<", ">1,600 faces<" })
    EXPECT_EQ(count(svg, text), 1u) << text;
  EXPECT_EQ(count(svg, "<svg "), 1u);
  EXPECT_EQ(svg.substr(svg.size() - 7), "</svg>\n");
  EXPECT_EQ(count(svg, "nan"), 0u);
  EXPECT_EQ(count(svg, "inf"), 0u);
}

TEST(Picture, DrawsEveryFaceOfAFlatMesh)
{
  Picture picture;
  picture.add_mesh(plate(2), "a");
  picture.add_mesh(plate(4), "b & <c>");
  const std::string svg = picture.svg();
  const std::regex end_of_polygon("[0-9]z");
  EXPECT_EQ(std::distance(std::sregex_iterator(svg.begin(), svg.end(), end_of_polygon),
                          std::sregex_iterator()),
            4 + 16);
  EXPECT_EQ(count(svg, "b &amp; &lt;c&gt;"), 1u);
}

TEST(Picture, HidesTheBackOfAClosedSurface)
{
  Picture picture;
  picture.add_mesh(cube(), "cube");
  // three of the six faces can be seen
  EXPECT_EQ(count(picture.svg(), "<path class=\"e"), 3u);

  Picture inside_out;
  inside_out.add_mesh(cube(true), "cube");
  EXPECT_EQ(count(inside_out.svg(), "<path class=\"e"), 3u);
}

TEST(Picture, PaintsFromBackToFront)
{
  // two parallel squares, the darker sizes nearer to the eye
  Mesh mesh;
  for(const double z : { 1., 0. }) {
    std::vector<Mesh::Vertex_index> v;
    for(const auto& p : { Point(0, 0, z), Point(1, 0, z), Point(1, 1, z), Point(0, 1, z) })
      v.push_back(mesh.add_vertex(p));
    mesh.add_face(v[0], v[1], v[2], v[3]);
  }
  Picture_options options;
  options.to_eye = { { 0, 0, 1 } };
  options.up = { { 0, 1, 0 } };
  options.panel_width = 20; // one polygon per face
  Picture picture(options);
  const auto size = [](const Point& p) { return p.z() > 0.5 ? 1. : 2.; };
  picture.add_sizing(mesh, size, "sizes");
  const std::string svg = picture.svg();
  const std::string faces = svg.substr(svg.find("<g class=\"faces\">"));
  const internal::Picture_view view = internal::view_from(Vec(0, 0, 1), Vec(0, 1, 0));
  const double shade = 0.5 + 0.5 * internal::shade_of(view, Vec(0, 0, 1));
  const std::size_t near = faces.find(internal::hex(internal::size_colour(0), shade)),
                    far = faces.find(internal::hex(internal::size_colour(1), shade));
  ASSERT_NE(near, std::string::npos);
  ASSERT_NE(far, std::string::npos);
  EXPECT_LT(far, near);
}

TEST(Picture, FindsThinFeaturesOfTheSizes)
{
  // a dip that no vertex and no centre of the four faces sees
  const auto size = [](const Point& p) {
    return std::hypot(p.x() - 0.31, p.y() - 0.37) < 0.03 ? 0.1 : 1;
  };
  const Mesh fine = plate(64);
  const std::string svg = picture_file_contents(plate(2), size, fine);
  EXPECT_GE(count(svg, internal::hex(internal::size_colour(0))), 2u);
}

TEST(Picture, LeavesEdgesOutOfVeryFineMeshes)
{
  Picture picture;
  picture.add_mesh(plate(300), "fine");
  const std::string svg = picture.svg();
  EXPECT_EQ(count(svg, "<path class=\"e"), 0u);
  EXPECT_EQ(count(svg, ">90,000 faces, colour is face size<"), 1u);
}

TEST(Picture, TakesANumberAndNoPanelsAtAll)
{
  EXPECT_EQ(count(picture_file_contents(plate(2), 0.5, plate(2)), ">0.5<"), 1u);
  EXPECT_EQ(count(Picture().svg(), "<svg "), 1u);
}

TEST(Picture, SurvivesSizesThatAreNoSizes)
{
  const auto size = [](const Point& p) { return p.x() < 0.5 ? std::nan("") : -1.; };
  const std::string svg = picture_file_contents(plate(2), size, plate(2));
  EXPECT_EQ(count(svg, "nan"), 0u);
}

TEST(Picture, OfAnEmptyMesh)
{
  const std::string svg = picture_file_contents(Mesh(), 0.5, Mesh());
  EXPECT_EQ(count(svg, "<svg "), 1u);
  EXPECT_EQ(count(svg, "nan") + count(svg, "inf"), 0u);
}

TEST(PictureView, SeesFlatMeshesAlongTheirNormal)
{
  const auto view_of = [](const Mesh& mesh) {
    return internal::default_view(internal::soup_of_mesh(mesh));
  };
  const internal::Picture_view flat = view_of(plate(3));
  EXPECT_TRUE(flat.is_planar);
  EXPECT_EQ(flat.to_eye, Vec(0, 0, 1));
  EXPECT_EQ(flat.up, Vec(0, 1, 0));

  const internal::Picture_view wall =
      view_of(grid(3, 3, [](double u, double v) { return Point(u, 5, v); }));
  EXPECT_TRUE(wall.is_planar);
  EXPECT_EQ(wall.up, Vec(0, 0, 1));
  EXPECT_EQ(std::abs(wall.to_eye.y()), 1);

  EXPECT_FALSE(view_of(cube()).is_planar);
  // a bowl that opens upwards is seen from below, where its outside is
  const internal::Picture_view bowl = view_of(grid(9, 9, [](double u, double v) {
    return Point(u, v, 4 * (u - .5) * (u - .5) + 4 * (v - .5) * (v - .5));
  }));
  EXPECT_LT(bowl.to_eye.z(), 0);
}

TEST(PictureView, HasARightHandedFrameForAnyDirection)
{
  for(const Vec& eye :
      { Vec(0, 0, 1), Vec(0, 0, -2), Vec(1, 2, 3), Vec(0, 1, 0), Vec(-1, 0, 1e-12) })
    for(const Vec& up : { Vec(0, 0, 1), Vec(0, 1, 0), Vec(0, 0, 0) }) {
      const internal::Picture_view view = internal::view_from(eye, up);
      EXPECT_NEAR(internal::norm(view.right), 1, 1e-12);
      EXPECT_NEAR(internal::norm(view.up), 1, 1e-12);
      EXPECT_NEAR(internal::norm(internal::cross(view.right, view.up) - view.to_eye), 0, 1e-12);
    }
}

TEST(ColourMap, GrowsEvenlyLighter)
{
  double last = -1;
  for(int i = 0; i <= 50; ++i) {
    const internal::Colour c = internal::size_colour(i / 50.);
    const double luma = 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
    EXPECT_GT(luma, last);
    last = luma;
    for(const double channel : c) {
      EXPECT_GE(channel, 0);
      EXPECT_LE(channel, 1);
    }
  }
}

TEST(SizeScale, IsLogarithmicAboveAFactorOfTen)
{
  const internal::Size_scale wide(0.1, 10), narrow(1, 3), flat(2, 2);
  EXPECT_NEAR(wide(1), 0.5, 1e-12);
  EXPECT_NEAR(narrow(2), 0.5, 1e-12);
  EXPECT_EQ(flat(2), 0.5);
  for(const auto& scale : { wide, narrow, flat, internal::Size_scale(0.04, 1.5) }) {
    const std::vector<double> ticks = scale.ticks();
    EXPECT_EQ(ticks.front(), scale.min());
    EXPECT_EQ(ticks.back(), scale.max());
    for(std::size_t i = 1; i < ticks.size(); ++i) EXPECT_LT(ticks[i - 1], ticks[i]);
    EXPECT_LT(ticks.size(), 16u);
  }
}

TEST(WritePicture, WritesOnlySvgAndOnlyWhereItCan)
{
  const std::string file = testing::TempDir() + "write_picture.svg";
  ASSERT_TRUE(write_picture(file, plate(2), 0.5, plate(3)).ok());
  EXPECT_GT(std::filesystem::file_size(file), 1000u);
  std::remove(file.c_str());
  EXPECT_EQ(write_picture(testing::TempDir() + "a.png", plate(2), 0.5, plate(3)).reason,
            Refusal::unwritable_file);
  EXPECT_EQ(write_picture("no/such/folder/a.svg", plate(2), 0.5, plate(3)).reason,
            Refusal::unwritable_file);
}

} // namespace
