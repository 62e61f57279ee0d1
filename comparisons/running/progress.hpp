#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace springcheck {

/// A bar on stderr with the number of simulations done and the remaining time; silent
/// unless stderr is a terminal.
class Progress {
 public:
  explicit Progress(std::string what);
  ~Progress();  // clears the line
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(std::size_t done, std::size_t all);

 private:
  std::string what_;
  bool on_terminal_;
  std::chrono::steady_clock::time_point start_;
};

/// Says on stderr what is being done, on a terminal or not: "12 s: WHAT", with the time
/// since the program's first such line.
void announce(const std::string& what);

/// A line on stderr with the simulated time, the step and its limit, steps per second and
/// the remaining time of one simulation; silent unless stderr is a terminal.
class MarchProgress {
 public:
  explicit MarchProgress(double duration);  // [s] simulated
  ~MarchProgress();                         // clears the line
  MarchProgress(const MarchProgress&) = delete;
  MarchProgress& operator=(const MarchProgress&) = delete;

  /// dt and limit: of the steps now [s].
  void show(double time, int step, double dt, double limit);

 private:
  double duration_;
  bool on_terminal_;
  std::chrono::steady_clock::time_point last_;
  double last_time_ = 0;
  int last_step_ = -1;  // none shown
};

}  // namespace springcheck
