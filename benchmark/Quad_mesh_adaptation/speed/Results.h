// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef QUAD_MESH_ADAPTATION_BENCHMARK_SPEED_RESULTS_H
#define QUAD_MESH_ADAPTATION_BENCHMARK_SPEED_RESULTS_H

#include "Task.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace speed {

inline double median(std::vector<double> values)
{
  if(values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

/// All runs of a task.
struct Result
{
  const Task* task = nullptr;
  std::vector<Outcome> runs;
  double peak = 0; ///< bytes above the mesh itself; 0: not measured

  bool is_done() const { return !runs.empty(); }
  double faces_in() const { return runs.front().faces_in; }
  double faces_out() const { return runs.front().faces_out; }
  double most_faces() const { return (std::max)(faces_in(), faces_out()); }
  double seconds() const { return median(all(&Outcome::cpu)); }
  double microseconds_per_face() const { return 1e6 * seconds() / faces_out(); }
  double microseconds_per_removed_face() const
  {
    return 1e6 * seconds() / (faces_in() - faces_out());
  }
  double bytes_per_face() const { return peak / most_faces(); }

  /// How far the runs are apart, as a share of their median.
  double spread() const
  {
    const std::vector<double> t = all(&Outcome::cpu);
    return (*std::max_element(t.begin(), t.end()) - *std::min_element(t.begin(), t.end())) /
           median(t);
  }

  /// Microseconds of the wall for each face of the result, by phase in the order of the run.
  std::vector<std::pair<std::string, double>> phases() const
  {
    std::vector<std::pair<std::string, double>> list;
    for(const auto& first : runs.front().phases) {
      std::vector<double> seconds;
      for(const Outcome& o : runs)
        for(const auto& p : o.phases)
          if(p.name == first.name) seconds.push_back(p.seconds);
      list.emplace_back(first.name, 1e6 * median(seconds) / faces_out());
    }
    return list;
  }

private:
  std::vector<double> all(double Outcome::*member) const
  {
    std::vector<double> values;
    for(const Outcome& o : runs) values.push_back(o.*member);
    return values;
  }
};

/// Results by task, shape and level.
class Results
{
public:
  explicit Results(const std::vector<Task>& tasks)
  {
    for(const Task& t : tasks) results_[t.name()].task = &t;
  }

  Result& of(const Task& t) { return results_.at(t.name()); }

  /// Null if it was not run.
  const Result* find(const std::string& what, const std::string& shape, int level) const
  {
    const auto it = results_.find(what + "/" + shape + "/1e" + std::to_string(level));
    return it != results_.end() && it->second.is_done() ? &it->second : nullptr;
  }

  /// The highest level at which it was run; null if at none.
  const Result* largest(const std::string& what, const std::string& shape) const
  {
    const Result* found = nullptr;
    for(int level = 1; level < 10; ++level)
      if(const Result* r = find(what, shape, level)) found = r;
    return found;
  }

  std::vector<int> levels() const
  {
    std::vector<int> list;
    for(const auto& r : results_)
      if(r.second.is_done()) list.push_back(r.second.task->level);
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    return list;
  }

  /// The most runs of a task at a level.
  std::size_t runs_at(int level) const
  {
    std::size_t most = 0;
    for(const auto& r : results_)
      if(r.second.task->level == level) most = (std::max)(most, r.second.runs.size());
    return most;
  }

  double largest_spread() const
  {
    double most = 0;
    for(const auto& r : results_)
      if(r.second.runs.size() > 1) most = (std::max)(most, r.second.spread());
    return most;
  }

  double median_spread() const
  {
    std::vector<double> spreads;
    for(const auto& r : results_)
      if(r.second.runs.size() > 1) spreads.push_back(r.second.spread());
    return median(spreads);
  }

private:
  std::map<std::string, Result> results_;
};

} // namespace speed

#endif // QUAD_MESH_ADAPTATION_BENCHMARK_SPEED_RESULTS_H
