// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_ADAPTATION_REPORT_H
#define CGAL_QUAD_MESH_ADAPTATION_ADAPTATION_REPORT_H

#include <CGAL/Quad_mesh_adaptation/Mesh_measures.h>
#include <CGAL/Quad_mesh_adaptation/Poor_face.h>
#include <CGAL/Quad_mesh_adaptation/Refusal.h>
#include <CGAL/Quad_mesh_adaptation/Size_growth.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {

/// How a call ended.  In the last three cases the caller's mesh is as it was.
enum class Adaptation_status
{
  sizes_met, ///< every face (paper's schedule: every face but the paper's tolerance) is within its
             ///< size
  sizes_not_met, ///< a valid mesh was made, but some faces are larger than asked or farther from
                 ///< the reference than `max_distance()`; see `message`
  input_refused, ///< the mesh cannot be adapted; `reason` and `entity` say why and where
  sizes_refused, ///< the sizing function gave a value that is not a positive finite number, at
                 ///< `place`, or sizes ask for too many faces
  cancelled      ///< the visitor or the callback asked to stop
};

/// What an operation of the adaptation did, by name ("face close", "chord removal" ...).
struct Operation_count
{
  std::string name;
  std::size_t count = 0;
};

/// Wall-clock seconds spent in a phase.
struct Phase_time
{
  std::string name;
  double seconds = 0;
};

/// Everything a call to `adapt_quad_mesh()` or to one of the phases tells about itself.
struct Adaptation_report
{
  Adaptation_status status = Adaptation_status::sizes_met;
  Refusal reason = Refusal::none;
  /// One sentence for a person, without a final full stop; empty when all went well.
  std::string message;
  /// The entity that was refused, as a number in the order of iteration over the mesh
  /// (a vertex or a face, as `message` says; of the reference surface where that is refused); -1
  /// when no single entity is to blame.
  long entity = -1;
  /// The point at which the sizing function or a projector gave no value to work with, as
  /// coordinates; nothing when another reason, or a size that is a number, was refused.
  std::optional<std::array<double, 3>> place;

  /// Of the input, with its nodes on the reference if there is a separate one; filled unless the
  /// input or the sizes were refused.  Of the result; filled where `has_valid_mesh()`.
  Mesh_measures before, after;
  /// What the formula of `expected_number_of_faces()` says, made before the work; where that
  /// function adapts a copy and counts, it is nearer to the outcome.  `adapt_quad_mesh()` with the
  /// default schedule only, otherwise 0.
  double expected_number_of_faces = 0;
  /// How fast the given size grows over the input mesh; filled unless the input or the
  /// sizes were refused.
  Size_growth size_growth;
  /// Sentences for a person on what could be asked for better, no errors; without final full stop.
  std::vector<std::string> advice;
  std::size_t iterations = 0; ///< passes of refinement; none where all else was enough
  std::vector<Operation_count> operations;
  std::vector<Phase_time> times;
  /// Faces larger than asked at the end, as positions in the iteration order of the mesh's faces.
  std::vector<std::size_t> faces_too_large;
  /// Faces farther from the reference than `max_distance()` allows, the same way; empty without.
  std::vector<std::size_t> faces_too_far;
  /// Faces with a scaled Jacobian below `Poor_face::floor`, the same way, and what holds each.
  std::vector<Poor_face> poor_faces;

  /// What the mesh has in features, detected or given: maximal sets of faces that no feature curve
  /// parts, curves from corner to corner or closed, borders among them, and corners.
  std::size_t patches = 0, feature_curves = 0, corners = 0;

  bool has_valid_mesh() const
  {
    return status == Adaptation_status::sizes_met || status == Adaptation_status::sizes_not_met;
  }
};

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_ADAPTATION_REPORT_H
