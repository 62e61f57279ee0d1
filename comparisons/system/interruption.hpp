#pragma once

#include <filesystem>
#include <functional>
#include <list>
#include <string>

namespace springcheck {

/// Starts to watch for signals: from here on SIGINT, SIGTERM and SIGHUP end the program
/// after what is to be done before; another one meanwhile ends it at once. Signals that
/// are ignored stay so.
void watch_interruptions();

/// Something that is done before a signal ends the program, as long as this lives, in a
/// thread of its own while the others go on. What is given first comes first.
class BeforeInterruption {
 public:
  explicit BeforeInterruption(std::function<void()> what);
  ~BeforeInterruption();  // waits where that is being done, for ever
  BeforeInterruption(const BeforeInterruption&) = delete;
  BeforeInterruption& operator=(const BeforeInterruption&) = delete;

 private:
  std::list<std::function<void()>>::iterator place_;
};

/// A file or folder that is removed, as long as this lives, as the last thing before a
/// signal ends the program: nobody may take it for abandoned while the program still
/// writes.
class RemovedAtInterruption {
 public:
  explicit RemovedAtInterruption(std::filesystem::path path);
  ~RemovedAtInterruption();
  RemovedAtInterruption(const RemovedAtInterruption&) = delete;
  RemovedAtInterruption& operator=(const RemovedAtInterruption&) = delete;

 private:
  std::list<std::filesystem::path>::iterator place_;
};

/// Says on stderr, before a signal ends the program, what is to be said by then.
BeforeInterruption tell_when_interrupted(std::function<std::string()> words);

}  // namespace springcheck
