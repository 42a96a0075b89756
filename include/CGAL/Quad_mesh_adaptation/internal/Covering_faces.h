// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_COVERING_FACES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_COVERING_FACES_H

#include <CGAL/Quad_mesh_adaptation/internal/Witness.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Some faces, one of which is to keep a witness.  Each lies in a ball, so that most that are not
// the nearest need not be looked at.
class Covering_faces
{
public:
  void clear() { faces_.clear(); }

  void add(const Corners& c)
  {
    const Vec centre = face_centre(c);
    double radius2 = 0;
    for(const Vec& p : c) radius2 = (std::max)(radius2, (p - centre).squared_length());
    faces_.push_back({ c, area_vector(c), centre, std::sqrt(radius2) });
  }

  // The cost of a witness on the face that covers it best, the first of equals, and the number of
  // that face; which one is looked at first matters for the time only.
  std::pair<double, std::size_t> best_cover(const Witness& w, std::size_t likely = 0) const
  {
    std::pair<double, std::size_t> best(1e300, 0); // distance and number
    const auto look_at = [&](std::size_t k) {
      const double d = w.distance_to(faces_[k].corners, faces_[k].area);
      if(d < best.first || (d == best.first && k < best.second)) best = { d, k };
    };
    if(likely < faces_.size()) look_at(likely);
    for(std::size_t k = 0; k < faces_.size(); ++k)
      if(k != likely && !is_beyond(faces_[k], w.p, best.first)) look_at(k);
    return { w.cost_at(best.first), best.second };
  }

private:
  struct Face
  {
    Corners corners;
    Vec area, centre;
    double radius;
  };

  // Certainly, whatever was rounded.
  static bool is_beyond(const Face& f, const Vec& p, double distance)
  {
    const double reach = distance + f.radius;
    return (p - f.centre).squared_length() > (1 + 1e-9) * reach * reach;
  }

  std::vector<Face> faces_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_COVERING_FACES_H
