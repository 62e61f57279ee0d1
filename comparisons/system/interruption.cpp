#include "comparisons/system/interruption.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <mutex>
#include <thread>

namespace springcheck {
namespace {

constexpr std::array watched{SIGINT, SIGTERM, SIGHUP};

struct Interruptions {
  std::mutex mutex;
  std::list<std::function<void()>> before{};
  std::list<std::filesystem::path> removed{};
};

/// What is to be done at an interruption. It is never destroyed: the program may end
/// while the thread waits.
Interruptions& interruptions() {
  static auto* const all = new Interruptions;
  return *all;
}

int to_thread = -1;  // the pipe's end that the handler writes a signal's number to

extern "C" void hand_on(int number) {
  const int error = errno;
  const char byte = static_cast<char>(number);
  if (write(to_thread, &byte, 1) != 1) _exit(128 + number);
  errno = error;
}

/// Waits for a signal, does what is to be done before, and ends as the signal would.
void wait_for_signal(int from_handler) {
  char number = 0;
  while (read(from_handler, &number, 1) != 1)
    if (errno != EINTR) return;
  for (const int other : watched)
    if (std::signal(other, SIG_DFL) == SIG_IGN) std::signal(other, SIG_IGN);
  const std::unique_lock lock(interruptions().mutex);
  for (const auto& what : interruptions().before) what();
  for (const std::filesystem::path& path : interruptions().removed) {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
  kill(getpid(), number);
  while (true) pause();  // with the lock: nothing that is undone may go on
}

/// While it lives, none of the watched signals comes to a thread that is started.
class SignalsBlocked {
 public:
  SignalsBlocked() {
    sigset_t signals;
    sigemptyset(&signals);
    for (const int number : watched) sigaddset(&signals, number);
    pthread_sigmask(SIG_BLOCK, &signals, &before_);
  }
  ~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

 private:
  sigset_t before_{};
};

}  // namespace

void watch_interruptions() {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return;  // signals end the program, and nothing more
  to_thread = ends[1];
  {
    const SignalsBlocked blocked;
    std::thread(wait_for_signal, ends[0]).detach();
  }
  for (const int number : watched) {
    struct sigaction before {};
    sigaction(number, nullptr, &before);
    if (before.sa_handler == SIG_IGN) continue;
    struct sigaction action {};
    action.sa_handler = hand_on;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    sigaction(number, &action, nullptr);
  }
}

BeforeInterruption::BeforeInterruption(std::function<void()> what) {
  auto& [mutex, before, removed] = interruptions();
  const std::lock_guard lock(mutex);
  place_ = before.insert(before.end(), std::move(what));
}

BeforeInterruption::~BeforeInterruption() {
  const std::lock_guard lock(interruptions().mutex);
  interruptions().before.erase(place_);
}

RemovedAtInterruption::RemovedAtInterruption(std::filesystem::path path) {
  auto& [mutex, before, removed] = interruptions();
  const std::lock_guard lock(mutex);
  place_ = removed.insert(removed.end(), std::move(path));
}

RemovedAtInterruption::~RemovedAtInterruption() {
  const std::lock_guard lock(interruptions().mutex);
  interruptions().removed.erase(place_);
}

BeforeInterruption tell_when_interrupted(std::function<std::string()> words) {
  return BeforeInterruption([words = std::move(words)] {
    std::fprintf(stderr, "\nspringcheck: interrupted. %s\n", words().c_str());
  });
}

}  // namespace springcheck
