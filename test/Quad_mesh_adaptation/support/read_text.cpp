// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "read_text.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace read_test {

Read_result read_text(const std::string& extension, const std::string& text, Mesh& mesh)
{
  const Temporary_file file(extension, text);
  return read_quad_mesh(file.name(), mesh);
}

Read_result read_off(const std::string& text)
{
  Mesh mesh;
  return read_text(".off", text, mesh);
}

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

std::string band(int n, bool is_twisted)
{
  std::string text = "OFF\n" + std::to_string(2 * n) + ' ' + std::to_string(n) + " 0\n";
  for(int i = 0; i < n; ++i) {
    const double angle = 2 * 3.14159265358979 * i / n, turn = is_twisted ? angle / 2 : 0;
    for(const double side : { -0.3, 0.3 }) {
      const double r = 2 + side * std::cos(turn);
      text += std::to_string(r * std::cos(angle)) + ' ' + std::to_string(r * std::sin(angle)) +
              ' ' + std::to_string(side * std::sin(turn) + (is_twisted ? 0 : side)) + '\n';
    }
  }
  for(int i = 0; i < n; ++i) {
    int c = 2 * ((i + 1) % n), d = c + 1;
    if(is_twisted && i == n - 1) std::swap(c, d);
    text += "4 " + std::to_string(2 * i) + ' ' + std::to_string(2 * i + 1) + ' ' +
            std::to_string(d) + ' ' + std::to_string(c) + '\n';
  }
  return text;
}

} // namespace read_test
