// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_ADAPT_SIZE_EXPRESSION_H
#define QUAD_ADAPT_SIZE_EXPRESSION_H

#include <muParser.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>

/// A sizing function given as text in x, y and z.  Copies share the parser; calls are not to be
/// made from several threads at once.
class Size_expression
{
public:
  /// `false` and `message` when the text is no expression.
  bool parse(const std::string& text, std::string& message)
  {
    parsed_ = std::make_shared<Parsed>();
    try {
      define_names(parsed_->parser);
      parsed_->parser.DefineVar("x", &parsed_->at[0]);
      parsed_->parser.DefineVar("y", &parsed_->at[1]);
      parsed_->parser.DefineVar("z", &parsed_->at[2]);
      parsed_->parser.SetExpr(text);
      parsed_->parser.Eval();
      if(parsed_->parser.GetNumResults() == 1) return true;
      message = "more than one value";
    } catch(const mu::Parser::exception_type& error) {
      message = error.GetMsg();
      while(!message.empty() && message.back() == '.') message.pop_back();
    }
    parsed_.reset();
    return false;
  }

  template <class Point>
  double operator()(const Point& p) const
  {
    parsed_->at = { { p.x(), p.y(), p.z() } };
    return parsed_->parser.Eval();
  }

private:
  struct Parsed
  {
    mu::Parser parser;
    std::array<double, 3> at = { { 0, 0, 0 } };
  };

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

  std::shared_ptr<Parsed> parsed_;
};

#endif // QUAD_ADAPT_SIZE_EXPRESSION_H
