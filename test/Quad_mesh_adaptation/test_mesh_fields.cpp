// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What files hold beside the shape: fields, patches and marked edges.

#include "support/read_text.h"

#include <CGAL/Quad_mesh_adaptation/IO/write_quad_mesh.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace {

using namespace read_test;
using Edges = std::vector<std::array<std::size_t, 2>>;
using Values = std::vector<double>;

Read_result read_fields(const std::string& extension, const std::string& text, Mesh& mesh,
                        Mesh_fields& fields)
{
  const Temporary_file file(extension, text);
  return read_quad_mesh(file.name(), mesh, fields);
}

// The first vertex belongs to no face.
const char* const ply_text = "ply\nformat ascii 1.0\n"
                             "element vertex 7\nproperty float x\nproperty float y\n"
                             "property float z\nproperty float heat\nproperty uchar fixed\n"
                             "element edge 2\nproperty int vertex1\nproperty int vertex2\n"
                             "property uchar red\n"
                             "element face 2\nproperty uchar patch\n"
                             "property list uchar int vertex_indices\nproperty float eta\n"
                             "end_header\n"
                             "9 9 9 100 0\n0 0 0 1.5 1\n1 0 0 2.5 0\n2 0 0 3.5 0\n0 1 0 4.5 0\n"
                             "1 1 0 5.5 0\n2 1 0 6.5 1\n"
                             "2 5 255\n0 1 255\n"
                             "3 4 1 2 5 4 0.25\n8 4 2 3 6 5 0.125\n";

TEST(MeshFields, ReadsPropertiesAndEdgesOfPly)
{
  Mesh mesh;
  Mesh_fields fields;
  const Read_result result = read_fields(".ply", ply_text, mesh, fields);
  ASSERT_TRUE(result.ok()) << result.message;
  ASSERT_EQ(fields.vertex.size(), 2u);
  EXPECT_EQ(fields.vertex[0].name, "heat");
  EXPECT_EQ(fields.vertex[0].values, (Values{ 1.5, 2.5, 3.5, 4.5, 5.5, 6.5 }));
  EXPECT_EQ(fields.vertex[1].name, "fixed");
  EXPECT_EQ(fields.vertex[1].values, (Values{ 1, 0, 0, 0, 0, 1 }));
  ASSERT_EQ(fields.face.size(), 2u);
  EXPECT_EQ(fields.face[0].name, patch_field);
  EXPECT_EQ(fields.face[0].values, (Values{ 3, 8 }));
  EXPECT_EQ(fields.face[1].values, (Values{ 0.25, 0.125 }));
  EXPECT_EQ(fields.edges, (Edges{ { 1, 4 } })) << "as the vertices are counted now";
}

TEST(MeshFields, RefusesEdgesOfVerticesThatAreNotThere)
{
  std::string text = ply_text;
  text.replace(text.find("2 5 255"), 3, "2 7");
  Mesh mesh;
  Mesh_fields fields;
  const Read_result result = read_fields(".ply", text, mesh, fields);
  EXPECT_EQ(result.reason, Refusal::unreadable_file);
  EXPECT_TRUE(contains(result.message, "edge 0 has a vertex number")) << result.message;
  EXPECT_TRUE(fields.vertex.empty() && fields.edges.empty());
  EXPECT_TRUE(read_text(".ply", text, mesh).ok()) << "who does not ask is not concerned";
}

const char* const obj_vertices = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\n";

TEST(MeshFields, ReadsGroupsMaterialsAndPolylinesOfObj)
{
  Mesh mesh;
  Mesh_fields fields;
  const Read_result result =
      read_fields(".obj",
                  std::string(obj_vertices) + "f 1 2 5 4\ng inner  wall\nusemtl steel\n"
                                              "f 2 3 6 5\nl 2/1 5/2 -1\n",
                  mesh, fields);
  ASSERT_TRUE(result.ok()) << result.message;
  ASSERT_EQ(fields.face.size(), 1u);
  EXPECT_EQ(fields.face[0].name, patch_field);
  EXPECT_EQ(fields.face[0].values, (Values{ 0, 1 }));
  EXPECT_EQ(fields.patch_names, (std::vector<std::string>{ "", "inner wall steel" }));
  EXPECT_EQ(fields.edges, (Edges{ { 1, 4 }, { 4, 5 } }));
}

