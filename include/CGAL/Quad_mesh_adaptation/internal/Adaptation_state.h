// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ADAPTATION_STATE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ADAPTATION_STATE_H

#include <CGAL/Quad_mesh_adaptation/internal/Coverage.h>
#include <CGAL/Quad_mesh_adaptation/internal/Feature_curve.h>
#include <CGAL/Quad_mesh_adaptation/internal/Reference_surface.h>
#include <CGAL/Quad_mesh_adaptation/internal/Run_record.h>
#include <CGAL/Quad_mesh_adaptation/internal/Sized_mesh.h>
#include <CGAL/Quad_mesh_adaptation/internal/Smoothing_weights.h>
#include <CGAL/Quad_mesh_adaptation/internal/Workers.h>
#include <CGAL/Quad_mesh_adaptation/internal/face_energy.h>
#include <CGAL/Quad_mesh_adaptation/internal/stray_creases.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Everything the phases work on: a compact copy of the caller's mesh, so that the call is
// transactional and the heavy code is compiled once, whatever the mesh type.
struct Adaptation_state : Run_record, Sized_mesh
{
  std::vector<Feature_curve> curves;
  Reference_surface surface;
  std::vector<Index> given_patch;            // by the patch of a face: the caller's
  std::vector<Index> reference_patch;        // by the patch of a face: the surface's; -1: not known
  std::function<Vec(const Vec&)> curve_lift; // from a curve's polyline to the true curve, if set
  Coverage coverage; // of bends of the surface by the mesh, see prepare_coverage()
  Energy_weights energy;
  double max_distance = (std::numeric_limits<double>::infinity)(); // to the reference, see
                                                                   // distance_guard.h
  Smoothing_weights smoothing;

  Workers workers;                       // for what can be done side by side
  std::size_t copies = 1;                // mirror images that make the whole mesh
  int order = 0;                         // of walks, see Walk: other ways to choose among equals
  std::size_t turned_faces = 0;          // of a curved input: upside down, in tangles
  Creases_taken_back creases_taken_back; // of the input

  Facing reference_normal(Index f) const
  {
    Facing r;
    for(Index v : mesh.quad(f)) r.add(mesh.vertex(v).normal);
    return r;
  }

  double face_energy(const Corners& p, const Facing& reference, double floor) const
  {
    return face_energy_for(p, reference, target(p, floor));
  }

  // With a given wanted size.
  double face_energy_for(const Corners& p, const Facing& reference, double wanted) const
  {
    const Vec n = facing(p, reference.sum);
    return energy.face + energy.shape * shape_cost(p, n) +
           energy.oversize_cost(mean_edge_length(p) / wanted) +
           energy.turn_cost(reference.mean_cosine(n));
  }

  double face_energy(Index f) const
  {
    return face_energy_for(corners(f), reference_normal(f),
                           (std::max)(wanted_size(f), face_floor(f)));
  }

  double cached_energy(Index f)
  {
    if(!energies.is_known(f)) energies.set(f, float(face_energy(f)), mesh.face_end());
    return energies[f];
  }

  void forget_faces()
  {
    forget_values();
    coverage.lose();
  }
  // In the end, when nothing will be changed any more.
  void forget_work()
  {
    energies = factors = Face_values<float>();
    factor_age = std::vector<std::uint8_t>();
    region = restless = stirred = std::vector<char>();
    coverage.forget_bends();
  }
  // When all that was to be known of it is.
  void forget_surface()
  {
    surface = Reference_surface();
    coverage = Coverage();
    forget_work();
    sizes = ratios = Face_values<double>();
  }
  // Face `order[i]` has number i now.
  void renumber_faces(const std::vector<Index>& order)
  {
    forget_values();
    coverage.renumber(order);
  }

  // Before threads ask for values of faces, disturb and stir: nothing has to grow then.
  void make_room()
  {
    fit_values(mesh.face_end());
    coverage.fit(mesh.face_end());
    restless.resize(mesh.vertex_end(), 1);
    stirred.resize(mesh.vertex_end(), 1);
  }

  // Before anything that moves nodes or replaces faces; next to nothing if nothing has changed.
  void prepare_coverage() { coverage.prepare(mesh, surface, size, reference_patch); }

  // From now on everything works against `factor` times the sizes of now.
  void scale_sizes(double factor)
  {
    size.scale_by(factor * size.scale());
    for(Index v = 0; v < mesh.vertex_end(); ++v) mesh.vertex(v).h *= factor;
    limit_distance(factor * factor * max_distance); // as faces of these sizes come to lie
    if(factor != 1) forget_sizes();
    disturb_all();
    stir_all();
  }

