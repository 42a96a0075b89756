// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_NODAL_SIZING_FIELD_H
#define CGAL_QUAD_MESH_ADAPTATION_NODAL_SIZING_FIELD_H

#include <CGAL/Quad_mesh_adaptation/internal/Values_on_triangles.h>
#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {

/// \brief A sizing field given by sizes at the vertices of a background mesh.
///
/// The logarithm of the size is interpolated linearly over a triangulated copy of the background
/// mesh, so that the size between two vertices never exceeds their geometric interpolation.  The
/// field keeps the copy: the background mesh may be adapted or destroyed afterwards, and adapting
/// it several times does not make the sizes drift.  It may be the
/// mesh that is adapted, or any other mesh of the same surface.  At a point off the background mesh
/// the size is that of its nearest point.
///
/// Copies share their data.  `operator()` may be called from several threads.
class Nodal_sizing_field
{
public:
  /// \param mesh the background mesh, a model of `FaceListGraph` and `HalfedgeListGraph` with at
  ///        least one face of non-zero area: triangles, quads (cut along the diagonal that keeps
  ///        the triangles well oriented) or polygons (cut around the mean of their vertices).
  /// \param sizes a readable property map from vertices to the target edge length there, in units
  ///        of the coordinates.
  /// \param np optional: `vertex_point_map`.
  /// \throws std::invalid_argument if a size or a coordinate is not finite, a size is not
  ///         positive, or the mesh has no face.
  template <class PolygonMesh, class VertexSizeMap, class NP = parameters::Default_named_parameters>
  Nodal_sizing_field(const PolygonMesh& mesh, const VertexSizeMap& sizes,
                     const NP& np = parameters::default_values())
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    const auto points = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                         get_const_property_map(vertex_point, mesh));
    using Descriptor = typename boost::graph_traits<PolygonMesh>::vertex_descriptor;
    std::unordered_map<Descriptor, Corner> corner;
    for(Descriptor v : vertices(mesh)) {
      const auto& p = get(points, v);
      corner.emplace(v, checked_corner({ CGAL::to_double(p.x()), CGAL::to_double(p.y()),
                                         CGAL::to_double(p.z()) },
                                       CGAL::to_double(get(sizes, v))));
    }
    Soup soup;
    std::vector<Corner> polygon;
    for(auto f : faces(mesh)) {
      polygon.clear();
      for(Descriptor v : vertices_around_face(halfedge(f, mesh), mesh))
        polygon.push_back(corner.at(v));
      triangulate(polygon, soup);
    }
    set_data(std::move(soup));
  }

  /// The same from arrays, for a background that need not be manifold or oriented.
  /// \param points anything with `x()`, `y()` and `z()`.
  /// \param polygons the numbers of the points of each, at least three.
  /// \param sizes one for each point.
  /// \throws std::invalid_argument also if the numbers of points and sizes differ, or a number of a
  ///         point is out of range.
  template <class Point, class Number>
  Nodal_sizing_field(const std::vector<Point>& points,
                     const std::vector<std::vector<Number>>& polygons,
                     const std::vector<double>& sizes)
  {
    if(points.size() != sizes.size())
      throw std::invalid_argument("Nodal_sizing_field: not one size for each point");
    std::vector<Corner> corners;
    for(std::size_t v = 0; v < points.size(); ++v)
      corners.push_back(
          checked_corner({ CGAL::to_double(points[v].x()), CGAL::to_double(points[v].y()),
                           CGAL::to_double(points[v].z()) },
                         sizes[v]));
    Soup soup;
    std::vector<Corner> polygon;
    for(const auto& numbers : polygons) {
      polygon.clear();
      for(const Number v : numbers) {
        if(!(v >= 0 && std::size_t(v) < points.size()))
          throw std::invalid_argument("Nodal_sizing_field: a polygon has no such point");
        polygon.push_back(corners[std::size_t(v)]);
      }
      if(polygon.size() < 3)
        throw std::invalid_argument("Nodal_sizing_field: a polygon has fewer than three points");
      triangulate(polygon, soup);
    }
    set_data(std::move(soup));
  }

  /// Target edge length at a point (anything with `x()`, `y()` and `z()`); always positive.
  template <class Point>
  double operator()(const Point& point) const
  {
    const internal::Vec p(CGAL::to_double(point.x()), CGAL::to_double(point.y()),
                          CGAL::to_double(point.z()));
    return std::exp((*log_sizes_)(p));
  }

private:
  using Vec = internal::Vec;

  struct Corner
  {
    Vec point;
    double log_size;
  };
  using Soup = std::vector<internal::Valued_triangle>;

  void set_data(Soup soup)
  {
    if(soup.empty())
      throw std::invalid_argument(
          "Nodal_sizing_field: the background mesh has no face with an area");
    log_sizes_ = std::make_shared<const internal::Values_on_triangles>(std::move(soup));
  }

  static Corner checked_corner(const Vec& p, double size)
  {
    if(!internal::is_finite(p))
      throw std::invalid_argument("Nodal_sizing_field: a coordinate is not finite");
    if(!(std::isfinite(size) && size > 0))
      throw std::invalid_argument("Nodal_sizing_field: a size is not a positive finite number");
    return { p, std::log(size) };
  }

  static Vec area_vector(const Corner& a, const Corner& b, const Corner& c)
  {
    return internal::cross(b.point - a.point, c.point - a.point);
  }

  // Triangles without an area are left out: nothing can lie inside them.
  static void add(const Corner& a, const Corner& b, const Corner& c, Soup& soup)
  {
    const internal::Valued_triangle t = { { a.point, b.point, c.point },
                                          { a.log_size, b.log_size, c.log_size } };
    if(t.has_area()) soup.push_back(t);
  }

  static void triangulate(const std::vector<Corner>& p, Soup& soup)
  {
    if(p.size() == 3) return add(p[0], p[1], p[2], soup);
    if(p.size() == 4) {
      const Vec normal = internal::cross(p[2].point - p[0].point, p[3].point - p[1].point);
      const auto least_area = [&](int i) { // of the two triangles at the diagonal from corner i
        return (std::min)(area_vector(p[i], p[i + 1], p[(i + 2) % 4]) * normal,
                          area_vector(p[i], p[(i + 2) % 4], p[(i + 3) % 4]) * normal);
      };
      const int i = least_area(0) >= least_area(1) ? 0 : 1;
      add(p[i], p[i + 1], p[(i + 2) % 4], soup);
      add(p[i], p[(i + 2) % 4], p[(i + 3) % 4], soup);
      return;
    }
    Corner mean = { Vec(0, 0, 0), 0. };
    for(const Corner& c : p) {
      mean.point = mean.point + c.point / double(p.size());
      mean.log_size += c.log_size / double(p.size());
    }
    for(std::size_t i = 0; i < p.size(); ++i) add(mean, p[i], p[(i + 1) % p.size()], soup);
  }

  std::shared_ptr<const internal::Values_on_triangles> log_sizes_;
};

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_NODAL_SIZING_FIELD_H
