// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_GRADED_SIZING_FIELD_H
#define CGAL_QUAD_MESH_ADAPTATION_GRADED_SIZING_FIELD_H

#include <CGAL/Quad_mesh_adaptation/internal/Sample_triangles.h>
#include <CGAL/Quad_mesh_adaptation/internal/Values_on_triangles.h>
#include <CGAL/Quad_mesh_adaptation/internal/ideal_count.h>
#include <CGAL/Quad_mesh_adaptation/internal/limit_slope.h>
#include <CGAL/Quad_mesh_adaptation/internal/mesh_arrays.h>
#include <CGAL/Quad_mesh_adaptation/internal/size_at.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {

/// \brief A sizing field that follows another one but grows by at most `growth` per unit of
/// distance over a mesh.
///
/// At no point it exceeds the given size h, and up to a tolerance it is the largest such field
/// g with |g(p) - g(q)| <= growth * d(p, q), d being the distance over the surface of the mesh:
/// g(p) = min over q of h(q) + growth * d(p, q), as in P.-O. Persson, "Mesh size functions for
/// implicit geometries and PDE-based gradient limiting" (2006).  Two sheets of a surface that are
/// close in space do not influence each other.  Quads follow a growth of 0.2 to 0.3 well.
///
/// The given size is sampled at the vertices of a triangulated copy of the mesh, refined until no
/// edge is longer than half of the graded size at it, or than a sixth where the bound begins to
/// count.  Where `is_resolved()`, the answer is off by at most about a quarter of the growth times
/// the size, plus what the given size changes over a twelfth of it where that is steeper; a dip
/// that lies between the samples, at least 16384 triangles of them, is not seen.
///
/// Copies share their data.  `operator()` may be called from several threads if the given size
/// may.  Points off the mesh are answered by the nearest point's bound.
template <class SizingField>
class Graded_sizing_field
{
public:
  /// \param mesh a quad mesh, a model of `FaceListGraph` and `HalfedgeListGraph`; it is copied.
  /// \param sizing the size to follow: a number, or a callable `double(const Point_3&)`, kept by
  ///        value.
  /// \param growth the largest slope, not negative.
  /// \param np optional: `vertex_point_map`.
  /// \param most_samples the refinement of the samples stops before it exceeds this number, the
  ///        longest edges relative to their size first; then `is_resolved()` is `false`.
  /// \throws std::invalid_argument if `growth` is negative or not finite, a face is not a quad, a
  ///         coordinate is not finite, or the mesh has no face with an area;
  ///         std::domain_error if a size is not a positive finite number;
  ///         exceptions of `sizing` pass through.
  ///
  /// O(n log n) for n samples, ten to thirty for each face that the graded size asks for.
  template <class QuadMesh, class NP = parameters::Default_named_parameters>
  Graded_sizing_field(const QuadMesh& mesh, SizingField sizing, double growth,
                      const NP& np = parameters::default_values(),
                      std::size_t most_samples = 500000)
      : sizing_(std::move(sizing))
  {
    if(!(std::isfinite(growth) && growth >= 0))
      throw std::invalid_argument("Graded_sizing_field: the slope is not a finite number >= 0");
    const auto points = internal::vertex_points(mesh, np);
    using Point = typename boost::property_traits<std::decay_t<decltype(points)>>::value_type;
    internal::Quad_arrays arrays = internal::quad_arrays(mesh, points, "Graded_sizing_field");
    for(const Vec& p : arrays.points)
      if(!internal::is_finite(p))
        throw std::invalid_argument("Graded_sizing_field: a coordinate is not finite");
    internal::Sample_triangles samples(std::move(arrays.points), arrays.quads);
    data_ = std::make_shared<const Data>(
        std::move(samples),
        [this](const Vec& p) {
          return checked(internal::size_at(sizing_, Point(p.x(), p.y(), p.z())));
        },
        growth, most_samples);
  }

  /// Target edge length at a point (anything with `x()`, `y()` and `z()` that the given size
  /// takes).
  template <class Point>
  double operator()(const Point& p) const
  {
    return (std::min)(internal::size_at(sizing_, p),
                      data_->bound_at(Vec(CGAL::to_double(p.x()), CGAL::to_double(p.y()),
                                          CGAL::to_double(p.z()))));
  }

  /// Number of points at which the given size was taken.
  std::size_t number_of_samples() const { return data_->number_of_samples; }
  /// The largest share of the samples' edge length in the graded size there, three times as much
  /// where the bound begins to count; 0.5 at most if `is_resolved()`.
  double largest_spacing() const { return data_->largest_spacing; }
  /// Whether the samples lie as close as the size asks for; if not, `most_samples` was too few.
  bool is_resolved() const { return data_->largest_spacing <= wanted_spacing; }
  /// Share of the mesh's area, about, where the given size is larger than the graded one by more
  /// than 1 %: where it grows faster than `growth`.
  double lowered_share() const { return data_->lowered_share; }

private:
  using Vec = internal::Vec;
  static constexpr double wanted_spacing = 0.5;
  static constexpr double finer_at_starts = 3; // a steep given size has its least value there

