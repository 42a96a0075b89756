// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes by other people, to uniform sizes above and below their own.

#include "support/surface_mesh_checks.h"
#include "support/usual_calls.h"
#include "support/usual_files.h"

#include <gtest/gtest.h>

#include <string>
#include <tuple>

namespace {

namespace Qma = CGAL::Quad_mesh_adaptation;
using usual_mesh::Mesh;
using usual_mesh::Point;

double mean_edge_length(const Mesh& mesh)
{
  double sum = 0;
  for(auto e : mesh.edges()) {
    const auto h = mesh.halfedge(e);
    sum +=
        std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))));
  }
  return sum / double(mesh.number_of_edges());
}

class Real_meshes : public testing::TestWithParam<std::tuple<const char*, double>>
{
};

TEST_P(Real_meshes, to_a_uniform_size)
{
  const auto& [name, factor] = GetParam();
  Mesh mesh;
  const auto read =
      Qma::read_quad_mesh(std::string(QUAD_MESH_DATA_DIR "/meshes/") + name + ".off", mesh);
  ASSERT_EQ(read.reason, Qma::Refusal::none) << read.message;
  const mesh_checks::Facts before = mesh_checks::facts_of_mesh(mesh);
  ASSERT_EQ(before.problem, "");

  const Qma::Adaptation_report r = Qma::adapt_quad_mesh(factor * mean_edge_length(mesh), mesh);
  const mesh_checks::Facts after = mesh_checks::facts_of_mesh(mesh);
  EXPECT_EQ(after.problem, "");
  EXPECT_TRUE(mesh_checks::same_topology(before, after));
  EXPECT_GT(after.min_scaled_jacobian, (std::min)(0.2, before.min_scaled_jacobian));
  // within the size, or said face by face that it is not
  const std::size_t large =
      r.after.strict_size_ratio.total() - r.after.strict_size_ratio.not_larger();
  EXPECT_EQ(r.faces_too_large.size(), large);
  EXPECT_EQ(r.status,
            large == 0 ? Qma::Adaptation_status::sizes_met : Qma::Adaptation_status::sizes_not_met);
  EXPECT_GE(r.after.strict_size_ratio.percent_not_larger(), 95.) << r.message;
  EXPECT_EQ(r.message.empty(), large == 0);
}

INSTANTIATE_TEST_SUITE_P(Uniform, Real_meshes,
                         testing::Combine(testing::Values("star", "icf", "box_cylinder",
                                                          "cylinder_hex", "pawn"),
                                          testing::Values(0.5, 1., 2.)),
                         [](const auto& info) {
                           return std::string(std::get<0>(info.param)) +
                                  (std::get<1>(info.param) < 1   ? "_finer"
                                   : std::get<1>(info.param) > 1 ? "_coarser"
                                                                 : "_same");
                         });

} // namespace
