// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MIRROR_TEST_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MIRROR_TEST_H

#include <CGAL/Quad_mesh_adaptation/internal/Adaptation_state.h>
#include <CGAL/Quad_mesh_adaptation/internal/Input_mesh.h>
#include <CGAL/Quad_mesh_adaptation/internal/Mirror_plane.h>
#include <CGAL/Quad_mesh_adaptation/internal/Point_lookup.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Is a plane a mirror plane of an input, of its constraints and of its sizes, along which it can be
// cut?  The state is that of the input, not adapted yet.  A test takes O(n log n) at most, and far
// less for most planes that are none.
class Mirror_test
{
public:
  static constexpr double accuracy = 1e-9; // of positions, over the diameter; of sizes

  // `reach`: largest distance of a vertex from the centre.
  Mirror_test(const Input_mesh& in, const Adaptation_state& s, const Vec& centre, double reach)
      : in_(in), s_(s), centre_(centre), tolerance_(2 * accuracy * reach)
  {
  }

  // Could the plane through the centre be one?  Looks at a few vertices only, for a face on both
  // sides, and at the sizes at some hundreds of vertices, so that a change of the sizes in a small
  // place costs no more than that.
  bool is_plausible(const Vec& normal)
  {
    if(!lookup_) lookup_.emplace(in_.points, tolerance_); // often there is no question
    const Mirror_plane p = plane_through_centre(normal);
    return maps_some(p, 7, false) && !cuts_a_face(p) &&
           maps_some(p, s_.size.is_constant() ? 50 : 500, true);
  }

  // The plane through the centre with all that is mapped by it, if it is a mirror plane.
  // Precondition: it is plausible.
  std::optional<Mirror_plane> operator()(const Vec& normal)
  {
    Mirror_plane p = plane_through_centre(normal);
    if(!map_points(p)) return std::nullopt;
    fit(p);
    if(!map_points(p) || !find_sides(p) || !map_faces(p) || !map_vertices(p)) return std::nullopt;
    if(!is_cut_along_edges(p) || !maps_constraints(p) || !maps_sizes(p)) return std::nullopt;
    return p;
  }

private:
  // Has one vertex in so many another one as image, with the same size where that is asked for?
  bool maps_some(const Mirror_plane& p, std::size_t parts, bool with_size) const
  {
    const std::size_t n = in_.points.size(), step = (std::max)(n / parts, std::size_t(1));
    for(std::size_t v = 0; v < n; v += step) {
      const Index image = lookup_->find(p.reflect(in_.points[v]));
      if(image < 0) return false;
      if(with_size && differ(s_.size.at(in_.points[v]), s_.size.at(in_.points[image])))
        return false;
    }
    return true;
  }

  // The lowest and the highest of a face, or 0.
  std::pair<double, double> heights(const Mirror_plane& p, const Quad& q) const
  {
    double low = 0, high = 0;
    for(Index v : q) {
      low = (std::min)(low, p.height(in_.points[v]));
      high = (std::max)(high, p.height(in_.points[v]));
    }
    return { low, high };
  }

  // Far beyond what the plane, which is not fitted yet, may be off.
  bool cuts_a_face(const Mirror_plane& p) const
  {
    const double far = 1000 * tolerance_;
    return std::any_of(in_.quads.begin(), in_.quads.end(), [&](const Quad& q) {
      const auto [low, high] = heights(p, q);
      return low < -far && high > far;
    });
  }

  static bool differ(double a, double b) { return !(std::abs(a - b) <= accuracy * a); }

  Index class_of(Index v) const { return lookup_->class_of(v); }
  Quad classes_of(const Quad& q) const
  {
    return { class_of(q[0]), class_of(q[1]), class_of(q[2]), class_of(q[3]) };
  }

  // The quad turned to start at its lowest number, and by how many corners it was turned.
  static std::pair<Quad, int> from_lowest(const Quad& q)
  {
    const int k = int(std::min_element(q.begin(), q.end()) - q.begin());
    return { { q[k], q[(k + 1) & 3], q[(k + 2) & 3], q[(k + 3) & 3] }, k };
  }

