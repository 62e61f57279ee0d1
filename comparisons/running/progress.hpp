#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <string>
#include <thread>

namespace springcheck {

/// How many of some things are done, and the remaining time, on stderr: a bar on a
/// terminal. Elsewhere a line where the program has said nothing for ten seconds, so that
/// whoever waits sees that it goes on even while one simulation takes long; of several at
/// once that which counts.
class Progress {
 public:
  explicit Progress(std::string what);
  ~Progress();  // clears the bar
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Draws the bar. From one thread at a time.
  void show(std::size_t done, std::size_t all);

 private:
  [[nodiscard]] std::string line() const;
  void break_silence(const std::stop_token& stop);

  std::string what_;
  bool on_terminal_;
  std::chrono::steady_clock::time_point start_;
  std::size_t done_ = 0, all_ = 0;
  std::mutex mutex_;  // of the counts
  std::condition_variable_any stopped_;
  std::jthread teller_;  // without a terminal
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
