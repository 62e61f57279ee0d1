#pragma once

#include <cstddef>
#include <unordered_set>

#include "comparisons/running/case_result.hpp"

namespace springcheck {

/// An estimate of how long requests take on one core, references included and each
/// simulation once [s]; it is from measured runs of the five tests (cost.cpp), good to a
/// factor of 3.
class CostEstimate {
 public:
  void add(const Request& request);
  [[nodiscard]] double seconds() const { return seconds_; }

 private:
  void add(const CaseSettings& settings);

  double seconds_ = 0;
  std::unordered_set<std::size_t> seen_;  // hashes of settings
};

}  // namespace springcheck
