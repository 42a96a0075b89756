// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_WORKERS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_WORKERS_H

#include <cstddef>
#include <functional>
#include <memory>
#include <utility>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Who does tasks that do not depend on each other: one thread after the other, or, where the
// caller asked for it, TBB's.  What comes out must not depend on that, so tasks neither share what
// they write nor count on an order.
class Workers
{
public:
#ifdef CGAL_LINKED_WITH_TBB
  void use_threads(bool use)
  {
    using Control = tbb::global_control;
    several_ = use && tbb::this_task_arena::max_concurrency() > 1 &&
               Control::active_value(Control::max_allowed_parallelism) > 1;
  }
#else
  void use_threads(bool) {}
#endif
  bool are_several() const { return several_; }

  // Calls task(i) for i from 0 to n - 1.
  template <typename Task>
  void run(std::size_t n, const Task& task) const
  {
#ifdef CGAL_LINKED_WITH_TBB
    if(several_ && n > 1) {
      tbb::parallel_for(std::size_t(0), n, task);
      return;
    }
#endif
    for(std::size_t i = 0; i < n; ++i) task(i);
  }

private:
  bool several_ = false;
};

// One object of a kind for each worker, made when it is first asked for.
template <typename T>
class Worker_own
{
public:
  using Make = std::function<std::unique_ptr<T>()>;

#ifdef CGAL_LINKED_WITH_TBB
  explicit Worker_own(Make make) : objects_(std::move(make)) {}
  T& mine() { return *objects_.local(); }

private:
  tbb::enumerable_thread_specific<std::unique_ptr<T>> objects_;
#else
  explicit Worker_own(const Make& make) : object_(make()) {}
  T& mine() { return *object_; }

private:
  std::unique_ptr<T> object_;
#endif
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_WORKERS_H
