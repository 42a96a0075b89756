// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_BOXES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_BOXES_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Along the axes; empty at first.
struct Box
{
  Vec low = Vec(1, 1, 1) * std::numeric_limits<double>::infinity(), high = -low;

  Box() = default;
  // Around all of a range of points.
  template <typename Points>
  explicit Box(const Points& points)
  {
    for(const Vec& p : points) add(p);
  }

  void add(const Vec& p)
  {
    low = Vec((std::min)(low.x(), p.x()), (std::min)(low.y(), p.y()), (std::min)(low.z(), p.z()));
    high =
        Vec((std::max)(high.x(), p.x()), (std::max)(high.y(), p.y()), (std::max)(high.z(), p.z()));
  }

  bool is_empty() const { return !(low.x() <= high.x()); }
  Vec extent() const { return high - low; }
  double squared_distance(const Vec& p) const { return squared_distance(p, p); }
  // From another one; infinite if one of both is empty.
  double squared_distance(const Box& o) const { return squared_distance(o.low, o.high); }
  double longest_side() const
  {
    const Vec size = extent();
    return (std::max)({ size.x(), size.y(), size.z() });
  }
  int longest_axis() const
  {
    const Vec size = extent();
    if(size.x() >= size.y() && size.x() >= size.z()) return 0;
    return size.y() >= size.z() ? 1 : 2;
  }

private:
  double squared_distance(const Vec& other_low, const Vec& other_high) const
  {
    double d2 = 0;
    for(int i = 0; i < 3; ++i) {
      const double off = (std::max)({ low[i] - other_high[i], other_low[i] - high[i], 0. });
      d2 += off * off;
    }
    return d2;
  }
};

struct Box_of_floats
{
  std::array<float, 3> low, high;

  // Empty: nothing is near to it.
  Box_of_floats()
  {
    low.fill((std::numeric_limits<float>::max)());
    high.fill(std::numeric_limits<float>::lowest());
  }
  // Rounded outwards.
  Box_of_floats(const Vec& a, const Vec& b)
  {
    constexpr float none = std::numeric_limits<float>::infinity();
    for(int i = 0; i < 3; ++i) {
      low[i] = std::nextafter(float(a[i]), -none);
      high[i] = std::nextafter(float(b[i]), none);
    }
  }

  void add(const Box_of_floats& b)
  {
    for(int i = 0; i < 3; ++i) {
      low[i] = (std::min)(low[i], b.low[i]);
      high[i] = (std::max)(high[i], b.high[i]);
    }
  }

  double squared_distance(const Vec& q) const
  {
    double sum = 0;
    for(int i = 0; i < 3; ++i) {
      const double x = (std::max)({ double(low[i]) - q[i], q[i] - double(high[i]), 0. });
      sum += x * x;
    }
    return sum;
  }
};

// Triangles to be sorted by place.
struct Triangle_centre
{
  Vec point;
  Index triangle;
};

// Sorts those from first to last into two halves along the longest side of their box; returns the
// middle.
inline std::size_t halve(std::vector<Triangle_centre>& centres, std::size_t first, std::size_t last)
{
  const auto at = [&](std::size_t i) { return centres.begin() + std::ptrdiff_t(i); };
  const std::size_t middle = first + (last - first) / 2;
  Box box;
  for(auto c = at(first); c != at(last); ++c) box.add(c->point);
  const int axis = box.longest_axis();
  std::nth_element(at(first), at(middle), at(last),
                   [axis](const Triangle_centre& s, const Triangle_centre& t) {
                     const double x = s.point[axis], y = t.point[axis];
                     return x < y || (x == y && s.triangle < t.triangle);
                   });
  return middle;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_BOXES_H