  static double checked(double h)
  {
    if(!(std::isfinite(h) && h > 0))
      throw std::domain_error("Graded_sizing_field: a size is not a positive finite number");
    return h;
  }

  struct Data
  {
    Data(internal::Sample_triangles samples, const internal::Size_function& size, double growth,
         std::size_t most_samples)
    {
      std::vector<double> given;
      while(refine(samples, size, growth, most_samples, given)) {
      }
      number_of_samples = samples.points().size();
      collect(samples, given);
      if(triangles.empty())
        throw std::invalid_argument("Graded_sizing_field: the mesh has no face with an area");
      graded = std::make_unique<const internal::Values_on_triangles>(std::move(triangles));
    }

    double bound_at(const Vec& p) const { return (*graded)(p); }

    std::size_t number_of_samples = 0;
    double largest_spacing = 0, lowered_share = 0;

  private:
    // Grades the present samples, and adds samples where they are too far apart; false at the end.
    bool refine(internal::Sample_triangles& samples, const internal::Size_function& size,
                double growth, std::size_t most_samples, std::vector<double>& given)
    {
      for(std::size_t i = given.size(); i < samples.points().size(); ++i)
        given.push_back(size(samples.points()[i]));
      bounds = given;
      internal::limit_slope(samples.points(), samples.triangles(), growth, bounds);

      const auto& edges = samples.edges();
      std::vector<double> spacing; // of each edge
      largest_spacing = 0;
      const std::vector<char> is_start = starts(edges, given);
      for(const auto& e : edges) {
        spacing.push_back((is_start[e.source] || is_start[e.target] ? finer_at_starts : 1.) *
                          e.length / (std::min)(bounds[e.source], bounds[e.target]));
        largest_spacing = (std::max)(largest_spacing, spacing.back());
      }
      const bool is_few = samples.triangles().size() < internal::least_triangles;
      double threshold =
          is_few ? (std::min)(wanted_spacing, 0.5 * largest_spacing) : wanted_spacing;
      const std::size_t room =
          most_samples > bounds.size() ? (most_samples - bounds.size()) / 2 : 0; // 2: the closure
      std::vector<double> wanted;
      for(double s : spacing)
        if(s > threshold) wanted.push_back(s);
      if(wanted.empty() || room < bounds.size() / 10) return false;
      if(wanted.size() > room) {
        std::nth_element(wanted.begin(), wanted.begin() + long(room), wanted.end(),
                         std::greater<double>());
        threshold = wanted[room];
      }
      std::vector<char> is_marked;
      for(double s : spacing) is_marked.push_back(s > threshold);
      if(std::count(is_marked.begin(), is_marked.end(), 1) == 0) return false;
      samples.split(std::move(is_marked));
      return true;
    }

    // The samples from which a lowered neighbour gets its bound.
    std::vector<char> starts(const std::vector<internal::Sample_triangles::Edge>& edges,
                             const std::vector<double>& given) const
    {
      const auto is_lowered = [&](internal::Index v) { return given[v] > 1.01 * bounds[v]; };
      std::vector<char> result(bounds.size(), false);
      for(const auto& e : edges)
        if(is_lowered(e.source) != is_lowered(e.target))
          result[is_lowered(e.source) ? e.target : e.source] = true;
      return result;
    }

    void collect(const internal::Sample_triangles& samples, const std::vector<double>& given)
    {
      double area = 0, lowered = 0;
      for(const auto& t : samples.triangles()) {
        const internal::Valued_triangle c = { { samples.points()[t[0]], samples.points()[t[1]],
                                                samples.points()[t[2]] },
                                              { bounds[t[0]], bounds[t[1]], bounds[t[2]] } };
        const double twice = internal::norm(
            internal::cross(c.corners[1] - c.corners[0], c.corners[2] - c.corners[0]));
        if(!(twice > 0)) continue;
        area += twice;
        for(internal::Index v : t)
          if(given[v] > 1.01 * bounds[v]) lowered += twice / 3;
        triangles.push_back(c);
      }
      lowered_share = area > 0 ? lowered / area : 0;
    }

    std::vector<double> bounds;                       // of the samples
    std::vector<internal::Valued_triangle> triangles; // moved into the function
    std::unique_ptr<const internal::Values_on_triangles> graded;
  };

  SizingField sizing_;
  std::shared_ptr<const Data> data_;
};

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_GRADED_SIZING_FIELD_H
