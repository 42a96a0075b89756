// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SVG_PANELS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SVG_PANELS_H

#include <CGAL/Quad_mesh_adaptation/internal/colour_map.h>
#include <CGAL/Quad_mesh_adaptation/internal/polygon_soup.h>
#include <CGAL/Quad_mesh_adaptation/internal/svg_canvas.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Above this number of faces edges would be all that is seen; faces then show their size by colour.
constexpr std::size_t max_faces_with_edges = 80000;

// A polygon of one colour on its way to the picture.
struct Painted_polygon
{
  std::vector<Picture_point> points;
  double depth = 0; // towards the eye
  std::string fill;
  int edge_class = -1; // width of its edges, -1 for none
};

// How bright a face with this normal is; the light comes over the viewer's left shoulder.
inline double shade_of(const Picture_view& view, const Vec& normal)
{
  if(view.is_planar) return 1;
  const Vec light = normalized(view.to_eye * 0.8 + view.up * 0.5 - view.right * 0.35);
  const Vec n = normalized(normal);
  return 0.66 + 0.34 * std::abs(dot(n, light));
}

// Which of the faces of a surface that is not flat are turned away from the eye.
class Sides
{
public:
  Sides(const Polygon_soup& soup, const Picture_view& view)
      : view_(view), outward_(outward_sign(soup)), is_closed_(border_edges(soup).empty())
  {
  }

  bool is_behind(const Vec& normal) const
  {
    return !view_.is_planar && outward_ * dot(normal, view_.to_eye) < 0;
  }
  /// The inner side of a closed surface is never seen.
  bool is_hidden(const Vec& normal) const { return is_closed_ && is_behind(normal); }

private:
  const Picture_view& view_;
  double outward_;
  bool is_closed_;
};

// Widths of edges in pixels: small faces get fine lines, or they would drown in ink.
constexpr std::array<double, 6> edge_widths = { { 0.1, 0.18, 0.28, 0.42, 0.6, 0.8 } };

inline int edge_class_of(const std::vector<Picture_point>& points)
{
  double length = 0;
  for(std::size_t i = 0; i < points.size(); ++i) {
    const Picture_point &a = points[i], &b = points[(i + 1) % points.size()];
    length += std::hypot(a.x - b.x, a.y - b.y) / double(points.size());
  }
  int width = 0;
  while(width + 1 < int(edge_widths.size()) && edge_widths[width + 1] < 0.07 * length) ++width;
  return width;
}

// The styles and the colour gradient that the panels use.
inline std::string svg_definitions()
{
  std::string css =
      "<style>\ntext{font-family:Helvetica,Arial,\"DejaVu Sans\",sans-serif;fill:#1c2430}\n"
      ".title{font-size:16px;font-weight:bold;text-anchor:middle}\n"
      ".note{font-size:12.5px;fill:#5a6472;text-anchor:middle}\n.tick{font-size:11.5px}\n"
      ".faces{stroke-width:.7;stroke-linejoin:round}\n"
      ".curve{fill:none;stroke:#1c2430;stroke-width:1.1;stroke-linejoin:round;"
      "stroke-linecap:round}\n";
  for(std::size_t i = 0; i < edge_widths.size(); ++i)
    css += ".faces .e" + std::to_string(i) +
           "{stroke:#1c2430;stroke-width:" + pixels(edge_widths[i]) + "}\n";
  css += "</style>\n<defs><linearGradient id=\"sizes\" x1=\"0\" y1=\"1\" x2=\"0\" y2=\"0\">\n";
  constexpr int stops = 24;
  for(int i = 0; i <= stops; ++i)
    css += "<stop offset=\"" + pixels(double(i) / stops) + "\" stop-color=\"" +
           hex(size_colour(double(i) / stops)) + "\"/>\n";
  return css + "</linearGradient></defs>\n";
}

