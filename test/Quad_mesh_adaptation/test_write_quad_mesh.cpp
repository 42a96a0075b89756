// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "support/usual_files.h"

#include <CGAL/Quad_mesh_adaptation/IO/write_quad_mesh.h>

#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#ifdef __unix__
#include <sys/resource.h>
#endif

#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace CGAL::Quad_mesh_adaptation;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace fs = std::filesystem;

// A folder of its own for every test, removed again.
class WriteQuadMesh : public testing::Test
{
protected:
  void SetUp() override
  {
    folder = fs::path(testing::TempDir()) /
             (std::string("write_quad_mesh_") +
              testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder);
    fs::create_directories(folder);
    // coordinates that no short decimal gives
    CGAL::make_grid(3, 2, mesh, [](std::size_t i, std::size_t j) {
      return Kernel::Point_3(std::sqrt(2. + double(i)), double(j) / 3, std::exp(-40. * double(i)));
    });
  }
  void TearDown() override { fs::remove_all(folder); }

  std::string path(const std::string& name) const { return (folder / name).string(); }
  std::size_t number_of_files() const
  {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
  }
  static std::string contents(const std::string& file)
  {
    std::ifstream stream(file, std::ios::binary);
    return { std::istreambuf_iterator<char>(stream), {} };
  }

  fs::path folder;
  Mesh mesh;
};

TEST_F(WriteQuadMesh, ReadsBackTheSameDoublesAndFaces)
{
  for(const char* name : { "a.off", "a.OBJ", "a.ply" }) {
    ASSERT_TRUE(write_quad_mesh(path(name), mesh).ok()) << name;
    Mesh again;
    const Read_result result = read_quad_mesh(path(name), again);
    ASSERT_TRUE(result.ok()) << result.message;
    ASSERT_EQ(again.number_of_vertices(), mesh.number_of_vertices());
    ASSERT_EQ(again.number_of_faces(), mesh.number_of_faces());
    for(const auto v : mesh.vertices()) EXPECT_EQ(again.point(v), mesh.point(v)) << name;
    for(const auto f : mesh.faces()) {
      std::vector<Mesh::Vertex_index> a, b;
      for(const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh)) a.push_back(v);
      for(const auto v : CGAL::vertices_around_face(again.halfedge(f), again)) b.push_back(v);
      // the same cycle; where it starts is the mesh type's affair
      std::rotate(b.begin(), std::find(b.begin(), b.end(), a[0]), b.end());
      EXPECT_EQ(a, b) << name;
    }
  }
  EXPECT_EQ(number_of_files(), 3u);
}

TEST_F(WriteQuadMesh, WritesFieldsAsPlyProperties)
{
  Mesh_fields fields;
  fields.vertex = { { "size asked", std::vector<double>(mesh.number_of_vertices(), 0.25) } };
  fields.face = { { "size_ratio", { 1, 2, 3, 4, 5, 0.1 } } };
  ASSERT_TRUE(write_quad_mesh(path("a.ply"), mesh, fields).ok());
  const std::string text = contents(path("a.ply"));
  EXPECT_NE(text.find("property double size_asked\n"), std::string::npos);
  EXPECT_NE(text.find("property double size_ratio\n"), std::string::npos);
  EXPECT_EQ(text.substr(text.size() - 5), " 0.1\n");
  Mesh again;
  EXPECT_TRUE(read_quad_mesh(path("a.ply"), again).ok());
}

