// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "growth_shapes.h"

#include <cmath>

namespace growth_shapes {

Shape strip(Index n)
{
  Shape s = plate(n, 1);
  s.name = "strip";
  return s;
}

Shape fan(Index n)
{
  Shape s{ "fan", { Vec(0, 0, 0) }, {} };
  for(Index i = 0; i < 2 * n; ++i)
    s.points.emplace_back(std::cos(pi * i / n), std::sin(pi * i / n), 0);
  for(Index i = 0; i < n; ++i)
    s.quads.push_back({ 0, 2 * i + 1, 2 * i + 2, (2 * i + 2) % (2 * n) + 1 });
  return s;
}

Shape half_fan(Index n)
{
  Shape s{ "half a fan", { Vec(0, 0, 0) }, {} };
  for(Index i = 0; i <= 2 * n; ++i)
    s.points.emplace_back(std::cos(pi * i / (2 * n)), std::sin(pi * i / (2 * n)), 0);
  for(Index i = 0; i < n; ++i) s.quads.push_back({ 0, 2 * i + 1, 2 * i + 2, 2 * i + 3 });
  return s;
}

Shape kites(Index n)
{
  Shape s{ "kites", { Vec(0, 0, 1), Vec(0, 0, -1) }, {} };
  const auto id = [n](Index i) { return 2 + i % (2 * n); };
  for(Index i = 0; i < 2 * n; ++i)
    s.points.emplace_back(std::cos(pi * i / n), std::sin(pi * i / n), 0);
  for(Index i = 0; i < 2 * n; i += 2) {
    s.quads.push_back({ 0, id(i), id(i + 1), id(i + 2) });
    s.quads.push_back({ 1, id(i + 3), id(i + 2), id(i + 1) });
  }
  return s;
}

Shape polar_disk(Index n, Index rings)
{
  return polar(n, rings, Vec(0, 0, 0), [rings](Index j, double a) {
    const double r = double(j + 1) / (rings + 1);
    return Vec(r * std::cos(a), r * std::sin(a), 0);
  });
}

Shape polar_sphere(Index n, Index rings)
{
  Shape s = polar(n, rings, Vec(0, 0, 1), [rings](Index j, double a) {
    const double b = pi * (j + 1) / (rings + 2);
    return Vec(std::sin(b) * std::cos(a), std::sin(b) * std::sin(a), std::cos(b));
  });
  s.name = "polar sphere";
  const Index pole = Index(s.points.size()), last = 1 + 2 * n * rings;
  s.points.emplace_back(0, 0, -1);
  for(Index i = 0; i < 2 * n; i += 2)
    s.quads.push_back({ pole, last + (i + 2) % (2 * n), last + i + 1, last + i });
  return s;
}

Shape screw(Index n, Index around)
{
  Shape s{ "screw", {}, {} };
  const double radius = around / (2 * pi);
  for(Index k = 0; k <= n + around; ++k) {
    const double a = 2 * pi * k / around;
    s.points.emplace_back(radius * std::cos(a), radius * std::sin(a), double(k) / around);
  }
  for(Index k = 0; k < n; ++k) s.quads.push_back({ k, k + 1, k + 1 + around, k + around });
  return s;
}

Shape archipelago(Index side)
{
  Shape s{ "archipelago", {}, {} };
  for(Index y = 0; y < side; ++y)
    for(Index x = 0; x < side; ++x)
      append(s, grid("", 2, 2, [=](Index i, Index j) { return Vec(3 * x + i, 3 * y + j, 0); }),
             false);
  return s;
}

} // namespace growth_shapes
