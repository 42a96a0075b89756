// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CAVITY_CHECKS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CAVITY_CHECKS_H

// Part of Cavity.h: is a replacement legal?

#include <CGAL/Quad_mesh_adaptation/internal/Cavity.h>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

inline void Cavity::count_corners()
{
  const std::size_t n = nodes.size();
  old_corners_.assign(n, 0);
  new_corners_.assign(n, 0);
  total_corners_.assign(n, 0);
  for(Index f : old_faces)
    for(Index v : s_.mesh.quad(f)) ++old_corners_[local_of_[v]];
  for(const Cavity_quad& q : quads)
    for(int v : q.v) ++new_corners_[v];
  for(std::size_t i = 0; i < n; ++i)
    total_corners_[i] =
        (ids[i] >= 0 ? s_.mesh.vertex(ids[i]).faces - old_corners_[i] : 0) + new_corners_[i];
}

// Half-edges of the new quads by origin.
inline void Cavity::list_corners()
{
  corner_end_.assign(nodes.size() + 1, 0);
  for(const Cavity_quad& q : quads)
    for(int v : q.v) ++corner_end_[v + 1];
  for(std::size_t i = 1; i < corner_end_.size(); ++i) corner_end_[i] += corner_end_[i - 1];
  corner_list_.resize(4 * quads.size());
  for(int h = 0; h < int(4 * quads.size()); ++h) corner_list_[corner_end_[origin(h)]++] = h;
}

// The new half-edge from node u to node v, -1 if there is none.
inline int Cavity::new_halfedge(int u, int v) const
{
  for(int i = first_corner(u); i < corner_end_[u]; ++i)
    if(target(corner_list_[i]) == v) return corner_list_[i];
  return -1;
}

inline bool Cavity::match_inside()
{
  for(const Cavity_quad& q : quads)
    if(q.v[0] == q.v[2] || q.v[1] == q.v[3]) return false;
  list_corners();
  const int n = int(4 * quads.size());
  partner_.resize(n);
  outer_.assign(n, -1);
  for(int h = 0; h < n; ++h) {
    const int u = origin(h), v = target(h);
    if(u == v || new_halfedge(u, v) != h) return false; // the same edge twice
    partner_[h] = new_halfedge(v, u);
  }
  return true;
}

inline bool Cavity::match_outside()
{
  for(Index f : old_faces)
    for(Index g = 4 * f; g < 4 * f + 4; ++g) {
      const Index o = s_.mesh.opposite(g);
      if(o < 0 || face_mark_[s_.mesh.face(o)]) continue;
      const int h = new_halfedge(local_of_[s_.mesh.origin(g)], local_of_[s_.mesh.target(g)]);
      if(h < 0 || partner_[h] >= 0) return false;
      outer_[h] = o;
    }
  for(int h = 0; h < int(partner_.size()); ++h) {
    Index& c = quads[h >> 2].curve[h & 3];
    if(partner_[h] >= 0) {
      Index& d = quads[partner_[h] >> 2].curve[partner_[h] & 3];
      c = d = (std::max)(c, d);
      if(c >= 0 && s_.curves[c].is_border()) return false;
    } else if(outer_[h] >= 0) {
      c = s_.mesh.curve(outer_[h]);
    } else if(c < 0 || !s_.curves[c].is_border()) {
      return false; // would tear the mesh open
    }
  }
  return true;
}

