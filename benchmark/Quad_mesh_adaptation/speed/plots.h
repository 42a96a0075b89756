// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_BENCHMARK_SPEED_PLOTS_H
#define QUAD_MESH_ADAPTATION_BENCHMARK_SPEED_PLOTS_H

#include "../../../examples/Quad_mesh_adaptation/support/log_plot.h"
#include "Results.h"

#include <string>
#include <vector>

namespace speed {

/// A curve of `value` over `faces` for all levels of a task; nothing if it was run at none.
template <typename Faces, typename Value>
void add_curve(Log_plot& plot, const Results& results, const std::string& what,
               const std::string& shape, const std::string& colour, bool is_dashed,
               const Faces& faces, const Value& value)
{
  Log_plot::Curve c = { what + ", " + shape, colour, {}, {}, is_dashed };
  for(int level : results.levels())
    if(const Result* r = results.find(what, shape, level)) {
      if(!(value(*r) > 0)) continue;
      c.x.push_back(faces(*r));
      c.y.push_back(value(*r));
    }
  if(!c.x.empty()) plot.curves.push_back(c);
}

inline const std::vector<std::string>& colours()
{
  static const std::vector<std::string> list = { "#2050a0", "#b03020", "#208040", "#806000" };
  return list;
}

inline Log_plot time_plot(const Results& results, const std::vector<std::string>& shapes)
{
  Log_plot plot;
  plot.title = "Time per element of the result";
  plot.x_title = "elements";
  plot.y_title = "microseconds of the processor";
  plot.has_legend_beside = true;
  const auto faces = [](const Result& r) { return r.faces_out(); };
  const auto time = [](const Result& r) { return r.microseconds_per_face(); };
  for(std::size_t i = 0; i < shapes.size(); ++i) {
    add_curve(plot, results, "adapt", shapes[i], colours()[i % 4], false, faces, time);
    add_curve(plot, results, "refine", shapes[i], colours()[i % 4], true, faces, time);
  }
  add_curve(plot, results, "isotropic_remeshing", shapes.front(), "#888888", true, faces, time);
  add_curve(plot, results, "gmsh", shapes.front(), "#000000", false, faces, time);
  return plot;
}

inline Log_plot memory_plot(const Results& results, const std::vector<std::string>& shapes)
{
  Log_plot plot;
  plot.title = "Peak of memory above the mesh itself";
  plot.x_title = "faces of the larger mesh";
  plot.y_title = "bytes per face";
  plot.has_legend_beside = true;
  const auto faces = [](const Result& r) { return r.most_faces(); };
  const auto bytes = [](const Result& r) { return r.bytes_per_face(); };
  for(std::size_t i = 0; i < shapes.size(); ++i) {
    add_curve(plot, results, "adapt", shapes[i], colours()[i % 4], false, faces, bytes);
    add_curve(plot, results, "coarsen", shapes[i], colours()[i % 4], true, faces, bytes);
  }
  return plot;
}

} // namespace speed

#endif // QUAD_MESH_ADAPTATION_BENCHMARK_SPEED_PLOTS_H
