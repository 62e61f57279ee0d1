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

}  // namespace springcheck