TEST(MeshFields, GroupsAndMaterialsOfTheSameNamesAreTwoPatches)
{
  Mesh mesh;
  Mesh_fields fields;
  ASSERT_TRUE(
      read_fields(".obj",
                  std::string(obj_vertices) + "g a b\nf 1 2 5 4\ng a\nusemtl b\nf 2 3 6 5\n", mesh,
                  fields)
          .ok());
  EXPECT_EQ(fields.face.at(0).values, (Values{ 0, 1 }));
  EXPECT_EQ(fields.patch_names, (std::vector<std::string>{ "a b", "a b_2" }));
}

TEST(MeshFields, AnObjFileWithoutGroupsHasNoPatches)
{
  Mesh mesh;
  Mesh_fields fields;
  fields.patch_names = { "of another mesh" };
  ASSERT_TRUE(read_fields(".obj", std::string(obj_vertices) + "o name\nf 1 2 5 4\nf 2 3 6 5\n",
                          mesh, fields)
                  .ok());
  EXPECT_TRUE(fields.face.empty() && fields.patch_names.empty() && fields.edges.empty());
}

TEST(MeshFields, RefusesPolylinesOfVerticesThatAreNotThere)
{
  Mesh mesh;
  Mesh_fields fields;
  const Read_result result =
      read_fields(".obj", std::string(obj_vertices) + "f 1 2 5 4\nl 2 7\n", mesh, fields);
  EXPECT_EQ(result.reason, Refusal::unreadable_file);
  EXPECT_TRUE(contains(result.message, "polyline has the vertex number \"7\"")) << result.message;
}

// What is written is read again.
TEST(MeshFields, ComeBackFromFiles)
{
  Mesh mesh;
  Mesh_fields fields;
  ASSERT_TRUE(read_fields(".ply", ply_text, mesh, fields).ok());
  fields.patch_names.resize(9);
  fields.patch_names[8] = "cap";
  for(const std::string extension : { ".ply", ".obj" }) {
    const Temporary_file file(extension, "");
    ASSERT_TRUE(write_quad_mesh(file.name(), mesh, fields).ok());
    Mesh again;
    Mesh_fields read;
    const Read_result result = read_quad_mesh(file.name(), again, read);
    ASSERT_TRUE(result.ok()) << result.message;
    EXPECT_EQ(again.number_of_faces(), 2u);
    EXPECT_EQ(read.edges, fields.edges) << extension;
    if(extension == ".ply") {
      ASSERT_EQ(read.vertex.size(), 2u);
      EXPECT_EQ(read.vertex[0].values, fields.vertex[0].values);
      EXPECT_EQ(read.face[0].values, fields.face[0].values);
      EXPECT_EQ(read.face[1].values, fields.face[1].values);
    } else {
      EXPECT_EQ(read.face[0].values, (Values{ 0, 1 }));
      EXPECT_EQ(read.patch_names, (std::vector<std::string>{ "default", "cap" }));
    }
  }
}

TEST(MeshFields, EqualNamesAreToldApart)
{
  Mesh mesh;
  ASSERT_TRUE(read_text(".ply", ply_text, mesh).ok());
  Mesh_fields fields, read;
  const Values numbers(6, 0.5), others(6, 7);
  fields.vertex = { { "x", others }, { "a-b", numbers }, { "a_b", others }, { "a b", others } };
  const Temporary_file file(".ply", "");
  ASSERT_TRUE(write_quad_mesh(file.name(), mesh, fields).ok());
  Mesh again;
  ASSERT_TRUE(read_quad_mesh(file.name(), again, read).ok());
  std::vector<std::string> names;
  for(const Scalar_field& field : read.vertex) names.push_back(field.name);
  EXPECT_EQ(names, (std::vector<std::string>{ "x_2", "a_b", "a_b_2", "a_b_3" }));
  EXPECT_EQ(again.point(*again.vertices().begin()), mesh.point(*mesh.vertices().begin()));
}

TEST(MeshFields, EdgesOfVerticesThatAreNotThereAreNotWritten)
{
  Mesh mesh;
  ASSERT_TRUE(read_text(".ply", ply_text, mesh).ok());
  Mesh_fields fields;
  fields.edges = { { 0, 6 } };
  const Temporary_file file(".obj", "as it was");
  const Write_result result = write_quad_mesh(file.name(), mesh, fields);
  EXPECT_EQ(result.reason, Refusal::unwritable_file);
  EXPECT_EQ(std::filesystem::file_size(file.name()), 9u);
}

} // namespace
