// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "support/read_text.h"
#include "support/zoo_mesh.h"

#include <CGAL/Polyhedron_3.h>

#include <array>
#include <cstdint>
#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace read_test;

TEST(ReadQuadMesh, ReadsOffWithCommentsCountsOnFirstLineAndWindowsLineEnds)
{
  Mesh mesh;
  const Read_result result =
      read_text(".OFF",
                "# a comment\r\nOFF 6 2 7\r\n\r\n0 0 0\r\n1 0 0 # here too\r\n2 0 0 255 0 0\r\n"
                "0 1 0\r\n+1 1e0 0\r\n2 1 0\r\n4 0 1 4 3 0.5 0.5 0.5\r\n4 1 2 5 4",
                mesh);
  ASSERT_TRUE(result.ok()) << result.message;
  EXPECT_TRUE(result.notes.empty());
  EXPECT_EQ(mesh.number_of_vertices(), 6u);
  EXPECT_EQ(mesh.number_of_faces(), 2u);
  EXPECT_EQ(mesh.point(Mesh::Vertex_index(4)), Kernel::Point_3(1, 1, 0));
}

TEST(ReadQuadMesh, PassesOverTheMarkOfUtf8)
{
  Mesh mesh;
  const Read_result result =
      read_text(".off", "\xEF\xBB\xBFOFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n", mesh);
  ASSERT_TRUE(result.ok()) << result.message;
  EXPECT_EQ(mesh.number_of_faces(), 1u);
}

TEST(ReadQuadMesh, TellsOfCoincidentVertices)
{
  Mesh mesh;
  const Read_result result =
      read_text(".off",
                "OFF\n8 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n1 0 0\n2 0 0\n2 1 0\n1 1 0\n"
                "4 0 1 2 3\n4 4 5 6 7\n",
                mesh);
  ASSERT_TRUE(result.ok()) << result.message;
  ASSERT_EQ(result.notes.size(), 1u);
  EXPECT_EQ(result.notes[0].find("2 vertices have the coordinates of others"), 0u)
      << result.notes[0];
  EXPECT_EQ(mesh.number_of_edges(), 8u);
}

TEST(ReadQuadMesh, ReadsObjWithSlashesNegativeNumbersAndContinuedLines)
{
  Mesh mesh;
  const Read_result result =
      read_text(".obj",
                "o x\nv 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0 1.0\nv 2 1 0\nvn 0 0 1\n"
                "f 1/1/1 2//1 \\\n5/2 4\nf -5 -4 -1 -2\n",
                mesh);
  ASSERT_TRUE(result.ok()) << result.message;
  EXPECT_EQ(mesh.number_of_faces(), 2u);
  EXPECT_EQ(mesh.number_of_edges(), 7u);
}

std::string ply_header(const std::string& format)
{
  return "ply\nformat " + format +
         " 1.0\ncomment made by hand\nelement vertex 4\nproperty float x\nproperty float y\n"
         "property float z\nproperty uchar red\nelement face 1\n"
         "property list uchar int vertex_indices\nend_header\n";
}

TEST(ReadQuadMesh, ReadsPlyAsText)
{
  Mesh mesh;
  const Read_result result = read_text(
      ".ply", ply_header("ascii") + "0 0 0 1\n1 0 0 2\n1 1 0 3\n0 1 0 4\n4 0 1 2 3\n", mesh);
  ASSERT_TRUE(result.ok()) << result.message;
  EXPECT_EQ(mesh.number_of_faces(), 1u);
}

TEST(ReadQuadMesh, ReadsPlyOfBothByteOrders)
{
  for(const bool is_big : { false, true }) {
    std::string text = ply_header(is_big ? "binary_big_endian" : "binary_little_endian");
    const auto add = [&](auto value) {
      std::string bytes(reinterpret_cast<const char*>(&value), sizeof value);
      if(is_big) bytes.assign(bytes.rbegin(), bytes.rend()); // this test runs on little endian
      text += bytes;
    };
    for(const auto& p :
        { std::array<float, 3>{ 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0.5 } }) {
      for(const float c : p) add(c);
      text += '\x07';
    }
    text += '\x04';
    for(std::int32_t v = 0; v < 4; ++v) add(v);
    Mesh mesh;
    const Read_result result = read_text(".ply", text, mesh);
    ASSERT_TRUE(result.ok()) << result.message;
    EXPECT_EQ(mesh.point(Mesh::Vertex_index(3)), Kernel::Point_3(0, 1, 0.5));
    EXPECT_EQ(read_text(".ply", text.substr(0, text.size() - 1), mesh).reason,
              Refusal::unreadable_file);
  }
}

TEST(ReadQuadMesh, FillsAPolyhedron)
{
  const Temporary_file file(".off", two_quads);
  CGAL::Polyhedron_3<Kernel> mesh;
  const Read_result result = read_quad_mesh(file.name(), mesh);
  ASSERT_TRUE(result.ok()) << result.message;
  EXPECT_TRUE(mesh.is_valid());
  EXPECT_EQ(mesh.size_of_facets(), 2u);
}

