// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_READ_PLY_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_READ_PLY_H

#include <CGAL/Quad_mesh_adaptation/IO/Read_result.h>
#include <CGAL/Quad_mesh_adaptation/internal/polygon_soup.h>
#include <CGAL/Quad_mesh_adaptation/internal/text_scanner.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
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

// The numbers of the data part, one after the other, as text or bytes.
class Ply_data
{
public:
  Ply_data(std::string_view data, Ply_header::Format format)
      : data_(data), words_(data), format_(format)
  {
  }

  bool next(const std::string& type, double& value)
  {
    if(format_ == Ply_header::Format::ascii) return to_number(words_.next(), value);
    const std::size_t size = size_of_ply_type(type);
    if(data_.size() < size) return false;
    unsigned char bytes[8] = {};
    // to the order of this machine's bytes
    const bool turn = is_little_endian() != (format_ == Ply_header::Format::little_endian);
    for(std::size_t i = 0; i < size; ++i)
      bytes[i] = static_cast<unsigned char>(data_[turn ? size - 1 - i : i]);
    data_.remove_prefix(size);
    value = as_number(type, bytes);
    return true;
  }

private:
  static bool is_little_endian()
  {
    const std::uint16_t one = 1;
    unsigned char first;
    std::memcpy(&first, &one, 1);
    return first == 1;
  }
  template <class T>
  static double as(const unsigned char* bytes)
  {
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return static_cast<double>(value);
  }
  static double as_number(const std::string& type, const unsigned char* bytes)
  {
    if(type == "char" || type == "int8") return as<std::int8_t>(bytes);
    if(type == "uchar" || type == "uint8") return as<std::uint8_t>(bytes);
    if(type == "short" || type == "int16") return as<std::int16_t>(bytes);
    if(type == "ushort" || type == "uint16") return as<std::uint16_t>(bytes);
    if(type == "int" || type == "int32") return as<std::int32_t>(bytes);
    if(type == "uint" || type == "uint32") return as<std::uint32_t>(bytes);
    if(type == "float" || type == "float32") return as<float>(bytes);
    return as<double>(bytes);
  }

  std::string_view data_;
  Word_scanner words_;
  Ply_header::Format format_;
};

// One item of an element: single numbers by property; of lists, the one of vertex numbers.
struct Ply_item
{
  std::vector<double> numbers; // one per property, 0 for lists
  std::vector<double> vertices;
};

inline bool is_vertex_list(const Ply_property& property)
{
  return !property.length_type.empty() &&
         (property.name == "vertex_indices" || property.name == "vertex_index");
}

inline bool read_ply_item(Ply_data& data, const Ply_element& element, Ply_item& item)
{
  item.numbers.clear();
  item.vertices.clear();
  for(const Ply_property& property : element.properties) {
    double value = 0;
    if(property.length_type.empty()) {
      if(!data.next(property.type, value)) return false;
      item.numbers.push_back(value);
      continue;
    }
    double length = 0;
    if(!data.next(property.length_type, length) || !(length >= 0)) return false;
    // a wrong length runs into the end of the data, it does not allocate
    for(double i = 0; i < length; ++i) {
      if(!data.next(property.type, value)) return false;
      if(is_vertex_list(property)) item.vertices.push_back(value);
    }
    item.numbers.push_back(0);
  }
  return true;
}

// Position of a property of single numbers, or -1.
inline int find_number(const Ply_element& element, const std::string& name)
{
  for(std::size_t i = 0; i < element.properties.size(); ++i)
    if(element.properties[i].name == name && element.properties[i].length_type.empty())
      return static_cast<int>(i);
  return -1;
}

inline Read_result add_ply_face(const Ply_item& item, std::size_t number_of_points,
                                Polygon_soup& soup)
{
  Polygon_soup::Face face;
  for(const double value : item.vertices) {
    if(!(value >= 0 && value < double(number_of_points) && value == std::floor(value)))
      return refuse(Refusal::unreadable_file,
                    "face " + std::to_string(soup.faces.size()) +
                        " has a vertex number that is not one from 0 to " +
                        std::to_string(static_cast<long long>(number_of_points) - 1),
                    static_cast<long>(soup.faces.size()));
    face.push_back(static_cast<Index>(value));
  }
  soup.faces.push_back(std::move(face));
  return {};
}

// A property of the vertices that is wanted beside their coordinates.
struct Ply_vertex_values
{
  std::string name;
  std::vector<double> values; // one for each vertex
};

/// Reads the bytes of a PLY file, text or binary of either order.
inline Read_result read_ply(std::string_view bytes, Polygon_soup& soup,
                            Ply_vertex_values* wanted = nullptr)
{
  Ply_header header;
  Read_result result = read_ply_header(bytes, header);
  if(!result.ok()) return result;
  constexpr std::size_t max_points = (std::numeric_limits<Index>::max)();
  std::size_t number_of_points = 0;
  for(const Ply_element& element : header.elements)
    if(element.name == "vertex") number_of_points = (std::min)(element.count, max_points);

  Ply_data data(bytes.substr(header.end), header.format);
  Ply_item item;
  for(const Ply_element& element : header.elements) {
    const int x = find_number(element, "x"), y = find_number(element, "y"),
              z = find_number(element, "z");
    const bool is_vertex = element.name == "vertex", is_face = element.name == "face";
    if(is_vertex && (x < 0 || y < 0 || z < 0))
      return refuse(Refusal::unreadable_file, "the PLY header gives vertices without x, y and z");
    const int extra = wanted && is_vertex ? find_number(element, wanted->name) : -1;
    if(wanted && is_vertex && extra < 0)
      return refuse(Refusal::unreadable_file,
                    "the PLY header gives vertices without a property " + wanted->name);
    if(element.properties.empty() && !is_face) continue;
    if(is_face && std::none_of(element.properties.begin(), element.properties.end(),
                               [](const Ply_property& p) { return is_vertex_list(p); }))
      return refuse(Refusal::unreadable_file,
                    "the PLY header gives faces without a list vertex_indices");
    for(std::size_t i = 0; i < element.count; ++i) {
      if(!read_ply_item(data, element, item))
        return refuse(Refusal::unreadable_file,
                      "the file is truncated or damaged: its header announces " +
                          std::to_string(element.count) + " items " + shown(element.name) +
                          ", the data end or are no numbers at item " + std::to_string(i),
                      static_cast<long>(i));
      if(is_vertex) soup.points.emplace_back(item.numbers[x], item.numbers[y], item.numbers[z]);
      if(extra >= 0) wanted->values.push_back(item.numbers[extra]);
      if(is_face) result = add_ply_face(item, number_of_points, soup);
      if(!result.ok()) return result;
    }
  }
  return result;
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_READ_PLY_H
