// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_ADAPT_PARSE_OPTIONS_H
#define QUAD_ADAPT_PARSE_OPTIONS_H

#include "Options.h"

#include <CGAL/Quad_mesh_adaptation/IO/write_picture.h>
#include <CGAL/Quad_mesh_adaptation/IO/write_quad_mesh.h>

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <limits>
#include <set>
#include <sstream>
#include <string>

#ifndef QUAD_MESH_ADAPTATION_VERSION
#define QUAD_MESH_ADAPTATION_VERSION "0.1.0"
#endif

// A finite number from `low` on, or above 0 where `low` is 0, and not above `high`; "nan" is a
// number to most parsers.
inline CLI::Validator number_from(double low, double high = std::numeric_limits<double>::infinity())
{
  return CLI::Validator(
      [low, high](std::string& text) {
        char* end = nullptr;
        const double value = std::strtod(text.c_str(), &end);
        const bool is_number = end != text.c_str() && *end == 0 && std::isfinite(value);
        if(is_number && (low > 0 ? value >= low : value > 0) && value <= high) return std::string();
        std::ostringstream message;
        message << text << " is not a finite number " << (low > 0 ? "from " : "above ") << low
                << (low > 0 ? " on" : "");
        if(std::isfinite(high)) message << ", " << high << " at most";
        return message.str();
      },
      "");
}

// Of a name: a variable that is not set would go unnoticed.
inline CLI::Validator not_empty()
{
  return CLI::Validator(
      [](std::string& text) { return text.empty() ? "the name is empty" : std::string(); }, "");
}

// The same for all names of a file, as far as the file system can tell.
inline std::string name_of_file(const std::string& name)
{
  std::error_code error;
  std::filesystem::path path = std::filesystem::absolute(name, error);
  if(!error) path = std::filesystem::weakly_canonical(path, error);
  return error ? name : path.string();
}

// Throws CLI::ValidationError where an output would take the place of another file; but the mesh
// may be adapted in place.
inline void check_files(const Options& options)
{
  std::set<std::string> names;
  for(const std::string& file : { options.input, options.reference, options.background })
    if(!file.empty()) names.insert(name_of_file(file));
  if(name_of_file(options.output) == name_of_file(options.input))
    names.erase(name_of_file(options.input));
  for(const std::string& file : { options.output, options.report, options.picture })
    if(!file.empty() && !names.insert(name_of_file(file)).second)
      throw CLI::ValidationError("OUTPUT, --report, --picture", file + " is named twice");
}

// Throws CLI::ValidationError where options contradict each other.
inline void check_options(const Options& options)
{
  using CGAL::Quad_mesh_adaptation::is_mesh_format_known;
  if(!is_mesh_format_known(options.output))
    throw CLI::ValidationError("OUTPUT", "must end in .off, .obj, .ply, .vtk or .vtu, not be " +
                                             options.output);
  if(options.gradation && std::isnan(*options.gradation))
    throw CLI::ValidationError("--gradation", "must be a number, not nan");
  if(options.aim == "nearest" && options.schedule == "paper")
    throw CLI::ValidationError("--aim", "nearest is for the default schedule only");
  const int targets = int(options.error_target.has_value()) +
                      int(options.error_reduction.has_value()) +
                      int(options.error_faces.has_value());
  if(options.error_property && targets != 1)
    throw CLI::ValidationError("--error",
                               "needs one of --error-target, --error-reduction and --error-faces");
  if(!options.picture.empty() &&
     !CGAL::Quad_mesh_adaptation::is_picture_format_known(options.picture))
    throw CLI::ValidationError("--picture", "must end in .svg, not be " + options.picture);
  if(options.smallest_size.value_or(0) >
     options.largest_size.value_or(std::numeric_limits<double>::infinity()))
    throw CLI::ValidationError("--min-size", "is larger than --max-size");
  check_files(options);
}

// What sizes from error indicators are to reach.
inline void describe_error(CLI::App& app, Options& options, CLI::Option* error)
{
  app.add_option("--error-target", options.error_target,
                 "Sizes by --error are for this error, the root of the sum of all squares")
      ->type_name("E")
      ->check(number_from(0))
      ->needs(error);
  app.add_option("--error-reduction", options.error_reduction,
                 "Sizes by --error are for this share of the present error")
      ->type_name("R")
      ->check(number_from(0))
      ->needs(error);
  app.add_option("--error-faces", options.error_faces,
                 "Sizes by --error are for about so many faces")
      ->type_name("N")
      ->check(number_from(1))
      ->needs(error);
  app.add_option("--error-order", options.error_order,
                 "The error falls like this power of the size: the degree of the elements")
      ->type_name("P")
      ->check(number_from(0))
      ->needs(error)
      ->capture_default_str();
}

