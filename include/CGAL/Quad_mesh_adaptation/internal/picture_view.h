// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PICTURE_VIEW_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PICTURE_VIEW_H

#include <CGAL/Quad_mesh_adaptation/internal/polygon_soup.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// An orthographic camera: picture axes and the direction from the surface to the eye.
struct Picture_view
{
  Vec right = Vec(1, 0, 0), up = Vec(0, 1, 0), to_eye = Vec(0, 0, 1);
  bool is_planar = false; // the surface lies in the picture plane: nothing to shade or sort
};

inline Picture_view view_from(const Vec& to_eye, const Vec& wanted_up)
{
  Picture_view view;
  view.to_eye = normalized(to_eye);
  Vec right = cross(wanted_up, view.to_eye);
  if(!(norm(right) > 1e-9 * norm(wanted_up))) right = cross(Vec(0, 1, 0), view.to_eye);
  if(!(norm(right) > 1e-9)) right = Vec(1, 0, 0);
  view.right = normalized(right);
  view.up = cross(view.to_eye, view.right);
  return view;
}

// The unit normal of the plane that holds all points up to rounding, or zero.
inline Vec plane_normal(const Polygon_soup& soup)
{
  Vec area(0, 0, 0);
  for(const Polygon_soup::Face& face : soup.faces) area = area + twice_vector_area(soup, face);
  const Vec normal = normalized(area);
  double low = (std::numeric_limits<double>::max)(), high = -low, extent = 0;
  for(const Vec& p : soup.points) {
    const double height = dot(normal, p - soup.points.front());
    low = (std::min)(low, height);
    high = (std::max)(high, height);
    extent = (std::max)(extent, distance(p, soup.points.front()));
  }
  return norm(normal) > 0 && high - low <= 1e-6 * extent ? normal : Vec(0, 0, 0);
}

// Edges of one face only, as pairs of vertices in ascending order.
inline std::vector<std::pair<Index, Index>> border_edges(const Polygon_soup& soup)
{
  std::vector<std::pair<Index, Index>> edges, border;
  for(const Polygon_soup::Face& face : soup.faces)
    for(std::size_t i = 0; i < face.size(); ++i) {
      const Index a = face[i], b = face[(i + 1) % face.size()];
      edges.emplace_back((std::min)(a, b), (std::max)(a, b));
    }
  std::sort(edges.begin(), edges.end());
  for(std::size_t i = 0, end; i < edges.size(); i = end) {
    end = i + 1;
    while(end < edges.size() && edges[end] == edges[i]) ++end;
    if(end - i == 1) border.push_back(edges[i]);
  }
  return border;
}

// 1 when the faces' normals point away from the middle of the surface on the whole, else -1.
inline double outward_sign(const Polygon_soup& soup)
{
  Vec middle(0, 0, 0);
  for(const Vec& p : soup.points) middle = middle + p / double(soup.points.size());
  double outward = 0;
  for(const Polygon_soup::Face& face : soup.faces)
    outward += dot(twice_vector_area(soup, face), centre_of_face(soup, face) - middle);
  return outward < 0 ? -1 : 1;
}

// Area of the outer side that is turned to the eye.
inline double area_seen(const Polygon_soup& soup, const Vec& to_eye)
{
  const double outward = outward_sign(soup);
  double area = 0;
  for(const Polygon_soup::Face& face : soup.faces)
    area += (std::max)(0., outward * dot(twice_vector_area(soup, face), to_eye));
  return area;
}

// A flat surface is seen along its normal, the y axis up where that is possible.  Any other is
// seen three-quarters from above; or from another quarter or below if much more of its outer side
// shows there.
inline Picture_view default_view(const Polygon_soup& soup)
{
  const Vec z(0, 0, 1), normal = plane_normal(soup);
  if(norm(normal) > 0) {
    // from the side of the coordinate axis that it is nearest to
    const double lead = std::abs(normal.z()) > 0.5   ? normal.z()
                        : std::abs(normal.y()) > 0.5 ? -normal.y()
                                                     : normal.x();
    Picture_view view =
        view_from(lead < 0 ? -normal : normal, std::abs(normal.z()) > 0.9 ? Vec(0, 1, 0) : z);
    view.is_planar = true;
    return view;
  }
  const double degree = pi / 180;
  Vec best = z;
  double best_area = 0;
  for(const double elevation : { 28., -28. })
    for(const double azimuth : { -60., 30., 120., 210. }) {
      const double flat = std::cos(elevation * degree);
      const Vec eye(flat * std::cos(azimuth * degree), flat * std::sin(azimuth * degree),
                    std::sin(elevation * degree));
      const double area = area_seen(soup, eye);
      if(area > 1.1 * best_area) {
        best = eye;
        best_area = area;
      }
    }
  return view_from(best, z);
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PICTURE_VIEW_H
