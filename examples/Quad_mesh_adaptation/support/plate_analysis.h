// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_EXAMPLES_PLATE_ANALYSIS_H
#define QUAD_MESH_ADAPTATION_EXAMPLES_PLATE_ANALYSIS_H

#include "polar_plate.h"
#include "quarter_plate_in_tension.h"
#include "show_case.h"

#include <CGAL/Quad_mesh_adaptation/Error_sizing_field.h>
#include <CGAL/Quad_mesh_adaptation/Graded_sizing_field.h>
#include <CGAL/Quad_mesh_adaptation/Nodal_sizing_field.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace paper_cases {

using Plate = plane_stress::Quarter_plate_in_tension;

/// Solves the plate in tension on a mesh.
inline Plate::Result analyse(const Mesh& mesh)
{
  return Plate().solve(plane_stress::plane_mesh(mesh));
}

using Plate_sizing_field =
    CGAL::Quad_mesh_adaptation::Graded_sizing_field<CGAL::Quad_mesh_adaptation::Error_sizing_field>;

/// Sizes for which the estimated error in energy norm becomes the given share of the solution's
/// norm, between the paper's 0.04/k and 1.5/k and with a slope of at most 0.25.
inline Plate_sizing_field sizes_from_analysis(const Mesh& mesh, const Plate::Result& result,
                                              double share_of_energy, int k)
{
  namespace QMA = CGAL::Quad_mesh_adaptation;
  const plane_stress::Error_estimate& e = result.estimate;
  Mesh with_errors = mesh;
  auto errors = with_errors.add_property_map<Mesh::Face_index, double>("f:error", 0.).first;
  std::size_t i = 0;
  for(auto f : mesh.faces()) errors[f] = e.element_error[i++];
  QMA::Error_sizing_options options;
  options.largest_change = 100; // where one step has to do
  options.range = { 0.04 / k, 1.5 / k };
  const double allowed = share_of_energy * std::hypot(e.energy_norm, e.error_norm);
  const QMA::Error_sizing_field wanted(with_errors, errors, QMA::Error_target::error(allowed),
                                       options);
  return Plate_sizing_field(mesh, wanted, 0.25);
}

inline void print_analysis_row(const std::string& name, const Plate::Result& r)
{
  PAPER_CASES_PRINT("  %-8s %7zu %7zu   %7.2f %7.2f   %.6f %.6f %.6f   %7.4f   %5.2f%%",
                    name.c_str(), r.nodes, r.faces, r.estimate.max_effective_stress,
                    r.estimate.max_effective_error, r.x_at_a, r.x_at_b, r.x_at_c,
                    r.stress_concentration, 100 * r.estimate.relative_error());
}

/// The paper's Table 4 with our analyses, and the paper's own figures below.
inline void print_analyses(const std::vector<std::pair<std::string, Plate::Result>>& rows)
{
  const Plate plate;
  std::cout << "\nFinite-element analysis: bilinear quads in plane stress, E = "
            << plate.material.young << ", nu = " << plate.material.poisson << ", traction "
            << plate.traction << " in x;\nerrors by patch recovery; x-displacements at A = (1,0) "
            << "and C = (6,0) on the axis and B = (6,6), the corner\n"
            << "                          effective stress     x-displacement\n"
            << "             nodes   faces   maximum   error        A        B        C"
            << "        Kt    energy error\n";
  for(const auto& [name, result] : rows) print_analysis_row(name, result);
  std::cout << "The paper (load, material and the places of its A, B, C are not given)\n"
            << "  coarse       121      97     94.30   32.08   0.001430 0.002790 0.004670\n"
            << "  medium      1770    1677    106.50   19.23   0.001540 0.002870 0.004740\n"
            << "  fine        6973    6788    107.90   12.33   0.001550 0.002880 0.004750\n"
            << "  adapted     1232    1170    108.30    7.53   0.001540 0.002870 0.004740\n\n";
}

/// Compares the stress concentration with the handbook.  Its chart is for long strips, where the
/// same analysis meets it; the paper's square plate has no handbook value and gets the limit of
/// two uniform meshes, one twice as fine, whose error falls with the square of the size.
inline void print_stress_concentration(const Plate::Result& medium, const Plate::Result& fine,
                                       const Plate::Result& adapted)
{
  const double radius = Quarter_plate::hole_radius, side = Quarter_plate::side;
  const double handbook = plane_stress::howland_factor(2 * radius, 2 * side);
  const double strip =
      Plate().solve(plane_stress::polar_plate(4 * side, side, 96, 96)).stress_concentration;
  const double square =
      fine.stress_concentration + (fine.stress_concentration - medium.stress_concentration) / 3;
  std::cout << "Stress concentration Kt on the gross section, d/w = 1/6\n";
  PAPER_CASES_PRINT("  long strip   %.4f by the handbook (Howland; Peterson's chart 4.1), "
                    "%.4f by this analysis (%+.2f%%)",
                    handbook, strip, 100 * (strip / handbook - 1));
  PAPER_CASES_PRINT("  square plate %.4f extrapolated from medium and fine, "
                    "%.4f on the adapted mesh (%+.2f%%; %+.2f%% of the handbook's strip)\n",
                    square, adapted.stress_concentration,
                    100 * (adapted.stress_concentration / square - 1),
                    100 * (adapted.stress_concentration / handbook - 1));
}

/// Writes the solution on the adapted mesh as `<base>_solution.vtk` and the estimated error of
/// the coarse mesh as `<base>_error.svg`, the paper's Figure 12.
inline bool write_analysis(const Mesh& coarse, const Plate::Result& on_coarse, const Mesh& adapted,
                           const Plate::Result& on_adapted, const std::string& base)
{
  namespace QMA = CGAL::Quad_mesh_adaptation;
  QMA::Mesh_fields fields;
  fields.vertex = { { "displacement_x", {} },
                    { "displacement_y", {} },
                    { "effective_stress", {} } };
  for(std::size_t n = 0; n < on_adapted.nodes; ++n) {
    fields.vertex[0].values.push_back(on_adapted.displacement[2 * long(n)]);
    fields.vertex[1].values.push_back(on_adapted.displacement[2 * long(n) + 1]);
    fields.vertex[2].values.push_back(plane_stress::effective(on_adapted.estimate.nodal_stress[n]));
  }
  fields.face = { { "stress_error", on_adapted.estimate.effective_error },
                  { "energy_error", on_adapted.estimate.element_error } };

  // the largest error of the elements at a node, as a field over the mesh
  Mesh background = coarse;
  auto error = background.add_property_map<Vertex, double>("v:error", 1e-6).first;
  std::size_t i = 0;
  for(auto f : coarse.faces()) {
    for(auto v : vertices_around_face(coarse.halfedge(f), coarse))
      error[v] = (std::max)(error[v], on_coarse.estimate.effective_error[i]);
    ++i;
  }
  const QMA::Nodal_sizing_field error_field(background, error);
  QMA::Picture picture;
  picture.add_mesh(coarse, "Initial mesh");
  picture.add_sizing(coarse, error_field, "Stress error");
  QMA::File_transaction files;
  return is_written(QMA::write_quad_mesh(base + "_solution.vtk", adapted, fields)) &&
         is_written(files.stage(base + "_error.svg", picture.svg())) && is_written(files.commit());
}

} // namespace paper_cases

#endif // QUAD_MESH_ADAPTATION_EXAMPLES_PLATE_ANALYSIS_H