inline void describe_size_bounds(CLI::App& app, Options& options)
{
  app.add_option("--min-size", options.smallest_size,
                 "Sizes below H are raised to H; edges come out somewhat shorter")
      ->type_name("H")
      ->check(number_from(0));
  app.add_option("--max-size", options.largest_size, "Sizes above H are lowered to H")
      ->type_name("H")
      ->check(number_from(0));
  app.add_option("--gradation", options.gradation,
                 "Let the size grow by at most G per unit of distance over INPUT: where the\n"
                 "given one grows faster it is lowered; 0.2 to 0.3 suits quads [no limit]")
      ->type_name("G")
      ->check(CLI::Range(0., 1e6));
}

inline void describe_sizes(CLI::App& app, Options& options)
{
  auto* sizes = app.add_option_group("Sizes", "At least one; of several the smallest counts");
  auto* size =
      sizes->add_option("--size", options.size, "Edge length to have everywhere")->type_name("H");
  sizes
      ->add_option("--size-function", options.size_function,
                   "Edge length as an expression in x, y, z")
      ->type_name("EXPR")
      ->excludes(size);
  auto* circle = sizes
                     ->add_option("--curvature", options.elements_per_circle,
                                  "So many edges along a full circle of the surface's curvature")
                     ->type_name("N")
                     ->check(number_from(3));
  sizes
      ->add_option("--chord-error", options.chord_error,
                   "Faces that leave the surface by at most about this distance; creases do\n"
                   "not count, nor, without --reference, do marked edges and patch borders;\n"
                   "with --smooth-reference and no --min-size like --max-distance 1.1 E, too")
      ->type_name("E")
      ->check(number_from(0))
      ->excludes(circle);
  sizes
      ->add_option("--proximity", options.elements_across,
                   "So many edges would fit across thin parts")
      ->type_name("N")
      ->check(number_from(0));
  sizes
      ->add_option("--background", options.background,
                   "Mesh whose vertices have a property \"size\", interpolated")
      ->type_name("FILE.ply")
      ->check(not_empty());
  auto* error =
      sizes
          ->add_option("--error", options.error_property,
                       "Property of INPUT's (.ply) faces or vertices with error indicators")
          ->type_name("NAME")
          ->check(not_empty());
  sizes->require_option(1, 0);
  describe_error(app, options, error);
  describe_size_bounds(app, options);
}

inline void describe_surface(CLI::App& app, Options& options)
{
  app.add_option("--reference", options.reference,
                 "Finer surface to stay on; its border and creases are the curves [INPUT]")
      ->type_name("SURFACE")
      ->check(not_empty());
  app.add_flag("--smooth-reference", options.is_smooth,
               "Stay on the smooth surface through the vertices instead of on the facets");
  app.add_option("--max-distance", options.max_distance,
                 "Let no face be farther from that surface than D [no limit]")
      ->type_name("D")
      ->check(number_from(0));
  app.add_option("--feature-angle", options.feature_angle,
                 "Turn in degrees, up to 180, from which an edge or a corner is kept; 180\n"
                 "keeps none")
      ->type_name("DEG")
      ->check(number_from(0, 180))
      ->capture_default_str();
  app.add_option("--region", options.region,
                 "Change only faces at whose centre this expression in x, y, z is not zero, like\n"
                 "\"x < 2 && z > 0\"; edges between them and the others stay [all faces]")
      ->type_name("EXPR");
  app.add_flag(
      "--ignore-sets", options.ignores_sets,
      "Do not keep INPUT's patches (.obj: g and usemtl; .ply: \"patch\" of faces), marked\n"
      "edges (.obj: l; .ply: edges) and fixed vertices (.ply: \"fixed\" not zero)");
  app.add_flag("--keep-border", options.is_border_frozen,
               "Leave the edges of the border as they are, so that other meshes still fit");
}

