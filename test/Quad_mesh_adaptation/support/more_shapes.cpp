// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "more_shapes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace more_shapes {

Shape moved(Shape s, const Vec& by)
{
  for(Vec& p : s.points) p = p + by;
  return s;
}

namespace {

Shape turned_over(Shape s)
{
  for(Quad& q : s.quads) std::swap(q[1], q[3]);
  return s;
}

} // namespace

Shape closed_cylinder(Index n)
{
  Shape s = open_cylinder(4 * n, n);
  append(s, moved(disk(n, n / 2), Vec(0, 0, 2)), true);
  append(s, turned_over(disk(n, n / 2)), true);
  s.name = "closed cylinder";
  return s;
}

Shape truncated_cone(Index n)
{
  Shape s = closed_cylinder(n);
  for(Vec& p : s.points) p = Vec((1 - 0.4 * p.z()) * p.x(), (1 - 0.4 * p.z()) * p.y(), p.z());
  s.name = "truncated cone";
  return s;
}

Shape dome(Index n)
{
  Shape s = disk(n, n / 2);
  for(Vec& p : s.points) p = Vec(p.x(), p.y(), 0.8 * (1 - p.x() * p.x() - p.y() * p.y()));
  const Shape square = grid("", n, n, [n](Index i, Index j) {
    const double u = std::tan((2. * i / n - 1) * pi / 4), v = std::tan((2. * j / n - 1) * pi / 4);
    const double far = (std::max)(std::abs(u), std::abs(v)), r = std::hypot(u, v);
    return r > 0 ? Vec(u * far / r, v * far / r, 0) : Vec(0, 0, 0);
  });
  append(s, turned_over(square), true);
  s.name = "dome";
  return s;
}

Shape paraboloid(Index n)
{
  Shape s = disk(n, n);
  for(Vec& p : s.points) p = Vec(p.x(), p.y(), 2 * (p.x() * p.x() + p.y() * p.y()));
  s.name = "paraboloid";
  return s;
}

double ridge_at(double x) { return 0.4 * std::sin(x); }

Shape ridge(Index n)
{
  return grid("ridge", 6 * n, 4 * n, [n](Index i, Index j) {
    const double x = double(i) / n, v = double(j) / n - 2;
    return Vec(x, v + (1 - std::abs(v) / 2) * ridge_at(x), 2 - std::abs(v) * 1.2);
  });
}

Shape two_sheets(double gap)
{
  Shape s = plate(8, 8);
  append(s, moved(turned_over(plate(8, 8)), Vec(0, 0, -gap)), false);
  s.name = "two sheets";
  return s;
}

Shape two_spheres(Index n, double gap)
{
  Shape s = sphere(n);
  append(s, moved(sphere(n), Vec(2 + gap, 0, 0)), false);
  s.name = "two spheres";
  return s;
}

Shape thin_box(double thickness)
{
  Shape s = voxels("thin box", { 8, 8, 1 }, [](Index, Index, Index) { return true; });
  for(Vec& p : s.points) p = Vec(p.x(), p.y(), thickness * p.z());
  return s;
}

Shape bracket()
{
  return voxels("bracket", { 8, 6, 8 }, [](Index x, Index y, Index z) {
    const bool hole = x >= 5 && x < 7 && y >= 2 && y < 4;
    return (x < 3 || z < 3) && !hole;
  });
}

} // namespace more_shapes
