// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_NEAREST_FACE_H
#define CGAL_QUAD_MESH_ADAPTATION_NEAREST_FACE_H

#include <CGAL/Quad_mesh_adaptation/internal/Box_tree.h>
#include <CGAL/Quad_mesh_adaptation/internal/append_polygon.h>
#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>
#include <CGAL/Quad_mesh_adaptation/internal/mesh_arrays.h>

#include <CGAL/Named_function_parameters.h>

#include <array>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {

/// \brief Tells which face of a mesh is nearest to a point, to carry over what belongs to faces.
///
/// Made of an initial mesh before that is adapted, it names for the centre of each face of the
/// adapted mesh the face whose material, thickness or other property it takes, of any type.  So
/// values are taken as they are and never mixed: numbers of materials stay such.  Where several
/// faces are equally near, as where four have become one, it is always the same one of them.
/// `Nodal_field` does the like for numbers at vertices.
///
/// Copies share their data.  `operator()` may be called from several threads.
class Nearest_face
{
public:
  /// \param mesh a model of `FaceListGraph` and `HalfedgeListGraph` with at least one face of
  ///        non-zero area, of any number of edges.
  /// \param np optional: `vertex_point_map`.
  /// \throws std::invalid_argument if a coordinate is not finite, or no face has an area.
  ///
  /// Linear in the size of the mesh, but for the search tree.
  template <class PolygonMesh, class NP = parameters::Default_named_parameters>
  explicit Nearest_face(const PolygonMesh& mesh, const NP& np = parameters::default_values())
  {
    std::vector<std::vector<internal::Index>> faces;
    const auto points = internal::points_and_faces(
        mesh, internal::vertex_points(mesh, np),
        [&](const std::vector<internal::Index>& face) { faces.push_back(face); });
    for(const Vec& p : points) require(internal::is_finite(p), "a coordinate is not finite");
    std::vector<internal::Valued_triangle> triangles;
    std::vector<std::size_t> face_of;
    for(std::size_t f = 0; f < faces.size(); ++f) {
      std::vector<internal::Valued_point> polygon;
      for(internal::Index v : faces[f]) polygon.push_back({ points[v], 0. });
      internal::append_polygon(polygon, triangles);
      face_of.resize(triangles.size(), f);
    }
    require(!triangles.empty(), "the mesh has no face with an area");
    data_ = std::make_shared<const Data>(triangles, std::move(face_of));
  }

  /// \param p anything with `x()`, `y()` and `z()`.
  /// \return the place of the face in the order of iteration over the mesh as it was.
  /// \throws std::invalid_argument if a coordinate is not finite.
  template <class Point>
  std::size_t operator()(const Point& p) const
  {
    return nearest(p, [](internal::Index) { return true; });
  }

  /// The same among the faces that do not face away from `normal`, if there are any: two sheets
  /// that lie closer to each other than `p` to its own are told apart by that.
  /// \param normal anything with `x()`, `y()` and `z()`; its length does not matter.
  template <class Point, class Vector>
  std::size_t operator()(const Point& p, const Vector& normal) const
  {
    const Vec n = internal::to_vec(normal);
    const Data& d = *data_;
    return nearest(p, [&](internal::Index t) { return !(d.normals[t] * n < 0); });
  }

private:
  using Vec = internal::Vec;

  struct Data
  {
    Data(const std::vector<internal::Valued_triangle>& triangles, std::vector<std::size_t> faces)
        : face_of(std::move(faces)), tree(internal::Index(triangles.size()),
                                          [&](internal::Index t) { return triangles[t].corners; })
    {
      for(const internal::Valued_triangle& t : triangles) {
        corners.push_back(t.corners);
        normals.push_back(
            internal::cross(t.corners[1] - t.corners[0], t.corners[2] - t.corners[0]));
      }
    }

    std::vector<std::array<Vec, 3>> corners; // of triangles
    std::vector<Vec> normals;
    std::vector<std::size_t> face_of;
    internal::Box_tree tree;
  };

  static void require(bool condition, const char* otherwise)
  {
    if(!condition) throw std::invalid_argument(std::string("Nearest_face: ") + otherwise);
  }

  template <class Point, class Accept>
  std::size_t nearest(const Point& point, const Accept& accept) const
  {
    const Vec p = internal::to_vec(point);
    require(internal::is_finite(p), "a coordinate of a point is not finite");
    const auto corners = [this](internal::Index t) { return data_->corners[t]; };
    constexpr double anywhere = 1e150; // its square is finite
    internal::Box_tree::Nearest found = data_->tree.nearest(p, corners, accept, anywhere);
    if(found.triangle < 0)
      found = data_->tree.nearest(
          p, corners, [](internal::Index) { return true; }, anywhere);
    return data_->face_of[found.triangle < 0 ? 0 : found.triangle];
  }

  std::shared_ptr<const Data> data_;
};

} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_NEAREST_FACE_H