TEST(ReadQuadMesh, RefusesWhatIsNoFileToRead)
{
  Mesh mesh;
  EXPECT_EQ(read_quad_mesh("no/such/file.off", mesh).reason, Refusal::unreadable_file);
  EXPECT_TRUE(contains(read_quad_mesh("no/such/file.off", mesh).message, "no such file"));
  EXPECT_EQ(read_quad_mesh(testing::TempDir(), mesh).reason, Refusal::unreadable_file);
  EXPECT_EQ(read_quad_mesh("mesh.stl", mesh).reason, Refusal::unreadable_file);
  EXPECT_TRUE(contains(read_off("").message, "empty"));
  EXPECT_EQ(read_off("solid thing\n").reason, Refusal::unreadable_file);
  EXPECT_EQ(read_off("OFF\n").reason, Refusal::unreadable_file);
  EXPECT_EQ(read_off("OFF\n-1 2 0\n").reason, Refusal::unreadable_file);
  EXPECT_EQ(read_off("OFF BINARY\n" + std::string(12, '\0')).reason, Refusal::unreadable_file);
}

TEST(ReadQuadMesh, RefusesEmptyMeshes)
{
  EXPECT_EQ(read_off("OFF\n0 0 0\n").reason, Refusal::empty_mesh);
  EXPECT_EQ(read_off("OFF\n1 0 0\n0 0 0\n").reason, Refusal::empty_mesh);
  Mesh mesh;
  EXPECT_EQ(read_text(".obj", "# nothing\n", mesh).reason, Refusal::empty_mesh);
}

// Cut anywhere but within or right after the last number, an OFF file is told to be incomplete.
TEST(ReadQuadMesh, RefusesTruncatedOffAtEveryByte)
{
  for(std::size_t length = 0; length + 2 < two_quads.size(); ++length) {
    const Read_result result = read_off(two_quads.substr(0, length));
    EXPECT_EQ(result.reason, Refusal::unreadable_file) << "cut to " << length << " bytes";
  }
  EXPECT_TRUE(read_off(two_quads.substr(0, two_quads.size() - 1)).ok());
}

TEST(ReadQuadMesh, RefusesAnnouncedCountsThatNoMemoryHolds)
{
  EXPECT_EQ(read_off("OFF\n999999999999999 1 0\n0 0 0\n").reason, Refusal::unreadable_file);
  EXPECT_EQ(read_off("OFF\n1 1 0\n0 0 0\n4000000000 0 0 0\n").reason, Refusal::unreadable_file);
  Mesh mesh;
  EXPECT_EQ(read_text(".ply",
                      "ply\nformat binary_little_endian 1.0\nelement face 99999999999\n"
                      "property list uint int vertex_indices\nend_header\n\xff\xff\xff\xff",
                      mesh)
                .reason,
            Refusal::unreadable_file);
}

TEST(ReadQuadMesh, RefusesVertexNumbersOutOfRange)
{
  for(const char* number : { "6", "-1", "99999999999999999999", "2.5", "x" }) {
    const Read_result result =
        read_off("OFF\n6 2 0\n" + two_points + "4 0 1 4 3\n4 1 2 " + number + " 4\n");
    EXPECT_EQ(result.reason, Refusal::unreadable_file) << number;
    EXPECT_EQ(result.entity, 1);
    EXPECT_TRUE(contains(result.message, "line 10")) << result.message;
  }
}

TEST(ReadQuadMesh, LeavesTheMeshAloneOnRefusal)
{
  Mesh mesh;
  ASSERT_TRUE(read_text(".off", two_quads, mesh).ok());
  ASSERT_FALSE(read_text(".off", band(12, true), mesh).ok());
  EXPECT_EQ(mesh.number_of_faces(), 2u);
  ASSERT_TRUE(read_text(".off", band(12, false), mesh).ok());
  EXPECT_EQ(mesh.number_of_faces(), 12u);
}

// Whatever the bytes: an answer, no crash; and what is accepted is a valid mesh of quads.
TEST(ReadQuadMesh, SurvivesRandomDamage)
{
  const unsigned seed = zoo_mesh::seed(std::random_device{}());
  std::cout << "QUAD_MESH_SEED=" << seed << std::endl;
  std::mt19937 random(seed);
  const std::string interesting = "0123456789-.+eEnaif# \n\t\\/\0\xff\x80OFply";
  const std::vector<std::pair<std::string, std::string>> originals = {
    { ".off", two_quads },
    { ".off", band(6, false) },
    { ".off", "STCNOFF\n" + two_quads.substr(4) },
    { ".obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1/2/3 2 3 -1\n" },
    { ".ply", ply_header("ascii") + "0 0 0 1\n1 0 0 2\n1 1 0 3\n0 1 0 4\n4 0 1 2 3\n" },
    { ".ply", ply_header("binary_big_endian") + std::string(70, '\1') }
  };
  std::size_t accepted = 0;
  for(int round = 0; round < 3000; ++round) {
    auto [extension, text] = originals[random() % originals.size()];
    for(unsigned edits = 1 + random() % 4; edits > 0 && !text.empty(); --edits) {
      const std::size_t at = random() % text.size();
      switch(random() % 4) {
      case 0:
        text[at] = interesting[random() % interesting.size()];
        break;
      case 1:
        text.insert(at, 1, interesting[random() % interesting.size()]);
        break;
      case 2:
        text.erase(at, 1 + random() % 5);
        break;
      default:
        text.insert(random() % text.size(), text.substr(at, random() % 20));
      }
    }
    Mesh mesh;
    const Read_result result = read_text(extension, text, mesh);
    if(!result.ok()) {
      EXPECT_FALSE(result.message.empty());
      EXPECT_EQ(mesh.number_of_faces(), 0u);
      continue;
    }
    ++accepted;
    ASSERT_TRUE(CGAL::is_quad_mesh(mesh)) << text;
    ASSERT_TRUE(CGAL::is_valid_polygon_mesh(mesh)) << text;
  }
  EXPECT_GT(accepted, 100u);
  EXPECT_LT(accepted, 2900u);
}

} // namespace
