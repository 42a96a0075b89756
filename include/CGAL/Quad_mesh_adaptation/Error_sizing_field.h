// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_ERROR_SIZING_FIELD_H
#define CGAL_QUAD_MESH_ADAPTATION_ERROR_SIZING_FIELD_H

#include <CGAL/Quad_mesh_adaptation/Nodal_sizing_field.h>
#include <CGAL/Quad_mesh_adaptation/Size_range.h>
#include <CGAL/Quad_mesh_adaptation/internal/Face_arrays.h>
#include <CGAL/Quad_mesh_adaptation/internal/optimal_sizes.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {

/// What the sizes of an `Error_sizing_field` are to reach.
struct Error_target
{
  enum class Kind
  {
    error,
    reduction,
    faces
  };
  Kind kind;
  double value;

  /// The error of the whole mesh, in units of the indicators.
  static Error_target error(double e) { return { Kind::error, e }; }
  /// The new error over the present one.
  static Error_target reduction(double share) { return { Kind::reduction, share }; }
  /// About so many faces, with the least error.
  static Error_target number_of_faces(double n) { return { Kind::faces, n }; }
};

/// How the error depends on the size, and within what the sizes stay.
struct Error_sizing_options
{
  /// p, the error of the whole going like h^p: the degree of the elements for the energy norm.
  double order = 1;
  /// A size is at most so many times the present one, and at least this part of it: an estimate
  /// says little of a mesh that is very different.  Repeat to go further.
  double largest_change = 4;
  Size_range range = {};
};

/// \brief A sizing field from error indicators, for a given error, reduction or number of faces.
///
/// The squares of the indicators add up to the square of the error.  Sizes are such that all new
/// faces have the same error, which takes the fewest faces; see E. Onate and G. Bugeda, "A study
/// of mesh optimality criteria in adaptive finite element analysis" (1993).  A face's present size
/// is the square root of its area; the size at a vertex is the geometric mean over the faces around
/// it, and between vertices the field interpolates as `Nodal_sizing_field` does.  It keeps a copy
/// of the mesh: adapting the mesh to it is safe.  Where `largest_change` or the range forbid what
/// the target asks for, the other faces make up for the former, and nothing does for the latter.
class Error_sizing_field
{
public:
  /// \param mesh a polygon mesh, model of `FaceListGraph` and `HalfedgeListGraph`.
  /// \param errors a readable property map from faces, or from vertices, to indicators that are not
  ///        negative.  The square at a vertex is spread evenly over the faces around it.
  /// \param target positive.
  /// \param np optional: `vertex_point_map`.
  /// \throws std::invalid_argument if an indicator, the target, the options or a coordinate is not
  ///         valid, all indicators are 0, or a face has no area.
  ///
  /// Linear in the size of the mesh, but for the search tree.
  template <class PolygonMesh, class ErrorMap, class NP = parameters::Default_named_parameters>
  Error_sizing_field(const PolygonMesh& mesh, const ErrorMap& errors, const Error_target& target,
                     const Error_sizing_options& options = Error_sizing_options(),
                     const NP& np = parameters::default_values())
      : field_(make(mesh, errors, target, options, np))
  {
  }

  /// Target edge length at a point; always positive.
  template <class Point>
  double operator()(const Point& p) const
  {
    return field_(p);
  }

private:
  using Face_arrays = internal::Face_arrays;

  static void require(bool condition, const char* otherwise)
  {
    if(!condition) throw std::invalid_argument(std::string("Error_sizing_field: ") + otherwise);
  }

  static double checked(double e)
  {
    require(e >= 0 && std::isfinite(e), "an indicator is negative or not finite");
    return e;
  }

  template <class PolygonMesh, class ErrorMap>
  static std::vector<double> face_errors(const PolygonMesh& mesh, const ErrorMap& errors,
                                         const Face_arrays& arrays)
  {
    using Key = typename boost::property_traits<ErrorMap>::key_type;
    std::vector<double> result;
    if constexpr(std::is_same_v<Key, typename boost::graph_traits<PolygonMesh>::face_descriptor>) {
      for(auto f : faces(mesh)) result.push_back(checked(CGAL::to_double(get(errors, f))));
    } else {
      std::vector<double> squares(arrays.points.size()), count(arrays.points.size(), 0.);
      std::size_t i = 0;
      for(auto v : vertices(mesh))
        squares[i++] = std::pow(checked(CGAL::to_double(get(errors, v))), 2);
      for(internal::Index v : arrays.origin) ++count[v];
      result.assign(std::size_t(arrays.number_of_faces()), 0.);
      for(internal::Index h = 0; h < arrays.number_of_halfedges(); ++h)
        result[arrays.face[h]] += squares[arrays.origin[h]] / count[arrays.origin[h]];
      for(double& e : result) e = std::sqrt(e);
    }
    return result;
  }

  static void check(const Error_target& target, const Error_sizing_options& options)
  {
    require(target.value > 0 && std::isfinite(target.value), "the target is not positive");
    require(options.order > 0 && std::isfinite(options.order), "the order is not positive");
    require(options.largest_change > 1 && std::isfinite(options.largest_change),
            "the largest change is not above 1");
    options.range.check();
  }

  template <class PolygonMesh, class ErrorMap, class NP>
  static Nodal_sizing_field make(const PolygonMesh& mesh, const ErrorMap& errors,
                                 const Error_target& target, const Error_sizing_options& options,
                                 const NP& np)
  {
    check(target, options);
    const Face_arrays arrays = internal::face_arrays(mesh, np, "Error_sizing_field");
    internal::Optimal_sizes optimal(face_errors(mesh, errors, arrays), options.order,
                                    options.largest_change);
    aim_at(target, optimal);
    return internal::nodal_sizing_field(mesh, nodal_sizes(arrays, optimal, options.range), np);
  }

  static void aim_at(const Error_target& target, internal::Optimal_sizes& optimal)
  {
    // adapted meshes have about this many faces for each that their sizes ask for
    constexpr double faces_per_ideal_face = 1.08;
    const double present = optimal.present_error();
    require(present > 0, "all indicators are 0");
    if(target.kind == Error_target::Kind::faces)
      optimal.set_number_of_faces(target.value / faces_per_ideal_face);
    else
      optimal.set_error(target.value * (target.kind == Error_target::Kind::error ? 1. : present));
  }

  static std::vector<double> nodal_sizes(const Face_arrays& arrays,
                                         const internal::Optimal_sizes& optimal,
                                         const Size_range& range)
  {
    std::vector<double> log_sum(arrays.points.size(), 0.), count(arrays.points.size(), 0.);
    for(internal::Index f = 0; f < arrays.number_of_faces(); ++f) {
      const double area = internal::norm(arrays.area_vector(f));
      require(area > 0, "a face has no area");
      const double size = range.clamp(std::sqrt(area) * optimal.ratio(std::size_t(f)));
      for(internal::Index h = arrays.first[f]; h < arrays.first[f + 1]; ++h) {
        log_sum[arrays.origin[h]] += std::log(size);
        ++count[arrays.origin[h]];
      }
    }
    std::vector<double> sizes(arrays.points.size(), 1.); // an isolated vertex takes part in nothing
    for(std::size_t v = 0; v < sizes.size(); ++v)
      if(count[v] > 0) sizes[v] = std::exp(log_sum[v] / count[v]);
    return sizes;
  }

  Nodal_sizing_field field_;
};

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_ERROR_SIZING_FIELD_H
