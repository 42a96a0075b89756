// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_IO_READ_RESULT_H
#define CGAL_QUAD_MESH_ADAPTATION_IO_READ_RESULT_H

#include <CGAL/Quad_mesh_adaptation/Refusal.h>

#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {

/// How reading a surface ended.
struct Read_result
{
  Refusal reason = Refusal::none; ///< `none` when the surface was read
  /// One sentence for a person, without a final full stop; says what and where.
  std::string message;
  /// Position in the file (from 0) of the vertex or face that `message` names; -1 when there is
  /// none.
  long entity = -1;
  /// What was silently harmless but changed the input: isolated vertices dropped, faces turned.
  std::vector<std::string> notes;

  bool ok() const { return reason == Refusal::none; }
};

namespace internal {

inline Read_result refuse(Refusal reason, std::string message, long entity = -1)
{
  Read_result result;
  result.reason = reason;
  result.message = std::move(message);
  result.entity = entity;
  return result;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_IO_READ_RESULT_H
