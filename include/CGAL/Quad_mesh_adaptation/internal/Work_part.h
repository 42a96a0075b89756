// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_WORK_PART_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_WORK_PART_H

#include <CGAL/Quad_mesh_adaptation/internal/Mesh_triangles.h>
#include <CGAL/Quad_mesh_adaptation/internal/Part_choice.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Takes the part of a large mesh that is worked on out of it, for as long as the work lasts: what
// goes over all faces, or keeps a copy of them, costs as little as the part is small then.  Its
// edges to the rest are frozen, far enough from where anything happens.
class Work_part
{
public:
  // Precondition: the choice is separable, or it was made with so few rings about `work`, and all
  // that is done are operations and moves.  `is_on_own`: all faces are their own triangles of the
  // reference still, and nobody has asked what they cover yet.
  Work_part(Adaptation_state& s, const std::vector<Index>& work, const Part_choice& choice,
            int rings = rings_to_work_on, bool is_on_own = false)
      : s_(s), is_on_own_(is_on_own), face_(choice.faces())
  {
    // later the witnesses of all faces would come to those of the part
    if(!is_on_own_) s.prepare_coverage();
    const std::vector<char> region = nodes_around(s.mesh, work, rings);
    whole_ = std::exchange(s.mesh, Quad_complex());
    s.curves.push_back(Feature_curve({}, false, false, true)); // the edges to the rest
    copy_part(choice, region);
    for(Index f : work)
      work_.push_back(Index(std::lower_bound(face_.begin(), face_.end(), f) - face_.begin()));
    take_values();
    if(is_on_own_)
      s.coverage.prepare_part(s.mesh, Mesh_triangles(s.mesh).surface(true, Normals::kept), s.size,
                              s.reference_patch);
    tell_of_whole();
  }

  Work_part(const Work_part&) = delete;
  Work_part& operator=(const Work_part&) = delete;

  // The faces to work on by their numbers in the part.
  const std::vector<Index>& work() const { return work_; }

  // The state is that of the whole again.
  void put_back()
  {
    s_.prepare_coverage();
    part_ = std::move(s_.mesh);
    number_faces_and_nodes();
    write_faces();
    write_nodes();
    s_.mesh = std::move(whole_);
    give_corners_back();
    s_.curves.pop_back();
    s_.end_phase = std::move(end_phase_);
    give_values();
    s_.region.clear();
    s_.restless.assign(s_.mesh.vertex_end(), 0);
    s_.stirred.assign(s_.mesh.vertex_end(), 0);
  }

private:
  void copy_part(const Part_choice& choice, const std::vector<char>& region)
  {
    Quad_complex& m = s_.mesh;
    std::vector<Index> node(whole_.vertex_end(), -1), face(whole_.face_end(), -1);
    for(std::size_t i = 0; i < face_.size(); ++i) face[face_[i]] = Index(i);
    m.reserve(2 * face_.size(), 2 * face_.size()); // the part may well grow
    for(Index f : face_)
      for(Index v : whole_.quad(f)) {
        if(node[v] >= 0) continue;
        node[v] = m.add_vertex(whole_.vertex(v));
        node_.push_back(v);
        s_.region.push_back(region[v]);
      }
    m.protect_vertices_below(Index(node_.size()));
    for(Index f : face_) {
      const Quad q = whole_.quad(f);
      m.add_face({ node[q[0]], node[q[1]], node[q[2]], node[q[3]] }, whole_.patch(f));
    }
    rename_corners(node);
    outside_.assign(node_.size(), -1);
    for(Index h = 0; h < 4 * m.face_end(); ++h) link(choice, face, h);
    for(Index h = 0; h < 4 * m.face_end(); ++h) m.refresh_vertex(m.origin(h), h);
  }

  void link(const Part_choice& choice, const std::vector<Index>& face, Index h)
  {
    Quad_complex& m = s_.mesh;
    const Index there = 4 * face_[m.face(h)] + (h & 3), o = whole_.opposite(there);
    if(o >= 0 && choice.has(whole_.face(o))) {
      m.set_opposites(h, 4 * face[whole_.face(o)] + (o & 3));
      m.set_curve(h, whole_.curve(there));
    } else if(o < 0) {
      m.set_curve(h, whole_.curve(there));
    } else {
      m.set_curve(h, Index(s_.curves.size()) - 1);
      outside_[m.origin(h)] = o;
      hold(m.vertex(m.origin(h)));
      hold(m.vertex(m.target(h)));
    }
  }

  // The ends of curves by their numbers in the part; others than all of these where they are not in
  // it.
  void rename_corners(const std::vector<Index>& node)
  {
    const auto rename = [&](Index& corner) {
      corners_.push_back(corner);
      if(corner >= 0) corner = node[corner] >= 0 ? node[corner] : -2 - corner;
    };
    for(Feature_curve& c : s_.curves) {
      rename(c.first_corner);
      rename(c.last_corner);
    }
  }

