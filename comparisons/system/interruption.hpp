#pragma once

#include <functional>
#include <list>
#include <string>

namespace springcheck {

/// From here on SIGINT, SIGTERM and SIGHUP end the program after what BeforeInterruption
/// holds was done; a second one ends it at once. Signals that are ignored stay so.
void watch_interruptions();

/// While it lives, what is done before a signal ends the program: what was given first
/// comes first, in a thread of its own, while the others go on.
class BeforeInterruption {
 public:
  explicit BeforeInterruption(std::function<void()> what);
  ~BeforeInterruption();  // waits where it is being done, for ever
  BeforeInterruption(const BeforeInterruption&) = delete;
  BeforeInterruption& operator=(const BeforeInterruption&) = delete;

 private:
  std::list<std::function<void()>>::iterator place_;
};

/// Says on stderr, before a signal ends the program, what is to be said by then.
BeforeInterruption tell_when_interrupted(std::function<std::string()> words);

}  // namespace springcheck
