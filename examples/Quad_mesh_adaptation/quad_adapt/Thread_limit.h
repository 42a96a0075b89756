// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_ADAPT_THREAD_LIMIT_H
#define QUAD_ADAPT_THREAD_LIMIT_H

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <optional>

/// Not more threads than this as long as it lives; 0: no limit.
class Thread_limit
{
public:
#ifdef CGAL_LINKED_WITH_TBB
  explicit Thread_limit(unsigned threads)
  {
    if(threads > 0) control_.emplace(tbb::global_control::max_allowed_parallelism, threads);
  }

private:
  std::optional<tbb::global_control> control_;
#else
  explicit Thread_limit(unsigned) {}
#endif
};

#endif // QUAD_ADAPT_THREAD_LIMIT_H
