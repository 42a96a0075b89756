// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_TEST_READ_TEXT_H
#define QUAD_MESH_ADAPTATION_TEST_READ_TEXT_H

#include <CGAL/Quad_mesh_adaptation/IO/read_quad_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <string>

namespace read_test {

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

Read_result read_text(const std::string& extension, const std::string& text, Mesh& mesh);

Read_result read_off(const std::string& text);

bool contains(const std::string& text, const std::string& part);

// Two unit squares side by side.
inline const std::string two_points = "0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 0\n2 1 0\n";
inline const std::string two_quads = "OFF\n6 2 0\n" + two_points + "4 0 1 4 3\n4 1 2 5 4\n";

// A closed band of n quads; twisted it is a Moebius strip.
std::string band(int n, bool is_twisted);

} // namespace read_test

#endif // QUAD_MESH_ADAPTATION_TEST_READ_TEXT_H
