// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_ADAPT_REFUSE_H
#define QUAD_ADAPT_REFUSE_H

#include "../support/report_json.h"
#include "Options.h"

#include <CGAL/Quad_mesh_adaptation/Adaptation_report.h>
#include <CGAL/Quad_mesh_adaptation/IO/File_transaction.h>
#include <CGAL/Quad_mesh_adaptation/IO/Read_result.h>

#include <iostream>
#include <string>

/// Says why on the error stream.
inline int refuse(const std::string& message, int exit_code = exit_refused)
{
  std::cerr << "quad_adapt: " << message << '\n';
  return exit_code;
}

/// Says why the input or the sizes are refused, behind `what` it is about, and writes the report if
/// it is asked for, which is all that is written then.
inline int refuse(const Options& options, const std::string& what,
                  const CGAL::Quad_mesh_adaptation::Adaptation_report& report)
{
  std::string message = what + report.message;
  if(!options.report.empty()) {
    CGAL::Quad_mesh_adaptation::File_transaction file;
    auto result = file.stage(options.report, to_json(report).dump(2) + '\n');
    if(result.ok()) result = file.commit();
    if(!result.ok()) message += "; nor is there a report: " + result.message;
  }
  return refuse(message);
}

/// The same for what is found before the library is asked; `entity`: as in a report.
inline int refuse(const Options& options, const std::string& what,
                  CGAL::Quad_mesh_adaptation::Refusal reason, const std::string& message,
                  long entity = -1)
{
  using CGAL::Quad_mesh_adaptation::Adaptation_status;
  using CGAL::Quad_mesh_adaptation::Refusal;
  CGAL::Quad_mesh_adaptation::Adaptation_report report;
  report.status = reason == Refusal::invalid_size ? Adaptation_status::sizes_refused
                                                  : Adaptation_status::input_refused;
  report.reason = reason;
  report.message = message;
  report.entity = entity;
  return refuse(options, what, report);
}

/// The same for a file that cannot be read.
inline int refuse(const Options& options, const std::string& what,
                  const CGAL::Quad_mesh_adaptation::Read_result& result)
{
  return refuse(options, what, result.reason, result.message, result.entity);
}

#endif // QUAD_ADAPT_REFUSE_H
