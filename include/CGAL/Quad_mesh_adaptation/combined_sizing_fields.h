// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_COMBINED_SIZING_FIELDS_H
#define CGAL_QUAD_MESH_ADAPTATION_COMBINED_SIZING_FIELDS_H

#include <CGAL/Quad_mesh_adaptation/Size_range.h>
#include <CGAL/Quad_mesh_adaptation/internal/size_at.h>

#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace CGAL {
namespace Quad_mesh_adaptation {

namespace internal {

// A value that is no number stays, whatever comes after it, so that it is refused by whoever asks.
inline double smaller_or_nan(double a, double b) { return a <= b || std::isnan(a) ? a : b; }
inline double larger_or_nan(double a, double b) { return a >= b || std::isnan(a) ? a : b; }

} // namespace internal

/// \brief The smallest of several sizing fields at each point: every wish is respected.
///
/// Each field is a number or a callable `double(const Point_3&)`, kept by value; so the fields of
/// this header nest.  A value that is not a number is passed on.  What the fields throw passes
/// through.
template <class... SizingFields>
class Minimum_sizing_field
{
  static_assert(sizeof...(SizingFields) > 0, "at least one field");

public:
  explicit Minimum_sizing_field(SizingFields... fields) : fields_(std::move(fields)...) {}

  template <class Point>
  double operator()(const Point& p) const
  {
    return std::apply(
        [&p](const auto&... f) {
          double result = std::numeric_limits<double>::infinity();
          ((result = internal::smaller_or_nan(result, internal::size_at(f, p))), ...);
          return result;
        },
        fields_);
  }

private:
  std::tuple<SizingFields...> fields_;
};

/// \brief The largest of several sizing fields at each point: a field holds only where no other one
/// allows more.  See `Minimum_sizing_field`.
template <class... SizingFields>
class Maximum_sizing_field
{
  static_assert(sizeof...(SizingFields) > 0, "at least one field");

public:
  explicit Maximum_sizing_field(SizingFields... fields) : fields_(std::move(fields)...) {}

  template <class Point>
  double operator()(const Point& p) const
  {
    return std::apply(
        [&p](const auto&... f) {
          double result = -std::numeric_limits<double>::infinity();
          ((result = internal::larger_or_nan(result, internal::size_at(f, p))), ...);
          return result;
        },
        fields_);
  }

private:
  std::tuple<SizingFields...> fields_;
};

/// A sizing field brought within bounds, see `Minimum_sizing_field`.
template <class SizingField>
class Clamped_sizing_field
{
public:
  /// \throws std::invalid_argument if the range is none.
  Clamped_sizing_field(SizingField field, const Size_range& range)
      : field_(std::move(field)), range_(range)
  {
    range.check();
  }

  template <class Point>
  double operator()(const Point& p) const
  {
    const double h = internal::size_at(field_, p);
    return std::isnan(h) ? h : range_.clamp(h);
  }

private:
  SizingField field_;
  Size_range range_;
};

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_COMBINED_SIZING_FIELDS_H
