// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_BENCHMARK_SPEED_OUR_TASKS_H
#define QUAD_MESH_ADAPTATION_BENCHMARK_SPEED_OUR_TASKS_H

#include "process.h"
#include "shapes.h"

#include <CGAL/Quad_mesh_adaptation/coarsen.h>
#include <CGAL/Quad_mesh_adaptation/refine.h>
#include <CGAL/adapt_quad_mesh.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// The package's own calls.
namespace speed {

using CGAL::Quad_mesh_adaptation::Adaptation_report;

using Call = std::function<Adaptation_report(const Sizing&, Mesh&)>;

/// The call on a copy of the mesh, timed.
inline Outcome timed(const Call& call, const Sizing& size, Mesh& mesh)
{
  Outcome o;
  o.faces_in = double(mesh.number_of_faces());
  const Stopwatch watch;
  const Adaptation_report report = call(size, mesh);
  o.cpu = watch.cpu();
  o.wall = watch.wall();
  if(!report.has_valid_mesh()) throw std::runtime_error(report.message);
  o.faces_out = double(mesh.number_of_faces());
  o.phases = report.times;
  return o;
}

inline std::function<Outcome()> on_mesh(Mesh mesh, Sizing size, Call call)
{
  const auto input = std::make_shared<Mesh>(std::move(mesh));
  return [=] { return timed(call, size, *input); };
}

namespace QMA = CGAL::Quad_mesh_adaptation;

inline Adaptation_report adapt(const Sizing& size, Mesh& mesh)
{
  return QMA::adapt_quad_mesh(size, mesh);
}

/// Whether a call may make use of symmetry.
enum class Use_of_symmetry
{
  as_by_default,
  none
};

inline std::string named(const std::string& what, Use_of_symmetry use)
{
  return use == Use_of_symmetry::none ? what + " whole" : what;
}

inline Task refine_task(const Shape& shape, int level, Use_of_symmetry use)
{
  const double faces = std::pow(10., level);
  return {
    named("refine", use), shape.name, level,
    [=] {
      return on_mesh(shape.coarse(), shape.graded(faces), [use](const Sizing& size, Mesh& mesh) {
        return QMA::refine(size, mesh, QMA::symmetry(use == Use_of_symmetry::as_by_default));
      });
    },
    true
  };
}

inline Task adapt_task(const Shape& shape, int level, Use_of_symmetry use)
{
  const double faces = std::pow(10., level);
  return { named("adapt", use), shape.name, level,
           [=] {
             return on_mesh(shape.to_adapt(faces), shape.graded(faces),
                            [use](const Sizing& size, Mesh& mesh) {
                              return QMA::adapt_quad_mesh(
                                  size, mesh, QMA::symmetry(use == Use_of_symmetry::as_by_default));
                            });
           },
           true };
}

#ifdef CGAL_LINKED_WITH_TBB
/// The same with so many threads, by the clock.
inline Task threads_task(const Shape& shape, int level, Use_of_symmetry use, int threads)
{
  Task task = adapt_task(shape, level, use);
  task.what += ", " + std::to_string(threads) + " threads";
  task.measures_memory = false;
  const double faces = std::pow(10., level);
  task.prepare = [=] {
    const auto call =
        on_mesh(shape.to_adapt(faces), shape.graded(faces), [use](const Sizing& size, Mesh& mesh) {
          return QMA::adapt_quad_mesh(size, mesh,
                                      QMA::symmetry(use == Use_of_symmetry::as_by_default,
                                                    QMA::concurrency(CGAL::Parallel_tag())));
        });
    return [=] {
      using Control = tbb::global_control;
      const Control control(Control::max_allowed_parallelism, std::size_t(threads));
      Outcome o = call();
      o.cpu = o.wall;
      return o;
    };
  };
  return task;
}
#endif

/// To edges `factor` times longer.
inline Task coarsen_task(const std::string& what, const Shape& shape, int level, double factor)
{
  const double faces = std::pow(10., level);
  return { what, shape.name, level,
           [=] {
             Mesh mesh = shape.of_faces(faces);
             const double length = factor * std::sqrt(area(mesh) / double(mesh.number_of_faces()));
             return on_mesh(
                 std::move(mesh), [length](const Point&) { return length; },
                 [](const Sizing& size, Mesh& m) { return QMA::coarsen(size, m); });
           },
           true };
}

/// Half the size about a point, in a ball that holds a hundredth of the faces of the mesh.
inline Sizing with_small_change(const Mesh& mesh, const Sizing& size)
{
  const Point centre = mesh.point(*(mesh.vertices_begin() + mesh.number_of_vertices() / 3));
  std::vector<double> distances;
  for(auto v : mesh.vertices()) distances.push_back(CGAL::squared_distance(centre, mesh.point(v)));
  const auto hundredth = distances.begin() + long(distances.size() / 100);
  std::nth_element(distances.begin(), hundredth, distances.end());
  const double radius2 = *hundredth;
  return [=](const Point& p) {
    return size(p) * (CGAL::squared_distance(centre, p) < radius2 ? 0.5 : 1.);
  };
}

/// An adapted mesh to sizes that differ in a small place, and the mesh it was made of to the same
/// sizes, from scratch.
inline std::vector<Task> small_change_tasks(const Shape& shape, int level)
{
  const double faces = std::pow(10., level);
  const auto known = std::make_shared<std::optional<Mesh>>();
  const auto adapted = [=]() -> const Mesh& { // once for all runs
    if(!*known) {
      Mesh mesh = shape.to_adapt(faces);
      adapt(shape.graded(faces), mesh);
      mesh.collect_garbage();
      *known = std::move(mesh);
    }
    return **known;
  };
  const auto task = [=](const char* what, bool is_from_scratch) {
    return Task{ what, shape.name, level,
                 [=] {
                   const Sizing changed = with_small_change(adapted(), shape.graded(faces));
                   return on_mesh(is_from_scratch ? shape.to_adapt(faces) : adapted(), changed,
                                  adapt);
                 },
                 !is_from_scratch };
  };
  return { task("small change", false), task("small change from scratch", true) };
}

} // namespace speed

#endif // QUAD_MESH_ADAPTATION_BENCHMARK_SPEED_OUR_TASKS_H