// Each node keeps the number of curve edges it has.
inline bool Cavity::curves_kept()
{
  std::vector<int>& degree = degree_;
  degree.assign(nodes.size(), 0);
  bool any = false;
  for(Index f : old_faces)
    for(Index h = 4 * f; h < 4 * f + 4; ++h) {
      if(s_.mesh.curve(h) < 0) continue;
      any = true;
      const Index o = s_.mesh.opposite(h);
      if(o >= 0 && o < h && face_mark_[s_.mesh.face(o)]) continue;
      --degree[local_of_[s_.mesh.origin(h)]];
      --degree[local_of_[s_.mesh.target(h)]];
    }
  for(int h = 0; h < int(partner_.size()); ++h) {
    if(quads[h >> 2].curve[h & 3] < 0 || (partner_[h] >= 0 && partner_[h] < h)) continue;
    any = true;
    ++degree[origin(h)];
    ++degree[target(h)];
  }
  if(!any) return true;
  for(std::size_t n = 0; n < nodes.size(); ++n) {
    if(new_corners_[n] == 0) continue; // gone
    const int expected = ids[n] < 0 && nodes[n].carrier == Carrier::curve ? 2 : 0;
    if(degree[n] != expected) return false;
  }
  return true;
}

// Every node keeps one umbrella, and the region its Euler characteristic.
inline bool Cavity::umbrellas_whole()
{
  fan_count_.assign(nodes.size(), 0);
  old_fan_count_.assign(nodes.size(), 0);
  long euler = long(quads.size()) - long(old_faces.size());
  for(int h = 0; h < int(partner_.size()); ++h) {
    if(partner_[h] < 0) ++fan_count_[origin(h)];
    if(partner_[h] < h) --euler; // an edge is counted once: unmatched, or at its later half
  }
  for(Index f : old_faces)
    for(Index h = 4 * f; h < 4 * f + 4; ++h) {
      const Index o = s_.mesh.opposite(h);
      const bool inside = o >= 0 && face_mark_[s_.mesh.face(o)];
      if(!inside) ++old_fan_count_[local_of_[s_.mesh.origin(h)]];
      if(!inside || o < h) ++euler;
    }
  for(std::size_t n = 0; n < nodes.size(); ++n)
    euler += (new_corners_[n] > 0) - (old_corners_[n] > 0);
  if(euler != 0) return false;
  // walk each fan; what the walks do not reach is a second umbrella
  std::vector<int>& reached = reached_;
  reached.assign(nodes.size(), 0);
  for(int h = 0; h < int(partner_.size()); ++h) {
    const int n = origin(h);
    const bool start = partner_[h] < 0 || (fan_count_[n] == 0 && reached[n] == 0);
    if(!start) continue;
    int c = h;
    do {
      ++reached[n];
      c = partner_[(c & ~3) | ((c + 3) & 3)];
    } while(c >= 0 && c != h);
  }
  for(std::size_t n = 0; n < nodes.size(); ++n) {
    if(reached[n] != new_corners_[n]) return false;
    if(new_corners_[n] == 0) continue;
    const bool outside = total_corners_[n] != new_corners_[n];
    if(!outside && fan_count_[n] > 1) return false;
    if(outside && fan_count_[n] != old_fan_count_[n]) return false;
    if(outside && fan_count_[n] > 1 && !same_pairs(int(n))) return false;
  }
  return true;
}

// The fans at node n join the same neighbours as before.
inline bool Cavity::same_pairs(int n) const
{
  std::vector<std::pair<int, int>> before, after;
  for(int h = 0; h < int(partner_.size()); ++h) {
    if(origin(h) != n || partner_[h] >= 0) continue;
    int c = h, last = h;
    while(c >= 0) {
      last = c;
      c = partner_[(c & ~3) | ((c + 3) & 3)];
    }
    after.emplace_back(target(h), origin((last & ~3) | ((last + 3) & 3)));
  }
  const Quad_complex& m = s_.mesh;
  const auto inside = [&](Index h) { return h >= 0 && face_mark_[m.face(h)]; };
  for(Index f : old_faces)
    for(Index h = 4 * f; h < 4 * f + 4; ++h) {
      if(local_of_[m.origin(h)] != n || inside(m.opposite(h))) continue;
      Index c = h, last = h;
      while(inside(c)) {
        last = c;
        c = m.turn_left(c);
      }
      before.emplace_back(local_of_[m.target(h)], local_of_[m.origin(m.prev(last))]);
    }
  std::sort(before.begin(), before.end());
  std::sort(after.begin(), after.end());
  return before == after;
}

