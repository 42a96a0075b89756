// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_NODAL_FIELD_H
#define CGAL_QUAD_MESH_ADAPTATION_NODAL_FIELD_H

#include <CGAL/Quad_mesh_adaptation/internal/Values_on_triangles.h>
#include <CGAL/Quad_mesh_adaptation/internal/append_polygon.h>
#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>
#include <CGAL/Quad_mesh_adaptation/internal/mesh_arrays.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {

/// \brief A field given by numbers at the vertices of a mesh, to carry it over to another one.
///
/// The numbers are interpolated linearly over a triangulated copy of the mesh, at the point of it
/// that is nearest to the one asked for.  So a field of an initial mesh, made before that is
/// adapted, gives the values at the vertices of the adapted mesh: those that have not moved keep
/// theirs, linear functions on a plane are kept, nothing exceeds the range of the values around.
/// Sums and integrals are not conserved.  Where sheets lie closer to each other than the new
/// vertices to their surface, a value may come from the other sheet.
///
/// Copies share their data.  `operator()` may be called from several threads.
class Nodal_field
{
public:
  /// \param mesh a model of `FaceListGraph` and `HalfedgeListGraph` with at least one face of
  ///        non-zero area: triangles, quads (cut along the diagonal that keeps the triangles well
  ///        oriented) or polygons (cut around the mean of their vertices).
  /// \param values a readable property map from vertices to numbers.
  /// \param np optional: `vertex_point_map`.
  /// \throws std::invalid_argument if a value or a coordinate is not finite, or no face has an
  ///         area.
  ///
  /// Linear in the size of the mesh, but for the search tree.
  template <class PolygonMesh, class VertexValueMap,
            class NP = parameters::Default_named_parameters>
  Nodal_field(const PolygonMesh& mesh, const VertexValueMap& values,
              const NP& np = parameters::default_values())
  {
    const auto points = internal::vertex_points(mesh, np);
    using Descriptor = typename boost::graph_traits<PolygonMesh>::vertex_descriptor;
    std::unordered_map<Descriptor, Corner> corner;
    for(Descriptor v : vertices(mesh))
      corner.emplace(v, checked_corner(get(points, v), CGAL::to_double(get(values, v))));
    Soup soup;
    std::vector<Corner> polygon;
    for(auto f : faces(mesh)) {
      polygon.clear();
      for(Descriptor v : vertices_around_face(halfedge(f, mesh), mesh))
        polygon.push_back(corner.at(v));
      internal::append_polygon(polygon, soup);
    }
    set_data(std::move(soup));
  }

  /// The same from arrays, for a mesh that need not be manifold or oriented.
  /// \param points anything with `x()`, `y()` and `z()`.
  /// \param polygons the numbers of the points of each, at least three.
  /// \param values one for each point.
  /// \throws std::invalid_argument also if the numbers of points and values differ, or a number of
  ///         a point is out of range.
  template <class Point, class Number>
  Nodal_field(const std::vector<Point>& points, const std::vector<std::vector<Number>>& polygons,
              const std::vector<double>& values)
  {
    require(points.size() == values.size(), "not one value for each point");
    std::vector<Corner> corners;
    for(std::size_t v = 0; v < points.size(); ++v)
      corners.push_back(checked_corner(points[v], values[v]));
    Soup soup;
    std::vector<Corner> polygon;
    for(const auto& numbers : polygons) {
      polygon.clear();
      for(const Number v : numbers) {
        require(v >= 0 && std::size_t(v) < points.size(), "a polygon has no such point");
        polygon.push_back(corners[std::size_t(v)]);
      }
      require(polygon.size() >= 3, "a polygon has fewer than three points");
      internal::append_polygon(polygon, soup);
    }
    set_data(std::move(soup));
  }

  /// The value at a point (anything with `x()`, `y()` and `z()`); not a number where a coordinate
  /// is none.
  template <class Point>
  double operator()(const Point& p) const
  {
    return (*values_)(internal::to_vec(p));
  }

private:
  using Corner = internal::Valued_point;
  using Soup = std::vector<internal::Valued_triangle>;

  static void require(bool condition, const char* otherwise)
  {
    if(!condition) throw std::invalid_argument(std::string("Nodal_field: ") + otherwise);
  }

  void set_data(Soup soup)
  {
    require(!soup.empty(), "the mesh has no face with an area");
    values_ = std::make_shared<const internal::Values_on_triangles>(std::move(soup));
  }

  template <class Point>
  static Corner checked_corner(const Point& p, double value)
  {
    const Corner corner = { internal::to_vec(p), value };
    require(internal::is_finite(corner.point), "a coordinate is not finite");
    require(std::isfinite(value), "a value is not finite");
    return corner;
  }

  std::shared_ptr<const internal::Values_on_triangles> values_;
};

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_NODAL_FIELD_H