  Mirror_plane plane_through_centre(const Vec& normal) const
  {
    Mirror_plane p;
    p.normal = normal;
    p.offset = normal * centre_;
    return p;
  }

  bool map_points(const Mirror_plane& p)
  {
    image_.resize(in_.points.size());
    for(std::size_t v = 0; v < image_.size(); ++v) {
      image_[v] = lookup_->find(p.reflect(in_.points[v]));
      if(image_[v] < 0) return false;
    }
    return true;
  }

  // From two points to all of them.  An axis is taken as exact, and its plane goes through the
  // vertices on it to the last bit if they agree.
  void fit(Mirror_plane& p) const
  {
    Vec sum(0, 0, 0);
    for(std::size_t v = 0; v < image_.size(); ++v) {
      const Vec d = in_.points[v] - in_.points[image_[v]];
      sum = sum + (d * p.normal > 0 ? d : -d);
    }
    p.normal = normalized(sum);
    for(int i = 0; i < 3; ++i) {
      if(!(1 - std::abs(p.normal[i]) < accuracy * accuracy)) continue;
      p.axis = i;
      p.normal = Vec(i == 0, i == 1, i == 2);
    }
    constexpr double none = std::numeric_limits<double>::infinity();
    double offset = 0, low = none, high = -none;
    for(std::size_t v = 0; v < image_.size(); ++v) {
      offset += 0.5 * (p.normal * (in_.points[v] + in_.points[image_[v]]));
      if(p.axis < 0 || image_[v] != class_of(Index(v))) continue;
      const double x = in_.points[v][p.axis];
      low = (std::min)(low, x);
      high = (std::max)(high, x);
    }
    p.offset = low == high ? low : offset / double(image_.size());
  }

  // Faces in the plane or on both sides of it speak against it.
  bool find_sides(Mirror_plane& p) const
  {
    p.side.resize(in_.quads.size());
    for(std::size_t f = 0; f < in_.quads.size(); ++f) {
      const auto [low, high] = heights(p, in_.quads[f]);
      if((low < -tolerance_) == (high > tolerance_)) return false;
      p.side[f] = high > tolerance_ ? 1 : -1;
    }
    return true;
  }

  void sort_faces()
  {
    if(!faces_.empty()) return;
    for(const Quad& q : in_.quads)
      faces_.emplace_back(from_lowest(classes_of(q)).first, Index(faces_.size()));
    std::sort(faces_.begin(), faces_.end());
  }

  // Every face has a partner of opposite orientation, and only one.
  bool map_faces(Mirror_plane& p)
  {
    sort_faces();
    p.face_partner.resize(in_.quads.size());
    corner_shift_.resize(in_.quads.size());
    for(std::size_t f = 0; f < in_.quads.size(); ++f) {
      const Quad& q = in_.quads[f];
      const auto [key, turn] =
          from_lowest({ image_[q[0]], image_[q[3]], image_[q[2]], image_[q[1]] });
      const auto it = std::lower_bound(faces_.begin(), faces_.end(), std::make_pair(key, Index(0)));
      if(it == faces_.end() || it->first != key) return false;
      if(it + 1 != faces_.end() && (it + 1)->first == key) return false;
      const Index g = it->second;
      p.face_partner[f] = g;
      const int start = from_lowest(classes_of(in_.quads[g])).second;
      corner_shift_[f] = (start - turn + 4) & 3;
    }
    for(std::size_t f = 0; f < in_.quads.size(); ++f)
      if(p.face_partner[p.face_partner[f]] != Index(f)) return false;
    return true;
  }

  // Corner of the partner of face f that corner i is mapped to.
  int partner_corner(Index f, int i) const { return (corner_shift_[f] + 4 - i) & 3; }
  // Half-edge that half-edge i of face f is mapped to.
  Index partner_halfedge(const Mirror_plane& p, Index f, int i) const
  {
    return 4 * p.face_partner[f] + partner_corner(f, (i + 1) & 3);
  }

