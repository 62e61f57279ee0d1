#pragma once

#include <compare>
#include <exception>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "comparisons/results/result_file.hpp"
#include "comparisons/sweeps/planned_cases.hpp"

namespace springcheck {

/// How the cases of a sweep ended: how many with each status, and how many for which
/// reason, where they have one.
struct SweepOutcome {
  struct Reason {
    Status status;
    std::string method;
    std::string words;

    auto operator<=>(const Reason&) const = default;
  };
  std::map<Status, int> count;
  std::map<Reason, int> reasons;
  std::exception_ptr failure{};  // the first case's that ended without a result
};

/// Runs the requests, `parallel` at a time, adds each to the file as soon as it is
/// complete and to the outcome; see run_study for `finished` and `known`. Throws what the
/// file does.
void run_into(ResultFile& file, const std::vector<Request>& requests, bool with_fields,
              MeshStore& meshes, int parallel, const KnownResult& known,
              const Finished& finished, SweepOutcome& outcome);

/// The same of cases of a sweep, of which a thousand at a time are in memory.
SweepOutcome run_cases(ResultFile& file, const Sweep& sweep,
                       std::span<const PlannedCase> cases, int parallel);

}  // namespace springcheck
