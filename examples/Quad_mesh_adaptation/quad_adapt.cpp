// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// quad_adapt INPUT OUTPUT (--size H | --size-function EXPR | ...) [options]
// Adapts a quad mesh in a file to sizes; see quad_adapt --help.

#include "quad_adapt/Carried_fields.h"
#include "quad_adapt/Mesh_sets.h"
#include "quad_adapt/Options.h"
#include "quad_adapt/Progress.h"
#include "quad_adapt/Sizes.h"
#include "quad_adapt/adapt.h"
#include "quad_adapt/parse_options.h"
#include "quad_adapt/refuse.h"
#include "support/face_fields.h"
#include "support/print_report.h"
#include "support/report_json.h"

#include <CGAL/Quad_mesh_adaptation/IO/read_quad_mesh.h>
#include <CGAL/Quad_mesh_adaptation/IO/write_picture.h>
#include <CGAL/Quad_mesh_adaptation/IO/write_quad_mesh.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace QMA = CGAL::Quad_mesh_adaptation;

// What the program reads but for the sizes.
struct Inputs
{
  Mesh mesh, reference;
  QMA::Mesh_fields fields;       // of the mesh as it was read
  std::optional<Mesh_sets> sets; // of the mesh, once it has been read
  Carried_fields carried;
};

// 0, or the exit code after having said why.
int read_inputs(const Options& options, Inputs& in)
{
  QMA::Read_result result = QMA::read_quad_mesh(options.input, in.mesh, in.fields);
  if(!result.ok()) return refuse(options, "", result);
  in.sets.emplace(in.mesh);
  if(!options.ignores_sets) {
    const QMA::Read_result taken = in.sets->take(in.fields, result.notes);
    if(!taken.ok()) return refuse(options, "", taken);
  }
  if(QMA::can_hold_fields(options.output)) in.carried.take(in.mesh, in.fields, result.notes);
  if(!options.is_quiet)
    for(const std::string& note : result.notes)
      std::cerr << "quad_adapt: note: " << options.input << ": " << note << '\n';
  if(options.reference.empty()) return 0;
  result = QMA::read_surface(options.reference, in.reference);
  return result.ok() ? 0 : refuse(options, "", result);
}

// Before the work rather than after it.
int probe_outputs(const Options& options)
{
  for(const std::string& file : { options.output, options.report, options.picture }) {
    if(file.empty()) continue;
    const QMA::Write_result result = QMA::File_transaction::probe(file);
    if(!result.ok()) return refuse(result.message);
  }
  return 0;
}

// All files or none.
int write_outputs(const Options& options, const Size_function& size, const Mesh& initial,
                  const Inputs& in, const QMA::Adaptation_report& report)
{
  QMA::Mesh_fields fields = size_and_quality_fields(in.mesh, size);
  in.sets->add_to(fields);
  in.carried.add_to(in.mesh, fields);
  QMA::File_transaction files;
  QMA::Write_result result =
      files.stage(options.output, QMA::quad_mesh_file_contents(options.output, in.mesh, fields));
  if(result.ok() && !options.report.empty())
    result = files.stage(options.report, to_json(report).dump(2) + '\n');
  if(result.ok() && !options.picture.empty())
    result = files.stage(options.picture, QMA::picture_file_contents(initial, size, in.mesh));
  if(is_interrupted) return exit_interrupted;
  if(result.ok()) result = files.commit();
  return result.ok() ? 0 : refuse(result.message);
}

// The sets are those of INPUT: a reference has none.
void add_sizes_of_shape(const Options& options, const Inputs& in, Size_function& size)
{
  if(options.reference.empty())
    add_sizes_of_surface(
        options, in.mesh, [&in](Mesh::Edge_index e) { return in.sets->is_kept(e); }, size);
  else
    add_sizes_of_surface(
        options, in.reference, [](Mesh::Edge_index) { return false; }, size);
}

int run(const Options& options)
{
  Size_function size;
  Inputs in;
  Mesh& mesh = in.mesh;
  int exit_code = read_given_sizes(options, size);
  if(exit_code == 0) exit_code = read_inputs(options, in);
  if(exit_code == 0) exit_code = probe_outputs(options);
  if(exit_code == 0) exit_code = add_sizes_of_error(options, mesh, in.fields, size);
  if(exit_code != 0) return exit_code;
  add_sizes_of_shape(options, in, size);
  if(options.gradation) limit_growth(options, mesh, size);
  std::vector<Mesh::Face_index> region;
  exit_code = choose_region(options, mesh, region);
  if(exit_code != 0) return exit_code;

  const Mesh initial = options.picture.empty() ? Mesh() : mesh;
  catch_interrupts();
  const QMA::Adaptation_report report = adapt(options, size, mesh, *in.sets, in.reference, region);
  if(report.status == QMA::Adaptation_status::cancelled)
    return refuse("interrupted, nothing was written", exit_interrupted);
  if(!report.has_valid_mesh()) return refuse(options, options.input + ": ", report);

  exit_code = write_outputs(options, size, initial, in, report);
  if(exit_code == exit_interrupted) return refuse("interrupted, nothing was written", exit_code);
  if(exit_code != 0) return exit_code;
  if(!options.is_quiet) print_report(std::cout, report);
  if(!options.is_quiet && !options.gradation && report.size_growth.is_too_steep())
    std::cout << "The option --gradation bounds the growth of the size\n";
  if(report.status == QMA::Adaptation_status::sizes_met) return exit_sizes_met;
  return refuse("not all that was asked for is met: " + report.message, exit_sizes_not_met);
}

int main(int argc, char** argv)
{
  Options options;
  int exit_code = exit_wrong_usage;
  if(!parse_options(argc, argv, options, exit_code)) return exit_code;
  try {
    return run(options);
  } catch(const std::domain_error& error) { // of fields of sizes
    return refuse(options, "", QMA::Refusal::invalid_size, error.what());
  } catch(const std::invalid_argument& error) {
    return refuse(options, "", QMA::Refusal::invalid_parameter, error.what());
  } catch(const std::exception& error) {
    return refuse(std::string("nothing was written: ") + error.what());
  }
}