TEST_F(WriteQuadMesh, WritesLegacyVtkWithQuadCells)
{
  Mesh_fields fields;
  fields.face = { { "size_ratio", { 1, 2, 3, 4, 5, 0.1 } } };
  fields.vertex = { { "size", std::vector<double>(mesh.number_of_vertices(), 7) } };
  ASSERT_TRUE(write_quad_mesh(path("a.vtk"), mesh, fields).ok());
  std::istringstream text(contents(path("a.vtk")));
  std::string line, word;
  std::getline(text, line);
  EXPECT_EQ(line, "# vtk DataFile Version 3.0");
  const auto go_to = [&](const std::string& wanted) {
    while(text >> word)
      if(word == wanted) return true;
    return false;
  };
  std::size_t n = 0, total = 0;
  ASSERT_TRUE(go_to("POINTS"));
  text >> n;
  EXPECT_EQ(n, 12u);
  ASSERT_TRUE(go_to("CELLS"));
  text >> n >> total;
  EXPECT_EQ(n, 6u);
  EXPECT_EQ(total, 30u);
  for(std::size_t f = 0; f < 6; ++f) {
    std::size_t degree = 0, vertex = 0;
    text >> degree;
    EXPECT_EQ(degree, 4u);
    for(int i = 0; i < 4; ++i) {
      text >> vertex;
      EXPECT_LT(vertex, 12u);
    }
  }
  ASSERT_TRUE(go_to("CELL_TYPES"));
  text >> n;
  for(std::size_t f = 0; f < 6; ++f) {
    int type = 0;
    text >> type;
    EXPECT_EQ(type, 9);
  }
  ASSERT_TRUE(go_to("CELL_DATA"));
  text >> n;
  EXPECT_EQ(n, 6u);
  ASSERT_TRUE(go_to("size_ratio"));
  ASSERT_TRUE(go_to("default"));
  double value = 0;
  for(int i = 0; i < 6; ++i) text >> value;
  EXPECT_EQ(value, 0.1);
  ASSERT_TRUE(go_to("POINT_DATA"));
  text >> n;
  EXPECT_EQ(n, 12u);
}

TEST_F(WriteQuadMesh, WritesXmlVtkThatCloses)
{
  Mesh_fields fields;
  fields.face = { { "quality", std::vector<double>(6, std::numeric_limits<double>::quiet_NaN()) } };
  ASSERT_TRUE(write_quad_mesh(path("a.vtu"), mesh, fields).ok());
  const std::string text = contents(path("a.vtu"));
  EXPECT_NE(text.find("NumberOfPoints=\"12\" NumberOfCells=\"6\""), std::string::npos);
  EXPECT_NE(text.find("Name=\"quality\""), std::string::npos);
  // every element is closed by its own name, in the right order
  std::vector<std::string> open;
  for(std::size_t at = text.find('<', 22); at != std::string::npos; at = text.find('<', at + 1)) {
    const std::size_t end = text.find_first_of(" >", at);
    const std::string name = text.substr(at + 1, end - at - 1);
    if(name[0] != '/') {
      open.push_back(name);
    } else {
      ASSERT_FALSE(open.empty());
      EXPECT_EQ(name, '/' + open.back());
      open.pop_back();
    }
  }
  EXPECT_TRUE(open.empty());
  const std::size_t offsets = text.find("\"offsets\"");
  EXPECT_EQ(text.substr(text.find('\n', offsets) + 1, 13), "4\n8\n12\n16\n20\n");
}

TEST_F(WriteQuadMesh, RefusesWhatCannotBeWritten)
{
  EXPECT_EQ(write_quad_mesh(path("a.stl"), mesh).reason, Refusal::unwritable_file);
  EXPECT_EQ(write_quad_mesh(path("no/such/folder/a.off"), mesh).reason, Refusal::unwritable_file);
  fs::create_directory(path("folder.off"));
  EXPECT_EQ(write_quad_mesh(path("folder.off"), mesh).reason, Refusal::unwritable_file);
  Mesh_fields fields;
  fields.face = { { "short", { 1, 2 } } };
  const Write_result result = write_quad_mesh(path("a.vtk"), mesh, fields);
  EXPECT_EQ(result.reason, Refusal::unwritable_file);
  EXPECT_NE(result.message.find("short"), std::string::npos);
  EXPECT_EQ(number_of_files(), 1u); // the folder
}

