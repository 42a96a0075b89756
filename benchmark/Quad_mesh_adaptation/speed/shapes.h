// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_BENCHMARK_SPEED_SHAPES_H
#define QUAD_MESH_ADAPTATION_BENCHMARK_SPEED_SHAPES_H

#include "../quality_cases.h"
#include "Task.h"

#include <CGAL/Quad_mesh_adaptation/refine.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace speed {

inline double area(const Mesh& mesh)
{
  double sum = 0;
  for(auto f : mesh.faces()) {
    std::vector<Point> p;
    for(auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh)) p.push_back(mesh.point(v));
    sum += 0.5 * std::sqrt(CGAL::cross_product(p[2] - p[0], p[3] - p[1]).squared_length());
  }
  return sum;
}

/// A surface with meshes and sizes for any number of faces.
struct Shape
{
  std::string name;
  std::function<Mesh()> coarse;               ///< to be refined
  std::function<Mesh(double faces)> of_faces; ///< about uniform, of about so many faces
  std::function<Mesh(double faces)> to_adapt; ///< to be adapted to that many faces
  std::function<Sizing(double faces)> graded; ///< sizes that ask for about so many faces
  double coarse_faces;
  bool is_symmetric; ///< in planes that cut no face, with its graded sizes
};

/// The closed shape, read once; halved until it has enough faces.
inline Mesh halved(Mesh mesh, double faces)
{
  while(double(mesh.number_of_faces()) < 0.75 * faces) {
    const double next = std::min(4 * double(mesh.number_of_faces()), 1.3 * faces);
    const double length = std::sqrt(area(mesh) / next);
    const auto report = CGAL::Quad_mesh_adaptation::refine(length, mesh);
    if(!report.has_valid_mesh()) throw std::runtime_error(report.message);
    if(next > faces) break;
  }
  mesh.collect_garbage();
  return mesh;
}

inline int side(double faces, double faces_of_one)
{
  return std::max(1, int(std::lround(std::sqrt(faces / faces_of_one))));
}

// Faces that the sizes of the paper's cases ask for, of those that the default schedule makes.
constexpr double plate_faces = 640, nosecone_faces = 1000;

inline Shape plate()
{
  using namespace paper_cases;
  return { "plate",
           [] { return square_plate(1); },
           [](double faces) { return square_plate(side(faces, 100)); },
           [](double faces) { return square_plate(side(faces, plate_faces)); },
           [](double faces) -> Sizing {
             const double k = std::sqrt(faces / plate_faces);
             return [k](const Point& p) { return circular_load_size(p, k); };
           },
           100,
           true };
}

inline Shape nosecone()
{
  using namespace paper_cases;
  return { "nosecone",
           [] { return nosecone_mesh(1); },
           [](double faces) { return nosecone_mesh(side(faces, 725)); },
           [](double faces) { return nosecone_mesh(side(faces, nosecone_faces)); },
           [](double faces) -> Sizing {
             const double k = std::sqrt(faces / nosecone_faces);
             return [k](const Point& p) { return nosecone_size(p, k); };
           },
           725,
           false };
}

/// A cow; sizes grow to three times the smallest from the head to the tail.
inline Shape spot(const std::string& folder)
{
  const auto mesh = std::make_shared<Mesh>();
  const auto read = CGAL::Quad_mesh_adaptation::read_quad_mesh(folder + "/spot.off", *mesh);
  if(!read.ok()) throw std::runtime_error(read.message);
  double low = 1e300, high = -1e300;
  for(auto v : mesh->vertices()) {
    low = std::min(low, mesh->point(v).z());
    high = std::max(high, mesh->point(v).z());
  }
  const auto relative = [low, high](const Point& p) {
    return 1 + 2 * std::min(1., std::max(0., (p.z() - low) / (high - low)));
  };
  double wanted = 0; // faces for the relative sizes
  for(auto f : mesh->faces()) {
    std::vector<Point> p;
    for(auto v : CGAL::vertices_around_face(mesh->halfedge(f), *mesh)) p.push_back(mesh->point(v));
    const double h = relative(CGAL::centroid(p[0], p[1], p[2], p[3]));
    wanted +=
        0.5 * std::sqrt(CGAL::cross_product(p[2] - p[0], p[3] - p[1]).squared_length()) / (h * h);
  }
  return { "spot",
           [mesh] { return *mesh; },
           [mesh](double faces) { return halved(*mesh, faces); },
           [mesh](double) { return *mesh; },
           [=](double faces) -> Sizing {
             const double smallest = std::sqrt(wanted / (0.87 * faces));
             return [=](const Point& p) { return smallest * relative(p); };
           },
           double(mesh->number_of_faces()),
           true };
}

} // namespace speed

#endif // QUAD_MESH_ADAPTATION_BENCHMARK_SPEED_SHAPES_H
