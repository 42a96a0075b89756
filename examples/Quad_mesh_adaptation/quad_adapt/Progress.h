// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_ADAPT_PROGRESS_H
#define QUAD_ADAPT_PROGRESS_H

#include <CGAL/Quad_mesh_adaptation/Adaptation_visitor.h>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

#include <csignal>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <string>
#include <utility>

// Set by the first Ctrl-C; a second one ends the program at once.
inline volatile std::sig_atomic_t is_interrupted = 0;

extern "C" inline void interrupt(int signal)
{
  is_interrupted = 1;
  std::signal(signal, SIG_DFL);
}

/// Lets Ctrl-C and a termination signal cancel the adaptation instead of ending the program.
inline void catch_interrupts()
{
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
}

/// Is the error stream a terminal?
inline bool is_on_terminal()
{
#ifdef _WIN32
  return _isatty(_fileno(stderr)) != 0;
#else
  return isatty(STDERR_FILENO) != 0;
#endif
}

/// A line on the terminal (the error stream, only when it is one) that says what is being done.
class Progress : public CGAL::Quad_mesh_adaptation::Adaptation_visitor
{
public:
  explicit Progress(bool is_quiet) : is_shown_(!is_quiet && is_on_terminal()) {}
  ~Progress() { clear(); }

  /// What to do with the number of faces that is foretold.
  void when_foretold(std::function<void(double)> action) { when_foretold_ = std::move(action); }

  void foretell(double faces)
  {
    if(when_foretold_) when_foretold_(faces);
  }
  void start_phase(const char* name, std::size_t iteration)
  {
    phase_ = name;
    iteration_ = iteration;
    show();
  }
  void end_phase(const char* /*name*/, std::size_t faces)
  {
    faces_ = faces;
    show();
  }
  bool go_further() { return is_interrupted == 0; }

  /// How much is done, in [0, 1]; `false` asks to stop.
  bool advance(double fraction)
  {
    fraction_ = fraction;
    show();
    return go_further();
  }

  void clear()
  {
    if(is_shown_ && is_dirty_) std::fputs("\r\033[K", stderr);
    is_dirty_ = false;
  }

private:
  void show()
  {
    if(!is_shown_) return;
    char line[160];
    std::snprintf(line, sizeof line, "%3.0f %%  iteration %zu  %-20.40s %zu faces", 100 * fraction_,
                  iteration_, phase_.c_str(), faces_);
    if(line == shown_) return;
    shown_ = line;
    std::fprintf(stderr, "\r\033[K%s", line);
    std::fflush(stderr);
    is_dirty_ = true;
  }

  bool is_shown_, is_dirty_ = false;
  double fraction_ = 0;
  std::size_t iteration_ = 0, faces_ = 0;
  std::string phase_, shown_;
  std::function<void(double)> when_foretold_;
};

#endif // QUAD_ADAPT_PROGRESS_H
