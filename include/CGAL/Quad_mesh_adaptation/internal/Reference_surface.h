// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_REFERENCE_SURFACE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_REFERENCE_SURFACE_H

#include <CGAL/Quad_mesh_adaptation/internal/Box_tree.h>
#include <CGAL/Quad_mesh_adaptation/internal/Linked_triangles.h>
#include <CGAL/Quad_mesh_adaptation/internal/closest_point.h>
#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>
#include <CGAL/Quad_mesh_adaptation/internal/plane_of_triangles.h>

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// From a point of a triangle to the true surface above it.
using Surface_lift = std::function<Surface_point(const Vec& foot, Index triangle)>;

// The surface that nodes stay on: triangles (quads cut in two, for a tree over quads would see
// half of each), their adjacency, and a tree of boxes.  A node remembers the triangle it lies
// on; a small move is followed from triangle to neighbouring triangle, which is fast and cannot
// jump to another sheet; the tree finds where to start and takes over when the walk is lost.
// A node stays on its patch.  A lift, if set, takes the point found to the surface that the
// triangles only approximate.
class Reference_surface
{
public:
  Reference_surface() = default;

  // `sharp` is sorted.
  Reference_surface(std::vector<Vec> points, std::vector<std::array<Index, 3>> triangles,
                    const Edge_keys& sharp = {})
      : mesh_(std::move(points), std::move(triangles), sharp)
  {
    if(!detect_plane()) mesh_.provide_normals(Normals::kept);
  }

  // Of triangles whose neighbours across sides (i, i + 1) are known, and maybe their patches.
  Reference_surface(std::vector<Vec> points, std::vector<std::array<Index, 3>> triangles,
                    std::vector<std::array<Index, 3>> neighbours, std::vector<Index> patches,
                    Normals normals)
      : mesh_(std::move(points), std::move(triangles), std::move(neighbours), std::move(patches))
  {
    if(!detect_plane()) mesh_.provide_normals(normals);
  }

  void set_lift(Surface_lift lift)
  {
    lift_ = std::move(lift);
    if(planar_ && lift_) mesh_.provide_normals(Normals::kept);
    planar_ = planar_ && !lift_;
  }
  bool has_lift() const { return bool(lift_); }

  bool is_planar() const { return planar_; }
  std::size_t number_of_triangles() const { return mesh_.number_of_triangles(); }
  std::array<Vec, 3> triangle(Index t) const { return mesh_.triangle(t); }
  const std::vector<Vec>& points() const { return mesh_.points(); }
  const std::vector<std::array<Index, 3>>& triangles() const { return mesh_.triangles(); }
  // Across edge (i, i + 1) of triangle t; -1 at the border and at a sharp edge.
  Index neighbour(Index t, int i) const { return mesh_.neighbour(t, i); }
  Index patch(Index t) const { return mesh_.patch(t); }

  // Are triangles 2 f and 2 f + 1 the halves of a quad, as they are of face f of an input that is
  // its own reference?
  bool has_halves_of(Index f, const std::array<Vec, 4>& p) const
  {
    if(lift_ || 2 * std::size_t(f) + 1 >= number_of_triangles()) return false;
    const std::array<Index, 3>&a = triangles()[2 * f], &b = triangles()[2 * f + 1];
    if(a[0] != b[0] || a[2] != b[1]) return false;
    const std::vector<Vec>& at = points();
    const int i = at[a[0]] == p[0] ? 0 : 1;
    return at[a[0]] == p[i] && at[a[1]] == p[i + 1] && at[a[2]] == p[i + 2] &&
           at[b[2]] == p[(i + 3) & 3];
  }

  // Unit normal of triangle t; the plane's normal on a planar surface, whatever t.
  Vec normal(Index t) const { return planar_ ? plane_.normal : mesh_.normal(t); }

  // Point of the surface nearest to p and its normal, looked for from triangle `hint`, which is
  // updated; hint < 0 asks the tree.  With a lift, the foot on the triangles is shifted until the
  // point above it lies straight below p.
  Surface_point place(const Vec& p, Index& hint) const
  {
    Vec foot = nearest_foot(p, hint);
    if(!lift_) return { foot, normal(hint) };
    Surface_point q = lift_(foot, hint);
    for(int i = 0; i < 3; ++i) {
      const Vec off = p - q.point, aside = off - (off * q.normal) * q.normal;
      const auto c = triangle(hint);
      if(aside * aside < 1e-10 * norm(cross(c[1] - c[0], c[2] - c[0]))) break;
      foot = walk(foot + aside, hint);
      q = lift_(foot, hint);
    }
    return q;
  }
  Vec project(const Vec& p, Index& hint) const { return place(p, hint).point; }

  // Is the surface no farther than d from p, looked for from triangle `hint` on?  Takes the first
  // triangle that is near enough, which saves most of the way to the nearest.
  bool is_within(const Vec& p, double d, Index& hint) const
  {
    if(planar_ || lift_ || hint < 0) return distance(p, project(p, hint)) <= d;
    return (p - walk(p, hint, d * d)).squared_length() <= d * d;
  }