inline void describe_course(CLI::App& app, Options& options)
{
  app.add_option("--schedule", options.schedule, "Order of the phases")
      ->type_name("paper|default")
      ->check(CLI::IsMember({ "paper", "default" }))
      ->capture_default_str();
  app.add_option("--aim", options.aim,
                 "No face larger than asked, or all as near as possible to their size")
      ->type_name("not-larger|nearest")
      ->check(CLI::IsMember({ "not-larger", "nearest" }))
      ->capture_default_str();
  app.add_flag("--quick", options.is_quick,
               "Do not try other ways for a better mesh, which takes most of the time for up to\n"
               "some 20000 faces");
  app.add_flag("--no-symmetry", options.may_lose_symmetry, "Do not keep mirror symmetry");
  app.add_option("--max-iterations", options.max_iterations, "Passes of refinement at most")
      ->type_name("N")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
#ifdef CGAL_LINKED_WITH_TBB
  app.add_option("--threads", options.threads,
                 "Threads to work with [all]; the result does not depend on them")
      ->type_name("N")
      ->check(CLI::Range(1, 4096));
#endif
}

inline void describe_options(CLI::App& app, Options& options)
{
  app.add_option("INPUT", options.input, "Quad mesh to adapt (.off, .obj, .ply)")
      ->required()
      ->check(not_empty());
  app.add_option("OUTPUT", options.output,
                 "Where to write the adapted mesh (.off, .obj, .ply, .vtk, .vtu)")
      ->required();
  describe_sizes(app, options);
  describe_surface(app, options);
  describe_course(app, options);
  app.add_option("--report", options.report, "Write what was done and measured, as JSON")
      ->type_name("FILE.json")
      ->check(not_empty());
  app.add_option("--picture", options.picture,
                 "Draw the initial mesh, the sizing function and the adapted mesh")
      ->type_name("FILE.svg")
      ->check(not_empty());
  app.add_flag("--quiet", options.is_quiet, "Print nothing but errors");
  app.set_version_flag("--version", "quad_adapt " QUAD_MESH_ADAPTATION_VERSION);
  app.footer(
      "Expressions: + - * / ^ ?: < > == && ||, pi, min max abs sqrt exp ln log10 sin cos tan\n"
      "  asin acos atan atan2 hypot floor ceil, if(a, b, c), clamp(v, low, high)\n"
      "Examples:\n"
      "  quad_adapt plate.off adapted.vtk --size-function \"0.1 + abs(hypot(x, y) - 4.8)\"\n"
      "  quad_adapt plate.off graded.vtk --size-function \"x < 2 ? 0.1 : 5\" --gradation 0.25\n"
      "  quad_adapt cow.off round.off --curvature 24 --max-size 0.1 --gradation 0.3\n"
      "  quad_adapt part.off part.off --background wanted.ply --max-size 3\n"
      "  quad_adapt solved.ply better.ply --error eta --error-reduction 0.5\n"
      "  quad_adapt dam.off finer.off --size 0.5 --region \"hypot(x - 3, y) < 2\"\n"
      "  quad_adapt part.obj coarse.obj --size 2.5 --reference part_fine.ply --picture part.svg\n"
      "Exit codes:\n"
      "  0    the mesh was written, all sizes are met, and --max-distance\n"
      "  1    input or sizes refused, or an output cannot be written: nothing was written but\n"
      "       --report where something was refused\n"
      "  2    wrong usage\n"
      "  3    a valid mesh was written, but some faces are larger than asked, or farther\n"
      "       from the surface than --max-distance\n"
      "  130  interrupted, nothing was written");
}

/// Reads the command line.  `false` when the program is to end with `exit_code`, everything being
/// said.
inline bool parse_options(int argc, char** argv, Options& options, int& exit_code)
{
  CLI::App app("Adapts a mesh of quadrilaterals to a sizing function: refines, coarsens and "
               "smooths it, all quads, on its surface.",
               "quad_adapt");
  describe_options(app, options);
  try {
    app.parse(argc, argv);
    check_options(options);
    return true;
  } catch(const CLI::CallForHelp&) {
    std::cout << app.help();
    exit_code = exit_sizes_met;
  } catch(const CLI::CallForVersion& version) {
    std::cout << version.what() << '\n';
    exit_code = exit_sizes_met;
  } catch(const CLI::ParseError& error) {
    std::cerr << "quad_adapt: " << error.what() << "; see quad_adapt --help\n";
    exit_code = exit_wrong_usage;
  }
  return false;
}

#endif // QUAD_ADAPT_PARSE_OPTIONS_H
