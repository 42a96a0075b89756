// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_TEST_USUAL_FILES_H
#define QUAD_MESH_ADAPTATION_TEST_USUAL_FILES_H

#include "usual_mesh.h"

#include <CGAL/Quad_mesh_adaptation/IO/read_quad_mesh.h>

#include <gtest/gtest.h>

#include <string>

// Reading of the usual mesh, see usual_mesh.h.
namespace CGAL {
namespace Quad_mesh_adaptation {

QUAD_MESH_TEST_INSTANCE Read_result read_quad_mesh(const std::string&, usual_mesh::Mesh&);

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#ifdef QUAD_MESH_DATA_DIR // for the tests that are told of it
namespace usual_mesh {

/// One of the meshes of the project, by its name.
inline Mesh read_mesh(const std::string& name)
{
  Mesh mesh;
  const auto result = CGAL::Quad_mesh_adaptation::read_quad_mesh(
      std::string(QUAD_MESH_DATA_DIR "/meshes/") + name + ".off", mesh);
  EXPECT_TRUE(result.ok()) << result.message;
  return mesh;
}

inline shape_zoo::Shape read_shape(const std::string& name)
{
  shape_zoo::Shape s = zoo_mesh::shape_of(read_mesh(name));
  s.name = name;
  return s;
}

} // namespace usual_mesh
#endif

#endif // QUAD_MESH_ADAPTATION_TEST_USUAL_FILES_H