  // How far p is from the surface, looked for from triangle `hint` on; rather too much, but where
  // it is more than `enough`.
  double distance_from(const Vec& p, double enough, Index& hint) const
  {
    if(planar_ || lift_ || hint < 0) return distance(p, project(p, hint));
    return distance(p, walk(p, hint, enough * enough));
  }

  // The tree is built again when there is a question: after many at once its memory is worth more.
  void forget_tree() const
  {
    const std::lock_guard<std::mutex> lock(tree_->mutex);
    tree_->tree.reset();
  }

  // The point of the surface above a point of triangle t.
  Vec lifted(const Vec& foot, Index t) const { return lift_ ? lift_(foot, t).point : foot; }

  // Of the triangles, without lift.
  double distance_to(const Vec& p) const
  {
    Index hint = -1;
    return distance(p, locate(p, hint));
  }

  // On the triangles alone, also where they are planar: by walking from triangle t.
  Vec nearest_on(const Vec& p, Index& t) const { return walk(p, t); }
  // Of all triangles, also on a planar surface.
  Index nearest_triangle(const Vec& p) const
  {
    Index t = -1;
    locate(p, t);
    return t;
  }

  // The triangle nearest to p among those of a patch (-1: any) that do not face away from
  // `direction` (zero: all do); among all of them if there is none.
  Index find(const Vec& p, Index patch, const Vec& direction) const
  {
    if(planar_) return -1;
    const Index t = find_nearer(p, patch, direction, 1e150);
    return t >= 0 ? t : nearest_of_all(p).triangle;
  }

  // The same, but only triangles nearer than `within` are looked for, which takes far less time
  // where that is little; -1 if there is none.
  Index find_nearer(const Vec& p, Index patch, const Vec& direction, double within) const
  {
    if(planar_) return -1;
    const auto accept = [&](Index t) {
      return (patch < 0 || mesh_.patch(t) == patch) && !(normal(t) * direction < 0);
    };
    return tree().nearest(p, Corners_of{ *this }, accept, within).triangle;
  }

  // The same without the tree, for a few questions: all triangles are looked at.
  Index scan_nearer(const Vec& p, Index patch, const Vec& direction, double within) const
  {
    Index best = -1;
    double least = within * within;
    for(Index t = 0; t < Index(number_of_triangles()); ++t) {
      if(patch >= 0 && mesh_.patch(t) != patch) continue;
      const std::array<Vec, 3> c = triangle(t);
      double off = 0; // squared distance from the box of the triangle
      for(int i = 0; i < 3 && off < least; ++i) {
        const double x = (std::max)({ (std::min)({ c[0][i], c[1][i], c[2][i] }) - p[i],
                                      p[i] - (std::max)({ c[0][i], c[1][i], c[2][i] }), 0. });
        off += x * x;
      }
      if(off >= least || normal(t) * direction < 0) continue;
      const double d = (p - closest_on_triangle(p, c).point).squared_length();
      if(!(d < least)) continue;
      least = d;
      best = t;
    }
    return best;
  }

private:
  bool detect_plane()
  {
    const std::optional<Plane> plane = plane_of(mesh_);
    planar_ = bool(plane);
    if(plane) plane_ = *plane;
    return planar_;
  }

  struct Corners_of // what the tree asks
  {
    const Reference_surface& surface;
    std::array<Vec, 3> operator()(Index t) const { return surface.triangle(t); }
  };

  Vec nearest_foot(const Vec& p, Index& hint) const
  {
    if(planar_) return p - ((p - plane_.point) * plane_.normal) * plane_.normal;
    if(hint < 0) return locate(p, hint);
    return walk(p, hint);
  }

  Vec locate(const Vec& p, Index& t) const
  {
    const Box_tree::Nearest found = nearest_of_all(p);
    t = found.triangle;
    return found.point;
  }

  Vec walk(const Vec& p, Index& t, double near_enough = 0) const
  {
    const Index start = t;
    const Vec there = mesh_.walk(p, t, near_enough);
    if(t >= 0) return there;
    if(planar_) return locate(p, t);
    t = find(p, patch(start), normal(start));
    return closest_on_triangle(p, triangle(t)).point;
  }

  Box_tree::Nearest nearest_of_all(const Vec& p) const
  {
    return tree().nearest(
        p, Corners_of{ *this }, [](Index) { return true; }, 1e150);
  }

  // Built at the first question, by whichever thread asks it.
  const Box_tree& tree() const
  {
    const std::lock_guard<std::mutex> lock(tree_->mutex);
    if(!tree_->tree)
      tree_->tree = std::make_unique<Box_tree>(Index(number_of_triangles()), Corners_of{ *this });
    return *tree_->tree;
  }

  struct Tree_on_demand
  {
    std::mutex mutex;
    std::unique_ptr<Box_tree> tree;
  };

  Linked_triangles mesh_;
  Surface_lift lift_;
  bool planar_ = false;
  Plane plane_;
  std::shared_ptr<Tree_on_demand> tree_ = std::make_shared<Tree_on_demand>(); // of all copies
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_REFERENCE_SURFACE_H
