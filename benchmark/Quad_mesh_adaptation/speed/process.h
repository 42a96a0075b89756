// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_BENCHMARK_SPEED_PROCESS_H
#define QUAD_MESH_ADAPTATION_BENCHMARK_SPEED_PROCESS_H

#include <cstdio>
#include <ctime>
#include <fcntl.h>
#include <fstream>
#include <spawn.h>
#include <stdexcept>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#ifdef __GLIBC__
#include <malloc.h>
#endif

extern char** environ;

// Time and memory of this process and of others (Linux).
namespace speed {

/// Seconds of the processor and of the wall since it was made.
class Stopwatch
{
public:
  double cpu() const { return now(CLOCK_PROCESS_CPUTIME_ID) - cpu_; }
  double wall() const { return now(CLOCK_MONOTONIC) - wall_; }

private:
  static double now(clockid_t clock)
  {
    timespec t;
    clock_gettime(clock, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
  }
  double cpu_ = now(CLOCK_PROCESS_CPUTIME_ID), wall_ = now(CLOCK_MONOTONIC);
};

/// Bytes of a line of /proc/self/status: "VmRSS" now, "VmHWM" at the peak.  The peak that
/// getrusage() tells would start with that of the parent process.
inline double memory(const std::string& line)
{
  std::ifstream status("/proc/self/status");
  for(std::string word; status >> word;)
    if(word == line + ":") {
      double kilobytes = 0;
      status >> kilobytes;
      return 1024 * kilobytes;
    }
  throw std::runtime_error("/proc/self/status has no " + line);
}

/// From now on the peak is that from now on; what was freed before is given back.
inline void reset_memory_peak()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
  std::ofstream clear("/proc/self/clear_refs");
  clear << "5" << std::flush;
  if(!clear) throw std::runtime_error("/proc/self/clear_refs cannot be written");
}

struct Child_result
{
  int exit_code = -1;
  double cpu = 0, wall = 0;
};

/// Runs a program that is found on the PATH, its output into a file, and waits for it.
inline Child_result run_child(const std::vector<std::string>& command, const std::string& output)
{
  std::vector<char*> arguments;
  for(const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 1, output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&actions, 1, 2);
  Child_result result;
  const Stopwatch watch;
  pid_t child = 0;
  const int error =
      posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if(error != 0) return result;
  int status = 0;
  rusage used;
  if(wait4(child, &status, 0, &used) != child) return result;
  const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
  result.cpu = seconds(used.ru_utime) + seconds(used.ru_stime);
  result.wall = watch.wall();
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return result;
}

} // namespace speed

#endif // QUAD_MESH_ADAPTATION_BENCHMARK_SPEED_PROCESS_H
