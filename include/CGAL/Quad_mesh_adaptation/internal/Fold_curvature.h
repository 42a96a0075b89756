// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FOLD_CURVATURE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FOLD_CURVATURE_H

#include <CGAL/Quad_mesh_adaptation/internal/Face_arrays.h>
#include <CGAL/Quad_mesh_adaptation/internal/Principal_curvatures.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The mean curvature about a vertex of flat triangles as a function of scale, from the turn across
// their edges (the normal cycle of Cohen-Steiner and Morvan, SoCG 2003).
//
// A straight line of length L over the middle of folds at distances s, that turn by t, is off them
// by the sum of t (L / 2 - |s|) / 2.  So the mean is taken with weights that fall linearly to zero
// at a distance where both a single fold and a steady curvature k give k L^2 / 8.
class Fold_curvature
{
public:
  // `is_feature`: by half-edge; what lies beyond those does not count.
  Fold_curvature(const Face_arrays& triangles, const std::vector<char>& is_feature)
      : mesh_(triangles), is_feature_(is_feature),
        reached_(std::size_t(triangles.number_of_faces()), -1)
  {
    normals_.reserve(std::size_t(mesh_.number_of_faces()));
    for(Index f = 0; f < mesh_.number_of_faces(); ++f)
      normals_.push_back(normalized(mesh_.area_vector(f)));
  }

  // Takes up the folds about a vertex between feature edges; its half-edges there are `fan`.
  void look_at_vertex(const std::vector<Index>& fan)
  {
    middle_ = mesh_.source(fan[0]);
    angle_ = 0;
    double area = 0;
    std::vector<Index> faces;
    for(Index g : fan) {
      const Vec a = mesh_.target(g) - middle_, b = mesh_.source(mesh_.prev(g)) - middle_;
      angle_ += angle_between(a, b);
      area += norm(cross(a, b)) / 6;
      faces.push_back(mesh_.face[g]);
    }
    look_around(faces, area);
  }

  // Those about the middle of an edge that is no feature: at its ends a fold may be half over.
  void look_at_edge(Index h)
  {
    const Index f = mesh_.face[h], g = mesh_.face[mesh_.opposite[h]];
    middle_ = 0.5 * (mesh_.source(h) + mesh_.target(h));
    angle_ = 2 * pi;
    look_around({ f, g }, norm(mesh_.area_vector(f)) + norm(mesh_.area_vector(g)));
  }

  // The largest length that a line may have here.  Beyond it the curvature is that of this length.
  double largest_length() const { return radius_ / share; }

  // As seen by a line of length L.
  Principal_curvatures operator()(double length) const
  {
    const double radius = (std::min)(share * length, radius_);
    if(!(angle_ > 0) || folds_.empty() || !(radius > 0)) return {};
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for(const Fold& f : folds_) {
      const double w = f.turn * weight(f, radius);
      if(w == 0) continue;
      const Eigen::Vector3d d(f.across.x(), f.across.y(), f.across.z());
      sum += w * d * d.transpose();
    }
    return Principal_curvatures(sum * (6 / (angle_ * radius * radius)));
  }

private:
  static constexpr double share = 3 / (2 * pi); // of the length
  static constexpr double far = 3;              // mean sides of the triangles

  // An edge, seen from the middle.
  struct Fold
  {
    double turn;            // positive where the surface is convex
    Vec across;             // in the surface, at right angles to the edge
    double apart, from, to; // of its line from the middle, and its ends along that
  };

  void look_around(const std::vector<Index>& faces, double area)
  {
    radius_ = far * std::sqrt(area);
    while(!gather(faces)) radius_ /= 2;
  }

  // Integral of 1 - r / radius along the edge within the radius.
  static double weight(const Fold& f, double radius)
  {
    if(!(f.apart < radius)) return 0;
    const double half = std::sqrt(radius * radius - f.apart * f.apart);
    const double a = (std::max)(f.from, -half), b = (std::min)(f.to, half);
    if(!(a < b)) return 0;
    const auto integral = [&](double s) { // of r
      const double r = std::hypot(s, f.apart);
      return 0.5 * (s * r + (f.apart > 0 ? f.apart * f.apart * std::asinh(s / f.apart) : 0.));
    };
    return b - a - (integral(b) - integral(a)) / radius;
  }

  // The folds within the radius that can be reached over the surface; false if these are too many.
  bool gather(const std::vector<Index>& middle_faces)
  {
    constexpr std::size_t most = 200; // faces
    ++round_;
    folds_.clear();
    std::vector<Index> faces;
    const auto reach = [&](Index f) {
      if(reached_[f] == round_) return;
      reached_[f] = round_;
      faces.push_back(f);
    };
    for(Index f : middle_faces) reach(f);
    const std::size_t first = faces.size();
    for(std::size_t i = 0; i < faces.size(); ++i) {
      if(faces.size() > most + first) return false;
      for(Index h = mesh_.first[faces[i]]; h < mesh_.first[faces[i] + 1]; ++h) {
        const Index o = mesh_.opposite[h];
        if(is_feature_[h] || distance_to(h) >= radius_) continue;
        if(h < o) add(h);
        reach(mesh_.face[o]);
      }
    }
    return true;
  }

  double distance_to(Index h) const
  {
    const Vec a = mesh_.source(h) - middle_, e = mesh_.target(h) - mesh_.source(h);
    const double t = e * e > 0 ? std::clamp(-(a * e) / (e * e), 0., 1.) : 0.;
    return norm(a + t * e);
  }

  void add(Index h)
  {
    const Vec &n = normals_[mesh_.face[h]], &m = normals_[mesh_.face[mesh_.opposite[h]]];
    const Vec axis = cross(n, m), a = mesh_.source(h) - middle_;
    const Vec edge = mesh_.target(h) - mesh_.source(h), along = normalized(edge);
    const double turn = std::atan2(norm(axis), n * m);
    if(!(turn > 1e-9)) return;
    const double from = a * along;
    // the ridge of a fold is off by the tangent of half its turn, up to a bound for sharp ones
    const double off = 2 * std::tan((std::min)(turn, 2.6) / 2);
    folds_.push_back({ axis * edge > 0 ? off : -off, normalized(cross(n + m, edge)),
                       norm(a - from * along), from, from + norm(edge) });
  }

  const Face_arrays& mesh_;
  const std::vector<char>& is_feature_;
  std::vector<Vec> normals_;
  std::vector<Index> reached_; // by face: the last round that did
  Index round_ = -1;
  Vec middle_ = Vec(0, 0, 0);
  double angle_ = 0, radius_ = 0; // about the middle
  std::vector<Fold> folds_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FOLD_CURVATURE_H
