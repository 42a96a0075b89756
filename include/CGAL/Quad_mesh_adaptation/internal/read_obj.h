// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_READ_OBJ_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_READ_OBJ_H

#include <CGAL/Quad_mesh_adaptation/IO/Mesh_fields.h>
#include <CGAL/Quad_mesh_adaptation/IO/Read_result.h>
#include <CGAL/Quad_mesh_adaptation/internal/field_names.h>
#include <CGAL/Quad_mesh_adaptation/internal/file_lines.h>
#include <CGAL/Quad_mesh_adaptation/internal/polygon_soup.h>

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// What the statements of an OBJ file say about the faces that follow.
class Obj_patches
{
public:
  // "g name ..." and "usemtl name" hold until the next of their kind.
  void set_group(Word_scanner words) { set(rest_of(words), material_); }
  void set_material(Word_scanner words) { set(group_, rest_of(words)); }

  void add_face(Mesh_fields& fields)
  {
    if(now_ < 0) now_ = number(fields);
    if(fields.face.empty()) fields.face.push_back({ patch_field, {} });
    fields.face[0].values.push_back(now_);
  }

  // Files that name no patches have none.
  void finish(Mesh_fields& fields) const
  {
    if(is_named_) return;
    fields.face.clear();
    fields.patch_names.clear();
  }

private:
  static std::string rest_of(Word_scanner words)
  {
    std::string text;
    for(std::string_view word = words.next(); !word.empty(); word = words.next())
      text.append(text.empty() ? "" : " ").append(word);
    return text;
  }

  void set(const std::string& group, const std::string& material)
  {
    group_ = group;
    material_ = material;
    is_named_ = true;
    now_ = -1;
  }

  int number(Mesh_fields& fields)
  {
    const auto known = numbers_.emplace(std::pair(group_, material_), int(numbers_.size()));
    if(known.second) {
      const bool both = !group_.empty() && !material_.empty();
      fields.patch_names.push_back(unused_name(group_ + (both ? " " : "") + material_, names_));
    }
    return known.first->second;
  }

  std::string group_, material_;
  std::map<std::pair<std::string, std::string>, int> numbers_; // by group and material
  std::set<std::string> names_;
  bool is_named_ = false;
  int now_ = -1; // number of the patch, -1 if that is not known yet
};

// A vertex number of an OBJ file: counted from 1, or from the last vertex back where negative.
inline bool read_obj_vertex(std::string_view word, std::size_t number_of_points, Index& vertex)
{
  // "vertex/texture/normal": only the vertex counts
  const long long size = static_cast<long long>(number_of_points);
  long long value = 0;
  if(!to_number(word.substr(0, word.find('/')), value) || value == 0 || value > size ||
     value < -size)
    return false;
  vertex = static_cast<Index>(value > 0 ? value - 1 : size + value);
  return true;
}

inline Read_result bad_obj_vertex(const std::string& entity, std::string_view word,
                                  std::size_t line, const Polygon_soup& soup, long number = -1)
{
  return refuse(Refusal::unreadable_file,
                entity + " has the vertex number " + shown(word.substr(0, word.find('/'))) +
                    ", but only " + std::to_string(soup.points.size()) +
                    " vertices come before it" + at_line(line),
                number);
}

inline Read_result read_obj_face(Word_scanner words, std::size_t line, Polygon_soup& soup)
{
  const long number = static_cast<long>(soup.faces.size());
  Polygon_soup::Face face;
  for(std::string_view word = words.next(); !word.empty(); word = words.next()) {
    face.emplace_back();
    if(!read_obj_vertex(word, soup.points.size(), face.back()))
      return bad_obj_vertex("face " + std::to_string(number), word, line, soup, number);
  }
  soup.faces.push_back(std::move(face));
  return {};
}

// Every stretch of a polyline is a marked edge.
inline Read_result read_obj_line(Word_scanner words, std::size_t line, const Polygon_soup& soup,
                                 Mesh_fields& fields)
{
  Index last = -1;
  for(std::string_view word = words.next(); !word.empty(); word = words.next()) {
    Index v = 0;
    if(!read_obj_vertex(word, soup.points.size(), v))
      return bad_obj_vertex("the polyline", word, line, soup);
    if(last >= 0) fields.edges.push_back({ std::size_t(last), std::size_t(v) });
    last = v;
  }
  return {};
}

// The next line with those that a backslash at its end continues it with; `false` at the end.
inline bool next_obj_line(Line_scanner& lines, std::string& joined)
{
  std::string_view line;
  if(!lines.next(line)) return false;
  joined.assign(line);
  std::size_t last = joined.find_last_not_of(" \t\r");
  while(last != std::string::npos && joined[last] == '\\' && lines.next(line)) {
    joined.resize(last);
    joined.append(" ").append(line);
    last = joined.find_last_not_of(" \t\r");
  }
  return true;
}

inline Read_result read_obj_point(Word_scanner words, std::size_t line, Polygon_soup& soup)
{
  Vec point;
  const long number = static_cast<long>(soup.points.size());
  if(!read_coordinates(words, point))
    return refuse(Refusal::unreadable_file,
                  "vertex " + std::to_string(number) + " has no three coordinates" + at_line(line),
                  number);
  soup.points.push_back(point);
  return {};
}

/// Reads the vertices and faces of the text of an OBJ file; also its patches (groups and materials)
/// and marked edges (polylines), where `fields` are asked for.  Everything else is ignored.
inline Read_result read_obj(std::string_view text, Polygon_soup& soup,
                            Mesh_fields* fields = nullptr)
{
  Line_scanner lines(text);
  Obj_patches patches;
  std::string line;
  while(next_obj_line(lines, line)) {
    Word_scanner words(line);
    const std::string_view keyword = words.next();
    Read_result result;
    if(keyword == "v") result = read_obj_point(words, lines.number(), soup);
    if(keyword == "f") {
      result = read_obj_face(words, lines.number(), soup);
      if(fields) patches.add_face(*fields);
    }
    if(fields && keyword == "g") patches.set_group(words);
    if(fields && keyword == "usemtl") patches.set_material(words);
    if(fields && keyword == "l") result = read_obj_line(words, lines.number(), soup, *fields);
    if(!result.ok()) return result;
  }
  if(fields) patches.finish(*fields);
  return {};
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_READ_OBJ_H
