// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SOUP_CHECK_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SOUP_CHECK_H

#include <CGAL/Quad_mesh_adaptation/IO/Read_result.h>
#include <CGAL/Quad_mesh_adaptation/internal/boxes.h>
#include <CGAL/Quad_mesh_adaptation/internal/polygon_soup.h>
#include <CGAL/Quad_mesh_adaptation/internal/soup_manifold.h>

#include <algorithm>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// An edge or a diagonal below this share of the soup's extent, or an area below this share of the
// square of the face's longest edge, is rounding noise.
constexpr double soup_epsilon = 1e-14;

inline Read_result check_finite_points(const Polygon_soup& soup)
{
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    if(!is_finite(soup.points[v]))
      return refuse(Refusal::non_finite_coordinate,
                    "vertex " + std::to_string(v) + " has a coordinate that is not finite",
                    static_cast<long>(v));
  return {};
}

// Indices in range, `quads_only` or at least triangles, no vertex twice.
inline Read_result check_faces(const Polygon_soup& soup, bool quads_only)
{
  const Index n = static_cast<Index>(soup.points.size());
  std::size_t wrong = 0, first_wrong = 0;
  Polygon_soup::Face sorted;
  for(std::size_t f = 0; f < soup.faces.size(); ++f) {
    const Polygon_soup::Face& face = soup.faces[f];
    for(const Index v : face)
      if(v < 0 || v >= n)
        return refuse(Refusal::unreadable_file,
                      "face " + std::to_string(f) + " has the vertex number " + std::to_string(v) +
                          ", which is not one from 0 to " + std::to_string(n - 1),
                      static_cast<long>(f));
    if(quads_only ? face.size() != 4 : face.size() < 3) {
      if(wrong++ == 0) first_wrong = f;
      continue;
    }
    sorted = face;
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if(twice != sorted.end())
      return refuse(Refusal::degenerate_face,
                    "face " + std::to_string(f) + " has vertex " + std::to_string(*twice) +
                        " more than once",
                    static_cast<long>(f));
  }
  if(wrong == 0) return {};
  return refuse(quads_only ? Refusal::not_all_quads : Refusal::degenerate_face,
                "face " + std::to_string(first_wrong) + " has " +
                    std::to_string(soup.faces[first_wrong].size()) + " vertices, " +
                    (quads_only ? "all must have four" : "at least three are needed") + " (" +
                    std::to_string(wrong) + " of " + std::to_string(soup.faces.size()) +
                    " faces are like this)",
                static_cast<long>(first_wrong));
}

// No edge without length, no face without area.
inline Read_result check_geometry(const Polygon_soup& soup)
{
  const double extent = norm(Box(soup.points).extent());
  if(!std::isfinite(extent))
    return refuse(Refusal::non_finite_coordinate,
                  "the coordinates are too large: distances between them are not finite");
  for(std::size_t f = 0; f < soup.faces.size(); ++f) {
    const Polygon_soup::Face& face = soup.faces[f];
    double longest = 0;
    for(std::size_t i = 0; i < face.size(); ++i) {
      const Index a = face[i], b = face[(i + 1) % face.size()];
      const double length = distance(soup.points[a], soup.points[b]);
      if(length <= soup_epsilon * extent)
        return refuse(Refusal::degenerate_face,
                      "face " + std::to_string(f) + " is degenerate: its vertices " +
                          std::to_string(a) + " and " + std::to_string(b) +
                          " are at the same place",
                      static_cast<long>(f));
      longest = (std::max)(longest, length);
    }
    // in units of the longest edge, so that tiny coordinates do not underflow
    const double area = norm(twice_vector_area(soup, face) / longest) / longest;
    if(!(area > soup_epsilon))
      return refuse(Refusal::degenerate_face,
                    "face " + std::to_string(f) + " is degenerate: it has no area",
                    static_cast<long>(f));
  }
  return {};
}

// Vertices that no face uses are of no use to anybody.  `number`: what the others are called then,
// -1 for those.
inline std::size_t drop_isolated_points(Polygon_soup& soup, std::vector<Index>& number)
{
  number.assign(soup.points.size(), -1);
  for(const Polygon_soup::Face& face : soup.faces)
    for(const Index v : face) number[v] = 0;
  Index kept = 0;
  for(std::size_t v = 0; v < number.size(); ++v)
    if(number[v] == 0) {
      number[v] = kept;
      soup.points[kept++] = soup.points[v];
    }
  const std::size_t dropped = soup.points.size() - kept;
  soup.points.resize(kept);
  for(Polygon_soup::Face& face : soup.faces)
    for(Index& v : face) v = number[v];
  return dropped;
}

/// Checks that a soup is an oriented manifold surface with boundary, of quads or of any polygons,
/// and makes it one where only the order of vertices is at fault: faces are turned so that each
/// component is oriented alike (the orientation of the majority stays), isolated vertices are
/// dropped; both is told in `notes`.  Coincident vertices are not merged.  On refusal the soup may
/// have been changed.  `number`: the new number of each vertex, -1 for those that were dropped.
inline Read_result check_soup(Polygon_soup& soup, bool quads_only, std::vector<Index>& number)
{
  if(soup.points.empty() || soup.faces.empty())
    return refuse(Refusal::empty_mesh,
                  soup.points.empty() ? "the mesh has no vertices" : "the mesh has no faces");
  Read_result result = check_finite_points(soup);
  if(result.ok()) result = check_faces(soup, quads_only);
  if(result.ok()) result = check_geometry(soup);
  if(!result.ok()) return result;

  Soup_manifold manifold(soup);
  std::size_t turned = 0;
  result = manifold.check_edges();
  if(result.ok()) result = manifold.orient(turned);
  if(result.ok()) result = manifold.check_vertices();
  if(!result.ok()) return result;

  if(turned > 0)
    result.notes.push_back(std::to_string(turned) + (turned == 1 ? " face was" : " faces were") +
                           " turned to orient the surface consistently");
  const std::size_t dropped = drop_isolated_points(soup, number);
  if(dropped > 0)
    result.notes.push_back(std::to_string(dropped) +
                           (dropped == 1 ? " vertex that no face uses was left out"
                                         : " vertices that no face uses were left out"));
  return result;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SOUP_CHECK_H
