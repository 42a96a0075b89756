// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SOUP_MANIFOLD_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SOUP_MANIFOLD_H

#include <CGAL/Quad_mesh_adaptation/IO/Read_result.h>
#include <CGAL/Quad_mesh_adaptation/internal/polygon_soup.h>

#include <algorithm>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// The adjacency of the faces of a soup through its edges, and what can be wrong with it.
// Expects indices in range and no vertex twice in a face.  Sorting, not hashing: the same soup
// gives the same answer everywhere.
class Soup_manifold
{
public:
  explicit Soup_manifold(Polygon_soup& soup) : soup_(soup)
  {
    for(std::size_t f = 0; f < soup.faces.size(); ++f) {
      const Polygon_soup::Face& face = soup.faces[f];
      for(std::size_t i = 0; i < face.size(); ++i) {
        const Index a = face[i], b = face[(i + 1) % face.size()];
        sides_.push_back({ (std::min)(a, b), (std::max)(a, b), static_cast<Index>(f), a < b });
      }
    }
    std::sort(sides_.begin(), sides_.end());
  }

  /// At most two faces at an edge, no two faces of the same vertices.
  Read_result check_edges() const
  {
    for(std::size_t i = 0, end; i < sides_.size(); i = end) {
      end = end_of_edge(i);
      if(end - i > 2)
        return refuse(Refusal::non_manifold,
                      "the edge between vertices " + std::to_string(sides_[i].low) + " and " +
                          std::to_string(sides_[i].high) + " is shared by " +
                          std::to_string(end - i) + " faces (" + std::to_string(sides_[i].face) +
                          ", " + std::to_string(sides_[i + 1].face) + ", " +
                          std::to_string(sides_[i + 2].face) + (end - i > 3 ? " ..." : "") + ")",
                      sides_[i].low);
      if(end - i == 2 && have_same_vertices(sides_[i].face, sides_[i + 1].face))
        return refuse(Refusal::non_manifold,
                      "faces " + std::to_string(sides_[i].face) + " and " +
                          std::to_string(sides_[i + 1].face) + " have the same vertices",
                      sides_[i].face);
    }
    return {};
  }

  /// Turns faces until both faces of every edge run along it in opposite directions, the fewest
  /// possible per component.  `turned` counts them.  Needs `check_edges()`.
  Read_result orient(std::size_t& turned)
  {
    list_neighbours();
    std::vector<char> visited(soup_.faces.size(), 0), turn(soup_.faces.size(), 0);
    std::vector<Index> component;
    turned = 0;
    for(std::size_t seed = 0; seed < soup_.faces.size(); ++seed) {
      if(visited[seed]) continue;
      component.assign(1, static_cast<Index>(seed));
      visited[seed] = 1;
      for(std::size_t k = 0; k < component.size(); ++k) {
        const Index f = component[k];
        for(std::size_t n = first_neighbour_[f]; n < first_neighbour_[f + 1]; ++n) {
          const Neighbour& other = neighbours_[n];
          const char wanted = turn[f] != other.runs_alike;
          if(!visited[other.face]) {
            visited[other.face] = 1;
            turn[other.face] = wanted;
            component.push_back(other.face);
          } else if(turn[other.face] != wanted) {
            return refuse(
                Refusal::non_orientable,
                "the surface is one-sided, it cannot be oriented: going round it, faces " +
                    std::to_string(f) + " and " + std::to_string(other.face) +
                    " contradict each other",
                f);
          }
        }
      }
      turned += turn_component(component, turn);
    }
    return {};
  }

