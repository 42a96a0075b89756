// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CAVITY_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CAVITY_H

#include <CGAL/Quad_mesh_adaptation/internal/Node_relaxation.h>
#include <CGAL/Quad_mesh_adaptation/internal/crease_sides.h>
#include <CGAL/Quad_mesh_adaptation/internal/curve_order.h>
#include <CGAL/Quad_mesh_adaptation/internal/distance_guard.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// One quad of the replacement: nodes by their number in the cavity, the curve each of its edges
// lies on (-1: none), and the old face it descends from.
struct Cavity_quad
{
  std::array<int, 4> v;
  std::array<Index, 4> curve;
  Index parent;
};

// An operation on the mesh: some old faces and what replaces them.  Operators only describe a
// cavity; it is checked, relaxed and judged in scratch memory here, and committed or dropped.
//
// Use: clear(), add_old_face()..., add_quad()..., then close(); if that is true relax(),
// energy_after() against energy_before(), and commit() or nothing.
class Cavity
{
public:
  explicit Cavity(Adaptation_state& state) : s_(state), relax_(state) {}

  std::vector<Index> old_faces;
  std::vector<Cavity_quad> quads;
  std::vector<Vertex_record> nodes;
  std::vector<Index> ids; // of the nodes in the mesh, -1 for a new one

  void clear()
  {
    for(Index f : old_faces) face_mark_[f] = 0;
    for(Index v : ids)
      if(v >= 0) local_of_[v] = -1;
    old_faces.clear();
    quads.clear();
    nodes.clear();
    ids.clear();
    if(Index(face_mark_.size()) < s_.mesh.face_end()) face_mark_.resize(s_.mesh.face_end(), 0);
    if(Index(local_of_.size()) < s_.mesh.vertex_end()) local_of_.resize(s_.mesh.vertex_end(), -1);
  }

  bool has_old_face(Index f) const { return face_mark_[f] != 0; }

  void add_old_face(Index f)
  {
    if(face_mark_[f]) return;
    face_mark_[f] = 1;
    old_faces.push_back(f);
    for(Index v : s_.mesh.quad(f)) node(v);
  }

  void add_old_star(Index v)
  {
    for(Index h : s_.mesh.outgoing(v)) add_old_face(s_.mesh.face(h));
  }

  // Number of vertex v in the cavity.
  int node(Index v)
  {
    if(local_of_[v] < 0) {
      local_of_[v] = int(nodes.size());
      nodes.push_back(s_.mesh.vertex(v));
      ids.push_back(v);
    }
    return local_of_[v];
  }

  int add_new_node(const Vertex_record& r)
  {
    nodes.push_back(r);
    nodes.back().faces = 0;
    ids.push_back(-1);
    return int(nodes.size()) - 1;
  }

  void add_quad(int a, int b, int c, int d, std::array<Index, 4> curve, Index parent)
  {
    quads.push_back({ { { a, b, c, d } }, curve, parent });
  }

  // Old face f again, as it is, with node numbers.
  Cavity_quad copy_of(Index f)
  {
    Cavity_quad q;
    for(int i = 0; i < 4; ++i) {
      q.v[i] = node(s_.mesh.origin(4 * f + i));
      q.curve[i] = s_.mesh.curve(4 * f + i);
    }
    q.parent = f;
    return q;
  }

  // Adds the faces around the cavity as they are, so that relax() may move its border nodes too.
  void add_halo()
  {
    const std::size_t n = ids.size();
    for(std::size_t i = 0; i < n; ++i) {
      if(ids[i] < 0) continue;
      for(Index h : s_.mesh.outgoing(ids[i])) {
        const Index f = s_.mesh.face(h);
        if(!has_old_face(f)) {
          add_old_face(f);
          quads.push_back(copy_of(f));
        }
      }
    }
  }

  // Checks that the replacement fits: same boundary, manifold, same topology, curves kept, no
  // two edges between the same nodes, no doublet left inside.
  bool close();

