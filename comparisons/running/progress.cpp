#include "comparisons/running/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace springcheck {
namespace {

std::mutex lines_mutex;
std::chrono::steady_clock::time_point last_line = std::chrono::steady_clock::now();

/// A line, which may get lost: nothing depends on it.
void say(const std::string& text) {
  std::fputs((text + "\n").c_str(), stderr);
  std::fflush(stderr);
  last_line = std::chrono::steady_clock::now();
}

}  // namespace

Progress::Progress(std::string what)
    : what_(std::move(what)),
      on_terminal_(isatty(STDERR_FILENO) != 0),
      start_(std::chrono::steady_clock::now()) {
  if (!on_terminal_)
    teller_ = std::jthread([this](const std::stop_token& stop) { break_silence(stop); });
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

void Progress::break_silence(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  const auto is_stopped = [&] { return stop.stop_requested(); };
  while (!stopped_.wait_for(lock, stop, std::chrono::milliseconds(200), is_stopped)) {
    // What counts tells more than what goes on around it, and comes first.
    const auto longest = std::chrono::milliseconds(all_ > 0 ? 9'000 : 9'500);
    const std::scoped_lock lines(lines_mutex);
    if (std::chrono::steady_clock::now() - last_line > longest) say(line());
  }
}

void announce(const std::string& what) {
  static const auto start = std::chrono::steady_clock::now();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  const std::scoped_lock lines(lines_mutex);
  say(fmt::format("{}{:.0f} s: {}", isatty(STDERR_FILENO) != 0 ? "\r\x1b[K" : "",
                  elapsed.count(), what));
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
