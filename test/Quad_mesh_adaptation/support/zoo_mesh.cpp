// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "zoo_mesh.h"

#include <cmath>
#include <cstdlib>
#include <random>
#include <string>

namespace zoo_mesh {

unsigned seed(unsigned otherwise)
{
  const char* given = std::getenv("QUAD_MESH_SEED");
  return given ? unsigned(std::stoul(given)) : otherwise;
}

int count(const char* variable, int otherwise)
{
  const char* given = std::getenv(variable);
  return given ? std::stoi(given) : otherwise;
}

double mean_edge(const Shape& s)
{
  double sum = 0;
  for(const Quad& q : s.quads)
    for(int i = 0; i < 4; ++i)
      sum += std::sqrt((s.points[q[(i + 1) % 4]] - s.points[q[i]]).squared_length());
  return sum / (4. * double(s.quads.size()));
}

Bumps random_bumps(const Shape& s, std::mt19937& random)
{
  const auto real = [&](double a, double b) { // the same on every standard library
    return a + (b - a) * (random() / double(std::mt19937::max()));
  };
  Bumps h;
  const double edge = mean_edge(s);
  h.base = edge * std::exp(real(-0.9, 1.2));
  const int n = int(random() % 4);
  for(int i = 0; i < n; ++i) {
    const Vec centre = s.points[random() % s.points.size()];
    const double radius = edge * real(0.8, 4), factor = std::exp(real(-1.4, 0.9));
    h.bumps.push_back({ centre, radius, factor });
  }
  return h;
}

} // namespace zoo_mesh