  // Moves the inner nodes, `sweeps` times each, to better places.
  void relax(int sweeps);

  double energy_before() const { return energy_before_; }
  double energy_after();
  double estimate_after(); // roughly energy_after(), for less
  // Least quality of a face, negative where one is folded over or a curve is, and largest size
  // ratio.
  double worst_before() const;
  double worst_after() const;
  // Does no face fall below `least`, or below the worst there was, is as much of the surface
  // covered as before, and is none farther off than allowed that was not?
  bool keeps_shape(double least) const;
  double largest_before() const;
  double largest_after() const;

  // Replaces the old faces; `touched`, if given, receives the vertices around.
  void commit(std::vector<Index>* touched = nullptr);

private:
  bool remove_doublets();
  bool fuse_at(int n);
  void list_corners();
  int first_corner(int n) const { return n == 0 ? 0 : corner_end_[n - 1]; }
  int new_halfedge(int u, int v) const;
  bool match_inside();
  bool match_outside();
  bool curves_kept();
  bool umbrellas_whole();
  bool same_pairs(int n) const;
  bool curves_in_order() const;
  bool keeps_surface_covered() const;
  bool keeps_distance() const;
  bool is_within_bound_after() const;
  Index hint_for(const Cavity_quad& q) const;
  double distance_after() const;
  bool has_parallel_edge() const;
  void count_corners();
  int limit_of(std::size_t n) const;
  void measure_before();
  double valences_after() const;
  int side_difference_after(int n) const;
  void set_factors();
  void find_sizes();
  void gather(int n);
  bool is_inner(int n) const { return total_corners_[n] == new_corners_[n] && new_corners_[n] > 0; }
  int origin(int h) const { return quads[h >> 2].v[h & 3]; }
  int target(int h) const { return quads[h >> 2].v[(h + 1) & 3]; }
  Corners corners_of(const Cavity_quad& q) const
  {
    return { nodes[q.v[0]].p, nodes[q.v[1]].p, nodes[q.v[2]].p, nodes[q.v[3]].p };
  }
  Facing reference_of(const Cavity_quad& q) const
  {
    Facing r;
    for(int v : q.v) r.add(nodes[v].normal);
    if(r.count == 0 && q.parent >= 0) r.add(normalized(area_vector(s_.corners(q.parent))));
    return r;
  }
  double floor_of(const Cavity_quad& q) const
  {
    return 0.25 *
           (nodes[q.v[0]].floor + nodes[q.v[1]].floor + nodes[q.v[2]].floor + nodes[q.v[3]].floor);
  }
  template <typename Visit>
  void for_each_witness(const Visit& visit);
  void gather_near(Index f);
  void write_faces(std::vector<Index>& face_of);
  void write_links(const std::vector<Index>& face_of);
  void write_nodes(const std::vector<Index>& face_of, std::vector<Index>* touched);

  Adaptation_state& s_;
  Node_relaxation relax_;
  std::vector<char> face_mark_;
  std::vector<int> local_of_;
  std::vector<int> partner_; // of new half-edges, inside the cavity
  std::vector<Index> outer_; // or in the mesh outside
  std::vector<int> old_corners_, new_corners_, total_corners_;
  std::vector<int> fan_count_, old_fan_count_, reached_, degree_;
  std::vector<int> corner_end_, corner_list_; // new half-edges by origin
  std::vector<double> factors_;               // wanted size over sum of nodal sizes, by quad
  std::vector<double> sizes_;                 // wanted, by quad; empty: nodes have moved since
  std::vector<int> near_;                     // quads about an old face
  Covering_faces near_covers_;                // the same
  double energy_before_ = 0;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#include <CGAL/Quad_mesh_adaptation/internal/cavity_checks.h>
#include <CGAL/Quad_mesh_adaptation/internal/cavity_commit.h>
#include <CGAL/Quad_mesh_adaptation/internal/cavity_energy.h>

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CAVITY_H