  // By their faces, so that vertices at the same place are told apart.
  bool map_vertices(Mirror_plane& p) const
  {
    p.vertex_partner.assign(in_.points.size(), -1);
    for(std::size_t f = 0; f < in_.quads.size(); ++f)
      for(int i = 0; i < 4; ++i) {
        const Index v = in_.quads[f][i];
        const Index w = in_.quads[p.face_partner[f]][partner_corner(Index(f), i)];
        if(p.vertex_partner[v] >= 0 && p.vertex_partner[v] != w) return false;
        p.vertex_partner[v] = w;
        if(distance(p.reflect(in_.points[v]), in_.points[w]) > tolerance_) return false;
      }
    for(Index w : p.vertex_partner)
      if(w < 0) return false;
    for(std::size_t v = 0; v < p.vertex_partner.size(); ++v)
      if(p.vertex_partner[p.vertex_partner[v]] != Index(v)) return false;
    return true;
  }

  // Where the sides meet, they meet in edges that stay in place.
  bool is_cut_along_edges(const Mirror_plane& p) const
  {
    const Quad_complex& m = s_.mesh;
    for(Index h = 0; h < 4 * m.face_end(); ++h) {
      const Index o = m.opposite(h);
      if(o < 0 || p.side[m.face(h)] == p.side[m.face(o)]) continue;
      if(!p.has_vertex(m.origin(h)) || !p.has_vertex(m.target(h))) return false;
    }
    return true;
  }

  bool maps_constraints(const Mirror_plane& p) const
  {
    for(Index f = 0; f < Index(in_.quads.size()); ++f) {
      if(!in_.patch.empty() && in_.patch[f] != in_.patch[p.face_partner[f]]) return false;
      for(int i = 0; i < 4; ++i) {
        const Index h = 4 * f + i, g = partner_halfedge(p, f, i);
        if(in_.has_constrained(h) != in_.has_constrained(g)) return false;
        if(in_.has_frozen(h) != in_.has_frozen(g)) return false;
        if((s_.mesh.curve(h) < 0) != (s_.mesh.curve(g) < 0)) return false;
      }
    }
    for(Index v = 0; v < Index(p.vertex_partner.size()); ++v) {
      const Vertex_record &r = s_.mesh.vertex(v), &q = s_.mesh.vertex(p.vertex_partner[v]);
      if(r.frozen != q.frozen || r.carrier != q.carrier) return false;
    }
    return true;
  }

  // Sizes are compared at vertices, middles of edges and centres of faces.
  bool maps_sizes(const Mirror_plane& p)
  {
    if(s_.size.is_constant()) return true;
    sample_sizes();
    for(Index f = 0; f < Index(in_.quads.size()); ++f) {
      if(differ(face_size_[f], face_size_[p.face_partner[f]])) return false;
      for(int i = 0; i < 4; ++i)
        if(differ(edge_size_[4 * f + i], edge_size_[partner_halfedge(p, f, i)])) return false;
    }
    for(Index v = 0; v < Index(p.vertex_partner.size()); ++v)
      if(differ(vertex_size_[v], vertex_size_[p.vertex_partner[v]])) return false;
    return true;
  }

  void sample_sizes()
  {
    if(!face_size_.empty()) return;
    for(const Vec& p : in_.points) vertex_size_.push_back(s_.size.at(p));
    edge_size_.resize(4 * in_.quads.size());
    for(Index f = 0; f < Index(in_.quads.size()); ++f) {
      const Quad& q = in_.quads[f];
      Vec sum(0, 0, 0);
      for(int i = 0; i < 4; ++i) {
        const Index o = s_.mesh.opposite(4 * f + i);
        const Vec &a = in_.points[q[i]], &b = in_.points[q[(i + 1) & 3]];
        edge_size_[4 * f + i] = o >= 0 && o < 4 * f + i ? edge_size_[o] : s_.size.at(0.5 * (a + b));
        sum = sum + a;
      }
      face_size_.push_back(s_.size.at(0.25 * sum));
    }
  }

  const Input_mesh& in_;
  const Adaptation_state& s_;
  Vec centre_;
  double tolerance_;
  std::optional<Point_lookup> lookup_;
  std::vector<std::pair<Quad, Index>> faces_; // classes of the corners from the lowest on, face
  std::vector<Index> image_;                  // class that a vertex is reflected to
  std::vector<int> corner_shift_;
  std::vector<double> vertex_size_, edge_size_, face_size_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_MIRROR_TEST_H