  /// The faces round every vertex form one fan.  Needs a successful `orient()`.
  Read_result check_vertices() const
  {
    // Round a vertex, each face leads from its next to its previous neighbour vertex: in one fan
    // the faces that can be reached from a start are all the faces there.
    std::vector<std::size_t> first(soup_.points.size() + 1, 0);
    for(const Polygon_soup::Face& face : soup_.faces)
      for(const Index v : face) ++first[v + 1];
    for(std::size_t v = 0; v < soup_.points.size(); ++v) first[v + 1] += first[v];
    std::vector<Corner> corners(first.back());
    std::vector<std::size_t> fill(first.begin(), first.end() - 1);
    for(const Polygon_soup::Face& face : soup_.faces)
      for(std::size_t i = 0; i < face.size(); ++i)
        corners[fill[face[i]]++] = { face[(i + 1) % face.size()],
                                     face[(i + face.size() - 1) % face.size()] };
    for(std::size_t v = 0; v < soup_.points.size(); ++v)
      if(!is_one_fan(corners.data() + first[v], first[v + 1] - first[v]))
        return refuse(Refusal::non_manifold,
                      "at vertex " + std::to_string(v) +
                          " parts of the surface touch that share no edge",
                      static_cast<long>(v));
    return {};
  }

private:
  // One face at an edge; `upward` when the face runs from the lower to the higher vertex.
  struct Side
  {
    Index low, high, face;
    bool upward;
    bool operator<(const Side& s) const
    {
      if(low != s.low) return low < s.low;
      if(high != s.high) return high < s.high;
      return face < s.face;
    }
  };
  struct Neighbour
  {
    Index face;
    bool runs_alike; // both faces run along their edge in the same direction
  };
  struct Corner
  {
    Index next, previous;
    bool operator<(const Corner& c) const { return next < c.next; }
  };

  std::size_t end_of_edge(std::size_t i) const
  {
    std::size_t end = i + 1;
    while(end < sides_.size() && sides_[end].low == sides_[i].low &&
          sides_[end].high == sides_[i].high)
      ++end;
    return end;
  }

  bool have_same_vertices(Index f, Index g) const
  {
    Polygon_soup::Face a = soup_.faces[f], b = soup_.faces[g];
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    return a == b;
  }

  void list_neighbours()
  {
    first_neighbour_.assign(soup_.faces.size() + 1, 0);
    for(std::size_t i = 0, end; i < sides_.size(); i = end) {
      end = end_of_edge(i);
      if(end - i == 2)
        for(std::size_t s = i; s < end; ++s) ++first_neighbour_[sides_[s].face + 1];
    }
    for(std::size_t f = 0; f < soup_.faces.size(); ++f)
      first_neighbour_[f + 1] += first_neighbour_[f];
    neighbours_.resize(first_neighbour_.back());
    std::vector<std::size_t> fill(first_neighbour_.begin(), first_neighbour_.end() - 1);
    for(std::size_t i = 0, end; i < sides_.size(); i = end) {
      end = end_of_edge(i);
      if(end - i != 2) continue;
      const Side &a = sides_[i], &b = sides_[i + 1];
      neighbours_[fill[a.face]++] = { b.face, a.upward == b.upward };
      neighbours_[fill[b.face]++] = { a.face, a.upward == b.upward };
    }
  }

  // Turns the smaller half of a component; gives the number of faces turned.
  std::size_t turn_component(const std::vector<Index>& component, const std::vector<char>& turn)
  {
    std::size_t marked = 0;
    for(const Index f : component) marked += turn[f];
    const bool turn_marked = 2 * marked <= component.size();
    for(const Index f : component)
      if((turn[f] != 0) == turn_marked) std::reverse(soup_.faces[f].begin(), soup_.faces[f].end());
    return turn_marked ? marked : component.size() - marked;
  }

  static bool is_one_fan(const Corner* corners, std::size_t n)
  {
    if(n < 2) return true;
    std::vector<Corner> fan(corners, corners + n);
    std::sort(fan.begin(), fan.end());
    const auto find = [&](Index next) {
      const auto it = std::lower_bound(fan.begin(), fan.end(), Corner{ next, 0 });
      return it != fan.end() && it->next == next ? it : fan.end();
    };
    // start where no face comes before, if there is such a place: the fan of a boundary vertex
    std::vector<Index> ends(n);
    for(std::size_t i = 0; i < n; ++i) ends[i] = fan[i].previous;
    std::sort(ends.begin(), ends.end());
    auto at = fan.begin();
    for(auto it = fan.begin(); it != fan.end(); ++it)
      if(!std::binary_search(ends.begin(), ends.end(), it->next)) at = it;
    std::size_t reached = 0;
    for(const auto start = at; at != fan.end();) {
      ++reached;
      at = find(at->previous);
      if(at == start) break;
    }
    return reached == n;
  }

  Polygon_soup& soup_;
  std::vector<Side> sides_;
  std::vector<Neighbour> neighbours_;
  std::vector<std::size_t> first_neighbour_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_SOUP_MANIFOLD_H
