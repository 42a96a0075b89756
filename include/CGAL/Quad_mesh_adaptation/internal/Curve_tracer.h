// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CURVE_TRACER_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CURVE_TRACER_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/Hermite_curve.h>
#include <CGAL/Quad_mesh_adaptation/internal/Input_mesh.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Follows the feature edges of a state (those with a curve number) from corner to corner and round
// the loops, makes them its curves and puts the nodes on them.
class Curve_tracer
{
public:
  // Points of a smooth curve per edge: its chords are off by a thousandth of what the edge was.
  static constexpr int points_per_edge = 24;

  Curve_tracer(const Input_mesh& in, Adaptation_state& s, bool smooth)
      : in_(in), s_(s), smooth_(smooth)
  {
  }

  // The geometry of every feature edge.
  const Hermite_edges& edges() const { return edges_; }

  void operator()()
  {
    Quad_complex& m = s_.mesh;
    std::vector<Index> number(4 * std::size_t(m.face_end()), -2); // -2: feature, not traced yet
    for(int round = 0; round < 2; ++round)                        // from corners, then the loops
      for(Index h = 0; h < 4 * m.face_end(); ++h) {
        if(m.curve(h) < 0 || number[h] != -2) continue;
        if(round == 0) {
          const bool a = m.vertex(m.origin(h)).carrier == Carrier::corner;
          const bool b = m.vertex(m.target(h)).carrier == Carrier::corner;
          if(a)
            trace(h, m.origin(h), number);
          else if(b)
            trace(h, m.target(h), number);
        } else {
          trace(h, m.origin(h), number);
        }
      }
    for(Index h = 0; h < 4 * m.face_end(); ++h)
      if(m.curve(h) >= 0) m.set_curve(h, number[h]);
  }

private:
  // Follows the curve of h from vertex "from" to its end.
  void trace(Index h, Index from, std::vector<Index>& number)
  {
    Quad_complex& m = s_.mesh;
    const Index id = Index(s_.curves.size());
    const Index start = h;
    std::vector<Index> path = { from };
    Index v = from;
    while(h >= 0 && number[h] == -2) {
      number[h] = id;
      if(m.opposite(h) >= 0) number[m.opposite(h)] = id;
      const bool forward = m.origin(h) == v;
      v = forward ? m.target(h) : m.origin(h);
      path.push_back(v);
      if(m.vertex(v).carrier == Carrier::corner) break;
      h = next_feature(v, h);
    }
    const bool closed = v == from && m.vertex(from).carrier != Carrier::corner;
    std::vector<std::size_t> where;
    Feature_curve c(shape(path, closed, in_.has_frozen(start), where), closed, m.is_border(start),
                    in_.has_frozen(start));
    c.constrained = in_.has_constrained(start) ||
                    (m.opposite(start) >= 0 && in_.has_constrained(m.opposite(start)));
    if(!closed) {
      c.first_corner = from;
      c.last_corner = v;
    }
    for(std::size_t i = 0; i + (closed ? 1 : 0) < path.size(); ++i) {
      Vertex_record& r = m.vertex(path[i]);
      if(r.carrier != Carrier::curve) continue;
      r.curve = id;
      r.param = c.arcs()[where[i]];
    }
    s_.curves.push_back(std::move(c));
  }

  std::vector<Vec> shape(const std::vector<Index>& path, bool closed, bool frozen,
                         std::vector<std::size_t>& where)
  {
    std::vector<Vec> points;
    for(Index v : path) points.push_back(s_.mesh.point(v));
    const Hermite_curve smooth(points, closed);
    for(std::size_t i = 0; i + 1 < path.size(); ++i) {
      const Hermite_segment segment = smooth_ && !frozen
                                          ? smooth.segments()[i]
                                          : Hermite_segment::straight(points[i], points[i + 1]);
      edges_[std::minmax(path[i], path[i + 1])] =
          path[i] < path[i + 1] ? segment : segment.reversed();
    }
    return smooth.polyline(smooth_ && !frozen ? points_per_edge : 1, where);
  }

  // The other feature edge at curve node v, as a half-edge in whichever direction has a face.
  Index next_feature(Index v, Index h) const
  {
    const Quad_complex& m = s_.mesh;
    const Index o = m.opposite(h);
    Index last = -1;
    for(Index g : m.outgoing(v)) {
      if(m.curve(g) >= 0 && g != h && g != o) return g;
      last = m.prev(g);
    }
    return m.is_border(last) && last != h ? last : Index(-1);
  }

  const Input_mesh& in_;
  Adaptation_state& s_;
  bool smooth_;
  Hermite_edges edges_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CURVE_TRACER_H
