// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FOUR_BOXES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FOUR_BOXES_H

#include <CGAL/Quad_mesh_adaptation/internal/Four_floats.h>
#include <CGAL/Quad_mesh_adaptation/internal/boxes.h>
#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// A point as one of four boxes sees it: somewhere in a range, for floats are less precise.
struct Point_of_floats
{
  explicit Point_of_floats(const Vec& q)
      : low{ at(q.x(), -margin), at(q.y(), -margin), at(q.z(), -margin) }, high{ at(q.x(), margin),
                                                                                 at(q.y(), margin),
                                                                                 at(q.z(), margin) }
  {
  }

  Four_floats low[3], high[3];

  // For squared distances in floats that are not more than the true ones, this factor on the true
  // ones is enough, wherever the point is within 1e15; boxes are within [0, 1].
  static constexpr double allowance = 1 + 2e-6;

private:
  static constexpr float margin = 3e-7f;

  static Four_floats at(double x, float shift) { return Four_floats(float(x) + shift); }
};

struct Four_boxes
{
  float low[3][4], high[3][4];

  void set(int i, const Box_of_floats& b)
  {
    for(int k = 0; k < 3; ++k) {
      low[k][i] = b.low[k];
      high[k][i] = b.high[k];
    }
  }
  Box_of_floats box(int i) const
  {
    Box_of_floats b;
    for(int k = 0; k < 3; ++k) {
      b.low[k] = low[k][i];
      b.high[k] = high[k][i];
    }
    return b;
  }

  Four_floats squared_distances(const Point_of_floats& p) const
  {
    const Four_floats x = along(0, p), y = along(1, p), z = along(2, p);
    return x * x + y * y + z * z;
  }

private:
  Four_floats along(int k, const Point_of_floats& p) const
  {
    return larger(larger(Four_floats(low[k]) - p.high[k], p.low[k] - Four_floats(high[k])),
                  Four_floats(0.f));
  }
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FOUR_BOXES_H
