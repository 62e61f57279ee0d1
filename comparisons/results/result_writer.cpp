#include "comparisons/results/result_writer.hpp"

#include <utility>

namespace springcheck {

ResultWriter::ResultWriter(ResultFile& file, bool with_fields, MeshStore& meshes)
    : file_(file),
      with_fields_(with_fields),
      meshes_(meshes),
      thread_([this] { write_until_stopped(); }) {}

ResultWriter::~ResultWriter() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void ResultWriter::put(CaseResult&& result) {
  {
    const std::lock_guard lock(mutex_);
    rethrow();
    waiting_.push_back(std::move(result));
  }
  changed_.notify_all();
}

void ResultWriter::finish() {
  std::unique_lock lock(mutex_);
  finishing_ = true;
  changed_.notify_all();
  changed_.wait(lock, [&] { return failure_ || (waiting_.empty() && !writing_); });
  rethrow();
}

void ResultWriter::rethrow() {
  if (failure_) std::rethrow_exception(failure_);
}

void ResultWriter::write_until_stopped() {
  constexpr std::chrono::milliseconds interval(200);
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [&] { return stopping_ || !waiting_.empty(); });
    if (waiting_.empty()) return;
    const std::vector<CaseResult> results = std::exchange(waiting_, {});
    writing_ = true;
    lock.unlock();
    std::exception_ptr failure;
    try {
      file_.put(results, with_fields_, meshes_);
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    writing_ = false;
    failure_ = failure;
    changed_.notify_all();
    if (failure_) return;
    changed_.wait_for(lock, interval, [&] { return stopping_ || finishing_; });
  }
}

}  // namespace springcheck
