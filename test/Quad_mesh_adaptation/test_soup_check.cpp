// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "support/read_text.h"

#include <string>

namespace {

using namespace read_test;

TEST(SoupCheck, RefusesCoordinatesThatAreNotFinite)
{
  for(const char* value : { "nan", "inf", "-inf", "NaN", "Infinity", "1e999", "-1e999" }) {
    const Read_result result =
        read_off("OFF\n4 1 0\n0 0 0\n1 0 0\n1 " + std::string(value) + " 0\n0 1 0\n4 0 1 2 3\n");
    EXPECT_EQ(result.reason, Refusal::non_finite_coordinate) << value;
    EXPECT_EQ(result.entity, 2);
    EXPECT_TRUE(contains(result.message, "vertex 2")) << result.message;
  }
  EXPECT_EQ(
      read_off("OFF\n4 1 0\n-1e308 0 0\n1e308 0 0\n1e308 1e308 0\n-1e308 1e308 0\n4 0 1 2 3\n")
          .reason,
      Refusal::non_finite_coordinate);
}

TEST(SoupCheck, RefusesFacesThatAreNoQuads)
{
  const Read_result result =
      read_off("OFF\n6 3 0\n" + two_points + "4 0 1 4 3\n3 1 2 5\n3 1 5 4\n");
  EXPECT_EQ(result.reason, Refusal::not_all_quads);
  EXPECT_EQ(result.entity, 1);
  EXPECT_TRUE(contains(result.message, "face 1 has 3 vertices")) << result.message;
  EXPECT_TRUE(contains(result.message, "2 of 3")) << result.message;
}

TEST(SoupCheck, RefusesDegenerateFaces)
{
  const auto with_face = [](const std::string& points, const std::string& face) {
    return read_off("OFF\n4 1 0\n" + points + face + "\n");
  };
  const std::string square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  EXPECT_TRUE(with_face(square, "4 0 1 2 3").ok());
  EXPECT_EQ(with_face(square, "4 0 1 2 1").reason, Refusal::degenerate_face);
  EXPECT_EQ(with_face("0 0 0\n1 0 0\n1 0 0\n0 1 0\n", "4 0 1 2 3").reason,
            Refusal::degenerate_face); // an edge without length
  EXPECT_EQ(with_face("0 0 0\n1 0 0\n2 0 0\n3 0 0\n", "4 0 1 2 3").reason,
            Refusal::degenerate_face); // on a line
  EXPECT_EQ(with_face("0 0 0\n1 1 0\n1 0 0\n0 1 0\n", "4 0 1 2 3").reason,
            Refusal::degenerate_face); // a bow tie encloses nothing
  const auto tiny = [&](const std::string& e) {
    return with_face("0 0 0\n1e" + e + " 0 0\n1e" + e + " 1e" + e + " 0\n0 1e" + e + " 0\n",
                     "4 0 1 2 3");
  };
  EXPECT_TRUE(tiny("-100").ok());
  EXPECT_EQ(tiny("-200").reason, Refusal::degenerate_face); // squares of lengths underflow
  EXPECT_TRUE(with_face("0 0 0\n1 0 0\n1 1e-9 0\n0 1e-9 0\n", "4 0 1 2 3").ok()); // thin is fine
}

TEST(SoupCheck, RefusesAnEdgeOfThreeFacesAndNamesIt)
{
  const Read_result result =
      read_off("OFF\n8 3 0\n" + two_points + "1 0 1\n1 1 1\n4 0 1 4 3\n4 1 2 5 4\n4 1 4 7 6\n");
  EXPECT_EQ(result.reason, Refusal::non_manifold);
  EXPECT_TRUE(contains(result.message, "vertices 1 and 4")) << result.message;
}

TEST(SoupCheck, RefusesTwoFansAtAVertex)
{
  const Read_result open = read_off("OFF\n7 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 1 0\n2 2 0\n1 2 0\n"
                                    "4 0 1 2 3\n4 2 4 5 6\n");
  EXPECT_EQ(open.reason, Refusal::non_manifold);
  EXPECT_EQ(open.entity, 2);
}

// Two closed surfaces that touch: all edges are fine, the vertex is not.
TEST(SoupCheck, RefusesCubesThatShareAVertex)
{
  const char* cube = "0 3 2 1|4 5 6 7|0 1 5 4|1 2 6 5|2 3 7 6|3 0 4 7|";
  std::string text = "OFF\n15 12 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
                     "2 1 1\n2 2 1\n1 2 1\n1 1 2\n2 1 2\n2 2 2\n1 2 2\n";
  for(const int offset : { 0, 1 })
    for(const char* c = cube; *c != 0; ++c) {
      if(c == cube || c[-1] == '|') text += "4 ";
      if(*c == '|')
        text += '\n';
      else if(*c == ' ')
        text += ' ';
      else // the second cube starts at the far corner of the first, number 6
        text += std::to_string(offset == 0 ? *c - '0' : *c == '0' ? 6 : *c - '0' + 7);
    }
  const Read_result result = read_off(text);
  EXPECT_EQ(result.reason, Refusal::non_manifold);
  EXPECT_EQ(result.entity, 6) << result.message;
}

TEST(SoupCheck, RefusesAFaceGivenTwice)
{
  for(const char* again : { "4 0 1 4 3\n", "4 3 4 1 0\n", "4 4 3 0 1\n" }) {
    const Read_result result = read_off("OFF\n6 2 0\n" + two_points + "4 0 1 4 3\n" + again);
    EXPECT_EQ(result.reason, Refusal::non_manifold) << again;
  }
}

TEST(SoupCheck, RefusesMoebiusStripsOnly)
{
  EXPECT_TRUE(read_off(band(12, false)).ok());
  EXPECT_EQ(read_off(band(12, true)).reason, Refusal::non_orientable);
}

TEST(SoupCheck, TurnsTheFewestFacesPerComponent)
{
  // a row of five squares, of which the second and the last are turned, and a single far square
  std::string text = "OFF\n16 6 0\n";
  for(int i = 0; i < 6; ++i) text += std::to_string(i) + " 0 0\n" + std::to_string(i) + " 1 0\n";
  text += "0 9 0\n1 9 0\n1 10 0\n0 10 0\n";
  for(int i = 0; i < 5; ++i) {
    const int a = 2 * i, b = a + 2, c = a + 3, d = a + 1;
    const bool is_turned = i == 1 || i == 4;
    for(const int v : { 4, a, is_turned ? d : b, c, is_turned ? b : d })
      text += std::to_string(v) + ' ';
    text += '\n';
  }
  text += "4 15 14 13 12\n";
  Mesh mesh;
  const Read_result result = read_text(".off", text, mesh);
  ASSERT_TRUE(result.ok()) << result.message;
  ASSERT_EQ(result.notes.size(), 1u);
  EXPECT_TRUE(contains(result.notes[0], "2 faces were turned")) << result.notes[0];
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  EXPECT_EQ(mesh.number_of_faces(), 6u);
}

TEST(SoupCheck, DropsIsolatedVerticesAndKeepsCoincidentOnes)
{
  Mesh mesh;
  Read_result result =
      read_text(".off", "OFF\n6 1 0\n9 9 9\n0 0 0\n1 0 0\n8 8 8\n1 1 0\n0 1 0\n4 1 2 4 5\n", mesh);
  ASSERT_TRUE(result.ok()) << result.message;
  ASSERT_EQ(result.notes.size(), 1u);
  EXPECT_TRUE(contains(result.notes[0], "2 vertices"));
  EXPECT_EQ(mesh.number_of_vertices(), 4u);

  result = read_text(".off",
                     "OFF\n8 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n1 0 0\n2 0 0\n2 1 0\n1 1 0\n"
                     "4 0 1 2 3\n4 4 5 6 7\n",
                     mesh);
  ASSERT_TRUE(result.ok()) << result.message;
  EXPECT_EQ(mesh.number_of_vertices(), 8u);
}

TEST(SoupCheck, TakesAnyPolygonsButNotTwoCorners)
{
  Mesh mesh;
  const Temporary_file good(".off", "OFF\n6 3 0\n" + two_points + "4 0 1 4 3\n3 1 2 5\n3 1 5 4\n");
  const Read_result result = read_surface(good.name(), mesh);
  EXPECT_TRUE(result.ok()) << result.message;
  EXPECT_EQ(mesh.number_of_faces(), 3u);
  const Temporary_file bad(".off", "OFF\n6 2 0\n" + two_points + "4 0 1 4 3\n2 1 2\n");
  EXPECT_EQ(read_surface(bad.name(), mesh).reason, Refusal::degenerate_face);
}

} // namespace
