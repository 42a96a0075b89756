// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ADVISE_ON_RESULT_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ADVISE_ON_RESULT_H

#include <CGAL/Quad_mesh_adaptation/Adaptation_report.h>
#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>

#include <algorithm>
#include <cstddef>
#include <sstream>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Tells what held many faces far below their size, if that was features: whoever expects fewer
// faces can have them with fewer features only.
inline void advise_on_features(const Adaptation_state& s, Adaptation_report& report)
{
  constexpr double many = 0.05, most = 2. / 3, far_too_small = 0.5;
  const double faces = double(report.after.faces);
  if(double(report.after.size_ratio.counts[0]) <= many * faces) return; // those below a half
  std::size_t small = 0, beside = 0;
  for(Index f : s.mesh.faces()) {
    if(s.size_ratio(f) * s.size.scale() >= far_too_small) continue;
    const Quad q = s.mesh.quad(f);
    ++small;
    if(std::any_of(q.begin(), q.end(),
                   [&](Index v) { return s.mesh.vertex(v).carrier != Carrier::surface; }))
      ++beside;
  }
  if(double(small) <= many * faces || double(beside) < most * double(small)) return;
  std::ostringstream text;
  text << small << " of " << report.after.faces << " faces "
       << (small == 1 ? "is smaller than half its size, " : "are smaller than half their size, ")
       << beside << " of them beside features or the border (" << report.feature_curves
       << " curves, " << report.corners
       << " corners), which leave no room for larger ones; only a larger feature angle would leave "
          "out some of those that are detected by their angle";
  report.advice.push_back(text.str());
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ADVISE_ON_RESULT_H
