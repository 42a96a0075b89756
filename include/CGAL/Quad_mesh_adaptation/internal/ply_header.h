// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PLY_HEADER_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PLY_HEADER_H

#include <CGAL/Quad_mesh_adaptation/IO/Read_result.h>
#include <CGAL/Quad_mesh_adaptation/internal/text_scanner.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

struct Ply_property
{
  std::string name, type, length_type; // length_type is empty but for lists
};

struct Ply_element
{
  std::string name;
  std::size_t count = 0;
  std::vector<Ply_property> properties;
};

struct Ply_header
{
  enum class Format
  {
    ascii,
    little_endian,
    big_endian
  };
  Format format = Format::ascii;
  std::vector<Ply_element> elements;
  std::size_t end = 0; // offset of the data
};

// Bytes of a type in binary files, 0 for what is no type.
inline std::size_t size_of_ply_type(std::string_view type)
{
  if(type == "char" || type == "int8" || type == "uchar" || type == "uint8") return 1;
  if(type == "short" || type == "int16" || type == "ushort" || type == "uint16") return 2;
  if(type == "int" || type == "int32" || type == "uint" || type == "uint32") return 4;
  if(type == "float" || type == "float32") return 4;
  if(type == "double" || type == "float64") return 8;
  return 0;
}

inline bool read_ply_property(Word_scanner& words, Ply_property& property)
{
  property.type = words.next();
  if(property.type == "list") {
    property.length_type = words.next();
    property.type = words.next();
    if(size_of_ply_type(property.length_type) == 0) return false;
  }
  property.name = words.next();
  return size_of_ply_type(property.type) > 0 && !property.name.empty();
}

inline bool read_ply_format(std::string_view word, Ply_header::Format& format)
{
  if(word == "ascii")
    format = Ply_header::Format::ascii;
  else if(word == "binary_little_endian")
    format = Ply_header::Format::little_endian;
  else if(word == "binary_big_endian")
    format = Ply_header::Format::big_endian;
  else
    return false;
  return true;
}

inline Read_result read_ply_header(std::string_view text, Ply_header& header)
{
  Line_scanner lines(text);
  std::string_view line;
  if(!lines.next(line) || Word_scanner(line).next() != "ply")
    return refuse(Refusal::unreadable_file, "the file does not start with the word ply");
  while(lines.next(line)) {
    Word_scanner words(line);
    const std::string_view keyword = words.next();
    bool good = true;
    if(keyword == "end_header") {
      header.end = (std::min)(lines.position(), text.size());
      return {};
    } else if(keyword == "format") {
      good = read_ply_format(words.next(), header.format);
    } else if(keyword == "element") {
      Ply_element element;
      element.name = words.next();
      long long count = 0;
      good = to_number(words.next(), count) && count >= 0;
      element.count = static_cast<std::size_t>(good ? count : 0);
      header.elements.push_back(std::move(element));
    } else if(keyword == "property") {
      Ply_property property;
      good = !header.elements.empty() && read_ply_property(words, property);
      if(good) header.elements.back().properties.push_back(std::move(property));
    }
    if(!good)
      return refuse(Refusal::unreadable_file, "the PLY header cannot be understood in line " +
                                                  std::to_string(lines.number()));
  }
  return refuse(Refusal::unreadable_file, "the file is truncated: its PLY header has no end");
}

// Position of a property of single numbers, or -1.
inline int find_number(const Ply_element& element, const std::string& name)
{
  for(std::size_t i = 0; i < element.properties.size(); ++i)
    if(element.properties[i].name == name && element.properties[i].length_type.empty())
      return static_cast<int>(i);
  return -1;
}

inline bool is_vertex_list(const Ply_property& property)
{
  return !property.length_type.empty() &&
         (property.name == "vertex_indices" || property.name == "vertex_index");
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PLY_HEADER_H
