// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Quad_mesh_adaptation/IO/read_quad_mesh.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace CGAL::Quad_mesh_adaptation;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// A file of the given text that is removed again.
class Temporary_file
{
public:
  Temporary_file(const std::string& extension, const std::string& text)
      : name_(testing::TempDir() + "read_quad_mesh_" +
              testing::UnitTest::GetInstance()->current_test_info()->name() + extension)
  {
    std::ofstream(name_, std::ios::binary) << text;
  }
  ~Temporary_file() { std::remove(name_.c_str()); }
  const std::string& name() const { return name_; }

private:
  std::string name_;
};

Read_result read_text(const std::string& extension, const std::string& text, Mesh& mesh)
{
  const Temporary_file file(extension, text);
  return read_quad_mesh(file.name(), mesh);
}

Read_result read_off(const std::string& text)
{
  Mesh mesh;
  return read_text(".off", text, mesh);
}

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

// Two unit squares side by side.
const std::string two_points = "0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 0\n2 1 0\n";
const std::string two_quads = "OFF\n6 2 0\n" + two_points + "4 0 1 4 3\n4 1 2 5 4\n";

// A closed band of n quads; twisted it is a Moebius strip.
std::string band(int n, bool is_twisted)
{
  std::string text = "OFF\n" + std::to_string(2 * n) + ' ' + std::to_string(n) + " 0\n";
  for(int i = 0; i < n; ++i) {
    const double angle = 2 * 3.14159265358979 * i / n, turn = is_twisted ? angle / 2 : 0;
    for(const double side : { -0.3, 0.3 }) {
      const double r = 2 + side * std::cos(turn);
      text += std::to_string(r * std::cos(angle)) + ' ' + std::to_string(r * std::sin(angle)) +
              ' ' + std::to_string(side * std::sin(turn) + (is_twisted ? 0 : side)) + '\n';
    }
  }
  for(int i = 0; i < n; ++i) {
    int c = 2 * ((i + 1) % n), d = c + 1;
    if(is_twisted && i == n - 1) std::swap(c, d);
    text += "4 " + std::to_string(2 * i) + ' ' + std::to_string(2 * i + 1) + ' ' +
            std::to_string(d) + ' ' + std::to_string(c) + '\n';
  }
  return text;
}

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

TEST(ReadQuadMesh, RefusesCoordinatesThatAreNotFinite)
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

TEST(ReadQuadMesh, RefusesFacesThatAreNoQuads)
{
  const Read_result result =
      read_off("OFF\n6 3 0\n" + two_points + "4 0 1 4 3\n3 1 2 5\n3 1 5 4\n");
  EXPECT_EQ(result.reason, Refusal::not_all_quads);
  EXPECT_EQ(result.entity, 1);
  EXPECT_TRUE(contains(result.message, "face 1 has 3 vertices")) << result.message;
  EXPECT_TRUE(contains(result.message, "2 of 3")) << result.message;
}

TEST(ReadQuadMesh, RefusesDegenerateFaces)
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

TEST(ReadQuadMesh, RefusesAnEdgeOfThreeFacesAndNamesIt)
{
  const Read_result result =
      read_off("OFF\n8 3 0\n" + two_points + "1 0 1\n1 1 1\n4 0 1 4 3\n4 1 2 5 4\n4 1 4 7 6\n");
  EXPECT_EQ(result.reason, Refusal::non_manifold);
  EXPECT_TRUE(contains(result.message, "vertices 1 and 4")) << result.message;
}

TEST(ReadQuadMesh, RefusesTwoFansAtAVertex)
{
  const Read_result open = read_off("OFF\n7 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 1 0\n2 2 0\n1 2 0\n"
                                    "4 0 1 2 3\n4 2 4 5 6\n");
  EXPECT_EQ(open.reason, Refusal::non_manifold);
  EXPECT_EQ(open.entity, 2);
}

// Two closed surfaces that touch: all edges are fine, the vertex is not.
TEST(ReadQuadMesh, RefusesCubesThatShareAVertex)
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

TEST(ReadQuadMesh, RefusesAFaceGivenTwice)
{
  for(const char* again : { "4 0 1 4 3\n", "4 3 4 1 0\n", "4 4 3 0 1\n" }) {
    const Read_result result = read_off("OFF\n6 2 0\n" + two_points + "4 0 1 4 3\n" + again);
    EXPECT_EQ(result.reason, Refusal::non_manifold) << again;
  }
}

TEST(ReadQuadMesh, RefusesMoebiusStripsOnly)
{
  EXPECT_TRUE(read_off(band(12, false)).ok());
  EXPECT_EQ(read_off(band(12, true)).reason, Refusal::non_orientable);
}

TEST(ReadQuadMesh, TurnsTheFewestFacesPerComponent)
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

TEST(ReadQuadMesh, DropsIsolatedVerticesAndKeepsCoincidentOnes)
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

TEST(ReadQuadMesh, LeavesTheMeshAloneOnRefusal)
{
  Mesh mesh;
  ASSERT_TRUE(read_text(".off", two_quads, mesh).ok());
  ASSERT_FALSE(read_text(".off", band(12, true), mesh).ok());
  EXPECT_EQ(mesh.number_of_faces(), 2u);
  ASSERT_TRUE(read_text(".off", band(12, false), mesh).ok());
  EXPECT_EQ(mesh.number_of_faces(), 12u);
}

TEST(ReadSurface, TakesAnyPolygonsButNotTwoCorners)
{
  Mesh mesh;
  const Temporary_file good(".off", "OFF\n6 3 0\n" + two_points + "4 0 1 4 3\n3 1 2 5\n3 1 5 4\n");
  const Read_result result = read_surface(good.name(), mesh);
  EXPECT_TRUE(result.ok()) << result.message;
  EXPECT_EQ(mesh.number_of_faces(), 3u);
  const Temporary_file bad(".off", "OFF\n6 2 0\n" + two_points + "4 0 1 4 3\n2 1 2\n");
  EXPECT_EQ(read_surface(bad.name(), mesh).reason, Refusal::degenerate_face);
}

// Whatever the bytes: an answer, no crash; and what is accepted is a valid mesh of quads.
TEST(ReadQuadMesh, SurvivesRandomDamage)
{
  const unsigned seed = std::random_device{}();
  RecordProperty("seed", std::to_string(seed));
  SCOPED_TRACE("seed " + std::to_string(seed));
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