  // Once the sizes come from something else.
  void renew_sizes()
  {
    for(Index v : mesh.vertices()) mesh.vertex(v).h = size.at(mesh.point(v));
    forget_sizes();
  }

  // From now on.
  void limit_distance(double allowed)
  {
    max_distance = allowed;
    coverage.set_bound(allowed);
  }

  // Does the face turn away from the direction it should show?
  static bool is_folded(const Corners& p, const Vec& reference)
  {
    const Vec n = area_vector(p);
    const double lr = norm(reference);
    // the sum of normals that nearly cancel says nothing
    return lr > 0.7 && !(n * reference > 0.1 * norm(n) * lr);
  }

  // The face's own unit normal, or the reference's where the face is folded over.
  static Vec facing(const Corners& p, const Vec& reference)
  {
    return is_folded(p, reference) ? normalized(reference) : normalized(area_vector(p));
  }

  // Scaled Jacobian of a face, or how flat it is or follows the surface if that is less; -1 where
  // it is folded over.
  static double face_quality(const Corners& p, const Facing& reference)
  {
    if(is_folded(p, reference.sum)) return -1;
    return (std::min)({ scaled_jacobian(p), flatness(warp(p)),
                        following(reference.mean_cosine(normalized(area_vector(p)))) });
  }

  // Is node v a vertex of the surface with the same number, as those of an input that is its own
  // reference are?  It lies on it to the last bit, then.
  bool is_own_vertex(Index v) const
  {
    const Vertex_record& r = mesh.vertex(v);
    return r.carrier == Carrier::surface && r.hint >= 0 && !surface.is_planar() &&
           !surface.has_lift() && std::size_t(v) < surface.points().size() &&
           surface.points()[v] == r.p;
  }

  // How many images of the faces at a node will meet there.
  int images_at(const Vertex_record& r) const
  {
    return r.carrier == Carrier::curve ? curves[r.curve].images : r.images;
  }

  // Where the mesh ends at a mirror plane, each image pays its share of what is wrong with the
  // whole, and more for a face too many: the whole has as many too many as there are images.
  double valence_energy(int faces, const Vertex_record& r) const
  {
    const double d = faces - r.ideal_faces;
    const int images = images_at(r);
    return energy.valence * (d > 0 ? images * images : images) * d * d;
  }

  // Puts a node where it belongs on its carrier and refreshes what hangs on its position.
  // A node on a curve takes its position from r.param.
  void place(Vertex_record& r) const
  {
    put_on_carrier(r);
    r.h = size.at(r.p);
  }

  // The same but for the size.
  void put_on_carrier(Vertex_record& r) const
  {
    if(r.carrier == Carrier::curve) {
      const Feature_curve& c = curves[r.curve];
      r.param = c.wrapped(r.param);
      r.p = c.point(r.param);
      if(curve_lift && !c.is_frozen()) r.p = curve_lift(r.p);
    } else if(r.carrier == Carrier::surface) {
      const Surface_point on = surface.place(r.p, r.hint);
      r.p = on.point;
      r.normal = on.normal;
    }
  }

  // The triangle of the reference surface from where to look for a new node at p inside face f:
  // that of a corner that lies on the surface, of f or of a neighbour within its patch, else the
  // nearest one on the patch, for which the tree may have to be built.
  Index triangle_near(Index f, const Vec& p) const
  {
    const Index hint = triangle_about(f);
    return hint >= 0 ? hint : surface.find(p, reference_patch_of(f), area_vector(corners(f)));
  }

  // The same by corners alone; -1 if none of them lies on the surface.
  Index triangle_about(Index f) const
  {
    Index hint = triangle_at_corner(f);
    for(Index h = 4 * f; h < 4 * f + 4 && hint < 0; ++h)
      if(!mesh.is_border(h) && mesh.curve(h) < 0)
        hint = triangle_at_corner(mesh.face(mesh.opposite(h)));
    return hint;
  }

  // The patch of the reference on which face f lies; -1 if that is not known.
  Index reference_patch_of(Index f) const
  {
    const Index k = mesh.patch(f);
    return k < Index(reference_patch.size()) ? reference_patch[k] : Index(-1);
  }

private:
  Index triangle_at_corner(Index f) const
  {
    for(Index v : mesh.quad(f))
      if(mesh.vertex(v).carrier == Carrier::surface && mesh.vertex(v).hint >= 0)
        return mesh.vertex(v).hint;
    return -1;
  }
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_ADAPTATION_STATE_H
