#include "comparisons/running/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace springcheck {

Progress::Progress(std::string what)
    : what_(std::move(what)),
      on_terminal_(isatty(STDERR_FILENO) != 0),
      start_(std::chrono::steady_clock::now()) {
  if (!on_terminal_)
    teller_ = std::jthread(
        [this](const std::stop_token& stop) { tell_every_ten_seconds(stop); });
}

Progress::~Progress() {
  if (on_terminal_) fmt::print(stderr, "\r\x1b[K");
}

void Progress::show(std::size_t done, std::size_t all) {
  const std::scoped_lock lock(mutex_);
  done_ = done;
  all_ = all;
  if (!on_terminal_ || all == 0) return;
  fmt::print(stderr, "\r\x1b[K{}", line());
  std::fflush(stderr);
}

std::string Progress::line() const {
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  if (all_ == 0) return fmt::format("{}, for {:.0f} s", what_, elapsed.count());
  constexpr std::size_t width = 30;
  const std::size_t filled = on_terminal_ ? width * done_ / all_ : 0;
  std::string text = what_;
  if (on_terminal_)
    text += fmt::format(" [{}{}]", std::string(filled, '#'),
                        std::string(width - filled, '.'));
  text += fmt::format(" {}/{}", done_, all_);
  if (done_ > 0 && done_ < all_)
    text += fmt::format(
        ", about {:.0f} s left",
        elapsed.count() / static_cast<double>(done_) * static_cast<double>(all_ - done_));
  return text;
}

void Progress::tell_every_ten_seconds(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!stopped_.wait_for(lock, stop, std::chrono::seconds(10),
                            [&] { return stop.stop_requested(); })) {
    fmt::print(stderr, "{}\n", line());
    std::fflush(stderr);
  }
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
