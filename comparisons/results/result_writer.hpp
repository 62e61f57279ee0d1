#pragma once

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "comparisons/results/result_file.hpp"

namespace springcheck {

/// Writes results to a file beside the computation: at once, but not more often than
/// every fifth of a second, those that came meanwhile together. What is not written yet
/// is lost when the program is killed.
class ResultWriter {
 public:
  ResultWriter(ResultFile& file, bool with_fields, MeshStore& meshes);
  ~ResultWriter();  // after finish(), or dropping what is not written
  ResultWriter(const ResultWriter&) = delete;
  ResultWriter& operator=(const ResultWriter&) = delete;

  /// Takes a result. Throws what an earlier writing threw.
  void put(CaseResult&& result);

  /// Returns when all is written. Throws what the writing threw.
  void finish();

 private:
  void write_until_stopped();
  void rethrow();  // under the lock

  ResultFile& file_;
  bool with_fields_;
  MeshStore& meshes_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<CaseResult> waiting_;
  bool writing_ = false, finishing_ = false, stopping_ = false;
  std::exception_ptr failure_;
  std::thread thread_;  // last: uses all of these
};

}  // namespace springcheck