  void give_corners_back()
  {
    auto corner = corners_.begin();
    for(Feature_curve& c : s_.curves) {
      c.first_corner = *corner++;
      c.last_corner = *corner++;
    }
  }

  static void hold(Vertex_record& r)
  {
    r.frozen = true;
    if(r.carrier == Carrier::surface) r.carrier = Carrier::corner;
  }

  void take_values()
  {
    sizes_ = std::move(s_.sizes);
    ratios_ = std::move(s_.ratios);
    for(Index f : face_) ratios_.forget(f);
    s_.sizes = Face_values<double>();
    s_.forget_ratios();
    s_.forget_values();
    for(std::size_t i = 0; i < face_.size(); ++i) {
      if(!sizes_.is_known(face_[i])) continue;
      s_.sizes.set(Index(i), sizes_[face_[i]], s_.mesh.face_end());
      sizes_.forget(face_[i]);
    }
    s_.coverage.leave_to(face_);
    s_.disturb_all();
    s_.stir_all();
  }

  void give_values()
  {
    const Face_values<double> of_part = std::move(s_.sizes);
    s_.sizes = Face_values<double>();
    s_.forget_values();
    s_.sizes = std::move(sizes_);
    s_.ratios = std::move(ratios_);
    for(Index f = 0; f < Index(face_.size()); ++f)
      if(face_[f] >= 0 && of_part.is_known(f))
        s_.sizes.set(face_[f], of_part[f], s_.mesh.face_end());
    if(is_on_own_)
      s_.coverage.forget();
    else
      s_.coverage.take_back(face_, s_.mesh.face_end());
  }

  // Observers are told of all faces.
  void tell_of_whole()
  {
    end_phase_ = s_.end_phase;
    const std::size_t rest = std::size_t(whole_.number_of_faces()) - face_.size();
    s_.end_phase = [told = end_phase_, rest](const char* name, std::size_t faces) {
      told(name, rest + faces);
    };
  }

  // Numbers in the whole of what is in the part now; what has gone is removed there first.
  void number_faces_and_nodes()
  {
    const std::size_t faces = face_.size(), nodes = node_.size();
    const auto take = [](Index& number) { return std::exchange(number, Index(-1)); };
    for(std::size_t i = 0; i < faces; ++i)
      if(!part_.is_face(Index(i))) whole_.remove_face(take(face_[i]));
    for(std::size_t i = 0; i < nodes; ++i)
      if(!part_.is_vertex(Index(i))) whole_.remove_vertex(take(node_[i]));
    for(Index v = Index(nodes); v < part_.vertex_end(); ++v)
      node_.push_back(part_.is_vertex(v) ? whole_.add_vertex(part_.vertex(v)) : Index(-1));
    for(Index f = Index(faces); f < part_.face_end(); ++f)
      face_.push_back(part_.is_face(f) ? whole_.add_face({ -1, -1, -1, -1 }, -1) : Index(-1));
  }

  void write_faces()
  {
    const Index frozen = Index(s_.curves.size()) - 1;
    const auto there = [&](Index h) { return 4 * face_[part_.face(h)] + (h & 3); };
    for(Index f : part_.faces()) {
      const Quad q = part_.quad(f);
      whole_.set_quad(face_[f], { node_[q[0]], node_[q[1]], node_[q[2]], node_[q[3]] });
      whole_.set_patch(face_[f], part_.patch(f));
    }
    for(Index h : part_.halfedges()) {
      const Index o = part_.opposite(h), c = part_.curve(h);
      if(o < 0 && c == frozen) {
        const Index outside = outside_[part_.origin(h)];
        whole_.set_opposites(there(h), outside);
        whole_.set_curve(outside, whole_.curve(outside));
      } else {
        if(o >= 0) whole_.set_opposites(there(h), there(o));
        whole_.set_curve(there(h), c);
      }
    }
  }

  void write_nodes()
  {
    for(Index h : part_.halfedges()) {
      const Index v = part_.origin(h);
      if(part_.vertex(v).halfedge != h) continue; // once for each
      Vertex_record& r = whole_.vertex(node_[v]);
      const Vertex_record old = r;
      r = part_.vertex(v);
      r.frozen = old.frozen; // nodes are held for the time of the work only
      r.carrier = old.carrier;
      whole_.refresh_vertex(node_[v], 4 * face_[part_.face(h)] + (h & 3));
    }
  }

  Adaptation_state& s_;
  bool is_on_own_;
  Quad_complex whole_, part_;
  std::vector<Index> face_, node_;    // of the part: their numbers in the whole
  std::vector<Index> work_, corners_; // corners_: two of each curve, in the whole
  std::vector<Index> outside_; // by node of the part: the half-edge of the rest that leads to it
  Face_values<double> sizes_, ratios_; // of the whole
  std::function<void(const char*, std::size_t)> end_phase_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_WORK_PART_H
