// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_READ_OFF_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_READ_OFF_H

#include <CGAL/Quad_mesh_adaptation/IO/Read_result.h>
#include <CGAL/Quad_mesh_adaptation/internal/file_lines.h>
#include <CGAL/Quad_mesh_adaptation/internal/polygon_soup.h>
#include <CGAL/Quad_mesh_adaptation/internal/text_scanner.h>

#include <limits>
#include <string>
#include <string_view>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

struct Off_counts
{
  std::size_t vertices = 0, faces = 0;
};

// "OFF", "COFF", "NOFF", "STOFF" and their combinations carry more per vertex, which is ignored.
inline bool is_off_keyword(std::string_view word)
{
  if(word.substr(0, 2) == "ST") word.remove_prefix(2);
  if(word.substr(0, 1) == "C") word.remove_prefix(1);
  if(word.substr(0, 1) == "N") word.remove_prefix(1);
  return word == "OFF";
}

inline Read_result read_off_header(Line_scanner& lines, Off_counts& counts)
{
  std::string_view line;
  if(!lines.next(line)) return refuse(Refusal::unreadable_file, "the file has no OFF header");
  Word_scanner words(line);
  const std::string_view keyword = words.next();
  if(!is_off_keyword(keyword))
    return refuse(Refusal::unreadable_file,
                  "the file starts with " + shown(keyword) + " instead of OFF");
  std::string_view word = words.next();
  if(word == "BINARY")
    return refuse(Refusal::unreadable_file, "binary OFF is not supported, write it as text");
  if(word.empty()) {
    if(!lines.next(line))
      return refuse(Refusal::unreadable_file, "the file ends after the word OFF");
    words = Word_scanner(line);
    word = words.next();
  }
  long long vertices = -1, faces = -1;
  if(!to_number(word, vertices) || !to_number(words.next(), faces) || vertices < 0 || faces < 0)
    return refuse(Refusal::unreadable_file,
                  "the numbers of vertices and faces are missing or wrong" +
                      at_line(lines.number()));
  counts.vertices = static_cast<std::size_t>(vertices);
  counts.faces = static_cast<std::size_t>(faces);
  return {};
}

inline Read_result truncated_off(const Off_counts& counts, const Polygon_soup& soup)
{
  return refuse(Refusal::unreadable_file,
                "the file is truncated: its header announces " + std::to_string(counts.vertices) +
                    " vertices and " + std::to_string(counts.faces) + " faces, it ends after " +
                    std::to_string(soup.points.size()) + " vertices and " +
                    std::to_string(soup.faces.size()) + " faces");
}

// A vertex number of a file, as an index that fits; range is checked against `limit`.
inline bool to_index(std::string_view word, std::size_t limit, Index& index)
{
  long long value = 0;
  if(!to_number(word, value) || value < 0 || static_cast<unsigned long long>(value) >= limit ||
     value > (std::numeric_limits<Index>::max)())
    return false;
  index = static_cast<Index>(value);
  return true;
}

inline Read_result read_off_face(Word_scanner words, std::size_t line, Polygon_soup& soup)
{
  const long number = static_cast<long>(soup.faces.size());
  const std::string name = "face " + std::to_string(number);
  long long degree = 0;
  if(!to_number(words.next(), degree) || degree < 0)
    return refuse(Refusal::unreadable_file, name + " has no number of vertices" + at_line(line),
                  number);
  Polygon_soup::Face face;
  for(long long i = 0; i < degree; ++i) {
    const std::string_view word = words.next();
    if(word.empty())
      return refuse(Refusal::unreadable_file,
                    "the file is truncated or damaged: " + name + " announces " +
                        std::to_string(degree) + " vertices and gives " + std::to_string(i) +
                        at_line(line),
                    number);
    Index index = 0;
    if(!to_index(word, soup.points.size(), index))
      return refuse(
          Refusal::unreadable_file,
          name + " has the vertex number " + shown(word) + ", which is not one from 0 to " +
              std::to_string(static_cast<long long>(soup.points.size()) - 1) + at_line(line),
          number);
    face.push_back(index);
  }
  soup.faces.push_back(std::move(face));
  return {};
}

/// Reads the text of an OFF file.  Counts and line structure must agree with the header.
inline Read_result read_off(std::string_view text, Polygon_soup& soup)
{
  Line_scanner lines(text);
  Off_counts counts;
  Read_result result = read_off_header(lines, counts);
  if(!result.ok()) return result;

  std::string_view line;
  while(soup.points.size() < counts.vertices) {
    if(!lines.next(line)) return truncated_off(counts, soup);
    Word_scanner words(line);
    Vec point;
    const long number = static_cast<long>(soup.points.size());
    if(!read_coordinates(words, point))
      return refuse(Refusal::unreadable_file,
                    "vertex " + std::to_string(number) + " has no three coordinates" +
                        at_line(lines.number()),
                    number);
    soup.points.push_back(point);
  }
  while(soup.faces.size() < counts.faces) {
    if(!lines.next(line)) return truncated_off(counts, soup);
    result = read_off_face(Word_scanner(line), lines.number(), soup);
    if(!result.ok()) return result;
  }
  if(lines.next(line))
    result.notes.push_back("everything from line " + std::to_string(lines.number()) +
                           " on was ignored, the announced faces end there");
  return result;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_READ_OFF_H
