#include "comparisons/system/interruption.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <mutex>
#include <thread>

namespace springcheck {
namespace {

constexpr std::array watched{SIGINT, SIGTERM, SIGHUP};

struct Interruptions {
  std::mutex mutex;  // of what is to be done
  std::list<std::function<void()>> before{};
};

/// Never destroyed: the program may end while the thread waits.
Interruptions& interruptions() {
  static auto* const all = new Interruptions;
  return *all;
}

int to_thread = -1;  // the pipe's end that the handler writes a signal's number to

extern "C" void hand_on(int number) {
  const char byte = static_cast<char>(number);
  if (write(to_thread, &byte, 1) != 1) _exit(128 + number);
}

/// Waits for a signal, does what is to be done before, and ends as the signal would.
void wait_for_signal(int from_handler) {
  char number = 0;
  if (read(from_handler, &number, 1) != 1) return;
  std::unique_lock lock(interruptions().mutex);
  for (const auto& what : interruptions().before) what();
  std::signal(number, SIG_DFL);
  kill(getpid(), number);
  pause();  // with the lock: nothing that is undone may go on
}

}  // namespace

void watch_interruptions() {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return;  // signals end the program, and nothing more
  to_thread = ends[1];
  std::thread(wait_for_signal, ends[0]).detach();
  for (const int number : watched) {
    struct sigaction before {};
    sigaction(number, nullptr, &before);
    if (before.sa_handler == SIG_IGN) continue;
    struct sigaction action {};
    action.sa_handler = hand_on;
    action.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND);
    sigemptyset(&action.sa_mask);
    sigaction(number, &action, nullptr);
  }
}

BeforeInterruption::BeforeInterruption(std::function<void()> what) {
  const std::lock_guard lock(interruptions().mutex);
  auto& before = interruptions().before;
  place_ = before.insert(before.end(), std::move(what));
}

BeforeInterruption::~BeforeInterruption() {
  const std::lock_guard lock(interruptions().mutex);
  interruptions().before.erase(place_);
}

BeforeInterruption tell_when_interrupted(std::function<std::string()> words) {
  return BeforeInterruption([words = std::move(words)] {
    std::fprintf(stderr, "\nspringcheck: interrupted. %s\n", words().c_str());
  });
}

}  // namespace springcheck
