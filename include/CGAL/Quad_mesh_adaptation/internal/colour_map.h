// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_COLOUR_MAP_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_COLOUR_MAP_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

using Colour = std::array<double, 3>; // red, green, blue in [0, 1], as screens want them

inline double screen_value(double linear)
{
  const double v = (std::min)((std::max)(linear, 0.), 1.);
  return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

// From Ottosson's Oklab, in polar form: lightness in [0, 1], chroma, hue in degrees.  Steps of
// equal length in it look equal.
inline Colour from_oklch(double lightness, double chroma, double hue)
{
  const double angle = hue * pi / 180;
  const double a = chroma * std::cos(angle), b = chroma * std::sin(angle);
  const auto cube = [](double v) { return v * v * v; };
  const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
  const double m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
  const double s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
  return { screen_value(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
           screen_value(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
           screen_value(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s) };
}

// From dark violet over blue and green to light yellow, lightness growing evenly, so that it also
// reads in grey; `t` in [0, 1].
inline Colour size_colour(double t)
{
  struct Stop
  {
    double lightness, chroma, hue;
  };
  static constexpr std::array<Stop, 5> stops = { { { 0.28, 0.12, 302 },
                                                   { 0.445, 0.11, 265 },
                                                   { 0.61, 0.085, 205 },
                                                   { 0.775, 0.13, 150 },
                                                   { 0.94, 0.17, 105 } } };
  const double x = (std::min)((std::max)(t, 0.), 1.) * (stops.size() - 1);
  const std::size_t i = (std::min)(static_cast<std::size_t>(x), stops.size() - 2);
  const double w = x - double(i);
  const auto mix = [w](double a, double b) { return a + w * (b - a); };
  return from_oklch(mix(stops[i].lightness, stops[i + 1].lightness),
                    mix(stops[i].chroma, stops[i + 1].chroma), mix(stops[i].hue, stops[i + 1].hue));
}

inline std::string hex(const Colour& colour, double shade = 1)
{
  static const char digits[] = "0123456789abcdef";
  std::string text = "#";
  for(const double value : colour) {
    const int v =
        static_cast<int>(std::lround(255 * (std::min)((std::max)(value * shade, 0.), 1.)));
    text += digits[v / 16];
    text += digits[v % 16];
  }
  return text;
}

// Sizes to [0, 1]: by their logarithm when they span more than a factor of ten.
class Size_scale
{
public:
  Size_scale() = default;
  Size_scale(double min, double max) : min_(min), max_(max), logarithmic_(min > 0 && max > 10 * min)
  {
  }

  double operator()(double size) const
  {
    if(!(max_ > min_)) return 0.5;
    return logarithmic_ ? std::log(size / min_) / std::log(max_ / min_)
                        : (size - min_) / (max_ - min_);
  }
  double min() const { return min_; }
  double max() const { return max_; }

  /// Round sizes to mark on a colour bar, the ends included.
  std::vector<double> ticks() const
  {
    std::vector<double> values = { min_ };
    if(!(max_ > min_)) return values;
    const double decade = std::pow(10., std::floor(std::log10(logarithmic_ ? min_ : max_ - min_)));
    if(logarithmic_) {
      for(double d = decade; d < max_; d *= 10)
        for(const double step : { 1., 2., 5. }) add_tick(values, d * step);
    } else {
      const double range = (max_ - min_) / decade;
      const double step = decade * (range > 5 ? 2 : range > 2.5 ? 1 : 0.5);
      for(double v = std::ceil(min_ / step) * step; v < max_; v += step) add_tick(values, v);
    }
    values.push_back(max_);
    return values;
  }

private:
  // not where its label would touch that of an end or of the tick before
  void add_tick(std::vector<double>& values, double value) const
  {
    const double t = (*this)(value);
    if(t - (*this)(values.back()) > 0.07 && t < 0.93) values.push_back(value);
  }

  double min_ = 0, max_ = 0;
  bool logarithmic_ = false;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_COLOUR_MAP_H
