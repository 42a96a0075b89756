// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_OCTAVES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_OCTAVES_H

#include <CGAL/Quad_mesh_adaptation/internal/Phase_scope.h>
#include <CGAL/Quad_mesh_adaptation/internal/measure_size_growth.h>
#include <CGAL/Quad_mesh_adaptation/internal/refinement.h>
#include <CGAL/Quad_mesh_adaptation/internal/smoothing.h>
#include <CGAL/Quad_mesh_adaptation/internal/spatial_order.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

inline bool is_anything_frozen(const Adaptation_state& s)
{
  for(const Feature_curve& c : s.curves)
    if(c.is_frozen()) return true;
  for(Index v : s.mesh.vertices())
    if(s.mesh.vertex(v).frozen) return true;
  return false;
}

// How often the sizes may be doubled, at most `most` times, before most faces of the input have
// them and should stay.
inline int octaves_below_input(const Adaptation_state& s, int most)
{
  constexpr double most_faces = 0.7, rounding = 1.001;
  for(int octaves = 0; octaves < most; ++octaves) {
    const double scale = std::exp2(octaves);
    const double right = fraction_below(s, rounding * scale) - fraction_below(s, 0.5 * scale);
    if(right >= most_faces) return octaves;
  }
  return most;
}

// The angle by which the surface turns across a face of the wanted size, by the faces on both sides
// of half-edge h.
inline double turn_per_face(const Adaptation_state& s, Index h)
{
  const Quad_complex& m = s.mesh;
  const Vec a = area_vector(s.corners(m.face(h))),
            b = area_vector(s.corners(m.face(m.opposite(h))));
  const Vertex_record &u = m.vertex(m.origin(h)), &v = m.vertex(m.target(h));
  const double way = 0.25 * (norm(a) + norm(b)) / distance(u.p, v.p); // between their centres
  return angle_between(a, b) * 0.5 * (u.h + v.h) / way;
}

// How often the sizes may be doubled, at most `most` times, before the surface turns by too much
// across a face for its shape to be found again, but for a small share of it.  Creases do not
// count.
inline int octaves_by_turn(const Adaptation_state& s, int most)
{
  constexpr double gentle_turn = 1.3, exempt = 0.02;
  if(s.surface.is_planar()) return most;
  const Quad_complex& m = s.mesh;
  std::vector<std::size_t> edges(std::size_t(most) + 1, 0); // by the octaves they allow
  std::size_t all = 0;
  for(Index h : m.halfedges()) {
    if(m.opposite(h) < h || m.curve(h) >= 0) continue;
    const double octaves = std::log2(gentle_turn / turn_per_face(s, h));
    if(octaves < most) ++edges[octaves > 0 ? std::size_t(octaves) : 0];
    ++all;
  }
  std::size_t steep = 0;
  for(int octaves = 0; octaves < most; ++octaves) {
    steep += edges[octaves];
    if(double(steep) > exempt * double(all)) return octaves;
  }
  return most;
}

// What the sizes ask for: the ideal number of faces, and how steeply they grow.
struct Demand
{
  double faces, slope;
  double gentle = 0.3; // slope up to which a mesh is to be halved later

  explicit Demand(const Adaptation_state& s)
  {
    const double given = double(s.mesh.number_of_faces());
    const Size_function size = [&s](const Vec& p) { return s.size.at(p); };
    Size_growth_meter meter(size, (std::max)(2, int(std::ceil(std::sqrt(4096 / given)))));
    for(Index f : s.mesh.faces()) meter.add(s.corners(f));
    faces = meter.faces();
    slope = std::sqrt(meter.result().mean_square_slope); // of all those faces
    // in large meshes a half to four fifths of the time matter more than one face in fifty
    constexpr double many = 20000;
    if(faces * double(s.copies) >= many) gentle = 0.4;
  }

  // Can a mesh for twice the sizes still follow them?
  bool is_gentle_doubled() const { return 2 * slope <= gentle; }

  void double_sizes()
  {
    faces /= 4;
    slope *= 2;
  }
};

// How often the sizes may be doubled, at most `most` times, for a first solution that is then
// halved everywhere as often.  Halving keeps the pattern: a mesh that has as many faces as wanted
// everywhere has them again, with as many irregular nodes in four times the faces and at a fraction
// of the work.  Two things set a limit.  Where sizes grow, rows end; halving doubles each row that
// ends but adds no place where one does, so the first solution must follow the sizes well already.
// And it is coarser than the input only where little of that would stay anyway and its shape can
// be found again.
inline int octaves_above(const Adaptation_state& s, int most)
{
  constexpr double least_faces = 400; // of the whole
  if(most <= 0 || is_anything_frozen(s)) return 0;
  const double given = double(s.mesh.number_of_faces());
  const int coarser = (std::min)(octaves_below_input(s, most), octaves_by_turn(s, most));
  Demand demand(s);
  int octaves = 0;
  while(octaves < most && (octaves < coarser || demand.faces >= 6 * given) &&
        demand.faces >= 4 * least_faces / double(s.copies) && demand.is_gentle_doubled()) {
    ++octaves;
    demand.double_sizes();
  }
  return octaves;
}

// The same for a mesh that is only refined: no face may be cut that is small enough.
inline int octaves_below_faces(const Adaptation_state& s, int most)
{
  if(most <= 0 || is_anything_frozen(s)) return 0;
  double least = std::exp2(most);
  for(Index f : s.mesh.faces()) least = (std::min)(least, s.size_ratio(f));
  Demand demand(s);
  int octaves = 0;
  while(octaves < most && least >= 2 * 0.75 && demand.is_gentle_doubled()) {
    ++octaves;
    least /= 2;
    demand.double_sizes();
  }
  return octaves;
}

// Ideal number of faces over that of the mesh, roughly.
inline double efficiency(const Adaptation_state& s)
{
  double ideal = 0;
  for(Index f : s.mesh.faces()) {
    const Corners p = s.corners(f);
    const double h = mean_edge_length(p) / s.size_ratio(f);
    ideal += 0.5 * norm(area_vector(p)) / (h * h);
  }
  return ideal / double(s.mesh.number_of_faces());
}

// Where faces are folded over each other, cuts may leave as much too large as there was, and more
// faces after each pass: refinement ends when there are far more than it can ever need.
class Growth_limit
{
public:
  explicit Growth_limit(const Adaptation_state& s)
      : s_(s), most_(10 * (1 + 4 * efficiency(s)) * double(s.mesh.number_of_faces()))
  {
  }

  bool is_exceeded() const { return double(s_.mesh.number_of_faces()) > most_; }

private:
  const Adaptation_state& s_;
  double most_;
};

inline void cut_all_faces(Adaptation_state& s)
{
  std::vector<Index> all;
  for(Index f : s.mesh.faces()) all.push_back(f);
  refine_faces(s, all);
}

// Halves the sizes and all edges.  Since no face of the input is left then, all may be renumbered.
// Sweeps over a million faces take half the time for it.
inline void halve_all(Adaptation_state& s, int sweeps = 3)
{
  Phase_scope phase(s, "refinement");
  s.scale_sizes(0.5);
  cut_all_faces(s);
  ++s.iterations;
  renumber_by_place(s);
  if(sweeps > 0) smooth(s, sweeps);
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_OCTAVES_H
