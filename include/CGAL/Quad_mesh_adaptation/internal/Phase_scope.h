// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PHASE_SCOPE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PHASE_SCOPE_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>

#include <exception>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Tells the observers of a state that a phase starts and, when it ends without exception, that
// it ended.
class Phase_scope
{
public:
  Phase_scope(Adaptation_state& s, const char* name)
      : s_(s), name_(name), exceptions_(std::uncaught_exceptions())
  {
    s_.check_cancelled();
    s_.start_phase(name_, s_.iterations);
  }
  ~Phase_scope() noexcept(false)
  {
    if(std::uncaught_exceptions() == exceptions_)
      s_.end_phase(name_, std::size_t(s_.mesh.number_of_faces()));
  }
  Phase_scope(const Phase_scope&) = delete;
  Phase_scope& operator=(const Phase_scope&) = delete;

private:
  Adaptation_state& s_;
  const char* name_;
  int exceptions_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PHASE_SCOPE_H