// Painted back to front.  In a flat picture nothing hides anything: polygons of the same look
// become one path.
inline std::string paint(std::vector<Painted_polygon>& polygons, const Picture_view& view)
{
  const auto open = [](const std::string& fill, int edge_class) {
    // without edges, a stroke of the same colour hides the seams between neighbours
    return edge_class >= 0
               ? "<path class=\"e" + std::to_string(edge_class) + "\" fill=\"" + fill + "\" d=\""
               : "<path fill=\"" + fill + "\" stroke=\"" + fill + "\" d=\"";
  };
  std::string svg = "<g class=\"faces\">\n";
  if(view.is_planar) {
    std::map<std::pair<int, std::string>, std::string> paths;
    for(const Painted_polygon& polygon : polygons)
      append_polygon(paths[{ polygon.edge_class, polygon.fill }], polygon.points);
    for(const auto& [look, path] : paths) svg += open(look.second, look.first) + path + "\"/>\n";
  } else {
    std::stable_sort(
        polygons.begin(), polygons.end(),
        [](const Painted_polygon& a, const Painted_polygon& b) { return a.depth < b.depth; });
    for(const Painted_polygon& polygon : polygons) {
      svg += open(polygon.fill, polygon.edge_class);
      append_polygon(svg, polygon.points);
      svg += "\"/>\n";
    }
  }
  return svg + "</g>\n";
}

// The curves that bound a flat surface.
inline std::string outline(const Polygon_soup& soup, const Picture_view& view,
                           const Panel_frame& frame)
{
  if(!view.is_planar) return {};
  std::string path;
  for(const auto& edge : border_edges(soup)) {
    const Picture_point a = frame.place(view, soup.points[edge.first]),
                        b = frame.place(view, soup.points[edge.second]);
    path += "M" + pixels(a.x) + ' ' + pixels(a.y) + ' ' + pixels(b.x) + ' ' + pixels(b.y);
  }
  return "<path class=\"curve\" d=\"" + path + "\"/>\n";
}

// Mean edge length of a face, its size of eq. (1).
inline double size_of_face(const Polygon_soup& soup, const Polygon_soup::Face& face)
{
  double sum = 0;
  for(std::size_t i = 0; i < face.size(); ++i)
    sum += distance(soup.points[face[i]], soup.points[face[(i + 1) % face.size()]]);
  return sum / double(face.size());
}

/// The faces of a mesh with their edges.
inline std::string mesh_panel(const Polygon_soup& soup, const Picture_view& view,
                              const Panel_frame& frame, const Size_scale& scale)
{
  const Colour front = { 0.925, 0.945, 0.97 }, back = { 0.93, 0.89, 0.82 };
  const bool with_edges = soup.faces.size() <= max_faces_with_edges;
  const Sides sides(soup, view);
  std::vector<Painted_polygon> polygons;
  polygons.reserve(soup.faces.size());
  for(const Polygon_soup::Face& face : soup.faces) {
    const Vec normal = twice_vector_area(soup, face);
    if(sides.is_hidden(normal)) continue;
    Painted_polygon polygon;
    for(const Index v : face) polygon.points.push_back(frame.place(view, soup.points[v]));
    polygon.depth = dot(centre_of_face(soup, face), view.to_eye);
    const Colour colour = !with_edges               ? size_colour(scale(size_of_face(soup, face)))
                          : sides.is_behind(normal) ? back
                                                    : front;
    polygon.fill = hex(colour, shade_of(view, normal));
    if(with_edges) polygon.edge_class = edge_class_of(polygon.points);
    polygons.push_back(std::move(polygon));
  }
  return paint(polygons, view) + outline(soup, view, frame);
}

// Cuts quads into four as long as their size varies visibly and they are large enough to see it.
class Size_painter
{
public:
  Size_painter(const Size_function& size, const Size_scale& scale, const Picture_view& view,
               const Panel_frame& frame)
      : size_(size), scale_(scale), view_(view), frame_(frame)
  {
  }

