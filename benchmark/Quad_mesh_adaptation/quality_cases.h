// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_BENCHMARK_QUALITY_CASES_H
#define QUAD_MESH_ADAPTATION_BENCHMARK_QUALITY_CASES_H

#include "../../examples/Quad_mesh_adaptation/support/paper_cases.h"

#include <CGAL/Quad_mesh_adaptation/IO/read_quad_mesh.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace quality {

using paper_cases::Mesh;
using paper_cases::Point;
using paper_cases::Sizing;

/// What the default schedule aims at; in percent where a share.
struct Goals
{
  double efficiency, below_half, scaled_jacobian, irregular;
  bool is_relative = false; ///< quality no worse than the input's, irregular nodes beyond its own
};

inline Goals smooth_size() { return { 0.85, 0.1, 0.55, 10 }; }
inline Goals steep_size() { return { 0.60, 3, 0.40, 30 }; }
inline Goals scaled_steep_size(std::size_t faces)
{
  return { 0.85, 0.1, 0.5, faces < 100000 ? 15. : 8. };
}
inline Goals uniform_size() { return { 0.80, 0.5, 0.45, 15, true }; }

enum class Kind
{
  smooth,
  steep,
  scaled_steep,
  uniform
};

struct Case
{
  std::string name;
  Kind kind;
  Mesh initial;
  std::optional<Mesh> reference;
  Sizing size;
  std::optional<std::array<std::size_t, 8>> paper_counts; ///< of Tables 1 to 3
  bool has_papers_size = false;                           ///< the paper asked for about this size

  Goals goals(std::size_t faces) const
  {
    switch(kind) {
    case Kind::smooth:
      return smooth_size();
    case Kind::steep:
      return steep_size();
    case Kind::scaled_steep:
      return scaled_steep_size(faces);
    default:
      return uniform_size();
    }
  }
};

inline double mean_edge_length(const Mesh& mesh)
{
  double sum = 0;
  for(auto e : mesh.edges())
    sum += std::sqrt(
        CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  return sum / double(mesh.number_of_edges());
}

inline Case of_paper(const paper_cases::Paper_case& c, int k)
{
  Case result = {
    c.name + ", k = " + std::to_string(k), Kind::smooth, c.initial, c.reference, c.size, {}
  };
  if(c.name == "circular_load") result.kind = k < 4 ? Kind::steep : Kind::scaled_steep;
  if(k == 1) result.paper_counts = c.paper_counts;
  result.has_papers_size = c.name != "plate_with_hole"; // the paper's came from its estimate
  return result;
}

/// The plate of the first case, as coarse as in the paper, to sizes divided by a number: about 1e4
/// faces for 4, 1e5 for 13, 1e6 for 41.
inline Case scaled_circular_load(int divisor)
{
  const paper_cases::Paper_case c = paper_cases::circular_load();
  return { "circular_load, sizes / " + std::to_string(divisor),
           Kind::scaled_steep,
           c.initial,
           c.reference,
           [divisor](const Point& p) { return paper_cases::circular_load_size(p, divisor); },
           {} };
}

inline void append_uniform(const std::string& name, const Mesh& mesh,
                           const std::optional<Mesh>& reference, std::vector<Case>& cases)
{
  const double edge = mean_edge_length(mesh);
  for(const double factor : { 4., 0.25 })
    cases.push_back({ name + (factor > 1 ? ", 4 x its size" : ", 1/4 of its size"),
                      Kind::uniform,
                      mesh,
                      reference,
                      [=](const Point&) { return factor * edge; },
                      {} });
}

/// How many cases.
enum class Extent
{
  usual,
  large, ///< also those of about 1e5 faces
  huge   ///< and the one of about 1e6
};

/// All cases up to an extent.
inline std::vector<Case> all_cases(const std::string& mesh_folder, Extent extent)
{
  const bool is_long = extent != Extent::usual;
  std::vector<Case> cases;
  for(auto* make :
      { paper_cases::circular_load, paper_cases::nosecone, paper_cases::plate_with_hole })
    for(int k : { 1, 2, 4 }) cases.push_back(of_paper(make(k), k));
  cases.push_back(scaled_circular_load(4));
  if(is_long) cases.push_back(scaled_circular_load(13));
  if(extent == Extent::huge) cases.push_back(scaled_circular_load(41));
  for(auto* make :
      { paper_cases::circular_load, paper_cases::nosecone, paper_cases::plate_with_hole }) {
    const paper_cases::Paper_case c = make(1);
    append_uniform(c.name, c.initial, c.reference, cases);
  }
  std::vector<std::string> names = { "star",         "icf",  "box_cylinder",
                                     "cylinder_hex", "pawn", "rotated_ellipse_with_subregions",
                                     "spot" };
  if(is_long) names.push_back("makehuman_body");
  for(const std::string& name : names) {
    Mesh mesh;
    const auto read =
        CGAL::Quad_mesh_adaptation::read_quad_mesh(mesh_folder + "/" + name + ".off", mesh);
    if(!read.ok()) throw std::runtime_error(read.message);
    append_uniform(name, mesh, std::nullopt, cases);
  }
  return cases;
}

} // namespace quality

#endif // QUAD_MESH_ADAPTATION_BENCHMARK_QUALITY_CASES_H
