// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_READ_PLY_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_READ_PLY_H

#include <CGAL/Quad_mesh_adaptation/IO/Mesh_fields.h>
#include <CGAL/Quad_mesh_adaptation/IO/Read_result.h>
#include <CGAL/Quad_mesh_adaptation/internal/ply_header.h>
#include <CGAL/Quad_mesh_adaptation/internal/polygon_soup.h>
#include <CGAL/Quad_mesh_adaptation/internal/text_scanner.h>

#include <algorithm>
#include <array>
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

// Reads the elements one after the other.
class Ply_reader
{
public:
  // `fields`: where what is no shape is to go, or null.
  Ply_reader(std::string_view bytes, Polygon_soup& soup, Mesh_fields* fields)
      : bytes_(bytes), soup_(soup), fields_(fields)
  {
  }

  Read_result operator()()
  {
    Ply_header header;
    Read_result result = read_ply_header(bytes_, header);
    if(!result.ok()) return result;
    constexpr std::size_t max_points = (std::numeric_limits<Index>::max)();
    for(const Ply_element& element : header.elements)
      if(element.name == "vertex") number_of_points_ = (std::min)(element.count, max_points);
    Ply_data data(bytes_.substr(header.end), header.format);
    for(const Ply_element& element : header.elements) {
      result = read_element(element, data);
      if(!result.ok()) return result;
    }
    return result;
  }

private:
  Read_result read_element(const Ply_element& element, Ply_data& data)
  {
    const bool is_vertex = element.name == "vertex", is_face = element.name == "face";
    Read_result result = check_properties(element);
    if(!result.ok() || (element.properties.empty() && !is_face)) return result;
    if(is_vertex) find_coordinates(element);
    const int first = find_number(element, "vertex1"), second = find_number(element, "vertex2");
    const bool is_edge = fields_ && element.name == "edge" && first >= 0 && second >= 0;
    std::vector<Scalar_field>* fields = nullptr;
    if(fields_ && (is_vertex || is_face)) fields = is_vertex ? &fields_->vertex : &fields_->face;
    if(fields) name_fields(element, *fields);
    Ply_item item;
    for(std::size_t i = 0; i < element.count && result.ok(); ++i) {
      if(!read_ply_item(data, element, item)) return truncated(element, i);
      if(is_vertex) add_point(item);
      if(is_face) result = add_ply_face(item, number_of_points_, soup_);
      if(is_edge) result = add_edge(item.numbers[first], item.numbers[second]);
      if(fields) add_values(element, item, *fields);
    }
    return result;
  }

  static Read_result check_properties(const Ply_element& element)
  {
    if(element.name == "vertex" && (find_number(element, "x") < 0 ||
                                    find_number(element, "y") < 0 || find_number(element, "z") < 0))
      return refuse(Refusal::unreadable_file, "the PLY header gives vertices without x, y and z");
    if(element.name == "face" &&
       std::none_of(element.properties.begin(), element.properties.end(),
                    [](const Ply_property& p) { return is_vertex_list(p); }))
      return refuse(Refusal::unreadable_file,
                    "the PLY header gives faces without a list vertex_indices");
    return {};
  }

  static Read_result truncated(const Ply_element& element, std::size_t item)
  {
    return refuse(Refusal::unreadable_file,
                  "the file is truncated or damaged: its header announces " +
                      std::to_string(element.count) + " items " + shown(element.name) +
                      ", the data end or are no numbers at item " + std::to_string(item),
                  static_cast<long>(item));
  }

  void find_coordinates(const Ply_element& element)
  {
    coordinates_ = { find_number(element, "x"), find_number(element, "y"),
                     find_number(element, "z") };
  }

  void add_point(const Ply_item& item)
  {
    soup_.points.emplace_back(item.numbers[coordinates_[0]], item.numbers[coordinates_[1]],
                              item.numbers[coordinates_[2]]);
  }

  Read_result add_edge(double first, double second)
  {
    for(const double v : { first, second })
      if(!(v >= 0 && v < double(number_of_points_) && v == std::floor(v)))
        return refuse(Refusal::unreadable_file,
                      "edge " + std::to_string(fields_->edges.size()) +
                          " has a vertex number that is not one from 0 to " +
                          std::to_string(static_cast<long long>(number_of_points_) - 1),
                      static_cast<long>(fields_->edges.size()));
    fields_->edges.push_back({ std::size_t(first), std::size_t(second) });
    return {};
  }

  // Is that property neither shape nor a list?
  static bool is_field(const Ply_element& element, const Ply_property& property)
  {
    const std::string& name = property.name;
    const bool is_coordinate = name == "x" || name == "y" || name == "z";
    return property.length_type.empty() && !(element.name == "vertex" && is_coordinate);
  }

  static void name_fields(const Ply_element& element, std::vector<Scalar_field>& fields)
  {
    for(const Ply_property& property : element.properties)
      if(is_field(element, property)) fields.push_back({ property.name, {} });
  }

  static void add_values(const Ply_element& element, const Ply_item& item,
                         std::vector<Scalar_field>& fields)
  {
    std::size_t field = 0;
    for(std::size_t i = 0; i < element.properties.size(); ++i)
      if(is_field(element, element.properties[i]))
        fields[field++].values.push_back(item.numbers[i]);
  }

  std::string_view bytes_;
  Polygon_soup& soup_;
  Mesh_fields* fields_;
  std::size_t number_of_points_ = 0;
  std::array<int, 3> coordinates_ = {};
};

/// Reads the bytes of a PLY file, text or binary of either order; also the single numbers at its
/// vertices and faces, and its edges, where `fields` are asked for.
inline Read_result read_ply(std::string_view bytes, Polygon_soup& soup,
                            Mesh_fields* fields = nullptr)
{
  return Ply_reader(bytes, soup, fields)();
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_READ_PLY_H