TEST_F(WriteQuadMesh, FollowsLinksAndKeepsPermissions)
{
  std::ofstream(path("real.off")) << "old";
  fs::permissions(path("real.off"), fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("real.off", path("link.off"));
  ASSERT_TRUE(write_quad_mesh(path("link.off"), mesh).ok());
  EXPECT_TRUE(fs::is_symlink(path("link.off")));
  EXPECT_EQ(contents(path("real.off")).substr(0, 4), "OFF\n");
  EXPECT_EQ(fs::status(path("real.off")).permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(number_of_files(), 2u);
}

TEST_F(WriteQuadMesh, FollowsLinksToFilesThatAreNotThereYet)
{
  fs::create_directory(path("sub"));
  fs::create_symlink("sub/second.off", path("first.off"));
  fs::create_symlink("real.off", path("sub/second.off"));
  ASSERT_TRUE(write_quad_mesh(path("first.off"), mesh).ok());
  EXPECT_TRUE(fs::is_symlink(path("first.off")) && fs::is_symlink(path("sub/second.off")));
  EXPECT_EQ(contents(path("sub/real.off")).substr(0, 4), "OFF\n");
  fs::create_symlink("b.off", path("a.off"));
  fs::create_symlink("a.off", path("b.off"));
  EXPECT_FALSE(write_quad_mesh(path("a.off"), mesh).ok());
  EXPECT_TRUE(fs::is_symlink(path("a.off")) && fs::is_symlink(path("b.off")));
}

TEST_F(WriteQuadMesh, TransactionRefusesTheSameNameTwice)
{
  fs::create_symlink("a.txt", path("link.txt"));
  File_transaction files;
  ASSERT_TRUE(files.stage(path("a.txt"), "one").ok());
  EXPECT_FALSE(files.stage(path("link.txt"), "two").ok());
  ASSERT_TRUE(files.commit().ok());
  EXPECT_EQ(contents(path("a.txt")), "one");
}

TEST_F(WriteQuadMesh, PlyHoldsLargePolygons)
{
  Mesh polygon;
  std::vector<Mesh::Vertex_index> corners;
  for(int i = 0; i < 300; ++i)
    corners.push_back(polygon.add_vertex(Kernel::Point_3(std::cos(i / 50.), std::sin(i / 50.), 0)));
  polygon.add_face(corners);
  ASSERT_TRUE(write_quad_mesh(path("a.ply"), polygon).ok());
  EXPECT_NE(contents(path("a.ply")).find("property list int int"), std::string::npos);
  Mesh again;
  ASSERT_TRUE(read_surface(path("a.ply"), again).ok());
  EXPECT_EQ(again.degree(*again.faces().begin()), 300u);
}

TEST_F(WriteQuadMesh, TransactionShowsNothingBeforeItIsCommitted)
{
  std::ofstream(path("a.txt")) << "old";
  {
    File_transaction files;
    ASSERT_TRUE(files.stage(path("a.txt"), "new").ok());
    ASSERT_TRUE(files.stage(path("b.txt"), "other").ok());
    EXPECT_FALSE(files.stage(path("no/such/c.txt"), "").ok());
    EXPECT_EQ(contents(path("a.txt")), "old");
    EXPECT_FALSE(fs::exists(path("b.txt")));
  }
  EXPECT_EQ(contents(path("a.txt")), "old");
  EXPECT_EQ(number_of_files(), 1u);

  File_transaction files;
  ASSERT_TRUE(files.stage(path("a.txt"), "new").ok());
  ASSERT_TRUE(files.stage(path("b.txt"), "other").ok());
  ASSERT_TRUE(files.commit().ok());
  EXPECT_EQ(contents(path("a.txt")), "new");
  EXPECT_EQ(contents(path("b.txt")), "other");
  EXPECT_EQ(number_of_files(), 2u);
}

TEST_F(WriteQuadMesh, ProbingLeavesNothingBehind)
{
  EXPECT_TRUE(File_transaction::probe(path("a.off")).ok());
  EXPECT_FALSE(File_transaction::probe(path("no/such/a.off")).ok());
  EXPECT_EQ(number_of_files(), 0u);
}

#ifdef __unix__
// As on a full disk: the system takes no more than 1000 bytes per file.
TEST_F(WriteQuadMesh, RefusesWhenTheDiskIsFullAndKeepsTheOldFile)
{
  std::ofstream(path("a.off")) << "old";
  rlimit before;
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = before;
  small.rlim_cur = 1000;
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  Mesh large;
  CGAL::make_grid(30, 30, large);
  const Write_result result = write_quad_mesh(path("a.off"), large);
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, old_handler);
  EXPECT_EQ(result.reason, Refusal::unwritable_file);
  EXPECT_EQ(contents(path("a.off")), "old");
  EXPECT_EQ(number_of_files(), 1u);
}
#endif

} // namespace
