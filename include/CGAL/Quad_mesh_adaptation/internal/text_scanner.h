// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TEXT_SCANNER_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TEXT_SCANNER_H

#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

inline bool is_blank(char c)
{
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f';
}

// The words of one line of a file.
class Word_scanner
{
public:
  explicit Word_scanner(std::string_view text = {}) : text_(text) {}

  /// The next word, empty when there is none.
  std::string_view next()
  {
    std::size_t begin = 0;
    while(begin < text_.size() && is_blank(text_[begin])) ++begin;
    std::size_t end = begin;
    while(end < text_.size() && !is_blank(text_[end])) ++end;
    const std::string_view word = text_.substr(begin, end - begin);
    text_.remove_prefix(end);
    return word;
  }

private:
  std::string_view text_;
};

// The lines of a text that hold anything; what follows a '#' is a comment.
class Line_scanner
{
public:
  explicit Line_scanner(std::string_view text) : text_(text)
  {
    constexpr std::string_view mark = "\xEF\xBB\xBF"; // that some editors put before UTF-8
    if(text_.substr(0, mark.size()) == mark) position_ = mark.size();
  }

  /// Moves to the next line with a word on it; `false` at the end of the text.
  bool next(std::string_view& line)
  {
    while(position_ < text_.size()) {
      std::size_t end = text_.find('\n', position_);
      if(end == std::string_view::npos) end = text_.size();
      line = text_.substr(position_, end - position_);
      position_ = end + 1;
      ++number_;
      line = line.substr(0, line.find('#'));
      if(!Word_scanner(line).next().empty()) return true;
    }
    return false;
  }
  /// Number of the current line, from 1.
  std::size_t number() const { return number_; }
  /// Offset of the next line in the text.
  std::size_t position() const { return position_; }

private:
  std::string_view text_;
  std::size_t position_ = 0, number_ = 0;
};

// Reads a whole word as a number, whatever the locale; infinite and NaN are numbers here, to be
// refused by name later.
inline bool to_number(std::string_view word, double& value)
{
  if(!word.empty() && word.front() == '+') word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if(end != word.data() + word.size() || word.empty()) return false;
  // too large becomes infinite, too small becomes zero or denormal
  if(error == std::errc::result_out_of_range)
    value = std::strtod(std::string(word).c_str(), nullptr);
  return error != std::errc::invalid_argument;
}

inline bool to_number(std::string_view word, long long& value)
{
  if(!word.empty() && word.front() == '+') word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size() && !word.empty();
}

// A word as it may be shown in a message: short, printable.
inline std::string shown(std::string_view word)
{
  std::string text;
  for(const char c : word.substr(0, 24)) text += c >= ' ' && c <= '~' ? c : '?';
  return '"' + text + (word.size() > 24 ? "...\"" : "\"");
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_TEXT_SCANNER_H