// A new inner edge must not run between vertices that an edge outside joins already.
inline bool Cavity::has_parallel_edge() const
{
  for(int h = 0; h < int(partner_.size()); ++h) {
    if(partner_[h] < h) continue;
    const int u = origin(h), v = target(h);
    if(ids[u] < 0 || ids[v] < 0 || is_inner(u) || is_inner(v)) continue;
    for(Index e : { s_.mesh.find_halfedge(ids[u], ids[v]), s_.mesh.find_halfedge(ids[v], ids[u]) })
      if(e >= 0 && !face_mark_[s_.mesh.face(e)]) return true;
  }
  return false;
}

// A new doublet (an inner node with two faces) is removed at once: its two quads
// (n, a, o1, b) and (n, b, o2, a) become (a, o1, b, o2).
inline bool Cavity::fuse_at(int n)
{
  int found[2] = { -1, -1 }, corner[2] = { 0, 0 }, count = 0;
  for(int k = 0; k < int(quads.size()) && count < 2; ++k)
    for(int i = 0; i < 4; ++i)
      if(quads[k].v[i] == n) {
        found[count] = k;
        corner[count++] = i;
        break;
      }
  if(count < 2) return false;
  const Cavity_quad p = quads[found[0]], q = quads[found[1]];
  const auto at = [](const Cavity_quad& f, int c, int i) { return f.v[(c + i) & 3]; };
  const auto curve = [](const Cavity_quad& f, int c, int i) { return f.curve[(c + i) & 3]; };
  const int c = corner[0], d = corner[1];
  if(at(p, c, 1) != at(q, d, 3) || at(p, c, 3) != at(q, d, 1)) return false;
  Cavity_quad fused;
  fused.v = { { at(p, c, 1), at(p, c, 2), at(p, c, 3), at(q, d, 2) } };
  fused.curve = { { curve(p, c, 1), curve(p, c, 2), curve(q, d, 1), curve(q, d, 2) } };
  fused.parent = p.parent;
  quads[found[0]] = fused;
  quads.erase(quads.begin() + found[1]);
  return true;
}

inline bool Cavity::remove_doublets()
{
  count_corners();
  for(std::size_t n = 0; n < nodes.size(); ++n) {
    const bool inner = ids[n] < 0 || !s_.mesh.is_border_vertex(ids[n]);
    if(total_corners_[n] != 2 || new_corners_[n] != 2 || !inner || nodes[n].frozen ||
       nodes[n].carrier != Carrier::surface)
      continue;
    if(!fuse_at(int(n))) return false;
    count_corners();
    n = std::size_t(-1); // its neighbours may be doublets now
  }
  return true;
}

inline bool Cavity::close()
{
  sizes_.clear();
  if(!remove_doublets() || !match_inside()) return false;
  for(std::size_t n = 0; n < nodes.size(); ++n) {
    const bool border = ids[n] >= 0 && s_.mesh.is_border_vertex(ids[n]);
    const bool gone = new_corners_[n] == 0;
    if(gone && ids[n] >= 0 &&
       (nodes[n].frozen || nodes[n].carrier == Carrier::corner || total_corners_[n] != 0))
      return false;
    const bool new_on_border =
        ids[n] < 0 && nodes[n].carrier == Carrier::curve && s_.curves[nodes[n].curve].is_border();
    if(!gone && !border && !new_on_border && total_corners_[n] < limit_of(n)) return false;
  }
  if(!match_outside() || !umbrellas_whole() || !curves_kept() || has_parallel_edge()) return false;
  measure_before();
  set_factors();
  return true;
}

// Fewest faces at an inner node: 3, or what it has already.
inline int Cavity::limit_of(std::size_t n) const
{
  return ids[n] >= 0 ? (std::min)(3, int(s_.mesh.vertex(ids[n]).faces)) : 3;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_CAVITY_CHECKS_H
