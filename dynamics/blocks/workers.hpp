#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace springcheck::dynamics {

/// Threads that take up pieces of work again and again, each as far as possible the ones
/// it had last time.
class Workers {
 public:
  /// threads: at least 1, the caller's among them.
  explicit Workers(int threads);
  ~Workers();
  Workers(Workers&&) noexcept;
  Workers& operator=(Workers&&) noexcept;

  /// work(0) to work(pieces - 1), and returns when all are done.
  void run(std::size_t pieces, const std::function<void(std::size_t)>& work);

 private:
  struct Arena;
  std::unique_ptr<Arena> arena_;  // none for one thread
};

}  // namespace springcheck::dynamics
