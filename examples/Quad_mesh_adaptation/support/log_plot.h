// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_EXAMPLES_LOG_PLOT_H
#define QUAD_MESH_ADAPTATION_EXAMPLES_LOG_PLOT_H

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

/// Curves on two logarithmic axes, as SVG.
class Log_plot
{
public:
  struct Curve
  {
    std::string name, colour;
    std::vector<double> x, y;
    bool is_dashed = false;
  };

  std::string title, x_title, y_title;
  std::vector<Curve> curves;
  bool is_percent = false;        ///< y is a share, written in percent
  bool has_legend_beside = false; ///< instead of inside, at the top on the right

  std::string svg() const
  {
    const Range x = range(&Curve::x), y = range(&Curve::y);
    const std::string width = has_legend_beside ? "880" : "640";
    std::string s = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width +
                    "\" height=\"460\" viewBox=\"0 0 " + width +
                    " 460\" font-family=\"sans-serif\" font-size=\"13\">\n<rect width=\"" + width +
                    "\" height=\"460\" fill=\"white\"/>\n";
    s += text(320, 26, "middle", title, "font-size=\"16\"");
    s += text(0.5 * (left + right), 448, "middle", x_title);
    s += text(0, 0, "middle", y_title, "transform=\"translate(18 225) rotate(-90)\"");
    for(double tick : ticks(x)) {
      const double at = along(x, tick, left, right);
      s += line(at, top, at, bottom) + text(at, bottom + 18, "middle", number(tick));
    }
    for(double tick : ticks(y)) {
      const double at = along(y, tick, bottom, top);
      s += line(left, at, right, at) +
           text(left - 8, at + 4, "end", is_percent ? number(100 * tick) + " %" : number(tick));
    }
    for(std::size_t i = 0; i < curves.size(); ++i)
      s += drawn(curves[i], x, y, 60 + 20. * double(i));
    return s + "</svg>\n";
  }

private:
  struct Range
  {
    double low, high;
  };
  static constexpr double left = 80, right = 615, top = 45, bottom = 405; // of the axes, pixels

  Range range(std::vector<double> Curve::*values) const
  {
    Range r = { 1e300, 0 };
    for(const Curve& c : curves)
      for(double v : c.*values) r = { (std::min)(r.low, v), (std::max)(r.high, v) };
    return { r.low / 1.25, r.high * 1.25 };
  }
  // 1, 2 and 5 times the powers of ten; of a wide range the powers only.
  static std::vector<double> ticks(const Range& r)
  {
    std::vector<double> found;
    for(int power = -9; power <= 9; ++power)
      for(double digit : { 1., 2., 5. }) {
        if(digit > 1 && r.high > 500 * r.low) break;
        const double tick = digit * std::pow(10., power);
        if(tick >= r.low && tick <= r.high) found.push_back(tick);
      }
    return found;
  }
  static double along(const Range& r, double value, double from, double to)
  {
    return from + (to - from) * std::log(value / r.low) / std::log(r.high / r.low);
  }
  static std::string number(double value)
  {
    char digits[40];
    std::snprintf(digits, sizeof digits, "%.6g", value);
    return digits;
  }
  static std::string text(double x, double y, const char* anchor, const std::string& words,
                          const std::string& more = "")
  {
    return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" text-anchor=\"" + anchor + "\" " +
           more + ">" + words + "</text>\n";
  }
  static std::string line(double x1, double y1, double x2, double y2)
  {
    return "<path d=\"M" + number(x1) + " " + number(y1) + "L" + number(x2) + " " + number(y2) +
           "\" stroke=\"#ddd\" fill=\"none\"/>\n";
  }

  std::string drawn(const Curve& c, const Range& x, const Range& y, double legend) const
  {
    const double edge = has_legend_beside ? right + 275 : right;
    const std::string style = " stroke=\"" + c.colour + "\" stroke-width=\"2\"" +
                              (c.is_dashed ? " stroke-dasharray=\"6 4\"" : "");
    std::string path, dots;
    const auto dot = [&](double at_x, double at_y) {
      dots += "<circle cx=\"" + number(at_x) + "\" cy=\"" + number(at_y) + "\" r=\"4\" fill=\"" +
              c.colour + "\"/>\n";
    };
    for(std::size_t i = 0; i < c.x.size(); ++i) {
      const double at_x = along(x, c.x[i], left, right), at_y = along(y, c.y[i], bottom, top);
      path += (i == 0 ? "M" : "L") + number(at_x) + " " + number(at_y);
      dot(at_x, at_y);
    }
    dot(edge - 235, legend);
    return "<path d=\"" + path + "\" fill=\"none\"" + style + "/>\n<path d=\"M" +
           number(edge - 255) + " " + number(legend) + "h40\" fill=\"none\"" + style + "/>\n" +
           dots + text(edge - 205, legend + 4, "start", c.name);
  }
};

#endif // QUAD_MESH_ADAPTATION_EXAMPLES_LOG_PLOT_H
