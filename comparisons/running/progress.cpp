#include "comparisons/running/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace springcheck {

Progress::Progress(std::string what)
    : what_(std::move(what)),
      on_terminal_(isatty(STDERR_FILENO) != 0),
      start_(std::chrono::steady_clock::now()) {}

Progress::~Progress() {
  if (on_terminal_) fmt::print(stderr, "\r\x1b[K");
}

void Progress::show(std::size_t done, std::size_t all) {
  if (!on_terminal_ || all == 0) return;
  constexpr std::size_t width = 30;
  const std::size_t filled = width * done / all;
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  fmt::print(stderr, "\r\x1b[K{} [{}{}] {}/{}", what_, std::string(filled, '#'),
             std::string(width - filled, '.'), done, all);
  if (done > 0 && done < all)
    fmt::print(
        stderr, ", about {:.0f} s left",
        elapsed.count() / static_cast<double>(done) * static_cast<double>(all - done));
  std::fflush(stderr);
}

void announce(const std::string& what) {
  static const auto start = std::chrono::steady_clock::now();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  fmt::print(stderr, "{}{:.0f} s: {}\n", isatty(STDERR_FILENO) != 0 ? "\r\x1b[K" : "",
             elapsed.count(), what);
  std::fflush(stderr);
}

MarchProgress::MarchProgress(double duration)
    : duration_(duration),
      on_terminal_(isatty(STDERR_FILENO) != 0),
      last_(std::chrono::steady_clock::now()) {}

MarchProgress::~MarchProgress() {
  if (on_terminal_) fmt::print(stderr, "\r\x1b[K");
}

void MarchProgress::show(double time, int step, double dt, double limit) {
  if (!on_terminal_) return;
  const auto now = std::chrono::steady_clock::now();
  const double seconds = std::chrono::duration<double>(now - last_).count();
  if (last_step_ >= 0 && time > last_time_) {
    fmt::print(
        stderr,
        "\r\x1b[K{:.4g} of {:.4g} s in steps of {:.3g} s ({}), {:.3g} "
        "steps a second, {:.0f} s left",
        time, duration_, dt,
        limit == 0 ? "no step is stable" : fmt::format("stable up to {:.3g} s", limit),
        (step - last_step_) / seconds,
        (duration_ - time) * seconds / (time - last_time_));
    std::fflush(stderr);
  }
  last_ = now;
  last_time_ = time;
  last_step_ = step;
}

}  // namespace springcheck