  void add(const std::array<Vec, 4>& corners, int depth = 0)
  {
    const Vec centre = face_centre(corners);
    const double here = level(centre);
    double variation = 0;
    for(const Vec& corner : corners)
      variation = (std::max)(variation, std::abs(level(corner * 0.98 + centre * 0.02) - here));
    const double diagonal = frame_.scale * (std::max)(distance(corners[0], corners[2]),
                                                      distance(corners[1], corners[3]));
    // a size that dips inside a face is only found if large faces are always cut
    const double fine = view_.is_planar ? 4 : 8; // solid surfaces take a path per polygon
    const bool cut = diagonal > 40 || (variation > 0.3 / number_of_colours && diagonal > fine);
    if(!cut || depth >= 12 || polygons.size() > max_polygons)
      paint_quad(corners, centre, here);
    else
      cut_quad(corners, centre, depth);
  }

  std::vector<Painted_polygon> polygons;

private:
  static constexpr int number_of_colours = 64;
  static constexpr std::size_t max_polygons = 100000;

  double level(const Vec& p) const { return scale_(size_(p)); }

  void cut_quad(const std::array<Vec, 4>& c, const Vec& centre, int depth)
  {
    std::array<Vec, 4> middle;
    for(int i = 0; i < 4; ++i) middle[i] = (c[i] + c[(i + 1) % 4]) / 2;
    for(int i = 0; i < 4; ++i) add({ c[i], middle[i], centre, middle[(i + 3) % 4] }, depth + 1);
  }

  void paint_quad(const std::array<Vec, 4>& corners, const Vec& centre, double t)
  {
    Painted_polygon polygon;
    for(const Vec& p : corners) polygon.points.push_back(frame_.place(view_, p));
    polygon.depth = dot(centre, view_.to_eye);
    const double step = std::round((std::min)((std::max)(t, 0.), 1.) * number_of_colours);
    const Vec normal = cross(corners[2] - corners[0], corners[3] - corners[1]);
    // gently, the colour has to be read
    const double shade = 0.5 + 0.5 * shade_of(view_, normal);
    polygon.fill = std::isfinite(t) ? hex(size_colour(step / number_of_colours), shade) : "#888888";
    polygons.push_back(std::move(polygon));
  }

  const Size_function& size_;
  const Size_scale& scale_;
  const Picture_view& view_;
  const Panel_frame& frame_;
};

/// A sizing function on the faces of a mesh, as colour.
inline std::string size_panel(const Polygon_soup& soup, const Size_function& size,
                              const Size_scale& scale, const Picture_view& view,
                              const Panel_frame& frame)
{
  Size_painter painter(size, scale, view, frame);
  const Sides sides(soup, view);
  for(const Polygon_soup::Face& face : soup.faces)
    if(face.size() == 4 && !sides.is_hidden(twice_vector_area(soup, face)))
      painter.add({ soup.points[face[0]], soup.points[face[1]], soup.points[face[2]],
                    soup.points[face[3]] });
  return paint(painter.polygons, view) + outline(soup, view, frame);
}

/// A bar of the colours with the sizes that they stand for, to the right of `x`.
inline std::string colour_bar(const Size_scale& scale, double x, double top, double height)
{
  constexpr double width = 13;
  std::string svg = "<rect x=\"" + pixels(x) + "\" y=\"" + pixels(top) + "\" width=\"" +
                    pixels(width) + "\" height=\"" + pixels(height) + "\" fill=\"url(#sizes)\"/>\n";
  for(const double value : scale.ticks()) {
    const double y = top + height * (1 - scale(value));
    char label[32];
    std::snprintf(label, sizeof label, "%.3g", value);
    svg += "<path class=\"curve\" style=\"stroke-width:.8\" d=\"M" + pixels(x + width) + ' ' +
           pixels(y) + "h4\"/>\n" + svg_text(x + width + 7, y + 4, "tick", label);
  }
  return svg;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SVG_PANELS_H
