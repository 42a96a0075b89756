// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_BENCHMARK_SPEED_PEER_TASKS_H
#define QUAD_MESH_ADAPTATION_BENCHMARK_SPEED_PEER_TASKS_H

#include "process.h"
#include "shapes.h"

#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

// Other programs on the same surfaces.
namespace speed {

/// CGAL's isotropic remeshing of what refinement begins with, or else of what adaptation begins
/// with, triangulated, to that many triangles: three iterations, uniform size.
inline Task isotropic_task(const Shape& shape, int level, bool is_from_coarse)
{
  const double triangles = std::pow(10., level);
  const char* what = is_from_coarse ? "isotropic_remeshing" : "isotropic_remeshing as adapt";
  return { what, shape.name, level, [=] {
            const auto mesh =
                std::make_shared<Mesh>(is_from_coarse ? shape.coarse() : shape.to_adapt(triangles));
            // it makes 1.3 times as many as there would be equilateral ones with this edge
            const double length = std::sqrt(1.3 * area(*mesh) * 4 / (std::sqrt(3.) * triangles));
            CGAL::Polygon_mesh_processing::triangulate_faces(*mesh);
            return [=] {
              Outcome o;
              o.faces_in = double(mesh->number_of_faces());
              const Stopwatch watch;
              CGAL::Polygon_mesh_processing::isotropic_remeshing(
                  faces(*mesh), length, *mesh,
                  CGAL::parameters::number_of_iterations(3).protect_constraints(false));
              o.cpu = watch.cpu();
              o.wall = watch.wall();
              o.faces_out = double(mesh->number_of_faces());
              return o;
            };
          } };
}

inline bool has_gmsh(const std::string& folder)
{
  return run_child({ "gmsh", "-version" }, folder + "/gmsh.log").exit_code == 0;
}

/// The plate of the first case with its size as background field, for Gmsh.
inline void write_gmsh_plate(const std::string& file, double k)
{
  std::ofstream out(file);
  out.precision(17);
  out << "Point(1) = {-5, -5, 0}; Point(2) = {5, -5, 0};\n"
         "Point(3) = {5, 5, 0}; Point(4) = {-5, 5, 0};\n"
         "Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};\n"
         "Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1}; Recombine Surface{1};\n"
         "Field[1] = MathEval;\n"
         "Field[1].F = \"(0.1 + Fabs(Sqrt(x*x + y*y) - 4.8)) / "
      << k
      << "\";\n"
         "Background Field = 1;\n"
         "Mesh.CharacteristicLengthExtendFromBoundary = 0;\n"
         "Mesh.CharacteristicLengthFromPoints = 0;\n"
         "Mesh.Algorithm = 6;\n"              // Frontal-Delaunay
         "Mesh.RecombinationAlgorithm = 1;\n" // Blossom
         "Mesh.MshFileVersion = 2.2;\n";
  if(!out.flush()) throw std::runtime_error(file + " cannot be written");
}

/// Quads in a file of version 2.2: elements of type 3.
inline double quads_in_msh(const std::string& file)
{
  std::ifstream in(file);
  double quads = 0;
  bool is_element = false;
  for(std::string line; std::getline(in, line);) {
    if(!line.empty() && line[0] == '$') is_element = line == "$Elements";
    std::istringstream words(line);
    long number = 0, type = 0;
    if(is_element && words >> number >> type && type == 3) ++quads;
  }
  return quads;
}

/// Gmsh on the plate, frontal and Blossom, whole process with reading and writing.
inline Task gmsh_task(const Shape& shape, int level, const std::string& folder)
{
  const double k = std::sqrt(std::pow(10., level) / plate_faces);
  return { "gmsh", shape.name, level, [=] {
            const std::string name = folder + "/gmsh_" + std::to_string(level);
            write_gmsh_plate(name + ".geo", k);
            return [=] {
              const Child_result child = run_child(
                  { "gmsh", "-2", "-nt", "1", name + ".geo", "-o", name + ".msh" }, name + ".log");
              if(child.exit_code != 0) throw std::runtime_error("gmsh failed, see its log");
              Outcome o;
              o.cpu = child.cpu;
              o.wall = child.wall;
              o.faces_out = quads_in_msh(name + ".msh");
              if(!(o.faces_out > 0)) throw std::runtime_error("gmsh made no quads");
              std::filesystem::remove(name + ".msh");
              return o;
            };
          } };
}

} // namespace speed

#endif // QUAD_MESH_ADAPTATION_BENCHMARK_SPEED_PEER_TASKS_H
