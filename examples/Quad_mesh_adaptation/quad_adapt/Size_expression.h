// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_ADAPT_SIZE_EXPRESSION_H
#define QUAD_ADAPT_SIZE_EXPRESSION_H

#include <muParser.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <shared_mutex>
#include <string>
#include <thread>

/// A sizing function given as text in x, y and z.  Copies share the parsers, of which there is one
/// for each thread that calls.
class Size_expression
{
public:
  /// `false` and `message` when the text is no expression.
  bool parse(const std::string& text, std::string& message)
  {
    if(assigns(text)) {
      message = "= gives a variable a value, == compares";
      return false;
    }
    try {
      Parsed first(text);
      first.parser.Eval();
      if(first.parser.GetNumResults() == 1) {
        parsers_ = std::make_shared<Parsers>();
        parsers_->text = text;
        return true;
      }
      message = "more than one value";
    } catch(const mu::Parser::exception_type& error) {
      message = error.GetMsg();
      while(!message.empty() && message.back() == '.') message.pop_back();
    }
    return false;
  }

  /// Precondition: parse() was successful.
  template <class Point>
  double operator()(const Point& p) const
  {
    Parsed& mine = parsers_->mine();
    mine.at = { { p.x(), p.y(), p.z() } };
    return mine.parser.Eval();
  }

private:
  struct Parsed
  {
    explicit Parsed(const std::string& text)
    {
      define_names(parser);
      parser.DefineVar("x", &at[0]);
      parser.DefineVar("y", &at[1]);
      parser.DefineVar("z", &at[2]);
      parser.SetExpr(text);
    }

    mu::Parser parser;
    std::array<double, 3> at = { { 0, 0, 0 } };
  };

  struct Parsers
  {
    Parsed& mine()
    {
      const auto id = std::this_thread::get_id();
      {
        const std::shared_lock<std::shared_mutex> lock(mutex);
        const auto known = by_thread.find(id);
        if(known != by_thread.end()) return *known->second;
      }
      const std::unique_lock<std::shared_mutex> lock(mutex);
      return *by_thread.emplace(id, std::make_unique<Parsed>(text)).first->second;
    }

    std::string text;
    std::shared_mutex mutex;
    std::map<std::thread::id, std::unique_ptr<Parsed>> by_thread;
  };

  // The parser takes "x = 3" for an expression, and loses x over it.
  static bool assigns(const std::string& text)
  {
    for(std::size_t i = 0; i < text.size(); ++i) {
      if(text[i] != '=') continue;
      if(i + 1 < text.size() && text[i + 1] == '=')
        ++i;
      else if(i == 0 || std::string("<>!").find(text[i - 1]) == std::string::npos)
        return true;
    }
    return false;
  }

  // What the parser does not bring itself.
  static void define_names(mu::Parser& parser)
  {
    parser.DefineFun("hypot", [](double a, double b) { return std::hypot(a, b); });
    parser.DefineFun("floor", [](double a) { return std::floor(a); });
    parser.DefineFun("ceil", [](double a) { return std::ceil(a); });
    parser.DefineFun("if", [](double a, double b, double c) { return a != 0 ? b : c; });
    parser.DefineFun("clamp", [](double v, double low, double high) {
      return (std::min)((std::max)(v, low), high);
    });
    parser.DefineConst("pi", 3.14159265358979323846);
  }

  std::shared_ptr<Parsers> parsers_;
};

#endif // QUAD_ADAPT_SIZE_EXPRESSION_H
