#pragma once

#include "comparisons/system/environment.hpp"

namespace springcheck {

/// What a command has while it simulates: at most so many threads, and the buffers of so
/// many calls of OpenBLAS at a time where the address space is limited (ulimit -v).
class Computing {
 public:
  /// Throws InputError where there is no room for the buffers.
  explicit Computing(int threads) : Computing(threads, threads) {}
  Computing(int threads, int calls);

 private:
  ThreadsInUse in_use_;
};

}  // namespace springcheck
